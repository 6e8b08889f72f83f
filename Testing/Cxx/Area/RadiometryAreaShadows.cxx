// SPDX-License-Identifier: BSD-3-Clause
// Shadows of area lights, against sums over 1024 points of each with exact visibility.
#include "vtkAreaLight.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"
#include "vtkRSMGatherPass.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
struct Lamp
{
  glm::dvec3 Corner;
  glm::dvec3 Edge1;
  glm::dvec3 Edge2;
  double Radiance;
};

// A floor, boxes over it, and lamps.
struct ShadowScene : Scene
{
  std::vector<vtkSmartPointer<vtkAreaLight>> Lights;
  std::vector<Lamp> Lamps;
  std::vector<std::pair<glm::dvec3, glm::dvec3>> Boxes;

  explicit ShadowScene(double floor)
    : Scene(128, 128)
  {
    this->Gather->SetModeToVirtualLights();
    this->Pass->SetVisibilityToMaps();
    this->AddQuad(
      { -floor, -floor, 0 }, { floor, -floor, 0 }, { -floor, floor, 0 }, { 0.5, 0.5, 0.5 });
    this->SetEye({ 4.0, 0.0, 4.0 }, { 0, 0, 0 }, { 0, 0, 1 }, 30.0, 0.1, 40.0);
  }

  void AddLamp(const Lamp& lamp)
  {
    auto light = vtkSmartPointer<vtkAreaLight>::New();
    const glm::dvec3 point1 = lamp.Corner + lamp.Edge1;
    const glm::dvec3 point2 = lamp.Corner + lamp.Edge2;
    light->SetOrigin(lamp.Corner.x, lamp.Corner.y, lamp.Corner.z);
    light->SetPoint1(point1.x, point1.y, point1.z);
    light->SetPoint2(point2.x, point2.y, point2.z);
    light->SetRadiance(lamp.Radiance, lamp.Radiance, lamp.Radiance);
    this->Pass->AddAreaLight(light);
    this->Lights.push_back(light);
    this->Lamps.push_back(lamp);
  }

  void AddOccluder(const glm::dvec3& lower, const glm::dvec3& upper)
  {
    this->AddBox(lower, upper, { 0.5, 0.5, 0.5 });
    this->Boxes.emplace_back(lower, upper);
  }

  // True if a segment meets a box.
  static bool Meets(
    const glm::dvec3& from, const glm::dvec3& way, const glm::dvec3& lower, const glm::dvec3& upper)
  {
    double begin = 0.0;
    double end = 1.0;
    for (int k = 0; k < 3; ++k)
    {
      const double a = (lower[k] - from[k]) / way[k];
      const double b = (upper[k] - from[k]) / way[k];
      begin = std::max(begin, std::min(a, b));
      end = std::min(end, std::max(a, b));
    }
    return begin < end;
  }

  double Sum(const Receiver& receiver) const
  {
    constexpr int edge = 32;
    double sum = 0.0;
    for (const Lamp& lamp : this->Lamps)
    {
      const glm::dvec3 span = glm::cross(lamp.Edge1, lamp.Edge2);
      for (int i = 0; i < edge * edge; ++i)
      {
        const glm::dvec3 d = lamp.Corner + (i % edge + 0.5) / edge * lamp.Edge1 +
          (i / edge + 0.5) / edge * lamp.Edge2 - receiver.Position;
        const bool hidden = std::any_of(this->Boxes.begin(), this->Boxes.end(),
          [&](const auto& box) { return Meets(receiver.Position, d, box.first, box.second); });
        const double square = glm::dot(d, d);
        sum += hidden ? 0.0
                      : lamp.Radiance * std::max(glm::dot(d, receiver.Normal), 0.0) *
            std::max(-glm::dot(d, span), 0.0) / (square * square * edge * edge);
      }
    }
    return sum / vtkMath::Pi();
  }

  // Renders until no map is left to draw; returns the number of frames.
  int Finish()
  {
    int frames = 0;
    do
    {
      this->Render();
      ++frames;
    } while (this->ReadReport("tiles_left") > 0.0 && frames < 100);
    return frames;
  }
};

bool OnGround(const Scene::Receiver& r)
{
  return std::abs(r.Position.z) < 1e-3 && r.Normal.z > 0.99;
}

const char* const Origin = "what users are promised of penumbrae";
}

// A small box, whose umbra does not reach the floor, and a long one whose umbra does, in the
// penumbra of a lamp of edge 1; on a ground much larger than the boxes, so that the texels of maps
// of the whole ground would be a third of the boxes.
VTK_INDIRECT_TEST(AreaShadowsOfBoxes)
{
  for (const double floor : { 2.0, 8.0 })
  {
    ShadowScene scene(floor);
    scene.AddLamp({ { -0.5, -0.5, 2 }, { 0, 1, 0 }, { 1, 0, 0 }, 2.0 });
    scene.AddOccluder({ -0.4, -0.5, 0.6 }, { -0.15, -0.2, 0.7 });
    scene.AddOccluder({ 0.2, -0.1, 0.0 }, { 0.3, 0.8, 0.5 });
    const std::string name = "floor of " + std::to_string(floor);
    CompareLight(
      scene, "area", OnGround, [&](const auto& r) { return scene.Sum(r); },
      { 5e-3, 0.01, "64 points" }, name + ", first frame");
    CheckEqual("frames: a round of points each", scene.Finish(), 15);
    CompareLight(
      scene, "area", OnGround, [&](const auto& r) { return scene.Sum(r); },
      { 2e-3, 6e-3, "1024 points, texels of a 256th of what boxes fill" }, name + ", all rounds");
    const Image light = scene.Copy("area");
    const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
    double most = 0.0;
    std::vector<double> errors;
    for (size_t i = 0; i < receivers.size(); ++i)
    {
      if (receivers[i].Lit && OnGround(receivers[i]))
      {
        const double sum = scene.Sum(receivers[i]);
        most = std::max(most, sum);
        errors.push_back(std::abs(light.Values[3 * i] - sum));
      }
    }
    CheckAtMost(name + ": 99 of 100 errors over the brightest", Percentile(errors, 0.99) / most,
      0.02, Origin);
  }
}

// A lamp turned away from a box, so that both the box and the ground behind it see the lamp from 75
// to 89 degrees off its normal.
VTK_INDIRECT_TEST(AreaShadowsAtGrazingAngles)
{
  for (const double degrees : { 60.0, 75.0, 80.0, 85.0, 89.0 })
  {
    ShadowScene scene(2.0);
    const glm::dvec3 middle(-2.0, 0.0, 2.5);
    const glm::dvec3 way = glm::normalize(glm::dvec3(0.0, 0.0, 0.2) - middle);
    const glm::dvec3 across(0.0, 1.0, 0.0);
    const glm::dvec3 above = glm::cross(way, across);
    const double angle = glm::radians(degrees);
    const glm::dvec3 up = std::cos(angle) * above - std::sin(angle) * way;
    // Its normal points above the side of the box: cos(angle) way + sin(angle) above.
    const double edge = 0.6;
    const glm::dvec3 normal = std::cos(angle) * way + std::sin(angle) * above;
    const glm::dvec3 other = glm::cross(normal, up);
    scene.AddLamp({ middle - 0.5 * edge * (up + other), edge * up, edge * other, 50.0 });
    scene.AddOccluder({ -0.3, -0.3, 0.0 }, { 0.1, 0.3, 0.6 });
    scene.Finish();
    CompareLight(
      scene, "area", OnGround, [&](const auto& r) { return scene.Sum(r); },
      { 5e-3, 0.03, "1024 points" }, std::to_string(static_cast<int>(degrees)) + " degrees");
  }
}

// A small bright distant lamp and a large dim near one of about the same light; each one's shadow
// is lit by the other, in still and in moving frames.
VTK_INDIRECT_TEST(AreaShadowsOfUnlikeLamps)
{
  ShadowScene scene(2.0);
  scene.AddLamp({ { -4.1, -0.1, 5 }, { 0, 0.2, 0 }, { 0.16, 0, 0.12 }, 500.0 });
  scene.AddLamp({ { 1.5, 1.5, 0.2 }, { 0, -3, 0 }, { 0, 0, 2 }, 1.0 });
  scene.AddOccluder({ -0.3, -0.3, 0.0 }, { 0.1, 0.3, 0.8 });
  scene.Finish();
  // Nearer to the large lamp the reference has too few points.
  auto counts = [](const Scene::Receiver& r) { return OnGround(r) && r.Position.x < 1.0; };
  CompareLight(
    scene, "area", counts, [&](const auto& r) { return scene.Sum(r); }, { 3e-3, 0.02, Origin },
    "still");
  scene.Window->SetDesiredUpdateRate(15.0);
  CompareLight(
    scene, "area", counts, [&](const auto& r) { return scene.Sum(r); },
    { 0.02, 0.06, "16 points of each, at every fourth pixel" }, "moving");
}
