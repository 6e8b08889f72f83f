// SPDX-License-Identifier: BSD-3-Clause
// Light from rectangles in moving frames, interpolated between samples, and in still frames,
// against sums over many pieces in double precision; and its change from frame to frame.
#include "vtkAreaLight.h"
#include "vtkImageData.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"
#include "vtkRSMGatherPass.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
constexpr int Texels = 64;
// Large enough for receivers between samples, which are every eighth pixel: much smaller frames do
// not interpolate here.
constexpr int Edge = 256;
using Picture = std::function<double(double, double)>; // a value for each pixel

struct ImageScene : Scene
{
  vtkNew<vtkAreaLight> Lamp;
  vtkNew<vtkImageData> Data;
  glm::dvec3 Corner;
  glm::dvec3 Edge1;
  glm::dvec3 Edge2;

  ImageScene(
    const glm::dvec3& corner, const glm::dvec3& edge1, const glm::dvec3& edge2, int size = Edge)
    : Scene(size, size)
  {
    this->Gather->SetModeToVirtualLights();
    this->Gather->InterpolationOff();
    this->AddQuad({ -2, -2, 0 }, { 2, -2, 0 }, { -2, 2, 0 }, { 0.5, 0.5, 0.5 });
    this->SetEye({ 0, -3, 5 }, { 0, 0, 0 }, { 0, 1, 0 }, 35.0, 0.1, 20.0);
    this->Place(corner, edge1, edge2);
    this->Pass->AddAreaLight(this->Lamp);
    this->SetMoving(true);
  }

  void SetMoving(bool moving) { this->Window->SetDesiredUpdateRate(moving ? 15.0 : 1e-4); }

  void Place(const glm::dvec3& corner, const glm::dvec3& edge1, const glm::dvec3& edge2)
  {
    this->Corner = corner;
    this->Edge1 = edge1;
    this->Edge2 = edge2;
    this->Lamp->SetOrigin(corner.x, corner.y, corner.z);
    this->Lamp->SetPoint1(corner.x + edge1.x, corner.y + edge1.y, corner.z + edge1.z);
    this->Lamp->SetPoint2(corner.x + edge2.x, corner.y + edge2.y, corner.z + edge2.z);
  }

  void Show(const Picture& picture)
  {
    this->Data->SetDimensions(Texels, Texels, 1);
    this->Data->AllocateScalars(VTK_FLOAT, 1);
    auto* values = static_cast<float*>(this->Data->GetScalarPointer());
    for (int i = 0; i < Texels * Texels; ++i)
    {
      values[i] = static_cast<float>(picture(i % Texels, i / Texels));
    }
    this->Data->Modified();
    this->Lamp->SetImage(this->Data);
  }

  // A receiver's irradiance from the picture: each pixel in this many pieces along an edge.
  double Sum(const Receiver& receiver, const Picture& picture, int pieces) const
  {
    const int edge = pieces * Texels;
    const glm::dvec3 span = glm::cross(this->Edge1, this->Edge2);
    double sum = 0.0;
    for (int j = 0; j < edge; ++j)
    {
      for (int i = 0; i < edge; ++i)
      {
        const glm::dvec3 place =
          this->Corner + (i + 0.5) / edge * this->Edge1 + (j + 0.5) / edge * this->Edge2;
        const glm::dvec3 d = place - receiver.Position;
        const double square = glm::dot(d, d);
        sum += picture(i / pieces, j / pieces) * std::max(glm::dot(d, receiver.Normal), 0.0) *
          std::max(-glm::dot(d, span), 0.0) / (square * square);
      }
    }
    return sum / vtkMath::Pi() / (1.0 * edge * edge);
  }
};

bool Everywhere(const Scene::Receiver&)
{
  return true;
}

// Selects every step-th pixel of every step-th row, because sums over thousands of pieces take
// long. An odd step covers all positions between samples.
std::function<bool(const Scene::Receiver&)> Every(int step)
{
  return [step](const Scene::Receiver& receiver)
  { return receiver.X % step == step / 2 && receiver.Y % step == step / 2; };
}

double Checkers(double x, double y)
{
  return (static_cast<int>(x) / 8 + static_cast<int>(y) / 8) % 2 ? 1.0 : 0.0;
}
double Step(double x, double)
{
  return x < 20 ? 1.0 : 0.05;
}
double Spark(double x, double y)
{
  return x == 40 && y == 9 ? 100.0 : 0.0;
}
// Waves whose strength falls with their frequency, as in photographs, and an edge.
double Photograph(double x, double y)
{
  double value = x + 0.3 * y > 45.0 ? 1.5 : 0.5;
  for (int k = 1; k <= 16; k *= 2)
  {
    value += 0.3 / k * std::sin(0.11 * k * (x + 0.6 * y) + k) * std::cos(0.13 * k * (y - 0.4 * x));
  }
  return std::max(value, 0.0);
}

const std::pair<const char*, Picture> Pictures[] = { { "checkers", Checkers }, { "step", Step },
  { "spark", Spark }, { "photograph", Photograph } };
}

// Each picture over a floor at two heights; the lower is a tenth of the lamp's edge.
VTK_INDIRECT_TEST(AreaImageInFrames)
{
  for (const double height : { 0.75, 0.1 })
  {
    ImageScene scene({ -0.5, -0.5, height }, { 0, 1, 0 }, { 1, 0, 0 });
    for (const auto& picture : Pictures)
    {
      scene.Show(picture.second);
      std::vector<double> sums;
      for (const bool moving : { true, false })
      {
        scene.SetMoving(moving);
        size_t number = 0;
        auto expect = [&](const Scene::Receiver& receiver)
        {
          if (number == sums.size())
          {
            sums.push_back(scene.Sum(receiver, picture.second, height < 0.5 ? 4 : 2));
          }
          return sums[number++];
        };
        CompareLight(scene, "area", Every(11), expect,
          { 5e-3, 0.01, "a hundredth of the value is what users are promised" },
          std::string(picture.first) + " at " + std::to_string(height) +
            (moving ? ", moving" : ", still"));
      }
    }
  }
}

// One radiance, in moving frames: heights from a thousandth of the edge on, and a lamp that stands
// on the floor, which crosses the lamp's plane and is lit at a grazing angle.
VTK_INDIRECT_TEST(AreaLightInMovingFrames)
{
  for (const double height : { 1e-3, 0.03, 0.5, 1.0, 30.0 })
  {
    ImageScene scene({ -0.5, -0.5, height }, { 0, 1, 0 }, { 1, 0, 0 });
    CompareLight(
      scene, "area", Everywhere,
      [&](const auto& r)
      {
        return PolygonFormFactor(r.Position, r.Normal,
          { { -0.5, -0.5, height }, { 0.5, -0.5, height }, { 0.5, 0.5, height },
            { -0.5, 0.5, height } });
      },
      { 1e-3, 3e-3, "interpolated over a fourteenth of the distance" },
      "at " + std::to_string(height));
  }
  ImageScene scene({ 0, -0.5, 0 }, { 0, 1, 0 }, { 0, 0, 1 });
  CompareLight(
    scene, "area", Everywhere,
    [](const auto& r)
    {
      const std::vector<glm::dvec3> lamp = { { 0, -0.5, 0 }, { 0, -0.5, 1 }, { 0, 0.5, 1 },
        { 0, 0.5, 0 } };
      return r.Position.x > 0.0 ? PolygonFormFactor(r.Position, r.Normal, lamp) : 0.0;
    },
    { 1e-3, 3e-3, "interpolated over a fourteenth of the distance" }, "standing");
}

// A picture that moves over the lamp, frame by frame: the rendered light changes by no more than
// the sum over many pieces.
VTK_INDIRECT_TEST(AreaVideoWithoutFlicker)
{
  const auto counts = Every(11);
  for (const auto& picture : { Pictures[0], Pictures[3] })
  {
    ImageScene scene({ -0.5, -0.5, 0.4 }, { 0, 1, 0 }, { 1, 0, 0 });
    Image before;
    std::vector<double> sumsBefore;
    double changes = 0.0;
    double expected = 0.0;
    for (int frame = 0; frame < 12; ++frame)
    {
      auto shown = [&](double x, double y)
      { return picture.second(std::fmod(x + 1.3 * frame, 64.0), y); };
      scene.Show(shown);
      scene.Render();
      const Image light = scene.Copy("area");
      const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
      std::vector<double> sums;
      for (const Scene::Receiver& receiver : receivers)
      {
        const bool lit = receiver.Lit && counts(receiver);
        sums.push_back(lit ? scene.Sum(receiver, shown, 1) : 0.0);
      }
      for (size_t i = 0; frame > 0 && i < sums.size(); ++i)
      {
        if (sums[i] > 0.0)
        {
          changes += std::pow(light.Values[3 * i] - before.Values[3 * i], 2.0);
          expected += std::pow(sums[i] - sumsBefore[i], 2.0);
        }
      }
      before = light;
      sumsBefore = sums;
    }
    Check("the picture changes the light", expected > 0.0, "a test of nothing passes");
    CheckAtMost(std::string(picture.first) + ": changes over those of the sum",
      std::sqrt(changes / expected), 1.2, "what users are promised");
  }
}

// A lamp that recedes in small steps, so that pieces of its picture are split and joined: the
// light's change between steps equals the sum's, but for a small part.
VTK_INDIRECT_TEST(AreaImageSplitsWithoutPop)
{
  const auto counts = Every(29);
  ImageScene scene({ -0.5, -0.5, 0.2 }, { 0, 1, 0 }, { 1, 0, 0 });
  scene.Show(Photograph);
  for (const bool moving : { true, false })
  {
    scene.SetMoving(moving);
    std::vector<double> errorsBefore;
    double worst = 0.0;
    size_t count = 0;
    for (int step = 0; step < 40; ++step)
    {
      scene.Place({ -0.5, -0.5, 0.2 * std::pow(1.03, step) }, { 0, 1, 0 }, { 1, 0, 0 });
      scene.Render();
      const Image light = scene.Copy("area");
      const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
      std::vector<double> errors;
      std::vector<double> sums;
      double total = 0.0;
      for (size_t i = 0; i < receivers.size(); ++i)
      {
        if (receivers[i].Lit && counts(receivers[i]))
        {
          sums.push_back(scene.Sum(receivers[i], Photograph, 1));
          errors.push_back(light.Values[3 * i] - sums.back());
          total += sums.back();
        }
      }
      const double mean = total / static_cast<double>(sums.size());
      for (size_t i = 0; step > 0 && i < errors.size(); ++i)
      {
        worst = std::max(worst, std::abs(errors[i] - errorsBefore[i]) / std::max(sums[i], mean));
      }
      count += sums.size();
      errorsBefore = errors;
    }
    Check("receivers are lit", count > 1000, "a test of nothing passes");
    CheckAtMost(std::string(moving ? "moving" : "still") + ": greatest change of the error", worst,
      0.01, "a hundredth of what is there, or in the mean, while the light changes by three");
  }
}

// A straight edge half way up hides half of the lamp in moving frames, so that the part visible
// from the floor is a rectangle, too.
VTK_INDIRECT_TEST(AreaPenumbraInMovingFrames)
{
  ImageScene scene({ -0.5, -0.5, 1 }, { 0, 1, 0 }, { 1, 0, 0 });
  scene.Pass->SetVisibilityToMaps();
  scene.AddQuad({ -2, -2, 0.5 }, { 0, -2, 0.5 }, { -2, 2, 0.5 }, { 0.5, 0.5, 0.5 });
  scene.SetEye({ 4.0, 0.0, 3.0 }, { 0.4, 0, 0 }, { 0, 0, 1 }, 30.0, 0.1, 20.0);
  double drawn = -1.0;
  for (double now = 0.0; now > drawn;)
  {
    drawn = now;
    scene.Render();
    now = scene.ReadReport("tiles_drawn");
  }
  CheckAtLeast("depth maps", drawn, 64, "of the lamp, and of what reflects it");
  auto onFloor = [](const Scene::Receiver& r)
  { return std::abs(r.Position.z) < 1e-3 && std::abs(r.Position.x) < 1.5; };
  auto expect = [](const Scene::Receiver& r)
  {
    const double left = std::min(std::max(-r.Position.x, -0.5), 0.5);
    return left >= 0.5
      ? 0.0
      : PolygonFormFactor(r.Position, r.Normal,
          { { left, -0.5, 1 }, { 0.5, -0.5, 1 }, { 0.5, 0.5, 1 }, { left, 0.5, 1 } });
  };
  CompareLight(scene, "area", onFloor, expect,
    { 0.02, 0.06, "16 points: a step of the penumbra is a sixteenth" });
}

// Lamps of several batches, and pixels at the border of a frame whose size is no multiple of the
// sample distance.
VTK_INDIRECT_TEST(AreaLightsInBatches)
{
  ImageScene scene({ -0.5, -0.5, 1 }, { 0, 1, 0 }, { 1, 0, 0 }, 101);
  scene.Lamp->SetRadiance(1.0 / 20, 1.0 / 20, 1.0 / 20);
  std::vector<vtkSmartPointer<vtkAreaLight>> others;
  for (int i = 1; i < 20; ++i)
  {
    auto other = vtkSmartPointer<vtkAreaLight>::New();
    other->SetOrigin(scene.Lamp->GetOrigin());
    other->SetPoint1(scene.Lamp->GetPoint1());
    other->SetPoint2(scene.Lamp->GetPoint2());
    other->SetRadiance(scene.Lamp->GetRadiance());
    scene.Pass->AddAreaLight(other);
    others.push_back(other);
  }
  CompareLight(scene, "area", Everywhere,
    [](const auto& r)
    {
      return PolygonFormFactor(r.Position, r.Normal,
        { { -0.5, -0.5, 1 }, { 0.5, -0.5, 1 }, { 0.5, 0.5, 1 }, { -0.5, 0.5, 1 } });
    },
    { 1e-3, 3e-3, "interpolated over a fourteenth of the distance" });
}
