// SPDX-License-Identifier: BSD-3-Clause
// Sample patterns on CPU and GPU: the disk of the neighbourhood gather, and the samplers' lattices.
#include "OpenGL/vtkIndirectKernels.h"
#include "Senders/vtkIndirectMapSampler.h"
#include "Senders/vtkIndirectSamplePattern.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
std::vector<vtkIndirectMapSampler::Sample> MakePattern(
  vtkUniformLightSampler* sampler, const std::vector<vtkIndirectMapSampler::Source>& sources)
{
  std::vector<vtkIndirectMapSampler::Sample> samples;
  vtkIndirectSampler::Get(sampler)->GetHeadlightPattern()->MakePattern(sources, samples);
  return samples;
}
}

VTK_INDIRECT_TEST(DiskSamples)
{
  for (int n : { 1, 16, 256, 4096 })
  {
    double weights = 0.0;
    double moments[5] = {};
    for (int i = 0; i < n; ++i)
    {
      const vtkIndirectKernels::vec3 s = vtkIndirectKernels::vtkiDiskSample(i, n);
      const double x = s.x;
      const double y = s.y;
      weights += s.z;
      const double m[5] = { x, y, x * x, y * y, x * x + y * y };
      for (int k = 0; k < 5; ++k)
      {
        moments[k] += s.z * m[k];
      }
    }
    const std::string what = std::to_string(n) + " samples: ";
    // The weights are linear in the radius: the midpoint rule sums them exactly.
    CheckRelative(
      what + "sum of weights is the disk's area", weights, vtkMath::Pi(), 2e-6, "rounding");
    if (n < 16)
    {
      continue;
    }
    // Midpoint rule of xi^3: 1/4 - 1/(8 n^2).
    CheckRelative(what + "second radial moment", moments[4], 0.5 * vtkMath::Pi(),
      0.5 / n / n + 4e-6, "midpoint rule and rounding");
    // Rotation by the golden ratio: angular sums of a quasi-random sequence fall about as 1 / n.
    const double bound = 3.0 / n;
    CheckAbsolute(
      what + "moment of x", moments[0], 0.0, bound, "discrepancy of the golden rotation");
    CheckAbsolute(
      what + "moment of y", moments[1], 0.0, bound, "discrepancy of the golden rotation");
    CheckAbsolute(what + "moment of x^2", moments[2], 0.25 * vtkMath::Pi(), bound,
      "discrepancy of the golden rotation");
    CheckAbsolute(what + "moment of y^2", moments[3], 0.25 * vtkMath::Pi(), bound,
      "discrepancy of the golden rotation");
  }
  // With the Jacobian xi^2, which counts areas twice, the sum of weights would be 2 pi / 3.
  Check("a weight of the radius squared would be rejected",
    !WouldPass(2.0 * vtkMath::Pi() / 3.0, vtkMath::Pi(), 2e-6));
}

VTK_INDIRECT_TEST(SquareToDisk)
{
  Random random(14);
  double worst = 0.0;
  double farthest = 0.0;
  for (int i = 0; i < 100000; ++i)
  {
    const double u = random.Next(0.001, 0.999);
    const double v = random.Next(0.001, 0.999);
    const double h = 1e-6;
    const double a = 2.0 * u - 1.0;
    const double b = 2.0 * v - 1.0;
    auto map = [](double x, double y)
    {
      vtkIndirectSamplePattern::SquareToDisk(x, y);
      return glm::dvec2(x, y);
    };
    const glm::dvec2 p = map(u, v);
    farthest = std::max(farthest, glm::length(p - 0.5));
    if (std::abs(std::abs(a) - std::abs(b)) < 1e-5)
    {
      continue; // the map has a crease on the diagonals
    }
    const glm::dvec2 du = (map(u + h, v) - map(u - h, v)) / (2.0 * h);
    const glm::dvec2 dv = (map(u, v + h) - map(u, v - h)) / (2.0 * h);
    const double jacobian = std::abs(du.x * dv.y - du.y * dv.x);
    worst = std::max(worst, std::abs(jacobian / vtkIndirectSamplePattern::DiskShare - 1.0));
  }
  CheckAtMost(
    "worst deviation of the area ratio from pi / 4", worst, 1e-6, "differences of step 1e-6");
  CheckAtMost("farthest from the centre", farthest, 0.5, "definition");
  double u = 0.5;
  double v = 0.5;
  vtkIndirectSamplePattern::SquareToDisk(u, v);
  Check("the centre stays", u == 0.5 && v == 0.5);
}

VTK_INDIRECT_TEST(FibonacciLattice)
{
  // Every sixteenth of the square has its share; random points deviate by sqrt(n).
  for (int n : { 64, 256, 1024, 4096 })
  {
    double worst = 0.0;
    for (int a = 1; a <= 16; ++a)
    {
      for (int b = 1; b <= 16; ++b)
      {
        int inside = 0;
        for (int i = 0; i < n; ++i)
        {
          inside +=
            (i + 0.5) / n < a / 16.0 && vtkIndirectSamplePattern::GoldenRatioFraction(i) < b / 16.0;
        }
        worst = std::max(worst, std::abs(inside - n * a * b / 256.0));
      }
    }
    CheckAtMost(std::to_string(n) + " points: worst miscount of a box at the corner", worst,
      1.0 + 0.5 * std::log(n), "discrepancy of the lattice grows with the logarithm");
  }
}

VTK_INDIRECT_TEST(RandomStreams)
{
  vtkIndirectSamplePattern::Random a(0);
  vtkIndirectSamplePattern::Random b(1);
  double mean = 0.0;
  double square = 0.0;
  double product = 0.0;
  const int n = 100000;
  int outside = 0;
  for (int i = 0; i < n; ++i)
  {
    const double x = a.Next();
    const double y = b.Next();
    outside += x < 0.0 || x >= 1.0;
    mean += x / n;
    square += x * x / n;
    product += (x - 0.5) * (y - 0.5) / n;
  }
  CheckEqual("values outside [0,1)", outside, 0);
  // Four standard deviations of n values.
  CheckAbsolute("mean", mean, 0.5, 4.0 * 0.2887 / std::sqrt(n), "four standard deviations");
  CheckAbsolute(
    "mean square", square, 1.0 / 3.0, 4.0 * 0.2981 / std::sqrt(n), "four standard deviations");
  CheckAbsolute(
    "two streams' covariance", product, 0.0, 4.0 / 12.0 / std::sqrt(n), "four standard deviations");
}

VTK_INDIRECT_TEST(SamplerPatterns)
{
  using Source = vtkIndirectMapSampler::Source;
  std::vector<Source> sources;
  for (int layer = 0; layer < 8; ++layer)
  {
    Source source;
    source.Layer = layer;
    source.Size[0] = source.Size[1] = 128;
    // A spot, six faces, and a parallel map.
    source.Light = layer == 0 ? 0 : (layer < 7 ? 1 : 2);
    source.Disk = layer == 0;
    sources.push_back(source);
  }
  vtkNew<vtkUniformLightSampler> sampler;
  for (int pattern = 0; pattern < 3; ++pattern)
  {
    for (int lights : { 1, 3, 64, 256, 1000, 4096 })
    {
      sampler->SetPattern(pattern);
      sampler->SetNumberOfLights(lights);
      const auto samples = MakePattern(sampler, sources);
      double texels[3] = {};
      int wrong = 0;
      for (const auto& s : samples)
      {
        const int layer = static_cast<int>(s.Layer);
        texels[sources[layer].Light] += s.Texels;
        wrong += !(s.U >= 0.0f && s.U < 1.0f && s.V >= 0.0f && s.V < 1.0f && s.Texels > 0.0f);
        wrong += layer == 0 && std::hypot(s.U - 0.5, s.V - 0.5) > 0.5 + 1e-6;
      }
      const std::string what =
        "pattern " + std::to_string(pattern) + ", " + std::to_string(lights) + " lights: ";
      const double map = 128.0 * 128.0;
      CheckEqual(what + "samples out of place", wrong, 0);
      // Floats represent each weight exactly.
      CheckRelative(
        what + "texels of the spot", texels[0], map * 0.25 * vtkMath::Pi(), 1e-6, "rounding");
      CheckRelative(what + "texels of the cube", texels[1], 6.0 * map, 1e-6, "rounding");
      CheckRelative(what + "texels of the parallel map", texels[2], map, 1e-6, "rounding");
      if (pattern == vtkUniformLightSampler::LOW_DISCREPANCY)
      {
        CheckEqual(what + "number of lights", samples.size(), 3 * std::max(1, lights / 3));
      }
      const auto again = MakePattern(sampler, sources);
      Check(what + "the same again",
        again.size() == samples.size() &&
          std::equal(again.begin(), again.end(), samples.begin(),
            [](const auto& p, const auto& q)
            { return p.U == q.U && p.V == q.V && p.Layer == q.Layer && p.Texels == q.Texels; }));
    }
  }
}

VTK_INDIRECT_TEST(ConeDirections)
{
  using namespace vtkIndirectKernels;
  using Source = vtkIndirectMapSampler::Source;
  vtkNew<vtkUniformLightSampler> sampler;
  for (double angle : { 61.0, 75.0, 89.0, 180.0 })
  {
    const double cosCone = std::cos(angle * vtkMath::Pi() / 180.0);
    std::vector<Source> sources;
    for (int face = 0; face < (angle < 90.0 ? 5 : 6); ++face)
    {
      Source source;
      source.Layer = face;
      source.Size[0] = source.Size[1] = 256;
      source.CosCone = cosCone;
      sources.push_back(source);
    }
    sampler->SetNumberOfLights(2000);
    const auto samples = MakePattern(sampler, sources);
    double solidAngle = 0.0;
    double outermost = -1.0;
    double along = 0.0;
    int wrong = 0;
    for (const auto& s : samples)
    {
      const vec2 tangent(2.0f * s.U - 1.0f, 2.0f * s.V - 1.0f);
      const double own = s.Texels * vtkiTexelSolidAngle(tangent, 2.0f / 256.0f);
      solidAngle += own;
      // Back to the light's frame: the faces' rotations are their transposes' inverses.
      double cosine = -2.0;
      const vec3 p = normalize(vec3(tangent.x, tangent.y, -1.0f));
      const vec3 forward = vtkiToFace(vec3(0.0f, 0.0f, -1.0f), static_cast<int>(s.Layer));
      cosine = dot(p, forward);
      outermost = std::max(outermost, cosCone - cosine);
      along += own * cosine;
      wrong += !(s.U >= 0.0f && s.U <= 1.0f && s.V >= 0.0f && s.V <= 1.0f);
    }
    const std::string what = std::to_string(static_cast<int>(angle)) + " degrees: ";
    const double expected = 2.0 * vtkMath::Pi() * (1.0 - cosCone);
    CheckEqual(what + "number of lights", samples.size(), 2000);
    CheckEqual(what + "samples off their face", wrong, 0);
    CheckRelative(what + "solid angle", solidAngle, expected, 1e-5, "weights are floats");
    CheckAtMost(what + "farthest outside the cone", outermost, 1e-6, "rounding");
    // Mean direction of a cap: pi (1 - cos^2).
    CheckAbsolute(what + "sum along the axis", along, vtkMath::Pi() * (1.0 - cosCone * cosCone),
      1e-3, "2000 directions of a lattice");
  }
}
