// SPDX-License-Identifier: BSD-3-Clause
// Surfaces without light stay dark, and none gets more light than there is: the backs of curved
// sheets, surfaces of colours beyond one, crevices under a uniform sky.
#include "vtkIndirectTestSheet.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkEnvironmentLight.h"
#include "vtkIndirectSplattingPass.h"
#include "vtkLightTreeSampler.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRSMGatherPass.h"
#include "vtkRadianceHintsPass.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>

using namespace vtkIndirectTest;

namespace
{
// The bounce on unlit sides, seen from outside, over that on lit ones, seen from within.
void CheckUnlit(const std::string& name, Scene& scene, const std::function<void()>& lookAtUnlit,
  const std::function<void()>& lookAtLit, double most, const char* origin)
{
  vtkNew<vtkLightTreeSampler> tree;
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  scene.Gather->SetModeToVirtualLights();
  scene.Pass->SetSampler(tree);
  for (vtkIndirectEstimatorPass* estimator :
    std::initializer_list<vtkIndirectEstimatorPass*>{ scene.Gather, splatting.Get() })
  {
    scene.Pass->SetEstimator(estimator);
    double means[2] = { 0.0, 0.0 };
    for (const bool lit : { false, true })
    {
      (lit ? lookAtLit : lookAtUnlit)();
      scene.Render();
      const Image bounce = scene.Copy("bounce");
      const Image direct = scene.Copy("direct");
      int count = 0;
      for (const Scene::Receiver& receiver : scene.GetReceivers())
      {
        if (receiver.Lit && (direct.At(receiver.X, receiver.Y)[0] > 0.0f) == lit)
        {
          means[lit ? 1 : 0] += static_cast<double>(bounce.At(receiver.X, receiver.Y)[0]);
          ++count;
        }
      }
      Check(name + ": there are such pixels", count > 500);
      means[lit ? 1 : 0] /= std::max(count, 1);
    }
    CheckAtMost(name + ", " + estimator->GetMethodName() + ": the unlit side over the lit one",
      means[0] / means[1], most, origin);
  }
  scene.Pass->SetEstimator(nullptr);
  scene.Pass->SetSampler(nullptr);
}

// Renders a furnace under a sky of (1, 0.5, 0.25), and compares its irradiance with that.
void CheckFurnace(Scene& scene, vtkIndirectEstimatorPass* estimator, double limit, double loss,
  const std::string& origin)
{
  scene.Pass->SetEstimator(estimator);
  scene.Render();
  scene.Render();
  const Image irradiance = scene.Copy("irradiance");
  const double radiance[3] = { 1.0, 0.5, 0.25 };
  double most = 0.0;
  double mean = 0.0;
  int count = 0;
  for (const Scene::Receiver& receiver : scene.GetReceivers())
  {
    if (receiver.Lit)
    {
      for (int c = 0; c < 3; ++c)
      {
        const float* e = irradiance.At(receiver.X, receiver.Y);
        most = std::max(most, static_cast<double>(e[c]) / radiance[c]);
      }
      mean += static_cast<double>(irradiance.At(receiver.X, receiver.Y)[0]);
      ++count;
    }
  }
  const std::string name = estimator->GetMethodName();
  CheckAtMost(name + ": the greatest irradiance over the sky's radiance", most, limit, origin);
  CheckRelative(name + ": the mean", mean / count, 1.0, loss,
    "a white furnace has one everywhere, but for what is lost");
}

const char* const MostOrigin = "surfaces invent no light, within 2 % of sums of many";
}

VTK_INDIRECT_TEST(BallsKeepTheirLight)
{
  Scene scene(96, 72);
  scene.AddSphere({ 0, 0, 0 }, 1.0, 32, { 0.8, 0.8, 0.8 });
  scene.AddPoint({ 0.3, 0.2, 0.1 }, { 0, 0, 1 });
  CheckUnlit(
    "a ball with a lamp in it", scene,
    [&] {
      scene.SetEye({ 0, 1, 4 }, { 0, 0, 0 }, { 0, 1, 0 }, 30, 0.1, 10);
    },
    [&] {
      scene.SetEye({ 0, 0, 0.5 }, { 0, 0, -1 }, { 0, 1, 0 }, 60, 0.01, 10);
    },
    1e-4, "facets of 11 degrees meet at less than what receivers allow for; before 0.4");
}

VTK_INDIRECT_TEST(BowlsKeepTheirLight)
{
  for (const double sign : { 1.0, -1.0 })
  {
    Scene scene(96, 72);
    const auto sheet = MakeSheet(
      48, [=](double x, double y) { return sign * (std::sqrt(4.0 - x * x - y * y) - 1.7); });
    scene.AddSource(sheet, { 0.8, 0.8, 0.8 });
    scene.AddDirectional({ 0.2, 0.1, -1 });
    CheckUnlit(
      sign > 0.0 ? "a dome" : "a bowl", scene,
      [&] {
        scene.SetEye({ 0.3, 0.2, -4 }, { 0, 0, 0 }, { 0, 1, 0 }, 30, 0.1, 10);
      },
      [&] {
        scene.SetEye({ 0.3, 0.2, 4 }, { 0, 0, 0 }, { 0, 1, 0 }, 30, 0.1, 10);
      },
      1e-3, "beside a bounce that itself is a hundredth of the light; before 0.1 to 1");
  }
}

VTK_INDIRECT_TEST(HillsAreDarkFromBelow)
{
  Scene scene(96, 72);
  const auto sheet =
    MakeSheet(64, [](double x, double y) { return 0.12 * std::sin(6.0 * x) * std::cos(6.0 * y); });
  scene.AddSource(sheet, { 0.8, 0.8, 0.8 });
  scene.AddDirectional({ 0.4, 0.2, -1 });
  // Without visibility hilltops would light the undersides of others.
  scene.Pass->SetVisibility(vtkIndirectIlluminationPass::AUTO);
  CheckUnlit(
    "hills", scene,
    [&] {
      scene.SetEye({ 0.5, 1.5, -4 }, { 0, 0, 0 }, { 0, 1, 0 }, 30, 0.1, 10);
    },
    [&] {
      scene.SetEye({ 0.5, 1.5, 4 }, { 0, 0, 0 }, { 0, 1, 0 }, 30, 0.1, 10);
    },
    0.06, "clusters of hilltops reach beyond their rims, measured 0.04 with nothing hidden");
}

VTK_INDIRECT_TEST(ColoursBeyondOneReflectNoMore)
{
  Scene scene(48, 36);
  scene.AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0.5, 0.5, 0.5 });
  vtkActor* wall = scene.AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1.0, 1.0, 1.0 });
  scene.SetEye({ 2.2, 1.6, 2.3 }, { 0.4, 0.3, 0.4 }, { 0, 1, 0 }, 36, 0.5, 6);
  scene.AddSpot({ 1, 1, 0.5 }, { 0.1, 0.3, 0.5 }, 50, 1, { 1, 0, 0 });
  vtkNew<vtkLightTreeSampler> tree;
  scene.Gather->SetModeToVirtualLights();
  scene.Pass->SetSampler(tree);
  scene.Pass->SetNumberOfBounces(3);
  scene.Render();
  const double white = scene.Copy("bounce").Mean();
  // Colours of 0 to 255, which VTK clamps in the picture.
  wall->GetProperty()->SetColor(255.0, 255.0, 255.0);
  scene.Render();
  CheckRelative("a wall of 255 over a white one", scene.Copy("bounce").Mean(), white, 1e-5,
    "the same numbers after clamping");
  scene.Pass->SetSampler(nullptr);
}

VTK_INDIRECT_TEST(WhiteFurnaceIsNoBrighterThanItsSky)
{
  Scene scene(96, 72);
  scene.AddQuad({ -2, 0, 2 }, { 2, 0, 2 }, { -2, 0, -2 }, { 1, 1, 1 });
  scene.AddQuad({ -2, 0, -2 }, { 2, 0, -2 }, { -2, 3, -2 }, { 1, 1, 1 });
  scene.AddSphere({ 0, 0.6, 0 }, 0.6, 32, { 1, 1, 1 });
  scene.SetEye({ 0, 1.6, 6.2 }, { 0, 0.5, 0 }, { 0, 1, 0 }, 30, 0.5, 20);
  vtkNew<vtkEnvironmentLight> sky;
  sky->SetRadiance(1.0, 0.5, 0.25);
  scene.Pass->SetEnvironment(sky);
  scene.Pass->SetVisibility(vtkIndirectIlluminationPass::AUTO);
  scene.Pass->SetNumberOfBounces(16);
  vtkNew<vtkLightTreeSampler> tree;
  scene.Pass->SetSampler(tree);
  vtkNew<vtkMultiresolutionSplattingPass> multiresolution;
  CheckFurnace(
    scene, multiresolution, 1.002, 0.02, "half floats of the images; before 1.8 under the ball");
  scene.Gather->SetModeToVirtualLights();
  CheckFurnace(scene, scene.Gather, 1.02, 0.02, MostOrigin);
  vtkNew<vtkIndirectSplattingPass> splatting;
  CheckFurnace(scene, splatting, 1.02, 0.02, MostOrigin);
  scene.Pass->SetSampler(nullptr);
  vtkNew<vtkRadianceHintsPass> hints;
  CheckFurnace(scene, hints, 1.02, 0.1, MostOrigin);
  scene.Pass->SetEstimator(nullptr);
}
