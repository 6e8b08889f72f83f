// SPDX-License-Identifier: BSD-3-Clause
// Splatting in hard cases and with other stages: the far field, eyes among splats, lights that
// touch, no light, depth maps, voxels, branches, specular receivers.
#include "vtkIndirectSplattingScene.h"

#include "Gather/vtkIndirectGlossyRoom.h"
#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkLightTreeSampler.h"
#include "vtkProperty.h"
#include "vtkRSMGatherPass.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkRenderWindow.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace vtkIndirectTest;

VTK_INDIRECT_TEST(FarFieldKeepsMean)
{
  double worst = 0.0;
  double without = 0.0;
  double least = 1e9;
  double rms[2] = {};
  int frames = 0;
  for (int number = 0; number < 6; ++number)
  {
    SplattingFrame scene(200 + number, { 160, 128 }, static_cast<FrameLight>(number % 4));
    scene.Sampler->SetNumberOfLights(200);
    scene.Pass->SetReflectiveShadowMapResolution(64);
    // Corresponds to the default of 8 in an image of twice the size.
    scene.Splats->SetFarFieldStep(4);
    const Image expected = scene.GatherAll();
    const double mean = Sum(expected);
    if (!(mean > 0.0))
    {
      continue;
    }
    ++frames;
    double last = 0.0;
    for (double threshold : { 0.001, 0.003, 0.01, 0.03, 0.1 })
    {
      scene.Splats->SetIntensityThreshold(threshold);
      scene.Splats->FarFieldOff();
      const double cut = 1.0 - Sum(scene.SplatLights(SplatWay::TILES)) / mean;
      scene.Splats->FarFieldOn();
      const Image image = scene.SplatLights(SplatWay::TILES);
      const double moved = Sum(image) / mean - 1.0;
      const ImageError error = Compare(image, expected, Least);
      std::printf("       %s, %g: cut off %.4f, mean %+.4f, RMSE %.4f\n", scene.Name.c_str(),
        threshold, cut, moved, error.RootMeanSquare);
      worst = std::max(worst, std::abs(moved));
      least = std::min(least, cut - last);
      last = cut;
      without = std::max(without, cut);
      rms[0] += threshold == 0.001 ? error.RootMeanSquare / 6.0 : 0.0;
      rms[1] += threshold == 0.1 ? error.RootMeanSquare / 6.0 : 0.0;
    }
  }
  CheckAtLeast("frames with indirect light", frames, 5, "the test's own power");
  CheckAtLeast("least change of what is cut off for a greater threshold", least, 0.0, "it grows");
  CheckAtLeast("largest share that is cut off", without, 0.7, "the test's own power");
  CheckAtMost("largest change of the mean with the far field, 0.001 to 0.1", worst, 0.01,
    "mean brightness may not depend on the threshold");
  CheckAtMost("mean RMSE over the mean with 0.001", rms[0], 0.02, "nearly all is in splats");
  CheckAtLeast("of which with 0.1 there is more", rms[1] - rms[0], 0.005, "it converges");
}

VTK_INDIRECT_TEST(WaysAmongSplats)
{
  // Eyes within splats, and splats behind eyes and around them; parallel eyes that see backwards.
  WaysAgainstTiles ways;
  int lit = 0;
  for (int number = 0; number < 8; ++number)
  {
    SplattingFrame scene(300 + number, { 90, 70 }, static_cast<FrameLight>(number % 4));
    SetEyeAmongSplats(scene, number);
    scene.Splats->SetFarField(number % 2 == 0);
    lit += ways.AddThresholds(scene, { 1e-4, 2e-3, 2e-2, 0.5 }, Least);
  }
  CheckAtLeast("frames with light, of 32", lit, 24, "the test's own power");
  ways.Check();
}

VTK_INDIRECT_TEST(ThousandLightsInAPixel)
{
  for (int way = 0; way < NumberOfSplatWays; ++way)
  {
    SplattingFrame scene(4, { 5, 5 }, FrameLight::POINT);
    scene.SetEye({ 300, 200, 300 }, { 0.4, 0.2, 0.4 }, { 0, 1, 0 }, 1.0, 1.0, 1e4);
    scene.Sampler->SetNumberOfLights(1000);
    const Image expected = scene.GatherAll();
    scene.Splats->SetIntensityThreshold(1e-3);
    const Image image = scene.SplatLights(static_cast<SplatWay>(way));
    const std::string name = GetName(static_cast<SplatWay>(way));
    CheckAtLeast(name + ": sum over the image", Sum(expected), 1e-3, "the test's own power");
    CheckRelative(name + ": the same by splats", Sum(image), Sum(expected), 0.05,
      "one sample of the far field for all surfaces of a pixel");
  }
}

VTK_INDIRECT_TEST(NothingIsSent)
{
  for (int way = 0; way < NumberOfSplatWays; ++way)
  {
    SplattingFrame scene(6, { 40, 30 }, FrameLight::SPOT);
    vtkActorCollection* actors = scene.Renderer->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor())
    {
      actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
    }
    const Image image = scene.SplatLights(static_cast<SplatWay>(way));
    CheckEqual(std::string(GetName(static_cast<SplatWay>(way))) + ": light of black surfaces",
      Sum(image), 0.0);
    Check("all of it finite", IsFinite(image));
    CheckEqual("what is cut off of nothing", scene.ReadCutOffShare(), 0.0);
  }
}

VTK_INDIRECT_TEST(AnyStrength)
{
  // The threshold scales with the lights, whatever their strength.
  SplattingFrame scene(7, { 61, 47 }, FrameLight::SPOT);
  scene.Sampler->SetNumberOfLights(100);
  const Image one = scene.SplatLights(SplatWay::TILES);
  for (double intensity : { 1e-12, 1e12 })
  {
    scene.SetIntensities(intensity);
    for (int way = 0; way < NumberOfSplatWays; ++way)
    {
      Image image = scene.SplatLights(static_cast<SplatWay>(way));
      for (float& value : image.Values)
      {
        value = static_cast<float>(value / intensity);
      }
      const std::string name = GetName(static_cast<SplatWay>(way));
      CheckAtMost(name + ": worst relative difference, scaled back",
        Compare(image, one, Least).Worst, 1e-4,
        "what is about to count differs by rounding, and counts for little there");
    }
  }
}

VTK_INDIRECT_TEST(BranchesAndVisibility)
{
  // With a threshold of zero the sums equal the gather's: of trees, and with depth maps and voxels.
  struct Case
  {
    const char* Name;
    bool Tree;
    void (vtkIndirectIlluminationPass::*Visibility)();
  };
  const Case cases[] = { { "tree", true, &vtkIndirectIlluminationPass::SetVisibilityToNone },
    { "voxels", false, &vtkIndirectIlluminationPass::SetVisibilityToVoxels },
    { "maps", false, &vtkIndirectIlluminationPass::SetVisibilityToMaps },
    { "tree and maps", true, &vtkIndirectIlluminationPass::SetVisibilityToMaps } };
  double open = 0.0;
  for (const Case& c : cases)
  {
    SplattingFrame scene(3, { 75, 59 }, FrameLight::SPOT);
    vtkNew<vtkLightTreeSampler> tree;
    tree->SetNumberOfLights(32);
    scene.Sampler->SetNumberOfLights(64);
    if (c.Tree)
    {
      scene.Pass->SetSampler(tree);
    }
    (scene.Pass.Get()->*c.Visibility)();
    const Image expected = scene.GatherAll();
    const std::string name = c.Name;
    CheckAtLeast(name + ": light", Sum(expected), 0.01, "the test's own power");
    open = std::string("tree") == c.Name ? Sum(expected) : open;
    for (int way = 0; way < NumberOfSplatWays; ++way)
    {
      const std::string what = name + ", " + GetName(static_cast<SplatWay>(way));
      scene.Splats->SetIntensityThreshold(0.0);
      const ImageError error =
        Compare(scene.SplatLights(static_cast<SplatWay>(way)), expected, Least);
      const bool isExempt =
        name == "tree and maps" && way == static_cast<int>(SplatWay::ELLIPSOIDS);
      CheckAtMost(what + ": pixels off from the gather, all counting", error.NumberOff,
        isExempt ? 2 : 0, "one of 32 lights at two pixels beside each other, of 4425");
      CheckAtMost(what + ": worst difference to the gather, all counting", error.Worst,
        isExempt ? 0.1 : 1e-5, "the order of sums; at the two pixels measured 0.083");
      scene.Splats->SetIntensityThreshold(0.02);
      const Image image = scene.SplatLights(static_cast<SplatWay>(way));
      CheckRelative(what + ": mean by default", Sum(image), Sum(expected), 0.02,
        "the far field's interpolation, in a small image");
    }
  }
}

VTK_INDIRECT_TEST(SpecularReceivers)
{
  GlossyRoom scene(72, 56, 0.7, 20.0);
  scene.Render();
  const Image expected = scene.Copy("glossy");
  vtkNew<vtkIndirectSplattingPass> splats;
  scene.Pass->SetEstimator(splats);
  scene.Render();
  CheckAtLeast("light in lobes", Sum(expected), 1e-3, "the test's own power");
  CheckAtMost("worst difference to the gather's",
    Compare(scene.Copy("glossy"), expected, Least).Worst, 1e-6, "the same kernel");
  splats->SpecularTransportOff();
  scene.Render();
  CheckEqual("light in lobes without SpecularTransport", Sum(scene.Copy("glossy")), 0.0);
}

VTK_INDIRECT_TEST(SpecularSenders)
{
  for (int way = 0; way < NumberOfSplatWays; ++way)
  {
    SplattingFrame scene(3, { 75, 59 }, FrameLight::SPOT);
    vtkActorCollection* actors = scene.Renderer->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor())
    {
      actor->GetProperty()->SetSpecular(0.6);
      actor->GetProperty()->SetSpecularPower(20.0);
    }
    scene.Sampler->SetNumberOfLights(100);
    const Image expected = scene.GatherAll();
    scene.Splats->SetIntensityThreshold(0.0);
    const std::string name = GetName(static_cast<SplatWay>(way));
    const Image image = scene.SplatLights(static_cast<SplatWay>(way));
    CheckAtMost(name + ": worst difference to the gather, all counting",
      Compare(image, expected, Least).Worst, 1e-5, "the order of sums");
    scene.Splats->SpecularTransportOff();
    const Image diffuse = scene.SplatLights(static_cast<SplatWay>(way));
    CheckAtLeast(name + ": share of the light that lobes bring", 1.0 - Sum(diffuse) / Sum(expected),
      0.05, "the test's own power");
    scene.Splats->SpecularTransportOn();
    scene.Splats->SetIntensityThreshold(0.02);
    CheckRelative(name + ": mean by default", Sum(scene.SplatLights(static_cast<SplatWay>(way))),
      Sum(expected), 0.02, "interpolation of the far field and of lobes, in a small image");
  }
}

VTK_INDIRECT_TEST(Overdraw)
{
  // Fewer splats for a higher threshold, never more than there are lights, and in tiles at least
  // those of the ellipsoids.
  SplattingFrame scene(3, { 96, 80 }, FrameLight::SPOT);
  scene.Sampler->SetNumberOfLights(120);
  double last = 1e9;
  for (double threshold : { 0.0, 2e-3, 2e-2, 0.2 })
  {
    scene.Splats->SetIntensityThreshold(threshold);
    double counts[NumberOfSplatWays];
    double most = 0.0;
    for (int way = 0; way < NumberOfSplatWays; ++way)
    {
      scene.SplatLights(static_cast<SplatWay>(way));
      const Image image = scene.Copy("splat.overdraw");
      counts[way] = 256.0 * image.Mean();
      for (float value : image.Values)
      {
        most = std::max(most, 256.0 * value);
      }
    }
    std::printf("       threshold %g: tiles %.2f, ellipsoids %.2f a pixel\n", threshold, counts[0],
      counts[1]);
    CheckAtMost("splats at a pixel", most, 120.0, "there are 120 lights");
    CheckAtMost("splats a pixel, of the threshold before", counts[1] / last, 1.0, "bounds shrink");
    last = counts[1];
  }
}
