// SPDX-License-Identifier: BSD-3-Clause
// A closed sphere with a point light and the eye at its centre: the one scene whose indirect light
// is the same everywhere and known exactly, E1 = albedo E0.
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkLightTreeSampler.h"
#include "vtkMath.h"
#include "vtkRSMGatherPass.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace vtkIndirectTest;

namespace
{
constexpr double Radius = 2.0;
constexpr int Sides = 200;
// A chord's middle lies 1 - cos(pi / Sides) of the radius inside: distances and areas are low by up
// to 1.3e-4, quantities that fall with the square of the distance by twice that.
const double MeshDeviation = 1.0 - std::cos(vtkMath::Pi() / Sides);

struct Statistics
{
  double Mean = 0.0; // over the sphere, by solid angle
  double Least = INFINITY;
  double Largest = 0.0;
};

struct SphereScene : Scene
{
  glm::dvec3 Albedo{ 0.75, 0.5, 0.25 };
  vtkLight* Light;

  explicit SphereScene(const glm::dvec3& attenuation)
    : Scene(40, 40)
  {
    this->AddSphere(glm::dvec3(0.0), Radius, Sides, this->Albedo);
    this->Light = this->AddPoint(glm::dvec3(0.0), attenuation);
    this->Pass->SetReflectiveShadowMapResolution(64);
  }

  struct Quantity
  {
    const char* Buffer;
    glm::dvec3 Expected;
  };

  // Channels over their expectation, seen in six directions, each rendered once.
  std::vector<Statistics> Measure(const std::vector<Quantity>& quantities)
  {
    std::vector<Statistics> found(quantities.size());
    double weights = 0.0; // for one quantity
    for (int i = 0; i < 6; ++i)
    {
      glm::dvec3 axis(0.0);
      axis[i / 2] = i % 2 ? -1.0 : 1.0;
      this->SetEye(glm::dvec3(0.0), axis, glm::dvec3(axis.y, axis.z, axis.x), 90.0, 0.1, 10.0);
      this->Render();
      for (std::size_t q = 0; q < quantities.size(); ++q)
      {
        Statistics& s = found[q];
        const Image image = this->Copy(quantities[q].Buffer);
        for (int y = 0; y < image.Height; ++y)
        {
          for (int x = 0; x < image.Width; ++x)
          {
            const double u = 2.0 * (x + 0.5) / image.Width - 1.0;
            const double v = 2.0 * (y + 0.5) / image.Height - 1.0;
            const double weight = std::pow(1.0 + u * u + v * v, -1.5);
            for (int c = 0; c < 3; ++c)
            {
              const double value = image.At(x, y)[c] / quantities[q].Expected[c];
              s.Mean += weight * value;
              weights += q == 0 ? weight : 0.0;
              s.Least = std::min(s.Least, value);
              s.Largest = std::max(s.Largest, value);
            }
          }
        }
      }
    }
    for (Statistics& s : found)
    {
      s.Mean /= weights;
    }
    return found;
  }

  Statistics Measure(const char* buffer, const glm::dvec3& expected)
  {
    return this->Measure({ { buffer, expected } })[0];
  }
};

void CheckAllTexels(const glm::dvec3& attenuation, double e0)
{
  SphereScene scene(attenuation);
  scene.Light->SetIntensity(3.0);
  e0 *= 3.0;
  const std::vector<Statistics> measured = scene.Measure({ { "direct", scene.Albedo * e0 },
    { "irradiance", scene.Albedo * e0 }, { "indirect", scene.Albedo * scene.Albedo * e0 } });
  const Statistics& direct = measured[0];
  CheckAbsolute("direct light over albedo E0, least", direct.Least, 1.0, 1e-3, "mesh");
  CheckAbsolute("direct light over albedo E0, largest", direct.Largest, 1.0, 1e-3, "mesh");
  const Statistics& s = measured[1];
  const double n = 6.0 * 64.0 * 64.0;
  CheckAbsolute("E1 over albedo E0, mean", s.Mean, 1.0 - std::log(1.0 + n) / n,
    3e-4 + 2.0 * MeshDeviation,
    "unequal texels raise the kernel's bias of 4.1e-4 by a fifth; mesh");
  CheckAbsolute("E1 over albedo E0, least", s.Least, 1.0, 0.01, "uniform within one per cent");
  CheckAbsolute("E1 over albedo E0, largest", s.Largest, 1.0, 0.01, "uniform within one per cent");
  Check("3 % more would be rejected", !WouldPass(1.03 * s.Mean, 1.0, 0.01));
  Check("3 % less would be rejected", !WouldPass(s.Mean / 1.03, 1.0, 0.01));
  Check("a stray pi would be rejected", !WouldPass(vtkMath::Pi() * s.Mean, 1.0, 0.01));
  const Statistics& indirect = measured[2];
  CheckAbsolute("indirect over albedo^2 E0, mean", indirect.Mean, s.Mean,
    s.Mean / (1023.0 * std::sqrt(scene.Albedo.z)), "ten bits hold the albedo's root");
  scene.CheckBuffers(1);
}
}

VTK_INDIRECT_TEST(ClosedSphereInverseSquare)
{
  CheckAllTexels({ 0.0, 0.0, 0.5 }, 1.0 / (0.5 * Radius * Radius));
}

VTK_INDIRECT_TEST(ClosedSphereConstant)
{
  CheckAllTexels({ 1.0, 0.0, 0.0 }, 1.0);
}

VTK_INDIRECT_TEST(ClosedSphereVirtualLights)
{
  SphereScene scene({ 0.0, 0.0, 1.0 });
  const glm::dvec3 expected = scene.Albedo / (Radius * Radius);
  scene.Gather->SetModeToVirtualLights();
  for (int n : { 1024, 4096 })
  {
    scene.Sampler->SetNumberOfLights(n);
    const Statistics s = scene.Measure("irradiance", expected);
    const std::string what = std::to_string(n) + " lights: E1 over albedo E0";
    const double bias = std::log(1.0 + n) / n;
    CheckAbsolute(what + ", mean", s.Mean, 1.0 - bias, 0.5 * bias + 5e-4,
      "bias; the cube's texels are not equal, which raises it by a fifth");
    // Bias 0.7 % at 1024; a single light's share, 1 / N, varies with the distance to it.
    CheckAbsolute(what + ", least", s.Least, 1.0, n < 2000 ? 0.013 : 0.01,
      "bias and the nearest light's share");
    CheckAbsolute(what + ", largest", s.Largest, 1.0, 0.01, "one per cent");
  }
}

VTK_INDIRECT_TEST(ClosedSphereLightTree)
{
  SphereScene scene({ 0.0, 0.0, 1.0 });
  vtkNew<vtkLightTreeSampler> tree;
  scene.Pass->SetSampler(tree);
  scene.Gather->SetModeToVirtualLights();
  for (const double tolerance : { 0.0, 0.005 })
  {
    scene.Pass->SetErrorTolerance(tolerance);
    const Statistics s = scene.Measure("irradiance", scene.Albedo / (Radius * Radius));
    const std::string what = "tolerance " + std::to_string(tolerance) + ", E1 over albedo E0: ";
    const double limit = 5e-3;
    CheckAbsolute(
      what + "mean", s.Mean, 1.0, limit, "a quarter of the tolerance where none is set");
    // Lights send about the normals of facets, and a texel sees one facet: 0.9948.
    CheckAbsolute(what + "least", s.Least, 1.0, 6e-3, "the same, and a facet's angle");
    CheckAbsolute(what + "largest", s.Largest, 1.0, limit, "the same");
  }
  scene.Pass->SetSampler(nullptr);
}

VTK_INDIRECT_TEST(ClosedSphereKnownBias)
{
  SphereScene scene({ 0.0, 0.0, 1.0 });
  const glm::dvec3 expected = scene.Albedo / (Radius * Radius);
  scene.Gather->SetModeToVirtualLights();
  for (int n : { 64, 256 })
  {
    scene.Sampler->SetNumberOfLights(n);
    const Statistics s = scene.Measure("irradiance", expected);
    // Expectation for lights of unequal area: sum of a (1 - a ln(1 + 1/a)), a the share of the
    // sphere.
    double exact = 0.0;
    double total = 0.0;
    for (const VirtualLight& light : scene.CopyLights())
    {
      const double a = light.Area / (4.0 * vtkMath::Pi() * Radius * Radius);
      total += a;
      exact += a * (1.0 - a * std::log(1.0 + 1.0 / a));
    }
    const std::string what = std::to_string(n) + " lights: ";
    // A lattice of N points integrates the cube's solid angle to about one in N.
    CheckAbsolute(
      what + "areas over the sphere's", total, 1.0, 2.0 / n, "sampling of the solid angle");
    CheckAbsolute(what + "mean E1 over albedo E0, its own areas", s.Mean, exact, 2e-3,
      "40^2 pixels a face see each light's neighbourhood");
    const double bias = std::log(1.0 + n) / n;
    CheckAbsolute(what + "mean E1 over albedo E0, equal areas", s.Mean, 1.0 - bias, 0.3 * bias,
      "unequal texels of the cube raise the bias by a fifth; sampling");
  }
}
