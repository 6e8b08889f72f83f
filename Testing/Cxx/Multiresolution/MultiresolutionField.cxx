// SPDX-License-Identifier: BSD-3-Clause
// Fields with a known upsampled image: constants, and light on only one side of a depth edge.
#include "vtkIndirectDetails.h"
#include "vtkIndirectRandomFrame.h"

#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace vtkIndirectTest;

namespace
{
using Pass = vtkMultiresolutionSplattingPass;

// A different combination of settings for each number.
std::string Configure(Pass* pass, int number)
{
  const int coarsest[] = { 64, 4, 16, 7 };
  const double thresholds[] = { 0.25, 0.02, 0.7 };
  SET_DETAIL(pass, CoarsestResolution, coarsest[number % 4]);
  pass->SetPlaneThreshold(thresholds[number % 3]);
  pass->SetNormalThreshold(number % 3 == 2 ? 1.5 : 0.2);
  SET_DETAIL(pass, Balance, number % 5 != 0);
  pass->SetFinestLevel(number % 7 < 3 ? Pass::HALF_RESOLUTION : Pass::FULL_RESOLUTION);
  SET_DETAIL(pass, NormalCorrection, number % 2 == 0);
  SET_DETAIL(pass, HalfFloats, number % 4 == 3);
  return "coarsest " + std::to_string(coarsest[number % 4]) + ", plane threshold " +
    std::to_string(thresholds[number % 3]) + (number % 5 ? "" : ", unbalanced") +
    (number % 7 < 3 ? ", half resolution" : "") + (number % 4 == 3 ? ", half floats" : "");
}
}

VTK_INDIRECT_TEST(ConstantField)
{
  // Parallel sheets at random depths, all of them within a thousandth of the distance to a lit
  // wall: their irradiance differs by as little, and interpolation between them, across their
  // edges, to the background or from outside of the image must not show.
  double worst[2] = {};
  double variation = 0.0;
  int gaps = 0;
  int leaks = 0;
  int covered = 0;
  const double extent = 2e-3;
  for (int number = 0; number < 28; ++number)
  {
    const FrameSize& size = GetFrameSizes()[number % GetFrameSizes().size()];
    MultiresolutionScene scene(size.Width, size.Height);
    Random random(900 + static_cast<std::uint64_t>(number));
    scene.AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, glm::dvec3(0.75));
    for (int i = 0; i < 12; ++i)
    {
      const double x = 0.5 + extent * random.Next(-0.5, 0.5);
      const double y = 0.5 + extent * random.Next(-0.5, 0.5);
      const double z = 1.0 + extent * random.Next(-0.5, 0.5);
      const double u = extent * random.NextMagnitude(0.02, 0.5);
      const double v = extent * random.NextMagnitude(0.02, 0.5);
      scene.AddQuad({ x, y, z }, { x, y + v, z }, { x + u, y, z }, glm::dvec3(0.75));
    }
    scene.AddSpot({ -0.5, 0.5, 0.9 }, { 0.5, 0.5, 0 }, 25, 0, { 1, 0, 0 });
    const glm::dvec3 from =
      glm::normalize(glm::dvec3(random.Next(-1, 1), random.Next(-1, 1), -random.Next(0.4, 1.5)));
    const glm::dvec3 target(0.5, 0.5, 1.0);
    const double distance = 0.05;
    scene.SetEye(
      target + distance * from, target, { 0.1, 1, 0.2 }, random.Next(1.5, 4.0), 0.02, 0.2);
    scene.Sampler->SetNumberOfLights(100);
    scene.Pass->SetReflectiveShadowMapResolution(64);
    const Image expected = scene.GatherAll();
    const std::string settings = Configure(scene.Splatting, number);
    const Image image = scene.Splat();
    const bool half = DetailsOf(scene.Splatting).HalfFloats;
    double mean = 0.0;
    int lit = 0;
    for (float value : expected.Values)
    {
      mean += value;
      lit += value > 0.0f ? 1 : 0;
    }
    mean /= std::max(lit, 1);
    double here = 0.0;
    for (size_t i = 0; i < expected.Values.size(); ++i)
    {
      if (expected.Values[i] > 0.0f)
      {
        variation = std::max(variation, std::abs(expected.Values[i] / mean - 1.0));
        here = std::max(here, std::abs(image.Values[i] / mean - 1.0));
        ++covered;
      }
      else
      {
        ++gaps;
        leaks += image.Values[i] != 0.0f ? 1 : 0;
      }
    }
    worst[half] = std::max(worst[half], here);
    std::printf("       %d x %d, %s: %d lit values, worst %.2e\n", size.Width, size.Height,
      settings.c_str(), lit, here);
  }
  CheckAtLeast("lit values", covered, 30000, "the test's own power");
  CheckEqual("values of the background with light", leaks, 0);
  CheckAtLeast("values of the background", gaps, 50000, "the test's own power");
  CheckAtMost("variation of the gathered values", variation, 6e-3, "size over distance, thrice");
  CheckAtMost("variation of the upsampled ones, 32-bit floats", worst[0], variation + 1e-5,
    "interpolation stays within what it interpolates, but for rounding");
  CheckAtMost("the same, half floats", worst[1], variation + 2e-3, "roundings of 2^-11 a level");
}

namespace
{
// A sender at half height beside the view lights all surfaces below it that face up; sheets above
// it, parallel to the ground, are dark. In the other case, the sheets lean towards a sender below
// the ground, which is dark. The sum in double precision tells which pixels are dark.
void CheckDepthEdge(bool nearIsLit)
{
  double worstDark = 0.0;
  double lost = 0.0;
  int dark = 0;
  int lit = 0;
  for (int number = 0; number < 24; ++number)
  {
    const FrameSize& size = GetFrameSizes()[number % GetFrameSizes().size()];
    MultiresolutionScene scene(size.Width, size.Height);
    Random random(1300 + static_cast<std::uint64_t>(number));
    scene.AddQuad({ -1, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 }, glm::dvec3(0.8));
    const glm::dvec3 sender(4.0, -1.0, nearIsLit ? -2.0 : 0.5);
    if (nearIsLit)
    {
      scene.AddQuad(sender, sender + glm::dvec3(0, 2, 0), sender + glm::dvec3(0, 0, 1.5),
        glm::dvec3(0.9)); // faces -x
      scene.Splatting->SetNormalThreshold(2.0);
    }
    else
    {
      scene.AddQuad(sender, sender + glm::dvec3(0, 2, 0), sender + glm::dvec3(2, 0, 0),
        glm::dvec3(0.9)); // faces -z
    }
    for (int i = 0; i < 10; ++i)
    {
      const glm::dvec3 at(random.Next(-1, 0.7), random.Next(-1, 0.7), random.Next(0.6, 1.0));
      const double u = random.NextMagnitude(0.02, 0.5);
      const double v = random.NextMagnitude(0.02, 0.5);
      const glm::dvec3 along = nearIsLit ? glm::dvec3(0.5 * u, 0, -0.87 * u) : glm::dvec3(u, 0, 0);
      scene.AddQuad(at, at + along, at + glm::dvec3(0, v, 0), glm::dvec3(0.8));
    }
    if (nearIsLit)
    {
      scene.AddSpot({ 2.0, 0, -1.3 }, { 4.0, 0, -1.3 }, 12, 0, { 1, 0, 0 });
    }
    else
    {
      scene.AddSpot({ 5.0, 0, -1.5 }, { 5.0, 0, 0.5 }, 12, 0, { 1, 0, 0 });
    }
    const glm::dvec3 target(random.Next(-0.2, 0.2), random.Next(-0.2, 0.2), 0.5);
    const glm::dvec3 from =
      glm::normalize(glm::dvec3(random.Next(-0.2, 0.4), random.Next(-0.4, 0.4), 1.0));
    scene.SetEye(target + 3.0 * from, target, { 0.1, 1, 0.2 }, random.Next(15, 32), 0.5, 10);
    scene.Sampler->SetNumberOfLights(64);
    const Image expected = scene.GatherAll();
    const std::string settings = Configure(scene.Splatting, number);
    const Image image = scene.Splat();
    double brightest = 0.0;
    for (float value : expected.Values)
    {
      brightest = std::max(brightest, static_cast<double>(value));
    }
    auto isDark = [&](int x, int y) { return expected.Color(x, y).x == 0.0; };
    double darkHere = 0.0;
    for (int y = 0; y < expected.Height && brightest > 0.0; ++y)
    {
      for (int x = 0; x < expected.Width; ++x)
      {
        const double wanted = expected.Color(x, y).x;
        const double value = image.Color(x, y).x;
        if (isDark(x, y))
        {
          darkHere = std::max(darkHere, value / brightest);
          ++dark;
          continue;
        }
        bool atEdge = false;
        for (int i = 0; i < 25; ++i)
        {
          const int u = std::min(std::max(x + i % 5 - 2, 0), expected.Width - 1);
          const int v = std::min(std::max(y + i / 5 - 2, 0), expected.Height - 1);
          atEdge = atEdge || isDark(u, v);
        }
        if (atEdge && wanted > 0.01 * brightest)
        {
          lost += 1.0 - value / wanted;
          ++lit;
        }
      }
    }
    std::printf("       %d x %d, %s: brightest of the dark %.2e\n", size.Width, size.Height,
      settings.c_str(), darkHere);
    worstDark = std::max(worstDark, darkHere);
  }
  CheckAtLeast("dark pixels", dark, 10000, "the test's own power");
  CheckAtLeast("lit pixels within two of a dark one", lit, 1000, "the test's own power");
  CheckAtMost("light beyond the edge, of the brightest", worstDark, 1e-6, "nothing may cross");
  CheckAbsolute("lit pixels at the edge, mean share of their light that is lost", lost / lit, 0.0,
    0.01, "interpolation's own error; a dark neighbour in it would take a sixteenth and more");
}
}

VTK_INDIRECT_TEST(DepthEdgeFarIsLit)
{
  CheckDepthEdge(false);
}

VTK_INDIRECT_TEST(DepthEdgeNearIsLit)
{
  CheckDepthEdge(true);
}
