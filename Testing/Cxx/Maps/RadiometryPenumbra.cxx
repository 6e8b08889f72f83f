// SPDX-License-Identifier: BSD-3-Clause
// Penumbrae of VTK's lights against closed forms and brute force.
//
// The visible part of a light behind a straight edge is cut off by a plane through the receiver and
// the edge. The points of a positional light fill a disk evenly in every direction, so that the
// share is exactly that of a disk cut by a chord, at the plane's distance from the light's centre.
#include "vtkIndirectTestUtilities.h"

#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkRSMGatherPass.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace vtkIndirectTest;

namespace
{
// Share of a unit disk on the side of a chord that contains its centre for t > 0.
double DiskShare(double t)
{
  const double c = std::max(-1.0, std::min(1.0, t));
  return 0.5 + (c * std::sqrt(1.0 - c * c) + std::asin(c)) / vtkMath::Pi();
}

// Direct light with shadows over direct light without; -1 for unlit pixels.
std::vector<double> FindVisibility(Scene& scene)
{
  scene.Pass->SetIndirectScale(0.0);
  scene.Gather->SetModeToVirtualLights();
  scene.Sampler->SetNumberOfLights(1);
  scene.Pass->ShadowsOn();
  scene.Render();
  const Image shadowed = scene.Copy("direct");
  // Without shadows and without indirect light only the delegate would run.
  scene.Pass->ShadowsOff();
  scene.Pass->SetIndirectScale(1e-6);
  scene.Render();
  const Image lit = scene.Copy("direct");
  scene.Pass->SetIndirectScale(0.0);
  std::vector<double> visibility;
  for (int y = 0; y < lit.Height; ++y)
  {
    for (int x = 0; x < lit.Width; ++x)
    {
      const double open = lit.At(x, y)[0];
      visibility.push_back(open > 1e-6 ? shadowed.At(x, y)[0] / open : -1.0);
    }
  }
  return visibility;
}

// A plane at z = 0, seen from above beside a sheet at height `height` that covers x < 0.
struct HalfPlane
{
  static constexpr int Width = 320;
  Scene Frame{ Width, 24 };
  double Height;
  double Unit;
  double Left = 0.0; // ends of the visible part of the plane
  double Right = 0.0;

  HalfPlane(double height, double unit)
    : Height(height)
    , Unit(unit)
  {
    const double e = 3.0 * unit;
    this->Frame.AddQuad({ -e, -e, 0 }, { e, -e, 0 }, { -e, e, 0 }, glm::dvec3(0.8));
    const double h = height * unit;
    this->Frame.AddQuad({ -e, -e, h }, { 0, -e, h }, { -e, e, h }, glm::dvec3(0.8));
  }

  // Looks at the plane from x = left to x = right, both greater than 0.
  void Look(double left, double right)
  {
    this->Left = left * this->Unit;
    this->Right = right * this->Unit;
    const double middle = 0.5 * (this->Left + this->Right);
    this->Frame.SetEye({ middle, 0, 4.0 * this->Unit }, { middle, 0, 0 }, { 0, 1, 0 }, 30,
      0.1 * this->Unit, 8.0 * this->Unit);
    this->Frame.SetParallelEye(0.5 * (this->Right - this->Left) * 24.0 / Width);
  }

  double GetX(int pixel) const
  {
    return this->Left + (pixel + 0.5) * (this->Right - this->Left) / Width;
  }
};

// Compares a row of pixels with the truth: the place of half visibility, and the mean difference,
// both over the penumbra's width.
void CheckEdge(HalfPlane& scene, const std::function<double(double)>& truth, double width,
  const std::string& what)
{
  const std::vector<double> visibility = FindVisibility(scene.Frame);
  const double pixel = (scene.Right - scene.Left) / HalfPlane::Width;
  double integral = 0.0;
  double squares = 0.0;
  double worst = 0.0;
  double darker = 0.0;
  double brighter = 0.0;
  double trueDarker = 0.0;
  double trueBrighter = 0.0;
  const size_t row = 12 * static_cast<size_t>(HalfPlane::Width);
  for (int x = 0; x < HalfPlane::Width; ++x)
  {
    const double v = visibility[row + x];
    const double t = truth(scene.GetX(x));
    integral += (v - t) * pixel;
    squares += (v - t) * (v - t) * pixel;
    worst = std::max(worst, std::abs(v - t));
    // The middle of the interval within one point of half visibility: light grows with x.
    darker = v <= 0.5 - 1.0 / 64.0 ? scene.GetX(x) : darker;
    brighter = v < 0.5 + 1.0 / 64.0 ? scene.GetX(x) : brighter;
    trueDarker = t <= 0.5 - 1.0 / 64.0 ? scene.GetX(x) : trueDarker;
    trueBrighter = t < 0.5 + 1.0 / 64.0 ? scene.GetX(x) : trueBrighter;
  }
  // Outlines are rounded to texels; over 32 maps a tenth of one remains. They are at most 0.022
  // wide.
  const double texel = 0.1 * 0.022 / width;
  CheckAtLeast(what + ": pixels across the penumbra", width / pixel, 16.0, "the test's own power");
  CheckAbsolute(what + ": where half of the light is seen, in penumbrae",
    0.5 * (darker + brighter) / width, 0.5 * (trueDarker + trueBrighter) / width, 0.02 + texel,
    "asked for, and a tenth of a texel");
  CheckAbsolute(
    what + ": integral of the difference, in penumbrae", integral / width, 0.0, 0.02, "asked for");
  // The discrepancy of 32 points across any edge; see Unit.LightPoints.
  CheckAtMost(what + ": RMS difference in the penumbra", std::sqrt(squares / width), 0.04 + texel,
    "32 points, and a tenth of a texel");
  CheckAtMost(what + ": largest difference", worst, 0.1, "32 points");
}
}

VTK_INDIRECT_TEST(PenumbraPositional)
{
  struct
  {
    double Height; // height of the sheet
    double Radius;
    double Cone;
  } cases[] = { { 0.5, 0.2, 50.0 }, { 1.0, 0.1, 50.0 }, { 0.5, 0.3, 50.0 }, { 0.25, 0.3, 50.0 },
    { 1.0, 0.2, 80.0 }, { 1.0, 0.2, 90.0 } };
  for (const auto& c : cases)
  {
    // The light is 2 above the plane and aside, so that its shadow is visible beside the sheet.
    const glm::dvec3 place(-1.5, 0.0, 2.0);
    HalfPlane scene(c.Height, 1.0);
    vtkLight* light = scene.Frame.AddSpot(place, { 0.4, 0, 0 }, c.Cone, 0.0, { 1, 0, 0 });
    vtkIndirectIlluminationPass::SetLightRadius(light, c.Radius);
    // Distance of the light's centre from the plane through a receiver and the edge.
    auto distance = [&](double x)
    {
      const glm::dvec2 edge = glm::normalize(glm::dvec2(-x, c.Height));
      const glm::dvec2 to(place.x - x, place.z);
      return edge.y * to.x - edge.x * to.y;
    };
    auto truth = [&](double x) { return DiskShare(distance(x) / c.Radius); };
    const double middle = 1.5 * c.Height / (2.0 - c.Height);
    // Places of the shares 0 and 1, by bisection.
    auto find = [&](double value)
    {
      double low = -3.0;
      double high = 3.0;
      for (int i = 0; i < 60; ++i)
      {
        const double x = 0.5 * (low + high);
        (distance(x) > value * c.Radius ? high : low) = x;
      }
      return 0.5 * (low + high);
    };
    const double left = find(-1.0);
    const double right = find(1.0);
    const double width = right - left;
    scene.Look(std::max(left - 0.3 * width, 0.01), std::max(right + 0.3 * width, middle + 0.05));
    CheckEdge(scene, truth, width,
      "sheet " + std::to_string(c.Height) + " high, radius " + std::to_string(c.Radius) +
        ", cone " + std::to_string(c.Cone));
  }
}

VTK_INDIRECT_TEST(PenumbraDirectional)
{
  for (double angle : { 2.0, 10.0 })
  {
    for (double height : { 0.5, 1.0 })
    {
      HalfPlane scene(height, 1.0);
      const glm::dvec3 way = glm::normalize(glm::dvec3(0.5, 0.0, -1.0));
      vtkLight* light = scene.Frame.AddDirectional(way);
      vtkIndirectIlluminationPass::SetLightAngle(light, angle);
      const double sine = std::sin(vtkMath::RadiansFromDegrees(angle));
      // Directions are evenly distributed over the disk seen along the axis; the plane through a
      // receiver and the edge cuts it in an ellipse, whose chord this is for narrow lights.
      auto truth = [&](double x)
      {
        const glm::dvec2 edge = glm::normalize(glm::dvec2(-x, height));
        const double aside = edge.y * -way.x - edge.x * -way.z;
        return DiskShare(aside / sine);
      };
      const double slant = std::atan2(0.5, 1.0);
      const double radians = vtkMath::RadiansFromDegrees(angle);
      const double left = height * std::tan(slant - radians);
      const double right = height * std::tan(slant + radians);
      const double width = right - left;
      scene.Look(left - 0.3 * width, right + 0.3 * width);
      CheckEdge(scene, truth, width,
        "sheet " + std::to_string(height) + " high, " + std::to_string(angle) + " degrees");
    }
  }
}

// Contract.PenumbraScales tests scales and distance from the origin; this test changes the light's
// distance.
VTK_INDIRECT_TEST(PenumbraDistance)
{
  for (double distance : { 16.0, 64.0 })
  {
    const double height = 0.5;
    const double radius = 0.1 * distance;
    const glm::dvec3 place = distance * glm::normalize(glm::dvec3(-1.5, 0.0, 2.0));
    HalfPlane scene(height, 1.0);
    vtkLight* light = scene.Frame.AddPoint(place, { 1, 0, 0 });
    vtkIndirectIlluminationPass::SetLightRadius(light, radius);
    auto truth = [&](double x)
    {
      const glm::dvec2 edge = glm::normalize(glm::dvec2(-x, height));
      return DiskShare((edge.y * (place.x - x) - edge.x * place.z) / radius);
    };
    const double middle = -place.x * height / (place.z - height);
    const double cosine = place.z / distance;
    const double width = 2.0 * height * radius / (place.z - height) / cosine;
    scene.Look(middle - 0.8 * width, middle + 0.8 * width);
    CheckEdge(scene, truth, width, "light " + std::to_string(distance) + " away");
  }
}

// A ball over a plane: brute force over many points of the light, with the exact ball.
VTK_INDIRECT_TEST(PenumbraOfBall)
{
  Scene scene(96, 96);
  scene.AddQuad({ -2, -2, 0 }, { 2, -2, 0 }, { -2, 2, 0 }, glm::dvec3(0.8));
  const glm::dvec3 centre(0.0, 0.0, 0.6);
  const double ball = 0.25;
  scene.AddSphere(centre, ball, 128, glm::dvec3(0.8));
  const glm::dvec3 place(-1.6, 0.3, 2.2);
  const double radius = 0.2;
  vtkLight* light = scene.AddPoint(place, { 1, 0, 0 });
  vtkIndirectIlluminationPass::SetLightRadius(light, radius);
  scene.SetEye({ 1.2, -0.2, 3.0 }, { 0.6, -0.1, 0.0 }, { 0, 1, 0 }, 25, 0.1, 8);
  const std::vector<double> visibility = FindVisibility(scene);
  const std::vector<Scene::Receiver> receivers = scene.GetReceivers();

  // Points evenly distributed in the disk that faces the receiver.
  constexpr int count = 2048;
  double squares = 0.0;
  double sum = 0.0;
  double partial = 0.0;
  double missing = 0.0;
  for (size_t i = 0; i < receivers.size(); ++i)
  {
    if (!receivers[i].Lit || receivers[i].Position.z > 1e-3)
    {
      continue;
    }
    const glm::dvec3 p = receivers[i].Position;
    const glm::dvec3 axis = glm::normalize(place - p);
    const glm::dvec3 x = glm::normalize(glm::cross(axis, glm::dvec3(0, 1, 0)));
    const glm::dvec3 y = glm::cross(axis, x);
    int seen = 0;
    for (int k = 0; k < count; ++k)
    {
      const double r = radius * std::sqrt((k + 0.5) / count);
      const double turn = 2.399963229728653 * k;
      const glm::dvec3 way =
        glm::normalize(place + r * (std::cos(turn) * x + std::sin(turn) * y) - p);
      const double along = glm::dot(centre - p, way);
      seen += glm::length(centre - p - along * way) > ball ? 1 : 0;
    }
    const double truth = double(seen) / count;
    const double difference = visibility[i] - truth;
    if (truth > 0.0 && truth < 1.0)
    {
      squares += difference * difference;
      sum += difference;
      partial += 1.0;
    }
    missing = truth < 1.0 ? missing + 1.0 - truth : missing;
  }
  CheckAtLeast("pixels in the penumbra", partial, 300.0, "the test's own power");
  CheckAtMost("RMS difference in the penumbra", std::sqrt(squares / partial), 0.04, "32 points");
  CheckAbsolute("mean difference over the shadow", sum / missing, 0.0, 0.02, "asked for");
}
