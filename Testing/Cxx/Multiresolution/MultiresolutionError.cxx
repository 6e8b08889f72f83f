// SPDX-License-Identifier: BSD-3-Clause
// Error of interpolation between subsplats, against the gather at every pixel over the same lights,
// and the effect of each setting.
#include "vtkIndirectDetails.h"
#include "vtkIndirectRandomFrame.h"

#include "vtkActor.h"
#include "vtkMath.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkRenderWindow.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

using namespace vtkIndirectTest;

namespace
{
constexpr double Least = 1e-3;

// A ball over a lit floor: a curved receiver of smooth light.
struct Ball : MultiresolutionScene
{
  Ball()
    : MultiresolutionScene(160, 160)
  {
    this->AddQuad({ -1, 0, -1 }, { -1, 0, 2 }, { 2, 0, -1 }, { 0.75, 0.75, 0.5 });
    this->AddSphere({ 0.5, 0.9, 0.5 }, 0.3, 128, { 0.5, 0.5, 0.75 });
    this->AddSpot({ -0.8, 1.4, 0.5 }, { 0, 0, 0.5 }, 30, 1, { 1, 0, 0 });
    this->SetEye({ 0.5, 0.2, 2.4 }, { 0.5, 0.9, 0.5 }, { 0, 1, 0 }, 16, 0.5, 5);
    this->Sampler->SetNumberOfLights(256);
  }
};
}

VTK_INDIRECT_TEST(Defaults)
{
  // Lower thresholds give more subsplats, and a lower error.
  const std::vector<double> factors = { 4.0, 1.0, 0.25, 0.0625 };
  std::vector<double> logarithms(factors.size(), 0.0);
  std::vector<double> defaults;
  for (int number = 0; number < 20; ++number)
  {
    RandomFrame scene(400 + number, { 271 - number, 197 + 2 * number },
      static_cast<FrameLight>(number % NumberOfFrameLights));
    scene.Sampler->SetNumberOfLights(100);
    scene.Pass->SetReflectiveShadowMapResolution(128);
    const Image expected = scene.GatherAll();
    if (!(expected.Mean() > 0.0))
    {
      continue;
    }
    std::printf("       %s: RMSE", scene.Name.c_str());
    for (size_t i = 0; i < factors.size(); ++i)
    {
      scene.ScaleThresholds(factors[i]);
      const double error = Compare(scene.Splat(), expected, Least).RootMeanSquare;
      logarithms[i] += std::log(error);
      if (factors[i] == 1.0)
      {
        defaults.push_back(error);
      }
      std::printf(" %.2e", error);
    }
    std::printf("\n");
  }
  const size_t count = defaults.size();
  CheckAtLeast("frames with indirect light", count, 18, "the test's own power");
  CheckAtMost("RMSE over the mean at the defaults, median frame", Percentile(defaults, 0.5), 0.0073,
    "measured 0.0069; 0.0077 where single lights are not looked at");
  CheckAtMost("the same, worst frame", Percentile(defaults, 1.0), 0.15,
    "measured 0.118: a bright spot where a small thing stands on the floor");
  for (size_t i = 1; i < factors.size(); ++i)
  {
    CheckAtMost("RMSE with thresholds times " + std::to_string(factors[i]) +
        " over that of four times as high ones, geometric mean",
      std::exp((logarithms[i] - logarithms[i - 1]) / count), 1.0, "it splits more");
  }
  CheckAtMost("the same from first to last", std::exp((logarithms.back() - logarithms[0]) / count),
    0.12, "measured 0.075");
}

namespace
{
// Counts the pixels that are lit in the expected image, among lit pixels only as far as a sample of
// this level may lie away, and those of them without a value. Next to unlit pixels, a nearby sample
// may be 0.
void CountLit(
  const Image& image, const Image& expected, const Image& normal, int level, int& lit, int& dark)
{
  // At each level the farthest sample lies one and a half texels away.
  const int radius = 3 * std::max((1 << level) - 1, 1);
  const double least = 0.1 * expected.Mean();
  for (int y = 0; y < expected.Height; ++y)
  {
    for (int x = 0; x < expected.Width; ++x)
    {
      bool surrounded = expected.Color(x, y).x > 0.0;
      for (int v = std::max(y - radius, 0);
           surrounded && v <= std::min(y + radius, expected.Height - 1); ++v)
      {
        for (int u = std::max(x - radius, 0);
             surrounded && u <= std::min(x + radius, expected.Width - 1); ++u)
        {
          surrounded = normal.Color(u, v) == glm::dvec3(0.0) || expected.Color(u, v).x > least;
        }
      }
      lit += surrounded ? 1 : 0;
      dark += surrounded && !(image.Color(x, y).x > 0.0) ? 1 : 0;
    }
  }
}
}

VTK_INDIRECT_TEST(FinestLevels)
{
  constexpr int coarsest = vtkMultiresolutionSplattingPass::EIGHTH_RESOLUTION;
  std::vector<double> errors[coarsest + 1];
  double logarithm[coarsest + 1] = {};
  int lit[coarsest + 1] = {};
  for (int number = 0; number < 15; ++number)
  {
    RandomFrame scene(500 + number, { 289 - number, 211 + number },
      static_cast<FrameLight>(number % NumberOfFrameLights));
    scene.Sampler->SetNumberOfLights(100);
    const Image expected = scene.GatherAll();
    if (!(expected.Mean() > 0.0))
    {
      continue;
    }
    std::printf("       %s: RMSE by finest level", scene.Name.c_str());
    int dark = 0;
    for (int level = 0; level <= coarsest; ++level)
    {
      scene.Splatting->SetFinestLevel(level);
      const Image image = scene.Splat();
      errors[level].push_back(Compare(image, expected, Least).RootMeanSquare);
      logarithm[level] += std::log(errors[level].back());
      std::printf(" %.2e", errors[level].back());
      CountLit(image, expected, scene.Copy("normal"), level, lit[level], dark);
    }
    std::printf("\n");
    CheckEqual(scene.Name + ": lit pixels without a value", dark, 0);
  }
  const double count = static_cast<double>(errors[0].size());
  CheckAtLeast("frames with indirect light", count, 13, "the test's own power");
  // Largest RMSE over the mean, of the median frame and of the worst frame.
  const double median[] = { 0.0, 0.03, 0.05, 0.1 };
  const double worst[] = { 0.0, 0.45, 0.8, 1.2 };
  for (int level = 1; level <= coarsest; ++level)
  {
    const std::string name = "finest subsplats of " + std::to_string(1 << level) + " pixels: ";
    CheckAtLeast(name + "pixels among lit pixels", lit[level], 100000, "the test's own power");
    CheckAtLeast(name + "RMSE over that of the level before, geometric mean",
      std::exp((logarithm[level] - logarithm[level - 1]) / count), 1.05,
      "the test's own power: it is another image");
    CheckAtMost(name + "RMSE over the mean, median frame", Percentile(errors[level], 0.5),
      median[level], "measured 0.023, 0.043, 0.078");
    CheckAtMost(name + "the same, worst frame", Percentile(errors[level], 1.0), worst[level],
      "measured 0.41, 0.74, 1.00, of frame 501");
  }
}

// While somebody drags, light is summed for blocks of 4 x 4 pixels; a still frame afterwards equals
// the still frame before.
VTK_INDIRECT_TEST(MovingFramesTakeBlocks)
{
  RandomFrame scene(503, { 289, 211 }, FrameLight::SPOT);
  scene.Sampler->SetNumberOfLights(100);
  const auto isFinest = [&scene](const std::string& level) {
    return scene.Pass->GetReport().find("\"FinestLevel\": \"" + level + "\"") != std::string::npos;
  };
  const Image expected = scene.GatherAll();
  const Image still = scene.Splat();
  Check("a still frame's finest level is the pixel", isFinest("full_resolution"));
  scene.GatherAll();
  scene.Window->SetDesiredUpdateRate(15.0);
  const Image moving = scene.Splat();
  Check("a moving frame's finest level is four pixels wide", isFinest("quarter_resolution"));
  const double error = Compare(still, expected, Least).RootMeanSquare;
  const double coarse = Compare(moving, expected, Least).RootMeanSquare;
  CheckAtLeast("RMSE of a moving frame over the still frame's", coarse / error, 1.2,
    "the test's own power: it is another image");
  CheckAtMost("RMSE over the mean of a moving frame", coarse, 0.1, "measured 0.060");
  scene.Window->SetDesiredUpdateRate(1e-4);
  CheckEqual("worst difference of the still frame that follows",
    Compare(scene.Splat(), still, Least).Worst, 0.0);
}

VTK_INDIRECT_TEST(NormalCorrection)
{
  Ball scene;
  const Image expected = scene.GatherAll();
  double error[2] = {};
  for (bool on : { false, true })
  {
    SET_DETAIL(scene.Splatting, NormalCorrection, on);
    error[on] = Compare(scene.Splat(), expected, Least).RootMeanSquare;
  }
  CheckAtLeast("without, RMSE over the mean", error[0], 1e-3, "the test's own power");
  CheckAtMost("with it, over that without", error[1] / error[0], 0.6,
    "what is left is of second order in the angle between normals");
}

VTK_INDIRECT_TEST(Lighting)
{
  // A wall close to a lit stripe: flat, so that geometry splits nothing.
  MultiresolutionScene scene(160, 120);
  scene.AddQuad({ -1, 0, 0 }, { -1, 0, 1 }, { 2, 0, 0 }, glm::dvec3(0.75));
  scene.AddQuad({ -1, 0.06, 0 }, { 2, 0.06, 0 }, { -1, 2.06, 0 }, glm::dvec3(0.5));
  scene.AddSpot({ 0.5, 0.5, 0.6 }, { 0.5, 0, 0.1 }, 12, 1, { 1, 0, 0 });
  scene.SetEye({ 0.5, 0.5, 2.6 }, { 0.5, 0.5, 0 }, { 0, 1, 0 }, 20, 0.5, 5);
  scene.Sampler->SetNumberOfLights(512);
  SET_DETAIL(scene.Splatting, CoarsestResolution, 16); // several levels in a small image
  const Image expected = scene.GatherAll();
  std::vector<double> errors;
  const double standard = DetailsOf(scene.Splatting).LightingThreshold;
  for (double threshold : { 0.0, 4.0 * standard, standard, 0.25 * standard })
  {
    SET_DETAIL(scene.Splatting, LightingThreshold, threshold);
    errors.push_back(Compare(scene.Splat(), expected, Least).RootMeanSquare);
    std::printf("       threshold %g: RMSE %.2e of the mean\n", threshold, errors.back());
  }
  CheckAtLeast("RMSE over the mean without", errors[0], 0.1, "the test's own power");
  CheckAtMost("default over none", errors[2] / errors[0], 0.02, "measured 0.012");
  CheckAtMost("the lowest over the default", errors[3] / errors[2], 0.9, "it splits more");
  CheckAtMost("the default over a higher one", errors[2] / errors[1], 1.0, "it splits more");

  // Splits beside a coarse subsplat must not leave it without neighbours for interpolation:
  // splitting would then increase the error (3 times).
  SET_DETAIL(scene.Splatting, CoarsestResolution, 64);
  SET_DETAIL(scene.Splatting, LightingThreshold, 0.0);
  const double none = Compare(scene.Splat(), expected, Least).RootMeanSquare;
  SET_DETAIL(scene.Splatting, LightingThreshold, standard);
  const double split = Compare(scene.Splat(), expected, Least).RootMeanSquare;
  CheckAtMost("default over none, from finer subsplats on", split / none, 0.25, "measured 0.14");
}

VTK_INDIRECT_TEST(NearLights)
{
  // A flat wall beside a floor with few virtual lights, each so near that its light on the wall is
  // narrower than the coarsest subsplats: probes there do not show its curvature. While the eye
  // turns, subsplats slide over the wall, and the error of interpolation flickers.
  MultiresolutionScene scene(256, 192);
  scene.AddQuad({ -1, 0, 0 }, { -1, 0, 1 }, { 2, 0, 0 }, glm::dvec3(0.75));
  scene.AddQuad({ -1, 0.06, 0 }, { 2, 0.06, 0 }, { -1, 2.06, 0 }, glm::dvec3(0.5));
  scene.AddSpot({ 0.5, 1.0, 0.3 }, { 0.5, 0, 0.1 }, 8, 1, { 1, 0, 0 });
  scene.Sampler->SetNumberOfLights(25);
  SET_DETAIL(scene.Splatting, HalfFloats, false);      // rounding flickers too
  SET_DETAIL(scene.Splatting, CoarsestResolution, 16); // several levels in a small image
  const std::vector<double> thresholds = { 0.0, DetailsOf(scene.Splatting).LightingThreshold };
  std::vector<Image> expected;
  std::vector<std::vector<Image>> shown(thresholds.size());
  for (int frame = 0; frame < 6; ++frame)
  {
    // Half a pixel a frame.
    scene.SetEye({ 0.5, 0.5, 2.6 }, { 0.5 + 0.002 * frame, 0.5, 0 }, { 0, 1, 0 }, 20, 0.5, 5);
    expected.push_back(scene.GatherAll());
    for (size_t i = 0; i < thresholds.size(); ++i)
    {
      SET_DETAIL(scene.Splatting, LightingThreshold, thresholds[i]);
      shown[i].push_back(scene.Splat());
    }
  }
  std::vector<double> errors;
  std::vector<double> flickers;
  for (size_t i = 0; i < thresholds.size(); ++i)
  {
    double flicker = 0.0;
    double error = 0.0;
    for (size_t frame = 0; frame < expected.size(); ++frame)
    {
      error = std::max(error, Compare(shown[i][frame], expected[frame], Least).RootMeanSquare);
      for (size_t k = 0; frame > 0 && k < expected[0].Values.size(); ++k)
      {
        const double now = shown[i][frame].Values[k] - expected[frame].Values[k];
        const double before = shown[i][frame - 1].Values[k] - expected[frame - 1].Values[k];
        flicker += std::abs(now - before);
      }
    }
    flicker /= (expected.size() - 1) * expected[0].Values.size() * expected[0].Mean();
    errors.push_back(error);
    flickers.push_back(flicker);
    std::printf("       threshold %g: RMSE %.2e of the mean, worst frame; flicker %.2e\n",
      thresholds[i], error, flicker);
  }
  CheckAtLeast("RMSE over the mean without", errors[0], 0.1, "the test's own power");
  CheckAtMost("RMSE, default over none", errors[1] / errors[0], 0.03,
    "measured 0.020; 0.044 by probes against each other alone");
  CheckAtLeast("flicker over the mean without", flickers[0], 4e-4, "the test's own power");
  CheckAtMost("flicker, default over none", flickers[1] / flickers[0], 0.11,
    "measured 0.078; 0.155 by probes against each other alone");
}

VTK_INDIRECT_TEST(Balance)
{
  // Neighbouring levels that differ by more than one make steps.
  double logarithm = 0.0;
  int differ = 0;
  int count = 0;
  for (int number = 0; number < 12; ++number)
  {
    RandomFrame scene(600 + number, { 191, 173 }, FrameLight::SPOT);
    scene.Sampler->SetNumberOfLights(64);
    SET_DETAIL(scene.Splatting, CoarsestResolution, 16);
    const Image expected = scene.GatherAll();
    if (!(expected.Mean() > 0.0))
    {
      continue;
    }
    const Image balanced = scene.Splat();
    SET_DETAIL(scene.Splatting, Balance, false);
    const Image loose = scene.Splat();
    logarithm += std::log(Compare(balanced, expected, Least).RootMeanSquare /
      Compare(loose, expected, Least).RootMeanSquare);
    ++count;
    differ += balanced.Values != loose.Values ? 1 : 0;
  }
  CheckAtLeast("frames in which it matters", differ, 8, "the test's own power");
  CheckAtMost("RMSE with balance over that without, geometric mean", std::exp(logarithm / count),
    0.7, "measured 0.41; it only splits what would not be");
}

VTK_INDIRECT_TEST(PointFormFactor)
{
  // Equation (1) of the paper, in doubles, where a floor meets a lit wall.
  MultiresolutionScene scene(120, 90);
  scene.AddQuad({ -1, 0, -1 }, { -1, 0, 1 }, { 1, 0, -1 }, { 0.5, 0.5, 0.5 });
  scene.AddQuad({ -1, 0, -1 }, { 1, 0, -1 }, { -1, 1, -1 }, { 0.75, 0.75, 0.5 });
  scene.AddSpot({ 0, 0.5, 1 }, { 0, 0.3, -1 }, 25, 1, { 1, 0, 0 });
  scene.SetEye({ 0, 1.2, 1.5 }, { 0, 0.1, -0.8 }, { 0, 1, 0 }, 40, 0.1, 5);
  scene.Sampler->SetNumberOfLights(64);
  scene.ScaleThresholds(0.0);
  const Image patch = scene.Splat();
  scene.Splatting->SetFormFactorToPoint();
  const Image image = scene.Splat();
  const std::vector<VirtualLight> lights = scene.CopyLights();
  const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
  double worst = 0.0;
  double brighter = 0.0;
  int lit = 0;
  for (size_t i = 0; i < receivers.size(); ++i)
  {
    double expected = 0.0;
    for (const VirtualLight& light : lights)
    {
      const glm::dvec3 d = light.Position - receivers[i].Position;
      const double r2 = glm::dot(d, d);
      const double cosines = std::max(0.0, -glm::dot(light.Normal, d)) *
        std::max(0.0, glm::dot(receivers[i].Normal, d)) / r2;
      expected += light.DensityArea.r * cosines / std::max(vtkMath::Pi() * r2, light.Area / 1024.0);
    }
    if (receivers[i].Lit && expected > 1e-2 * patch.Mean())
    {
      ++lit;
      worst = std::max(worst, std::abs(image.Values[3 * i] / expected - 1.0));
      brighter = std::max(brighter, image.Values[3 * i] / double(patch.Values[3 * i]));
    }
  }
  CheckAtLeast("lit receivers", lit, 4000, "the test's own power");
  CheckAtLeast("largest irradiance over that of patches", brighter, 1.5, "the test's own power");
  CheckAtMost("difference to the sum of points, worst", worst, 3e-3,
    "half floats, and positions of pixels in floats");
}

VTK_INDIRECT_TEST(SurfaceDetail)
{
  // Equation (2) of the paper, at every pixel.
  Ball scene;
  const Image plain = scene.Splat();
  scene.Splatting->SetSurfaceDetail(0.5);
  const Image detailed = scene.Splat();
  const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
  const glm::dvec3 eye(0.5, 0.2, 2.4);
  double worst = 0.0;
  double least = 1.0;
  for (size_t i = 0; i < receivers.size(); ++i)
  {
    const double irradiance = plain.Values[3 * i];
    if (receivers[i].Lit && irradiance > 1e-2 * plain.Mean())
    {
      const double cosine =
        std::max(0.0, glm::dot(glm::normalize(eye - receivers[i].Position), receivers[i].Normal));
      const double expected = 0.5 * cosine + 0.5;
      least = std::min(least, expected);
      worst = std::max(worst, std::abs(detailed.Values[3 * i] / irradiance - expected));
    }
  }
  CheckAtMost("smallest factor", least, 0.6, "the test's own power: grazing pixels");
  CheckAtMost("difference to alpha cos + 1 - alpha, worst", worst, 2e-3, "half floats, twice");
}
