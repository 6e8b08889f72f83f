// SPDX-License-Identifier: BSD-3-Clause
// Light that comes directly from the sky, against view factors of what hides it.
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkEnvironmentLight.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace vtkIndirectTest;

namespace
{
const glm::dvec3 White(0.8);
using Polygon = std::vector<glm::dvec3>;

// Compares the buffer `sky` with what `expect` says of each receiver that counts.
void CompareSky(Scene& scene, const std::function<bool(const Scene::Receiver&)>& counts,
  const std::function<double(const Scene::Receiver&)>& expect, double meanTolerance,
  double rmsTolerance, const std::string& origin)
{
  scene.Render();
  const Image sky = scene.Copy("sky");
  const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
  double sum = 0.0;
  double expectedSum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (size_t i = 0; i < receivers.size(); ++i)
  {
    if (!receivers[i].Lit || !counts(receivers[i]))
    {
      continue;
    }
    const double expected = expect(receivers[i]);
    const double measured = sky.Values[3 * i];
    sum += measured;
    expectedSum += expected;
    squares += (measured - expected) * (measured - expected);
    ++count;
  }
  Check("receivers are seen", count > 100, "a test of nothing passes");
  CheckRelative("mean irradiance from the sky", sum, expectedSum, meanTolerance, origin);
  CheckAtMost(
    "its RMS error over the mean", std::sqrt(squares * count) / expectedSum, rmsTolerance, origin);
}

bool Any(const Scene::Receiver&)
{
  return true;
}

void SetSky(Scene& scene, vtkEnvironmentLight* environment)
{
  scene.Pass->SetEnvironment(environment);
}
}

VTK_INDIRECT_TEST(SkyOverAnOpenPlane)
{
  Scene scene(48, 48);
  scene.Pass->SetVisibilityToAuto();
  scene.AddQuad({ -1, 0, 1 }, { 1, 0, 1 }, { -1, 0, -1 }, White);
  scene.SetEye({ 0, 3, 0.01 }, { 0, 0, 0 }, { 0, 0, -1 }, 36, 0.1, 10);
  vtkNew<vtkEnvironmentLight> sky;
  sky->SetRadiance(2.0, 1.0, 0.5);
  SetSky(scene, sky);
  CompareSky(
    scene, Any, [](const Scene::Receiver&) { return 2.0; }, 0.002, 0.002,
    "quadrature by 256 directions");
  const Image irradiance = scene.Copy("irradiance");
  const Image final = scene.Copy("final");
  CheckRelative(
    "all irradiance is the sky's", irradiance.Mean(), scene.Copy("sky").Mean(), 1e-6, "rounding");
  CheckRelative(
    "a white plane shows it", final.Mean(), 0.8 * irradiance.Mean(), 0.005, "albedo in 10 bits");
  // Turned and in other units.
  for (const double scale : { 1e-9, 1e6 })
  {
    Scene other(32, 32);
    const glm::dvec3 n = glm::normalize(glm::dvec3(1, 2, -0.5));
    const glm::dvec3 x = glm::normalize(glm::cross(n, glm::dvec3(0, 0, 1)));
    const glm::dvec3 y = glm::cross(n, x);
    const glm::dvec3 c(3.0 * scale, -scale, scale);
    other.AddQuad(c - scale * (x + y), c + scale * (x - y), c + scale * (y - x), White);
    other.SetEye(c + 3.0 * scale * n, c, y, 36, 0.1 * scale, 10.0 * scale);
    vtkNew<vtkEnvironmentLight> same;
    SetSky(other, same);
    CompareSky(
      other, Any, [](const Scene::Receiver&) { return 1.0; }, 0.005, 0.005,
      "quadrature by 256 directions");
  }
}

VTK_INDIRECT_TEST(SkyBesideAWall)
{
  const Polygon wall = { { 0, 0, -2 }, { 0, 0, 2 }, { 0, 2, 2 }, { 0, 2, -2 } };
  Scene scene(96, 96);
  scene.Pass->SetVisibilityToAuto();
  scene.AddQuad({ 0, 0, 2 }, { 2, 0, 2 }, { 0, 0, -2 }, White);
  scene.AddQuad({ 0, 0, 2 }, { 0, 0, -2 }, { 0, 2, 2 }, White);
  scene.SetEye({ 1, 6, 0.01 }, { 1, 0, 0 }, { 0, 0, -1 }, 18, 0.1, 10);
  vtkNew<vtkEnvironmentLight> sky;
  SetSky(scene, sky);
  auto onPlane = [](const Scene::Receiver& r) { return r.Normal.y > 0.9 && r.Position.x > 0.05; };
  auto expect = [&](const Scene::Receiver& r) {
    return 1.0 - PolygonFormFactor(r.Position, { 0, 1, 0 }, wall);
  };
  CompareSky(scene, onPlane, expect, 0.01, 0.02,
    "256 directions, each hard; tiles of 128 texels over four units");
}

VTK_INDIRECT_TEST(SkyUnderADisk)
{
  Polygon disk;
  for (int i = 0; i < 128; ++i)
  {
    const double angle = -2.0 * vtkMath::Pi() * i / 128;
    disk.emplace_back(std::cos(angle), 0.6, std::sin(angle));
  }
  Scene scene(96, 96);
  scene.Pass->SetVisibilityToAuto();
  scene.AddQuad({ -2, 0, 2 }, { 2, 0, 2 }, { -2, 0, -2 }, White);
  scene.AddDisk({ 0, 0.6, 0 }, { 0, 1, 0 }, 1.0, 128, White);
  // From below the disk, all around.
  scene.SetEye({ 0, 0.55, 0 }, { 0, 0, 0 }, { 0, 0, -1 }, 120, 0.01, 10);
  vtkNew<vtkEnvironmentLight> sky;
  SetSky(scene, sky);
  auto onPlane = [](const Scene::Receiver& r)
  { return r.Normal.y > 0.9 && r.Position.y < 0.1 && glm::length(r.Position) < 1.8; };
  auto expect = [&](const Scene::Receiver& r) {
    return 1.0 - std::abs(PolygonFormFactor(r.Position, { 0, 1, 0 }, disk));
  };
  CompareSky(scene, onPlane, expect, 0.01, 0.035, "256 directions, each hard");
}

VTK_INDIRECT_TEST(SkyInAGroove)
{
  // Two squares that meet at a right angle, opening upward.
  const double s = std::sqrt(0.5);
  const Polygon left = { { -s, s, -1 }, { -s, s, 1 }, { 0, 0, 1 }, { 0, 0, -1 } };
  Scene scene(96, 96);
  scene.Pass->SetVisibilityToAuto();
  scene.AddQuad({ -s, s, 1 }, { 0, 0, 1 }, { -s, s, -1 }, White);
  scene.AddQuad({ 0, 0, 1 }, { s, s, 1 }, { 0, 0, -1 }, White);
  scene.SetEye({ 0, 5, 0.01 }, { 0, 0, 0 }, { 0, 0, -1 }, 16, 0.1, 10);
  vtkNew<vtkEnvironmentLight> sky;
  SetSky(scene, sky);
  auto counts = [](const Scene::Receiver& r) { return r.Position.x > 0.03; };
  auto expect = [&](const Scene::Receiver& r) {
    return 1.0 - std::abs(PolygonFormFactor(r.Position, { -s, s, 0 }, left)) - 0.0;
  };
  CompareSky(scene, counts, expect, 0.01, 0.02, "256 directions, each hard");
}
