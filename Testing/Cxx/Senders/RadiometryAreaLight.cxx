// SPDX-License-Identifier: BSD-3-Clause
// Light from rectangles against Lambert's closed form of a polygon, and sums over many pieces.
#include "vtkAreaLight.h"
#include "vtkAreaLightSampler.h"
#include "vtkImageData.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkRSMGatherPass.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
constexpr double Radiance = 2.5;

// A floor at z = 0, seen from above, and a lamp of edge 1 at z = height that shines down on it.
struct LampScene : Scene
{
  vtkNew<vtkAreaLight> Lamp;
  vtkNew<vtkMultiresolutionSplattingPass> Splatting;
  double Height;

  explicit LampScene(double height)
    : Scene(64, 64)
    , Height(height)
  {
    this->Gather->SetModeToVirtualLights();
    this->Gather->InterpolationOff();
    this->Lamp->SetOrigin(-0.5, -0.5, height);
    this->Lamp->SetPoint1(-0.5, 0.5, height);
    this->Lamp->SetPoint2(0.5, -0.5, height);
    this->Lamp->SetRadiance(Radiance, Radiance, Radiance);
    this->Pass->AddAreaLight(this->Lamp);
    this->AddQuad({ -2, -2, 0 }, { 2, -2, 0 }, { -2, 2, 0 }, { 0.5, 0.5, 0.5 });
    this->SetEye({ 0, 0, 6 }, { 0, 0, 0 }, { 0, 1, 0 }, 35.0, 0.1, 20.0);
  }
  ~LampScene() { this->Pass->SetEstimator(nullptr); }

  // Expected irradiance from the part of the lamp beyond x = left.
  double Expect(const Receiver& receiver, double left = -0.5) const
  {
    const double z = this->Height;
    return left >= 0.5 ? 0.0
                       : Radiance *
        PolygonFormFactor(receiver.Position, receiver.Normal,
          { { left, -0.5, z }, { 0.5, -0.5, z }, { 0.5, 0.5, z }, { left, 0.5, z } });
  }
};

bool Everywhere(const Scene::Receiver&)
{
  return true;
}
}

// Lambert's polygon at every pixel, down to a thousandth of the edge.
VTK_INDIRECT_TEST(AreaLightOfOneRadiance)
{
  for (const double height : { 1e-3, 0.03, 0.5, 1.0, 30.0 })
  {
    LampScene scene(height);
    CompareLight(
      scene, "area", Everywhere, [&](const auto& r) { return scene.Expect(r); },
      { 1e-3, 2e-3, "depths and normals of the geometry buffer" }, "at " + std::to_string(height));
    CheckEqual("nothing reflects it", scene.ReadReport("virtual_lights"), 0.0);
  }
}

// By default: maps of 64 points, all of which are unoccluded.
VTK_INDIRECT_TEST(AreaLightByDefault)
{
  LampScene scene(1.0);
  scene.Pass->SetEstimator(nullptr);
  scene.Pass->SetVisibility(vtkIndirectIlluminationPass::AUTO);
  CompareLight(scene, "irradiance", Everywhere, [&](const auto& r) { return scene.Expect(r); },
    { 1e-3, 2e-3, "a share of one, bit for bit" });
}

// As virtual lights, whose branches are a 64th of the edge: near the lamp as well. With the
// estimator's preset PAPER they are squares of an eighth of the edge, and one of them is wrong
// nearer than a few of its widths.
VTK_INDIRECT_TEST(AreaLightAsVirtualLights)
{
  for (const double height : { 0.1, 0.5, 1.0, 3.0 })
  {
    LampScene scene(height);
    scene.Lamp->SetMethodToVirtualLights();
    CompareLight(
      scene, "bounce", Everywhere, [&](const auto& r) { return scene.Expect(r); },
      { 5e-3, 0.01, "disks for squares: A / (pi height^2) is 0.5 % at most, and half floats" },
      "at " + std::to_string(height));
    CheckEqual("pieces", scene.ReadReport("virtual_lights"), 256);
    scene.Pass->SetEstimator(scene.Splatting);
    CompareLight(
      scene, "bounce", Everywhere, [&](const auto& r) { return scene.Expect(r); },
      { 0.01, 0.02, "and interpolation at the tolerance of 0.02" },
      "subsplats at " + std::to_string(height));
  }
  LampScene scene(1.0);
  scene.Splatting->SetPresetToPaper();
  scene.Pass->SetEstimator(scene.Splatting);
  CompareLight(
    scene, "bounce", Everywhere, [&](const auto& r) { return scene.Expect(r); },
    { 0.02, 0.05, "64 disks: A / (pi height^2) is 0.5 %; and the paper's interpolation" },
    "preset");
  CheckEqual("squares of one radiance", scene.ReadReport("virtual_lights"), 64);
  scene.Lamp->SetMethodToClosedForm();
  CompareLight(
    scene, "area", Everywhere, [&](const auto& r) { return scene.Expect(r); },
    { 1e-3, 2e-3, "depths and normals of the geometry buffer" }, "closed form");
}

// A sampler of the user's gives the same light.
VTK_INDIRECT_TEST(AreaLightOfAFurtherSampler)
{
  LampScene scene(0.5);
  scene.Pass->RemoveAllAreaLights();
  vtkNew<vtkAreaLightSampler> sampler;
  sampler->AddLight(scene.Lamp);
  scene.Pass->AddSampler(sampler);
  for (const bool minMax : { false, true })
  {
    sampler->SetClustering(minMax ? vtkAreaLightSampler::MIN_MAX : vtkAreaLightSampler::VARIANCE);
    CompareLight(
      scene, "bounce", Everywhere, [&](const auto& r) { return scene.Expect(r); },
      { 0.02, 0.03, "64 disks: A / (pi height^2) is 2 %, and half floats" }, "sampler");
    CheckEqual("pieces", scene.ReadReport("virtual_lights"), minMax ? 64 : 256);
  }
  scene.Pass->RemoveSampler(sampler);
}

// Occlusion by a straight edge: it hides a part of the lamp from each point of the floor, and the
// rest is a rectangle too.
VTK_INDIRECT_TEST(AreaLightPenumbra)
{
  LampScene scene(1.0);
  scene.Pass->SetVisibility(vtkIndirectIlluminationPass::MAPS);
  // A screen half way up that covers x < 0.
  scene.AddQuad({ -2, -2, 0.5 }, { 0, -2, 0.5 }, { -2, 2, 0.5 }, { 0.5, 0.5, 0.5 });
  scene.SetEye({ 0.0, 0.0, -6.0 }, { 0, 0, 0 }, { 0, 1, 0 }, 35.0, 0.1, 20.0);
  // Not from below, through the floor's back, but from beside the screen.
  scene.SetEye({ 4.0, 0.0, 3.0 }, { 0.4, 0, 0 }, { 0, 0, 1 }, 30.0, 0.1, 20.0);
  auto onFloor = [](const Scene::Receiver& r)
  { return std::abs(r.Position.z) < 1e-3 && std::abs(r.Position.x) < 1.5; };
  // From x on the floor the edge at half the height hides the lamp up to -x.
  auto expect = [&](const Scene::Receiver& r)
  { return scene.Expect(r, std::min(std::max(-r.Position.x, -0.5), 0.5)); };
  CompareLight(scene, "area", onFloor, expect,
    { 0.02, 0.04, "64 points, texels of 1/20 of the lamp at the screen" });
}

// A checkerboard of 8 x 8, a step and a bright pixel, against sums over 256 x 256 pieces.
VTK_INDIRECT_TEST(AreaLightWithAnImage)
{
  auto checkers = [](int x, int y) { return (x / 8 + y / 8) % 2 ? 1.0 : 0.0; };
  auto step = [](int x, int) { return x < 20 ? 1.0 : 0.05; };
  auto spark = [](int x, int y) { return x == 40 && y == 9 ? 100.0 : 0.0; };
  const std::pair<const char*, std::function<double(int, int)>> images[] = {
    { "checkers", checkers }, { "step", step }, { "spark", spark }
  };
  for (const auto& image : images)
  {
    LampScene scene(0.75);
    vtkNew<vtkImageData> data;
    data->SetDimensions(64, 64, 1);
    data->AllocateScalars(VTK_FLOAT, 1);
    for (int y = 0; y < 64; ++y)
    {
      for (int x = 0; x < 64; ++x)
      {
        data->SetScalarComponentFromDouble(x, y, 0, 0, image.second(x, y));
      }
    }
    scene.Lamp->SetImage(data);
    auto expect = [&](const Scene::Receiver& r)
    {
      double sum = 0.0;
      for (int i = 0; i < 256 * 256; ++i)
      {
        const int u = i % 256;
        const int v = i / 256;
        const double radiance = image.second(u / 4, v / 4);
        if (radiance == 0.0)
        {
          continue;
        }
        // Rows run along Point1 - Origin, which is y.
        const glm::dvec3 place((v + 0.5) / 256.0 - 0.5, (u + 0.5) / 256.0 - 0.5, scene.Height);
        const glm::dvec3 d = place - r.Position;
        const double square = glm::dot(d, d);
        sum += radiance * std::max(glm::dot(d, r.Normal), 0.0) * d.z / (square * square);
      }
      return Radiance * sum / vtkMath::Pi() / 65536.0;
    };
    CompareLight(scene, "area", Everywhere, expect,
      { 5e-3, 0.01, "the tolerance of 0.02 over eight; sums of 65536 points" }, image.first);
    const std::string name(image.first);
    scene.Lamp->SetMethodToVirtualLights();
    CompareLight(scene, "bounce", Everywhere, expect, { 0.01, 0.02, "disks for squares" },
      name + " as virtual lights");
    scene.Lamp->SetMethodToAutomatic();
    scene.Splatting->SetPresetToPaper();
    scene.Splatting->SetDepthThreshold(0.0); // no interpolation
    scene.Pass->SetEstimator(scene.Splatting);
    CompareLight(scene, "bounce", Everywhere, expect,
      { 0.01, 0.02, "squares of an eighth where radiances differ little" },
      name + " by the preset");
  }
}

// A lamp at the ceiling of a closed white box lights floor and walls, which light the ceiling: a
// surface without direct light. Against a sum over patches of the floor and the walls.
VTK_INDIRECT_TEST(AreaLightIsReflected)
{
  Scene scene(48, 48);
  scene.Gather->SetModeToVirtualLights();
  scene.Gather->InterpolationOff();
  const double albedo = 0.5;
  const glm::dvec3 grey(albedo);
  // From -1 to 1, its faces turned inwards; the front is open to the eye.
  scene.AddQuad({ -1, -1, -1 }, { 1, -1, -1 }, { -1, 1, -1 }, grey); // floor, z = -1
  scene.AddQuad({ -1, -1, 1 }, { -1, 1, 1 }, { 1, -1, 1 }, grey);    // ceiling
  vtkNew<vtkAreaLight> lamp;
  lamp->SetOrigin(-0.3, -0.3, 0.9);
  lamp->SetPoint1(-0.3, 0.3, 0.9);
  lamp->SetPoint2(0.3, -0.3, 0.9);
  lamp->SetRadiance(Radiance, Radiance, Radiance);
  scene.Pass->AddAreaLight(lamp);
  scene.SetEye({ 0, -4, 0 }, { 0, 0, 0.7 }, { 0, 0, 1 }, 40.0, 0.1, 20.0);
  const std::vector<glm::dvec3> corners = { { -0.3, -0.3, 0.9 }, { 0.3, -0.3, 0.9 },
    { 0.3, 0.3, 0.9 }, { -0.3, 0.3, 0.9 } };
  constexpr int edge = 48;
  std::vector<double> floor;
  auto place = [](int i)
  {
    return glm::dvec3(
      -1.0 + 2.0 * (i % edge + 0.5) / edge, -1.0 + 2.0 * (i / edge + 0.5) / edge, -1.0);
  };
  for (int i = 0; i < edge * edge; ++i)
  {
    floor.push_back(Radiance * PolygonFormFactor(place(i), { 0, 0, 1 }, corners));
  }
  auto onCeiling = [](const Scene::Receiver& r) { return std::abs(r.Position.z - 1.0) < 1e-3; };
  auto expect = [&](const Scene::Receiver& r)
  {
    double sum = 0.0;
    for (int i = 0; i < edge * edge; ++i)
    {
      const glm::dvec3 d = place(i) - r.Position;
      const double square = glm::dot(d, d);
      sum += floor[static_cast<size_t>(i)] * d.z * d.z / (square * square);
    }
    return albedo * sum * 4.0 / (edge * edge) / vtkMath::Pi();
  };
  CompareLight(scene, "bounce", onCeiling, expect,
    { 0.03, 0.03, "four points for the lamp leave out 1 %, 256 clusters of their maps the rest" });
  CheckEqual("virtual lights of the floor", scene.ReadReport("virtual_lights"), 256);
}

// It lights only its front, unless it has two sides; switched off, dark or removed it lights
// nothing.
VTK_INDIRECT_TEST(AreaLightSides)
{
  LampScene scene(1.0);
  auto mean = [&scene]
  {
    scene.Render();
    return scene.Copy("area").Mean(0);
  };
  const double front = mean();
  CheckAtLeast("towards the floor", front, 0.1, "a lamp of edge 1 over a floor of 4");
  scene.Lamp->SetPoint1(0.5, -0.5, 1.0);
  scene.Lamp->SetPoint2(-0.5, 0.5, 1.0);
  // No other surface is lit: the pass leaves the frame to its delegate, or writes zero.
  scene.Lamp->TwoSidedOn();
  CheckRelative("away from it, with two sides", mean(), front, 1e-5, "the same rectangle");
  scene.Lamp->SetTwoSided(false);
  CheckEqual("away from it", mean(), 0.0);
  scene.Lamp->TwoSidedOn();
  scene.Lamp->SetRadiance(2.0 * Radiance, 0.0, 0.0);
  CheckRelative("twice as bright", mean(), 2.0 * front, 1e-5, "twice the radiance");
  CheckEqual("in red", scene.Copy("area").Mean(1), 0.0);
  scene.Lamp->SetSwitch(false);
  scene.Render();
  const double bytes = scene.ReadReport("bytes");
  scene.Lamp->SetSwitch(true);
  CheckRelative("on again", mean(), 2.0 * front, 1e-5, "the same as before");
  CheckAtLeast(
    "memory", scene.ReadReport("bytes"), bytes + 64.0 * 64.0 * 16.0, "an image of floats");
  scene.Pass->RemoveAreaLight(scene.Lamp);
  scene.Render();
  CheckEqual("which goes with it", scene.ReadReport("bytes"), bytes);
}
