// SPDX-License-Identifier: BSD-3-Clause
// Reflection of the sky's light by surfaces, against quadrature, a closed form, and the same light
// as a vtkLight.
#include "vtkIndirectTestUtilities.h"

#include "Emitters/vtkIndirectEmitterAccess.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkEnvironmentLight.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkNew.h"
#include "vtkRSMGatherPass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace vtkIndirectTest;

namespace
{
const glm::dvec3 BounceAlbedo(0.8, 0.4, 0.2);
using Polygon = std::vector<glm::dvec3>;

// A scene lit only by a sky.
struct SkyBounceScene : Scene
{
  vtkNew<vtkEnvironmentLight> Sky;

  SkyBounceScene(int width, int height)
    : Scene(width, height)
  {
    this->Pass->SetEnvironment(this->Sky);
  }
};

void CompareBounce(Scene& scene, const std::string& name,
  const std::function<bool(const Scene::Receiver&)>& counts,
  const std::function<double(const Scene::Receiver&)>& expect, const LightTolerance& tolerance)
{
  CompareLight(scene, "bounce", counts, expect, tolerance, name);
}

// A sender on a surface with known irradiance from the sky.
struct Patch
{
  glm::dvec3 Position;
  double Light; // density times area
};

double SumPatches(
  const std::vector<Patch>& patches, const glm::dvec3& normal, const Scene::Receiver& receiver)
{
  double sum = 0.0;
  for (const Patch& patch : patches)
  {
    const glm::dvec3 d = patch.Position - receiver.Position;
    const double r2 = glm::dot(d, d);
    sum += patch.Light * std::max(glm::dot(d, receiver.Normal), 0.0) *
      std::max(-glm::dot(d, normal), 0.0) / (vtkMath::Pi() * r2 * r2);
  }
  return sum;
}

void AddRoom(Scene& scene)
{
  scene.AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, BounceAlbedo);
  scene.AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.3, 0.6, 0.9 });
  scene.AddBox({ 0.6, 0.0, 0.2 }, { 0.9, 0.5, 0.5 }, { 0.9, 0.9, 0.3 });
  scene.SetEye({ 2.2, 1.6, 2.3 }, { 0.4, 0.3, 0.4 }, { 0, 1, 0 }, 36, 0.5, 6);
}
}

// Two squares that meet at a right angle, opening upward, see only each other and the sky.
VTK_INDIRECT_TEST(SkyBouncesInAGroove)
{
  const double s = std::sqrt(0.5);
  const Polygon right = { { s, s, -1 }, { s, s, 1 }, { 0, 0, 1 }, { 0, 0, -1 } };
  const glm::dvec3 leftNormal(s, s, 0.0);
  SkyBounceScene scene(96, 96);
  scene.AddQuad({ -s, s, 1 }, { 0, 0, 1 }, { -s, s, -1 }, BounceAlbedo);
  scene.AddQuad({ 0, 0, 1 }, { s, s, 1 }, { 0, 0, -1 }, BounceAlbedo);
  scene.SetEye({ 0, 5, 0.01 }, { 0, 0, 0 }, { 0, 0, -1 }, 16, 0.1, 10);
  scene.Sky->SetRadiance(2.0, 1.0, 0.5);

  constexpr int rows = 96;
  std::vector<Patch> patches;
  for (int i = 0; i < rows; ++i)
  {
    for (int j = 0; j < 2 * rows; ++j)
    {
      const double u = (i + 0.5) / rows;
      const glm::dvec3 p(-s * u, s * u, (j + 0.5) / rows - 1.0);
      const double irradiance = 2.0 * (1.0 - PolygonFormFactor(p, leftNormal, right));
      patches.push_back({ p, BounceAlbedo.x * irradiance / rows / rows });
    }
  }
  auto counts = [](const Scene::Receiver& r) { return r.Position.x > 0.07; };
  auto expect = [&](const Scene::Receiver& r) { return SumPatches(patches, leftNormal, r); };
  CompareBounce(scene, "all texels", counts, expect,
    { 0.01, 0.015, "32 directions, each hard; maps of 64 texels" });
  scene.Gather->SetModeToVirtualLights();
  CompareBounce(
    scene, "256 lights", counts, expect, { 0.02, 0.03, "kernel of disks, nearest to the edge" });
  CheckEqual("lights", scene.ReadReport("virtual_lights"), 256);
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  scene.Pass->SetEstimator(splatting);
  CompareBounce(
    scene, "multiresolution", counts, expect, { 0.02, 0.03, "the same lights, and interpolation" });
  vtkNew<vtkRadianceHintsPass> hints;
  scene.Pass->SetEstimator(hints);
  CompareBounce(scene, "hints", counts, expect,
    { 0.2, 0.25, "harmonics of order 2 at hints of a grid, through which the groove's edge runs" });
  scene.Pass->SetEstimator(nullptr);
}

// The form factor between any two points of a sphere is constant: in a hemispherical pit under a
// uniform sky every point sees half of the sky, and half of the pit.
VTK_INDIRECT_TEST(SkyBouncesInAPit)
{
  SkyBounceScene scene(64, 64);
  vtkNew<vtkSphereSource> pit;
  pit->SetRadius(1.0);
  pit->SetThetaResolution(96);
  pit->SetPhiResolution(49);
  pit->SetStartPhi(90.0);
  pit->SetEndPhi(180.0);
  scene.AddSource(pit, BounceAlbedo);
  scene.SetEye({ 0, 0, 5 }, { 0, 0, 0 }, { 0, 1, 0 }, 22, 0.1, 10);
  scene.Sky->SetRadiance(2.0, 1.0, 0.5);
  auto counts = [](const Scene::Receiver& r)
  { return r.Position.z < -0.05 && glm::dot(r.Position, r.Normal) < 0.0; };
  auto expect = [](const Scene::Receiver&) { return BounceAlbedo.x * 2.0 / 4.0; };
  CompareBounce(scene, "all texels", counts, expect,
    { 0.02, 0.03, "32 directions, each hard; maps of 64 texels" });
  scene.Gather->SetModeToVirtualLights();
  // All lights are inside. Disks are low by ln(1 + n) / n, with n = 512 for a whole sphere; here
  // this affects half as much light.
  CompareBounce(scene, "256 lights", counts, expect,
    { 0.02 + 2.0 * std::log(513.0) / 512.0, 0.06, "kernel of disks; maps as above" });
  const Image bounce = scene.Copy("bounce");
  CheckRelative("green", bounce.Mean(1), bounce.Mean(0) / 4.0, 1e-3, "albedo in half floats");
  CheckRelative("irradiance is the sum", scene.Copy("irradiance").Mean(),
    scene.Copy("sky").Mean() + bounce.Mean(), 1e-5, "rounding");
}

// A sky with all its light from one direction is a directional light.
VTK_INDIRECT_TEST(SkyBouncesOfASun)
{
  constexpr int columns = 512;
  constexpr int rows = 256;
  vtkNew<vtkImageData> image;
  image->SetDimensions(columns, rows, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  auto* pixels = static_cast<float*>(image->GetScalarPointer());
  std::fill(pixels, pixels + 3 * columns * rows, 0.0f);
  const double pi = vtkMath::Pi();
  // Above, and between the directions of the sky.
  pixels[3 * (178 * columns + 105)] = 1e5f;

  Image images[2];
  for (const bool sky : { true, false })
  {
    Scene scene(64, 48);
    AddRoom(scene);
    scene.Pass->SetReflectiveShadowMapResolution(128);
    vtkNew<vtkEnvironmentLight> environment;
    environment->SetImage(image);
    if (sky)
    {
      scene.Pass->SetEnvironment(environment);
    }
    else
    {
      double strength = 0.0;
      glm::dvec3 from(0.0);
      for (const vtkIndirectEmitterAccess::Cell& cell :
        vtkIndirectEmitterAccess::GetCells(environment))
      {
        strength += cell.Light[0] / pi;
        from += cell.Light[0] * glm::dvec3(cell.Direction[0], cell.Direction[1], cell.Direction[2]);
      }
      scene.AddDirectional(-glm::normalize(from))->SetColor(1.0, 0.0, 0.0);
      scene.SetIntensities(strength);
    }
    scene.Render();
    images[sky] = scene.Copy("bounce");
    CheckEqual("maps", scene.ReadReport("faces_drawn"), 1);
  }
  CheckRelative("mean of a sun of the sky and of a light", images[1].Mean(), images[0].Mean(), 1e-4,
    "the same map; directions of lights are floats");
  double worst = 0.0;
  for (size_t i = 0; i < images[0].Values.size(); ++i)
  {
    worst = std::max(worst, std::abs(double(images[1].Values[i]) - images[0].Values[i]));
  }
  CheckAtMost("worst difference over the mean", worst / images[0].Mean(), 0.01,
    "single texels of the map's outlines");
}

// The reflected light of lights and that of the sky add up, whichever has the maps.
VTK_INDIRECT_TEST(SkyBouncesBesideLights)
{
  enum
  {
    Spot,
    Headlight,
    NumberOfKinds
  };
  for (int kind = 0; kind < NumberOfKinds; ++kind)
  {
    for (const bool maps : { false, true })
    {
      Image images[3]; // the sky's, the light's, both
      for (int which = 0; which < 3; ++which)
      {
        SkyBounceScene scene(64, 48);
        AddRoom(scene);
        scene.Gather->SetModeToVirtualLights();
        scene.Pass->SetVisibility(
          maps ? vtkIndirectIlluminationPass::MAPS : vtkIndirectIlluminationPass::NONE);
        scene.Pass->SetReflectiveShadowMapResolution(64);
        vtkLight* light = scene.AddSpot({ 1, 2, 1 }, { 0.4, 0, 0.4 }, 40, 1, { 1, 0, 0 });
        if (kind == Headlight)
        {
          light->SetLightTypeToHeadlight();
          light->SetPositional(false);
        }
        light->SetSwitch(which != 0);
        if (which == 1)
        {
          scene.Pass->SetEnvironment(nullptr);
        }
        scene.Render();
        images[which] = scene.Copy("bounce");
        Check("there is a bounce", images[which].Mean() > 1e-3);
        CheckEqual("lights", scene.ReadReport("virtual_lights"), which == 2 ? 512 : 256);
        scene.CheckBuffers(which > 0 && kind == Spot ? 1 : 0);
      }
      Image sum = images[0];
      for (size_t i = 0; i < sum.Values.size(); ++i)
      {
        sum.Values[i] += images[1].Values[i];
      }
      double worst = 0.0;
      size_t others = 0;
      for (size_t i = 0; i < sum.Values.size(); ++i)
      {
        const double difference =
          std::abs(double(sum.Values[i]) - images[2].Values[i]) / sum.Mean();
        worst = std::max(worst, difference);
        others += difference > 1e-4 ? 1 : 0;
      }
      CheckAtMost("worst difference of the sum over its mean", worst, maps ? 0.03 : 1e-4,
        maps ? "one of 256 lights, several times as bright as usual"
             : "the order of a sum of floats");
      CheckAtMost("values that differ by more than 1e-4", static_cast<double>(others),
        maps ? 12.0 : 0.0, "on the border of two texels of a depth map rounding decides");
    }
  }
}

VTK_INDIRECT_TEST(SkyBouncesAreKept)
{
  SkyBounceScene scene(48, 36);
  AddRoom(scene);
  vtkActor* ball = scene.AddSphere({ 0.4, 0.2, 0.7 }, 0.1, 24, BounceAlbedo);
  scene.Gather->SetModeToVirtualLights();
  scene.Pass->SetVisibilityToMaps();
  scene.Render();
  const double faces = scene.ReadReport("faces_drawn");
  const double tiles = scene.ReadReport("tiles_drawn");
  Check("a map for each group of directions", faces >= 16 && faces <= 64);
  const Image before = scene.Copy("bounce");
  scene.Renderer->GetActiveCamera()->Azimuth(3.0);
  scene.Render();
  CheckEqual("a turned camera draws no map", scene.ReadReport("faces_drawn"), faces);
  CheckEqual("nor a tile", scene.ReadReport("tiles_drawn"), tiles);
  scene.Renderer->GetActiveCamera()->Azimuth(-3.0);

  scene.Sky->SetRadiance(3.0, 3.0, 3.0);
  scene.Render();
  CheckEqual("nor does another radiance", scene.ReadReport("faces_drawn"), faces);
  CheckEqual("which moves no light", scene.ReadReport("tiles_drawn"), tiles);
  CheckRelative("but is three times as bright", scene.Copy("bounce").Mean(), 3.0 * before.Mean(),
    1e-4, "rounding; the camera is back but for that");
  const double estimates = scene.ReadReport("estimates");
  scene.Render();
  CheckEqual("nothing has changed", scene.ReadReport("estimates"), estimates);

  // A sky with a dark half, which turns.
  vtkNew<vtkImageData> image;
  image->SetDimensions(1, 2, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* pixels = static_cast<float*>(image->GetScalarPointer());
  pixels[0] = 0.0f;
  pixels[1] = 1.0f;
  scene.Sky->SetImage(image);
  scene.Render();
  const double above = scene.Copy("bounce").Mean();
  scene.Sky->SetUp(0.0, -1.0, 0.0);
  scene.Render();
  const double below = scene.Copy("bounce").Mean();
  scene.Sky->SetUp(0.0, 1.0, 0.0);
  scene.Render();
  CheckEqual("nor does a sky that turns", scene.ReadReport("faces_drawn"), faces);
  CheckEqual("and it is as it was", scene.Copy("bounce").Mean(), above);
  CheckAtMost("light from below reaches little of the room", below, 0.2 * above,
    "the open sides of the box and walls");

  ball->SetPosition(0.0, 0.2, 0.0);
  scene.Render();
  const double moved = scene.ReadReport("faces_drawn") - faces;
  Check("a moved ball is drawn again, under what is lit", moved >= 8.0 && moved < faces);
  const Image kept = scene.Copy("bounce");
  scene.Pass->CachingOff();
  scene.Render();
  CheckRelative("as all maps drawn anew have it", scene.Copy("bounce").Mean(), kept.Mean(), 0.005,
    "a moved ball has room, which maps are fitted to: their texels lie elsewhere");
  scene.Pass->CachingOn();
  scene.Pass->SetEnvironment(nullptr);
  scene.AddDirectional({ -0.3, -1.0, -0.2 });
  scene.Render();
  const double bytes = scene.ReadReport("bytes");
  scene.Pass->SetEnvironment(scene.Sky);
  scene.Render();
  Check("maps take memory", scene.ReadReport("bytes") > bytes);
  scene.Pass->SetEnvironment(nullptr);
  scene.Render();
  CheckEqual("and give it back", scene.ReadReport("bytes"), bytes);
}
