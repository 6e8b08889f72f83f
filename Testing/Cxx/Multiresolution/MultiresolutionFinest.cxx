// SPDX-License-Identifier: BSD-3-Clause
// With thresholds of zero every subsplat is a pixel, and the result equals the gather at every
// pixel over the same lights.
//
// Tolerances are relative to a pixel's irradiance, or to a ten-thousandth of the brightest one:
// smaller irradiances come from senders in nearly the same plane, whose cosines are rounding.
#include "Sums/vtkIndirectSum.h"
#include "vtkIndirectDetails.h"
#include "vtkIndirectRandomFrame.h"

#include "vtkRSMGatherPass.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkRenderWindow.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace vtkIndirectTest;

namespace
{
constexpr double LeastOfFinest = 1e-4;
constexpr int Frames = 30;

void SetFinest(MultiresolutionScene& scene, bool half)
{
  // A zero for any one threshold of the geometry splits everything.
  scene.Splatting->SetPlaneThreshold(0.0);
  SET_DETAIL(scene.Splatting, HalfFloats, half);
}
}

VTK_INDIRECT_TEST(FinestIsGather)
{
  double worst[2] = {};
  int lit = 0;
  double fullest = 0.0;
  for (int number = 0; number < Frames; ++number)
  {
    const FrameSize& size = GetFrameSizes()[number % GetFrameSizes().size()];
    RandomFrame scene(number, size, static_cast<FrameLight>(number % NumberOfFrameLights));
    scene.Sampler->SetNumberOfLights(48 + number);
    scene.Pass->SetReflectiveShadowMapResolution(64);
    const Image expected = scene.GatherAll();
    const bool halves[] = { false, true };
    for (bool half : halves)
    {
      SetFinest(scene, half);
      if (number % 2)
      {
        scene.Splatting->SetPlaneThreshold(0.25);
        scene.Splatting->SetNormalThreshold(0.0);
      }
      const Image image = scene.Splat();
      // Below 2^-14 of the unit of storage, each component of half floats is a multiple of 2^-24.
      const double floor =
        half ? std::exp2(-13.0) * vtkIndirectSum::Get(scene.Splatting).GetIrradianceUnit() : 0.0;
      const ImageError error = Compare(image, expected, LeastOfFinest, floor);
      worst[half] = std::max(worst[half], error.Worst);
      lit += error.Mean > 0.0 ? 1 : 0;
      fullest = std::max(fullest, error.Mean);
      std::printf("       %s, %s floats: mean %.3g, worst %.2e\n", scene.Name.c_str(),
        half ? "half" : "32-bit", error.Mean, error.Worst);
    }
  }
  CheckAtLeast("frames with indirect light, of 60", lit, 50, "the test's own power");
  CheckAtLeast("brightest mean irradiance", fullest, 0.01, "the test's own power");
  CheckAtMost("worst relative difference, 32-bit floats", worst[0], 1e-5, "the order of sums");
  CheckAtMost("worst relative difference, half floats", worst[1], 1e-3,
    "a half float's last bit, 2^-10, which drivers may cut off");
}

VTK_INDIRECT_TEST(ManyLights)
{
  // A uniform block holds 1024 lights at most; the rest come from textures.
  for (int lights : { 255, 256, 257, 1023, 1024, 1025, 2500 })
  {
    RandomFrame scene(3, { 61, 47 }, FrameLight::SPOT);
    scene.Pass->SetReflectiveShadowMapResolution(128);
    scene.Sampler->SetNumberOfLights(lights);
    const Image expected = scene.GatherAll();
    CheckEqual("virtual lights", scene.ReadReport("virtual_lights"), lights);
    SetFinest(scene, false);
    const Image image = scene.Splat();
    const std::string what = std::to_string(lights) + " lights: ";
    CheckAtMost(what + "worst relative difference to the gather",
      Compare(image, expected, LeastOfFinest).Worst, 1e-5, "the order of sums");
    // The test can tell one light less.
    scene.Sampler->SetNumberOfLights(lights - 1);
    CheckAtLeast(what + "the same with one light less",
      Compare(image, scene.GatherAll(), LeastOfFinest).Worst, 1e-4, "the test's own power");
  }
}

VTK_INDIRECT_TEST(Views)
{
  // Tests lights and eyes one by one, also with the defaults: they differ in the number and
  // positions of the lights that count.
  for (int kind = 0; kind < NumberOfFrameLights; ++kind)
  {
    for (bool parallel : { false, true })
    {
      RandomFrame scene(11, { 83, 71 }, static_cast<FrameLight>(kind));
      if (parallel)
      {
        scene.SetParallelEye(0.6);
      }
      scene.Pass->SetReflectiveShadowMapResolution(96);
      scene.Sampler->SetNumberOfLights(200);
      const Image expected = scene.GatherAll();
      const std::string what = scene.Name + (parallel ? ", parallel eye: " : ": ");
      const ImageError coarse = Compare(scene.Splat(), expected, LeastOfFinest);
      SetFinest(scene, false);
      const ImageError fine = Compare(scene.Splat(), expected, LeastOfFinest);
      CheckAtLeast(what + "mean irradiance", fine.Mean, 1e-3, "the test's own power");
      CheckAtMost(
        what + "worst relative difference at the finest", fine.Worst, 1e-5, "the order of sums");
      CheckAtMost(what + "RMSE of the mean at the defaults", coarse.RootMeanSquare, 0.15,
        "measured 0.11, along the edges of a small image; see Multiresolution.Defaults");
      CheckAtLeast(
        what + "the same", coarse.RootMeanSquare, 1e-5, "the test's own power: it interpolates");
    }
  }
}

VTK_INDIRECT_TEST(Storage)
{
  double worst = 0.0;
  double least = 1.0;
  for (int number = 0; number < 12; ++number)
  {
    RandomFrame scene(200 + number, GetFrameSizes()[number % 4],
      static_cast<FrameLight>(number % NumberOfFrameLights));
    scene.Sampler->SetNumberOfLights(64);
    SET_DETAIL(scene.Splatting, HalfFloats, false);
    const Image exact = scene.Splat();
    SET_DETAIL(scene.Splatting, HalfFloats, true);
    const ImageError error = Compare(scene.Splat(), exact, 1e-3);
    // The mean is no measure for a frame with a bright spot in the dark.
    const double difference = error.RootMeanSquare * error.Mean / error.Power;
    std::printf("       %s: root mean square %.2e, worst pixel %.2e\n", scene.Name.c_str(),
      difference, error.Worst);
    worst = std::max(worst, difference);
    least = std::min(least, difference);
  }
  CheckAtMost("half floats against 32-bit ones, root mean square over that of the image", worst,
    1e-3, "2^-10 where drivers cut bits off, half of it on average, once a level that is passed");
  CheckAtLeast("the same, smallest", least, 1e-6, "the test's own power: they are not the same");
}

VTK_INDIRECT_TEST(Strength)
{
  for (const bool half : { false, true })
  {
    RandomFrame scene(5, { 64, 48 }, FrameLight::SEVERAL);
    SET_DETAIL(scene.Splatting, HalfFloats, half);
    scene.Sampler->SetNumberOfLights(128);
    scene.Sampler->LitTexelsOff(); // spreads light over more levels
    const Image unit = scene.Splat();
    for (double intensity : { 1e-12, 1e12 })
    {
      scene.SetIntensities(intensity);
      Image scaled = scene.Splat();
      scene.CheckBuffers(3);
      for (float& value : scaled.Values)
      {
        value = static_cast<float>(value / intensity);
      }
      char what[80];
      std::snprintf(what, sizeof(what), "strength %g, %s floats: worst relative difference",
        intensity, half ? "half" : "32-bit");
      CheckAtMost(what, Compare(scaled, unit, 1e-3).Worst, half ? 3e-3 : 3e-5,
        half ? "roundings of 2^-11 on each level" : "rounding");
    }
  }
}

VTK_INDIRECT_TEST(Bytes)
{
  RandomFrame scene(8, { 1024, 1024 }, FrameLight::SPOT);
  scene.Sampler->SetNumberOfLights(16);
  scene.Splat();
  // The uniform block has space for 1024 lights, whatever their number.
  const double constant = 1024 * 48 + 4096;
  const double pixels = 1024.0 * 1024.0;
  const double full =
    (static_cast<double>(vtkIndirectSum::Get(scene.Splatting).GetBytes()) - constant) / pixels;
  // Measured 31.9: 23.9, and the places of the pixels for a moving frame that follows.
  CheckAtMost("bytes a pixel in the default setting", full, 32.0, "the class's promise");
  CheckAtLeast("the same", full, 8.0, "the irradiance itself is half of that: it is counted");
  SET_DETAIL(scene.Splatting, HalfFloats, false);
  scene.Splat();
  CheckAtLeast("bytes a pixel with 32-bit floats, over those with half floats",
    static_cast<double>(vtkIndirectSum::Get(scene.Splatting).GetBytes()) / pixels / full, 1.3,
    "they are larger");
}
