// SPDX-License-Identifier: BSD-3-Clause
// Windows, views and maps of extreme shapes.
#include "vtkIndirectHardCase.h"

#include <algorithm>
#include <cstdio>
#include <string>

using namespace vtkIndirectTest;

namespace
{
void AddRoom(HardCase& scene)
{
  scene.AddCorner(Albedo);
  scene.AddSphere({ 0.6, 0.25, 0.5 }, 0.2, 48, Albedo);
  scene.AddSpot({ 0.613, 0.937, 0.713 }, { 0.357, 0, 0.411 }, 47, 1, { 0.2, 0, 1 });
}
}

// A window of one column sees the same as the middle column of a wider one.
VTK_INDIRECT_TEST(Windows)
{
  const int sizes[][2] = { { 1, 1 }, { 1, 2000 }, { 2000, 1 }, { 33, 2 }, { 2, 33 } };
  for (const auto& size : sizes)
  {
    const std::string name = std::to_string(size[0]) + " x " + std::to_string(size[1]);
    HardCase scene("a window of " + name, size[0], size[1]);
    AddRoom(scene);
    // The angle keeps the scene in view of a wide window: VTK's angle is the vertical one.
    const double angle = size[0] > 100 ? 0.02 : 32.0;
    scene.SetEye({ 2.2, 1.6, 2.3 }, { 0.4, 0.3, 0.4 }, { 0, 1, 0 }, angle, 0.5, 6);
    const Image truth = scene.CheckEstimators(1);
    CheckEqual("width of the buffers", truth.Width, size[0]);
    CheckEqual("height of the buffers", truth.Height, size[1]);
    CheckAtLeast("largest irradiance", GetLargest(truth), 1e-3, "the test's own power");
  }
  HardCase narrow("one column", 1, 31);
  AddRoom(narrow);
  const Image column = narrow.CheckEstimators(1);
  HardCase wide("31 columns", 31, 31);
  AddRoom(wide);
  const Image image = wide.CheckEstimators(1);
  Image middle = column;
  for (int y = 0; y < 31; ++y)
  {
    std::copy(image.At(15, y), image.At(15, y) + 3, &middle.Values[3 * y]);
  }
  CheckEqual("share of pixels in which one column is not the middle of 31",
    GetShareOfDifferent(column, middle, 1e-4), 0.0);
}

// The view's depth range does not matter if no surface is behind another within the depth buffer's
// step.
VTK_INDIRECT_TEST(DepthRange)
{
  Image expected;
  for (double ratio : { 10.0, 1e3, 1e6 })
  {
    char name[64];
    std::snprintf(name, sizeof(name), "a far plane %g times as far as the near one", ratio);
    HardCase scene(name);
    AddRoom(scene);
    scene.SetEye({ 2.2, 1.6, 2.3 }, { 0.4, 0.3, 0.4 }, { 0, 1, 0 }, 32, 6.0 / ratio, 6);
    const Image truth = scene.CheckEstimators(1);
    if (ratio == 10.0)
    {
      expected = truth;
      CheckAtLeast("mean irradiance", truth.Mean(), 1e-3, "the test's own power");
      continue;
    }
    // z^2 / near of a depth buffer of 24 bits or of floats just below one.
    const double step = 9.0 * ratio / 6.0 / 16777216.0;
    std::printf("       step of the depth buffer: %.2g of the scene\n", step);
    CheckAtMost("share of pixels that are not those of a short range",
      GetShareOfDifferent(truth, expected, 1e-4), ratio < 1e6 ? 1e-3 : 0.02,
      ratio < 1e6 ? "step of the depth buffer, 1e-4"
                  : "steps of 0.09: where the ball meets the floor, either may be drawn");
  }
}

VTK_INDIRECT_TEST(EmptyView)
{
  for (bool behind : { false, true })
  {
    HardCase scene(behind ? "a scene behind the eye" : "a scene beyond the far plane");
    AddRoom(scene);
    scene.SetEye({ 2.2, 1.6, 2.3 }, behind ? glm::dvec3(4.0, 2.9, 4.2) : glm::dvec3(0.4, 0.3, 0.4),
      { 0, 1, 0 }, 32, 0.1, behind ? 6 : 0.2);
    scene.CheckEstimators(1,
      [&](const EstimatorEntry&)
      {
        for (const char* name : { "final", "irradiance", "depth", "albedo" })
        {
          CheckEqual(std::string("largest value of ") + name, GetLargest(scene.Copy(name)), 0.0);
        }
        CheckAtLeast("largest density in the map", GetLargest(scene.Copy("rsm0.density")), 0.1,
          "maps do not depend on the view");
      });
  }
}

// Maps of one texel have possible positions and areas, and the right flux if one surface fills the
// texel.
VTK_INDIRECT_TEST(TinyMaps)
{
  for (int texels : { 1, 2, 3 })
  {
    HardCase room("a room, maps of " + std::to_string(texels) + " texels");
    AddRoom(room);
    room.AddPoint({ 0.3, 0.6, 0.8 }, { 0, 0, 1 });
    room.AddDirectional({ -0.4, -0.7, -0.5 });
    room.Pass->SetReflectiveShadowMapResolution(texels);
    room.CheckEstimators(3);

    HardCase floor(
      "a floor lit by a parallel light, maps of " + std::to_string(texels) + " texels");
    floor.AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, Albedo);
    floor.AddDirectional({ 0, -1, 0 });
    floor.Radiance = 0.75;
    floor.Pass->SetReflectiveShadowMapResolution(texels);
    floor.CheckEstimators(1,
      [&](const EstimatorEntry& estimator)
      {
        if (estimator.Sum == EstimatorEntry::ALL_TEXELS)
        {
          CheckRelative("reflected flux", floor.GetReflectedFlux().x, 0.75 * 1.01 * 1.01, 1e-3,
            "the map is 1 % wider than what it shows, and every texel's centre lies on the floor");
        }
      });
  }
}
