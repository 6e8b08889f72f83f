// SPDX-License-Identifier: BSD-3-Clause
// Excess change of fixed receivers' irradiance from frame to frame, while a light moves, and while
// the eye moves.
#include "vtkIndirectTestUtilities.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightTreeSampler.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace vtkIndirectTest;

namespace
{
constexpr int Frames = 8;
constexpr int Width = 96;
constexpr int Height = 72;

// A corner with objects in it, seen in parallel: a step of the eye is a step of whole pixels.
struct FlickerScene : Scene
{
  vtkNew<vtkRSMGatherPass> DefaultGather;
  vtkNew<vtkMultiresolutionSplattingPass> Splatting;
  vtkNew<vtkRadianceHintsPass> Hints;
  vtkNew<vtkUniformLightSampler> Changing;
  vtkNew<vtkLightTreeSampler> Tree;
  vtkLight* Light;

  FlickerScene()
    : Scene(Width, Height)
  {
    this->AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, glm::dvec3(0.8));
    this->AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.9, 0.3, 0.2 });
    this->AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.3, 0.8, 0.2 });
    this->AddBox({ 0.35, 0.0, 0.3 }, { 0.55, 0.3, 0.5 }, glm::dvec3(0.7));
    this->AddSphere({ 0.75, 0.15, 0.6 }, 0.15, 48, { 0.4, 0.5, 0.9 });
    this->Light = this->AddSpot({ 0.7, 1.2, 0.7 }, { 0.3, 0.2, 0.3 }, 35, 1, { 1, 0, 0 });
    this->Pass->SetReflectiveShadowMapResolution(64);
    this->Changing->SetPatternToJittered();
    this->SetFrame(0, false);
  }
  ~FlickerScene() { this->Pass->SetEstimator(nullptr); }

  void SetFrame(int frame, bool eyeMoves)
  {
    const double angle = eyeMoves ? 0.0 : 0.01 * frame;
    this->Light->SetPosition(0.7 * std::cos(angle) - 0.3 * std::sin(angle), 1.2,
      0.7 * std::cos(angle) + 0.3 * std::sin(angle));
    const double scale = 0.62;
    const glm::dvec3 way(-1.0, -0.8, -0.9);
    const glm::dvec3 right = glm::normalize(glm::cross(way, glm::dvec3(0.0, 1.0, 0.0)));
    const glm::dvec3 shift = eyeMoves ? 2.0 * scale / Height * frame * right : glm::dvec3(0.0);
    const glm::dvec3 target = glm::dvec3(0.4, 0.35, 0.4) + shift;
    this->SetEye(target - 2.0 * way, target, { 0, 1, 0 }, 30.0, 0.1, 6.0);
    this->SetParallelEye(scale);
  }

  // Irradiance of the receivers in a common part of the picture, in all frames.
  std::vector<std::vector<double>> Follow(
    vtkIndirectEstimatorPass* estimator, vtkVirtualLightSampler* sampler, bool eyeMoves)
  {
    this->Pass->SetEstimator(estimator);
    this->Pass->SetSampler(sampler);
    std::vector<std::vector<double>> sequence;
    for (int frame = 0; frame < Frames; ++frame)
    {
      this->Changing->SetNumberOfLights((4 + frame) * (4 + frame));
      this->SetFrame(frame, eyeMoves);
      this->Render();
      const Image image = this->Copy("irradiance");
      sequence.emplace_back();
      for (int y = 0; y < Height; ++y)
      {
        for (int x = Frames; x < Width; ++x)
        {
          const int u = eyeMoves ? x - frame : x;
          const glm::dvec3 color = image.Color(u, y);
          sequence.back().push_back((color.x + color.y + color.z) / 3.0);
        }
      }
    }
    return sequence;
  }
};

double FindMean(const std::vector<std::vector<double>>& sequence)
{
  double sum = 0.0;
  for (double value : sequence[0])
  {
    sum += value;
  }
  return sum / sequence[0].size();
}

// Root mean square change of a receiver's value from one frame to the next.
double FindFlicker(const std::vector<std::vector<double>>& sequence)
{
  double squares = 0.0;
  double count = 0.0;
  for (size_t frame = 1; frame < sequence.size(); ++frame)
  {
    for (size_t i = 0; i < sequence[0].size(); ++i)
    {
      squares += std::pow(sequence[frame][i] - sequence[frame - 1][i], 2.0);
      count += 1.0;
    }
  }
  return std::sqrt(squares / count);
}
}

VTK_INDIRECT_TEST(FlickerOfLight)
{
  // Relative to the change of the sum over all texels while the light moves.
  FlickerScene scene;
  const double truth = FindFlicker(scene.Follow(scene.Gather, scene.Sampler, false));
  CheckAtLeast("all texels: change from frame to frame", truth, 1e-4, "the test's own power");
  auto check = [&](const char* name, vtkIndirectEstimatorPass* estimator, double limit)
  {
    CheckAtMost(std::string(name) + ": change over that of all texels",
      FindFlicker(scene.Follow(estimator, scene.Sampler, false)) / truth, limit,
      "measured 0.89, 0.97 and 1.15: the lights' places move with the light");
    if (estimator != scene.Hints)
    {
      CheckAtLeast(std::string(name) + ", other random lights in each frame: the same",
        FindFlicker(scene.Follow(estimator, scene.Changing, false)) / truth, 5.0,
        "the test's own power: measured 20");
    }
  };
  check("gather", scene.DefaultGather, 1.2);
  check("multiresolution", scene.Splatting, 1.2);
  check("hints", scene.Hints, 1.4);
  CheckAtMost("gather, lights of a tree: change over that of all texels",
    FindFlicker(scene.Follow(scene.DefaultGather, scene.Tree, false)) / truth, 1.2,
    "clusters change by a little");
  CheckAtMost("multiresolution, lights of a tree: change over that of all texels",
    FindFlicker(scene.Follow(scene.Splatting, scene.Tree, false)) / truth, 1.2,
    "clusters change by a little");
}

VTK_INDIRECT_TEST(FlickerOfEye)
{
  // Receivers under still lights do not change. Relative to their mean irradiance.
  FlickerScene scene;
  const double mean = FindMean(scene.Follow(scene.DefaultGather, scene.Sampler, true));
  CheckAtLeast("mean irradiance", mean, 1e-2, "the test's own power");
  auto check =
    [&](const char* name, vtkIndirectEstimatorPass* estimator, double limit, const char* origin)
  {
    CheckAtMost(std::string(name) + ": change over the mean",
      FindFlicker(scene.Follow(estimator, scene.Sampler, true)) / mean, limit, origin);
  };
  const char* const interpolated =
    "measured 0.115 and 0.095: samples at every fourth pixel slide over the many edges of a small "
    "picture";
  check("gather", scene.DefaultGather, 0.13, interpolated);
  check("multiresolution", scene.Splatting, 0.013,
    "measured 0.0047 and 0.0099 with lights at other places: subsplats slide over what is near "
    "them");
  check("hints", scene.Hints, 0.11, interpolated);
  scene.DefaultGather->InterpolationOff();
  scene.Hints->SetInterpolationStep(1);
  check("gather at every pixel", scene.DefaultGather, 1e-4, "rounding");
  check("hints at every pixel", scene.Hints, 1e-4, "rounding; hints do not move");
  CheckAtLeast("other random lights in each frame: the same",
    FindFlicker(scene.Follow(scene.Splatting, scene.Changing, true)) / mean, 0.2,
    "the test's own power: measured 0.36");
}
