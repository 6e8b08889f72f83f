// SPDX-License-Identifier: BSD-3-Clause
// ErrorTolerance of radiance hints: the error of the irradiance against that of a much finer grid,
// otherwise equal.
#include "vtkIndirectDetails.h"
#include "vtkIndirectHintScenes.h"

#include <cstdio>

using namespace vtkIndirectTest;

namespace
{
// Tolerance of the finest grid: 35 hints along the longest edge, where the tested ones have 8 to
// 25.
constexpr double Converged = 0.01;

// A ball in the middle of a room lit by its walls: no sender is nearer than a quarter of the room,
// the assumption of the number of hints.
struct FarSenders : HintScene
{
  FarSenders()
    : HintScene(48, 48)
  {
    this->AddBox(glm::dvec3(-2.0), glm::dvec3(2.0), { 0.8, 0.6, 0.4 });
    this->AddSphere(glm::dvec3(0.0), 0.4, 64, glm::dvec3(0.0));
    this->AddPoint({ 0.9, 0.5, 1.2 }, { 1.0, 0.0, 0.0 });
    this->SetEye({ 1.9, 1.5, -1.7 }, glm::dvec3(0.0), { 0, 0, 1 }, 12.0, 0.1, 10.0);
  }
};

// Three walls that meet: senders touch receivers.
struct Corner : HintScene
{
  Corner()
    : HintScene(64, 64)
  {
    this->AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, glm::dvec3(0.8));
    this->AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.9, 0.3, 0.2 });
    this->AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.3, 0.8, 0.2 });
    this->AddDirectional({ -0.5, -1.0, -0.7 });
    this->SetEye({ 2, 1.7, 1.8 }, { 0.3, 0.3, 0.3 }, { 0, 1, 0 }, 35, 0.5, 5);
  }
};

// Errors at the tolerances; each is lower than at the next higher tolerance.
std::vector<double> Measure(
  const std::string& name, HintScene& scene, const std::vector<double>& tolerances)
{
  scene.Pass->SetReflectiveShadowMapResolution(128);
  SET_DETAIL(scene.Hints, NumberOfRays, 100);
  scene.Pass->SetErrorTolerance(Converged);
  scene.Render();
  const Image normal = scene.Copy("normal");
  const Image converged = scene.Copy("irradiance");
  CheckAtLeast(name + ": mean irradiance", converged.Mean(), 1e-3, "the test's own power");
  std::vector<double> errors;
  for (double tolerance : tolerances)
  {
    scene.Pass->SetErrorTolerance(tolerance);
    scene.Render();
    CheckEqual(name + ": tolerance in force", scene.ReadReport("ErrorTolerance"), tolerance);
    errors.push_back(FindRelativeError(scene.Copy("irradiance"), converged, normal));
    std::printf("       %s: tolerance %g, %d hints, error %.4f\n", name.c_str(), tolerance,
      scene.Hints->GetNumberOfHints(), errors.back());
    CheckAtMost(name + ": error over that of the next higher tolerance",
      errors.back() / errors[errors.size() < 2 ? 0 : errors.size() - 2], 1.0, "more hints");
  }
  return errors;
}
}

VTK_INDIRECT_TEST(HintsTolerance)
{
  const std::vector<double> tolerances = { 0.2, 0.1, 0.05, 0.02 };
  FarSenders far;
  std::vector<double> errors = Measure("far senders", far, tolerances);
  for (size_t i = 0; i < tolerances.size(); ++i)
  {
    CheckAtMost("far senders: error over the tolerance of " + std::to_string(tolerances[i]),
      errors[i] / tolerances[i], 1.0, "what the property says of light from that distance");
  }
  // Light from a nearer sender is not within the tolerance, and the report says so.
  Corner corner;
  errors = Measure("corner", corner, tolerances);
  Check("corner: the report says that it does not hold for nearer light",
    corner.Pass->GetReport().find("nearer light is interpolated with a larger error") !=
      std::string::npos);
  CheckAtMost(
    "corner: error at 0.02", errors.back(), 0.13, "measured 0.106, the report makes no promise");
  TwoRooms rooms(true, 64, 32);
  errors = Measure("two rooms", rooms, tolerances);
  CheckAtMost("two rooms: error at 0.02", errors.back(), 0.055,
    "measured 0.040, the report makes no promise");
}
