// SPDX-License-Identifier: BSD-3-Clause
// Splats against the gather of the same lights at every pixel, and against sums in double
// precision.
//
// Tolerances are relative to a pixel's irradiance, or to a ten-thousandth of the brightest one:
// smaller irradiances come from senders in nearly the same plane, whose cosines are rounding.
#include "vtkIndirectSplattingScene.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkRenderWindow.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace vtkIndirectTest;

VTK_INDIRECT_TEST(AllIsGather)
{
  double worst[NumberOfSplatWays] = {};
  int lit = 0;
  constexpr int frames = 15;
  for (int number = 0; number < frames; ++number)
  {
    const FrameSize& size = GetFrameSizes()[number % GetFrameSizes().size()];
    SplattingFrame scene(number, size, static_cast<FrameLight>(number % NumberOfFrameLights));
    scene.Sampler->SetNumberOfLights(48 + number);
    scene.Pass->SetReflectiveShadowMapResolution(64);
    if (number % 3 == 2)
    {
      scene.SetParallelEye(0.6);
    }
    const Image expected = scene.GatherAll();
    scene.Splats->SetIntensityThreshold(0.0);
    for (int way = 0; way < NumberOfSplatWays; ++way)
    {
      const ImageError error =
        Compare(scene.SplatLights(static_cast<SplatWay>(way)), expected, Least);
      worst[way] = std::max(worst[way], error.Worst);
      lit += error.Mean > 0.0 ? 1 : 0;
      std::printf("       %s, %s: mean %.3g, worst %.2e\n", scene.Name.c_str(),
        GetName(static_cast<SplatWay>(way)), error.Mean, error.Worst);
    }
  }
  CheckAtLeast("share of frames with indirect light", lit / (1.0 * frames * NumberOfSplatWays),
    2.0 / 3.0, "the test's own power");
  for (int way = 0; way < NumberOfSplatWays; ++way)
  {
    CheckAtMost(std::string("worst relative difference, ") + GetName(static_cast<SplatWay>(way)),
      worst[way], 1e-5, "the order of sums");
  }
}

VTK_INDIRECT_TEST(CutOff)
{
  // Without the far field: the sum over the lights that exceed I_low at the receiver, in double
  // precision from the frame's lights and receivers.
  double worst = 0.0;
  WaysAgainstTiles ways;
  double share = 1.0;
  double shares = 0.0;
  int receivers = 0;
  for (int number = 0; number < 6; ++number)
  {
    SplattingFrame scene(100 + number, { 83, 61 }, static_cast<FrameLight>(number % 4));
    scene.Sampler->SetNumberOfLights(150);
    scene.Sampler->LitTexelsOff(); // few samples may miss lights that stand close together
    scene.Pass->SetReflectiveShadowMapResolution(64);
    if (number == 5)
    {
      scene.SetParallelEye(0.6);
    }
    scene.Splats->FarFieldOff();
    scene.Splats->SetIntensityThreshold(0.05);
    const Image image = scene.SplatLights(SplatWay::TILES);
    double measured = scene.ReadCutOffShare();
    ways.Add(scene, image, Least);
    const std::vector<VirtualLight> lights = scene.CopyLights();
    auto intensity = [](const VirtualLight& light)
    {
      return std::max({ light.DensityArea.x, light.DensityArea.y, light.DensityArea.z }) /
        3.14159265358979;
    };
    std::vector<double> intensities;
    for (const VirtualLight& light : lights)
    {
      intensities.push_back(intensity(light));
    }
    const double low = FindLowest(scene, intensities);
    double largest = 0.0;
    for (float value : image.Values)
    {
      largest = std::max(largest, static_cast<double>(value));
    }
    double cut = 0.0;
    double all = 0.0;
    std::vector<double> errors;
    for (const Scene::Receiver& r : scene.GetReceivers())
    {
      if (!r.Lit || lights.empty())
      {
        continue;
      }
      // Rounding decides on lights at the limit: they may count or not.
      glm::dvec3 sure(0.0);
      glm::dvec3 unsure(0.0);
      for (const VirtualLight& light : lights)
      {
        const glm::dvec3 toReceiver = r.Position - light.Position;
        const double d = glm::length(toReceiver);
        const double level =
          intensity(light) * std::max(glm::dot(light.Normal, toReceiver), 0.0) / (d * d * d * low);
        const glm::dvec3 e = Gather({ light }, r.Position, r.Normal);
        sure += level >= 1.001 ? e : glm::dvec3(0.0);
        unsure += level > 0.999 && level < 1.001 ? e : glm::dvec3(0.0);
        all += e.x;
        cut += level < 1.0 ? e.x : 0.0;
      }
      AddErrors(image.Color(r.X, r.Y), sure, unsure, Least * largest, errors);
      ++receivers;
    }
    if (!errors.empty() && all > 0.0)
    {
      worst = std::max(worst, Percentile(errors, 0.999));
      share = std::min(share, cut / all);
      shares = std::max(shares, std::abs(measured - cut / all));
      std::printf("       %s: cut off %.4f, measured at every 16th pixel %.4f, worst %.2e\n",
        scene.Name.c_str(), cut / all, measured, Percentile(errors, 0.999));
    }
  }
  CheckAtLeast("receivers", receivers, 5000, "the test's own power");
  CheckAtLeast("least share that is cut off", share, 0.02, "the test's own power");
  CheckAtMost("99.9th percentile of the relative error against double precision", worst, 1e-4,
    "rounding of floats, largest where walls meet");
  CheckAtMost("share that is said to be cut off, of 20 to 30 samples", shares, 0.1,
    "luminance against red, and few samples");
  ways.Check();
}
