// SPDX-License-Identifier: BSD-3-Clause
// Radiance hints' results from frame to frame.
#include "vtkIndirectHintScenes.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace vtkIndirectTest;

VTK_INDIRECT_TEST(HintsCaching)
{
  TwoRooms scene(true);
  scene.Pass->SetNumberOfBounces(2);
  scene.Render();
  auto updates = [&] { return static_cast<int>(scene.ReadReport("hint_updates")); };
  auto voxels = [&] { return static_cast<int>(scene.ReadReport("voxel_updates")); };
  CheckEqual("updates of the first frame", updates(), 1);
  CheckEqual("voxels of the first frame", voxels(), 1);
  scene.Render();
  CheckEqual("updates when nothing changed", updates(), 1);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const double estimates = scene.ReadReport("estimates");
  for (int i = 0; i < 3; ++i)
  {
    camera->Azimuth(3.0);
    scene.Render();
  }
  CheckEqual("updates when the camera moved", updates(), 1);
  CheckEqual("look-ups when the camera moved", scene.ReadReport("estimates") - estimates, 3);
  const Image kept = scene.Copy("irradiance");
  scene.Pass->CachingOff();
  scene.Render();
  CheckEqual("updates without caching", updates(), 2);
  const Image anew = scene.Copy("irradiance");
  CheckEqual("values that differ from those made anew",
    static_cast<double>(kept.Values.size()) - CountSame(kept, anew), 0);
  scene.Pass->CachingOn();
  scene.Render();
  const int before = updates();
  const int voxelsBefore = voxels();
  auto* light = vtkLight::SafeDownCast(scene.Renderer->GetLights()->GetItemAsObject(0));
  const double mean = scene.Copy("irradiance").Mean();
  light->SetIntensity(2.0);
  scene.Render();
  CheckEqual("updates when the light is stronger", updates(), before + 1);
  CheckRelative("light in the same frame", scene.Copy("irradiance").Mean(), 2.0 * mean, 1e-4,
    "linear in the light; rounding");
  light->SetPosition(0.5, 1.2, 1.5);
  scene.Render();
  CheckEqual("updates when the light moved", updates(), before + 2);
  CheckEqual("voxels when only lights changed", voxels(), voxelsBefore);
  auto* actor = vtkActor::SafeDownCast(scene.Renderer->GetActors()->GetLastActor());
  actor->SetPosition(0.02, 0.0, 0.0);
  scene.Render();
  CheckEqual("voxels when a wall moved", voxels(), voxelsBefore + 1);
}

VTK_INDIRECT_TEST(HintsTemporal)
{
  for (const double keep : { 0.5, 0.8 })
  {
    TwoRooms scene(true);
    auto set = [&](double intensity)
    {
      vtkLight::SafeDownCast(scene.Renderer->GetLights()->GetItemAsObject(0))
        ->SetIntensity(intensity);
    };
    set(3.0);
    scene.Render();
    const Image wanted = scene.Copy("irradiance");
    set(1.0);
    scene.Hints->SetTemporalSmoothing(keep);
    // A first look-up is not smoothed.
    scene.Pass->ReleaseGraphicsResources(scene.Window);
    scene.Render();
    const double first = scene.Copy("irradiance").Mean();
    set(3.0);
    scene.Render();
    const std::string what = "keep " + std::to_string(keep).substr(0, 3) + ": ";
    CheckRelative(what + "a share of the way in one frame", scene.Copy("irradiance").Mean(),
      (3.0 - 2.0 * keep) * first, 1e-3, "of 1 and 3; interpolation leaves some pixels out");
    // Equal frames cover the rest of the change, and then end.
    const int frames = static_cast<int>(std::ceil(std::log(1.0 / 4096.0) / std::log(keep)));
    double before = 0.0;
    for (int i = 1; i < frames; ++i)
    {
      scene.Render();
      const double mean = scene.Copy("irradiance").Mean();
      Check(
        what + "frame " + std::to_string(i) + " is brighter than the one before it", mean > before);
      before = mean;
    }
    CheckRelative(what + "last frame but one", before, wanted.Mean(), 1.0 / 4096.0,
      "2/3 of the way is left over after the first, times what " + std::to_string(frames) +
        " frames keep");
    scene.Render();
    CheckEqual(what + "values that differ from those without smoothing",
      static_cast<double>(wanted.Values.size()) - CountSame(wanted, scene.Copy("irradiance")), 0);
    const double estimates = scene.ReadReport("estimates");
    scene.Render();
    scene.Render();
    CheckEqual(what + "look-ups at rest", scene.ReadReport("estimates") - estimates, 0);
    // The next change is smoothed again from there.
    set(1.0);
    scene.Render();
    CheckRelative(what + "a share of the way back", scene.Copy("irradiance").Mean(),
      (1.0 + 2.0 * keep) * first, 1e-3, "as above");
  }
}

// Every pixel follows E = keep E_last + (1 - keep) E_now in each frame; without further changes it
// equals the unsmoothed value bit for bit after exactly the documented number of frames, and then
// nothing is computed.
VTK_INDIRECT_TEST(HintsTemporalSequence)
{
  struct Row
  {
    double Keep;
    int Frames; // documented
  };
  for (const Row& row : { Row{ 0.5, 12 }, Row{ 0.8, 38 }, Row{ 0.95, 163 } })
  {
    HintScene scene(24, 24);
    scene.AddBox({ 0, 0, 0 }, { 4, 3, 2 }, { 0.8, 0.4, 0.2 });
    vtkLight* light = scene.AddPoint({ 1.0, 1.0, 1.7 }, { 0.0, 0.0, 1.0 });
    scene.SetEye({ 0.2, 0.2, 1.8 }, { 3.0, 2.5, 0.2 }, { 0, 0, 1 }, 70.0, 0.05, 10.0);
    scene.Pass->SetReflectiveShadowMapResolution(32);
    scene.SetGrid(4);
    scene.Hints->SetInterpolationStep(1); // every pixel is looked up, and smoothed
    const std::vector<double> intensities = { 1.0, 3.0, 2.0, 0.25, 4.0 };
    std::vector<Image> unsmoothed;
    for (double intensity : intensities)
    {
      light->SetIntensity(intensity);
      scene.Render();
      unsmoothed.push_back(scene.Copy("irradiance"));
    }
    CheckAtLeast("light", unsmoothed[0].Mean(), 1e-3, "the test's own power");
    scene.Hints->SetTemporalSmoothing(row.Keep);
    scene.Pass->ReleaseGraphicsResources(scene.Window);

    const std::string what = "keep " + std::to_string(row.Keep).substr(0, 4) + ": ";
    const Image& wanted = unsmoothed.back();
    std::vector<double> expected(wanted.Values.begin(), wanted.Values.end());
    double worst = 0.0;
    auto follow = [&](const Image& now, bool first)
    {
      const Image shown = scene.Copy("irradiance");
      for (size_t i = 0; i < expected.size(); ++i)
      {
        expected[i] =
          first ? now.Values[i] : row.Keep * expected[i] + (1.0 - row.Keep) * now.Values[i];
        // Over the largest value in the sum: four times that at one.
        const double scale = 4.0 * std::max(unsmoothed[0].Values[i], 1e-30f);
        worst = std::max(worst, std::abs(shown.Values[i] - expected[i]) / scale);
      }
      return shown;
    };
    for (size_t i = 0; i < intensities.size(); ++i)
    {
      light->SetIntensity(intensities[i]);
      scene.Render();
      follow(unsmoothed[i], i == 0);
    }
    Image shown;
    for (int frame = 1; frame < row.Frames; ++frame)
    {
      scene.Render();
      shown = follow(wanted, false);
    }
    CheckAtMost(what + "worst difference to the closed form, over the brightest", worst,
      2.0 * std::exp2(-23.0) / (1.0 - row.Keep), "two roundings a frame, a geometric series");
    CheckAtLeast(what + "values that are not yet the unsmoothed ones, one frame before the last",
      static_cast<double>(wanted.Values.size()) - CountSame(wanted, shown), 1, "still smoothed");
    scene.Render();
    CheckEqual(what + "values that differ from the unsmoothed ones after " +
        std::to_string(row.Frames) + " equal frames",
      static_cast<double>(wanted.Values.size()) - CountSame(wanted, scene.Copy("irradiance")), 0);
    const vtkIdType estimates = scene.ReadReport("estimates");
    const vtkIdType updates = scene.ReadReport("hint_updates");
    for (int i = 0; i < 5; ++i)
    {
      scene.Render();
    }
    CheckEqual(what + "look-ups at rest", scene.ReadReport("estimates") - estimates, 0);
    CheckEqual(what + "hints updated at rest", scene.ReadReport("hint_updates") - updates, 0);
    CheckEqual(what + "values that differ at rest",
      static_cast<double>(wanted.Values.size()) - CountSame(wanted, scene.Copy("irradiance")), 0);
  }
}
