// SPDX-License-Identifier: BSD-3-Clause
// Evenly spread lights on texels that send light: their sum, their positions, and their small
// jumps.
#include "vtkIndirectTestUtilities.h"

#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkRSMGatherPass.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
int CountUnlit(const std::vector<VirtualLight>& lights)
{
  int dark = 0;
  for (const VirtualLight& light : lights)
  {
    dark += light.DensityArea.x > 0.0 ? 0 : 1;
  }
  return dark;
}

glm::dvec3 SumLight(const std::vector<VirtualLight>& lights)
{
  glm::dvec3 sum(0.0);
  for (const VirtualLight& light : lights)
  {
    sum += light.DensityArea;
  }
  return sum;
}

struct MapScene : Scene
{
  MapScene()
    : Scene(24, 18)
  {
    this->Pass->SetVisibility(vtkIndirectIlluminationPass::NONE);
    this->Gather->InterpolationOff();
    this->SetEye({ 0, -6, 4 }, { 0, 0, 0 }, { 0, 0, 1 }, 40, 0.5, 20);
  }
  std::vector<VirtualLight> Draw(bool all)
  {
    all ? this->Gather->SetModeToAllTexels() : this->Gather->SetModeToVirtualLights();
    this->Render();
    return this->CopyLights();
  }
};
}

// Each texel of a plane under parallel light sends the same: the sum over any number of lights is
// exactly that of all texels.
VTK_INDIRECT_TEST(LitTexelsSumExactly)
{
  MapScene scene;
  scene.AddQuad({ -2, -2, 0 }, { 2, -2, 0 }, { -2, 2, 0 }, { 0.8, 0.4, 0.2 });
  // Black: in the maps, but not a sender.
  scene.AddBox({ 1.0, 1.0, 0.5 }, { 1.9, 1.9, 1.5 }, { 0, 0, 0 });
  scene.AddDirectional({ 0.8, 0.3, -0.4 });
  for (const int resolution : { 3, 64, 100, 256, 600 })
  {
    scene.Pass->SetReflectiveShadowMapResolution(resolution);
    // In a map of more than 256 texels one texel represents several.
    const glm::dvec3 all = resolution <= 256 ? SumLight(scene.Draw(true)) : glm::dvec3(0.0);
    for (const int pattern : { 0, 1, 2 })
    {
      for (const int count : { 1, 7, 64, 1000 })
      {
        scene.Sampler->SetPattern(pattern);
        scene.Sampler->SetNumberOfLights(count);
        const std::vector<VirtualLight> lights = scene.Draw(false);
        const std::string what = std::to_string(resolution) + " texels, pattern " +
          std::to_string(pattern) + ", " + std::to_string(count) + " lights: ";
        CheckEqual(what + "lights without light", CountUnlit(lights), 0);
        if (resolution <= 256)
        {
          CheckRelative(what + "sum", SumLight(lights).x, all.x, 2e-6 + 1e-4 * (resolution == 3),
            "rounding of weights; of half floats where one texel is a plane's edge");
        }
      }
    }
  }
}

// With different texels the sum converges with the number of lights.
VTK_INDIRECT_TEST(LitTexelsConverge)
{
  for (const bool point : { false, true })
  {
    MapScene scene;
    scene.AddSphere({ 0.3, 0.2, 0.4 }, 0.5, 48, { 0.8, 0.6, 0.4 });
    scene.AddQuad({ -1, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 }, { 0.7, 0.5, 0.2 });
    point ? scene.AddPoint({ -1.5, 0.5, 1.0 }, { 0, 0, 1 })
          : scene.AddSpot({ -1.5, 0.5, 2.0 }, { 1.5, 0, 0 }, 50.0, 2.0, { 0, 0, 1 });
    // Inside of the sphere around all casters the map of the point light has faces.
    point ? (void)scene.AddBox({ -3, -3, 3 }, { -2.5, -2.5, 3.2 }, { 0, 0, 0 }) : (void)0;
    scene.Pass->SetReflectiveShadowMapResolution(128);
    const std::vector<VirtualLight> texels = scene.Draw(true);
    const double all = SumLight(texels).x;
    const double dark =
      static_cast<double>(CountUnlit(texels)) / static_cast<double>(texels.size());
    const std::string what = point ? "point light: " : "spot: ";
    CheckAtLeast(what + "share of dark texels", dark, 0.5, "the test's own power");
    for (const int count : { 64, 256, 4096 })
    {
      scene.Sampler->SetNumberOfLights(count);
      const std::vector<VirtualLight> lights = scene.Draw(false);
      CheckEqual(what + std::to_string(count) + " lights without light", CountUnlit(lights), 0);
      CheckRelative(what + std::to_string(count) + " lights, sum over that of all texels",
        SumLight(lights).x, all, count < 4096 ? 0.05 : 5e-3,
        "stratified samples of what varies by half; measured 0.02, 0.005, 0.001");
    }
    scene.Sampler->LitTexelsOff();
    scene.Sampler->SetNumberOfLights(256);
    CheckAtLeast(what + "over whole maps: lights without light", CountUnlit(scene.Draw(false)), 100,
      "the test's own power");
  }
}

// A light without lit surfaces has rows without light; others keep theirs.
VTK_INDIRECT_TEST(LitTexelsNothingLit)
{
  MapScene scene;
  scene.AddQuad({ -2, -2, 0 }, { 2, -2, 0 }, { -2, 2, 0 }, { 0.5, 0.5, 0.5 });
  scene.AddBox({ 5, 5, 0.2 }, { 6, 6, 1.2 }, { 0, 0, 0 });
  scene.AddSpot({ 5.5, 5.5, 4.0 }, { 5.5, 5.5, 0.0 }, 5.0, 0.0, { 1, 0, 0 });
  scene.AddDirectional({ 0, 0, -1 });
  scene.Pass->SetReflectiveShadowMapResolution(64);
  const double all = SumLight(scene.Draw(true)).x;
  scene.Sampler->SetNumberOfLights(128);
  const std::vector<VirtualLight> lights = scene.Draw(false);
  CheckEqual("lights", static_cast<double>(lights.size()), 128);
  CheckEqual("lights without light", CountUnlit(lights), 64);
  CheckRelative("sum", SumLight(lights).x, all, 1e-5, "rounding");
  scene.CheckBuffers(2);
  for (const double intensity : { 1e-9, 1e6 })
  {
    scene.SetIntensities(intensity);
    CheckRelative("sum at " + std::to_string(intensity), SumLight(scene.Draw(false)).x,
      intensity * all, 1e-5, "rounding");
  }
}

// While a light that fills a small part of its map moves, the irradiance changes about as much as
// with all texels.
VTK_INDIRECT_TEST(LitTexelsDoNotJump)
{
  MapScene scene;
  scene.AddSphere({ 0.0, 0.0, 0.5 }, 0.5, 48, { 0.8, 0.6, 0.4 });
  scene.AddQuad({ -1, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 }, { 0.7, 0.5, 0.2 });
  vtkLight* light = scene.AddSpot({ -1.5, 0.5, 2.0 }, { 1.5, 0, 0 }, 50.0, 1.0, { 1, 0, 0 });
  scene.Pass->SetReflectiveShadowMapResolution(128);
  auto follow = [&](bool all, bool lit)
  {
    all ? scene.Gather->SetModeToAllTexels() : scene.Gather->SetModeToVirtualLights();
    scene.Sampler->SetLitTexels(lit);
    Image last;
    double squares = 0.0;
    for (int frame = 0; frame < 10; ++frame)
    {
      light->SetPosition(-1.5 + 0.01 * frame, 0.5 + 0.004 * frame, 2.0);
      scene.Render();
      const Image image = scene.Copy("irradiance");
      for (size_t i = 0; i < last.Values.size(); ++i)
      {
        squares += std::pow(static_cast<double>(image.Values[i]) - last.Values[i], 2.0);
      }
      last = image;
    }
    return std::sqrt(squares);
  };
  const double truth = follow(true, true);
  CheckAtLeast("all texels: change", truth, 1e-3, "the test's own power");
  const double lit = follow(false, true) / truth;
  CheckAtMost("change over that of all texels", lit, 3.0,
    "of a small part of a map one light is much; measured 2.5");
  CheckAtLeast("spread over the whole map: over that", follow(false, false) / truth / lit, 1.2,
    "lights there come and go at borders; measured 1.4");
}

// With AmbientOcclusion lights of a plane send nothing, those of a corner some, and none more than
// without.
VTK_INDIRECT_TEST(LitTexelsAmbientOcclusion)
{
  for (const bool corner : { false, true })
  {
    MapScene scene;
    scene.AddQuad({ -2, -2, 0 }, { 2, -2, 0 }, { -2, 2, 0 }, { 0.8, 0.4, 0.2 });
    corner ? (void)scene.AddQuad({ -2, 2, 0 }, { 2, 2, 0 }, { -2, 2, 3 }, { 0.8, 0.4, 0.2 })
           : (void)0;
    scene.AddPoint({ 0, -1, 2 }, { 1, 0, 0 });
    scene.Pass->SetReflectiveShadowMapResolution(64);
    const std::vector<VirtualLight> plain = scene.Draw(false);
    scene.Sampler->AmbientOcclusionOn();
    const std::vector<VirtualLight> modulated = scene.Draw(false);
    int more = 0;
    double nearest = 0.0;
    double farthest = 0.0;
    for (size_t i = 0; i < plain.size(); ++i)
    {
      more += modulated[i].DensityArea.x > plain[i].DensityArea.x ? 1 : 0;
      const double share = modulated[i].DensityArea.x / plain[i].DensityArea.x;
      const bool inCorner = plain[i].Position.y > 1.8 && plain[i].Position.z < 0.01;
      nearest = inCorner ? std::max(nearest, share) : nearest;
      farthest = plain[i].Position.y < 1.0 ? std::max(farthest, share) : farthest;
    }
    const std::string what = corner ? "corner: " : "plane: ";
    CheckEqual(what + "lights with more light than without", more, 0);
    CheckAtMost(what + "share that is left of lights on the open floor", farthest, 1e-3,
      "depths of half a texel");
    if (corner)
    {
      CheckAtLeast(what + "share that is left of a light in the corner", nearest, 0.1,
        "half of the hemisphere is hidden");
    }
  }
}
