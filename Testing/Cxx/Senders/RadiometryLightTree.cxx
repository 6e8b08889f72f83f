// SPDX-License-Identifier: BSD-3-Clause
// Virtual lights from a tree over the maps' texels, against all texels, and compared with as many
// evenly spread lights.
#include "vtkIndirectTestSheet.h"
#include "vtkIndirectTestUtilities.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "Senders/vtkIndirectSenderClusters.h"
#include "vtkLightTreeSampler.h"
#include "vtkMath.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRandomWalkLightSampler.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>

using namespace vtkIndirectTest;

namespace
{
struct Difference
{
  double Squared; // mean squared relative difference
  double Bias;    // relative bias of the mean
};

Difference Compare(const Image& image, const Image& reference)
{
  const double mean = reference.Mean();
  Difference difference = { 0.0, image.Mean() / mean - 1.0 };
  for (size_t i = 0; i < reference.Values.size(); ++i)
  {
    const double value = reference.Values[i];
    const double d = image.Values[i] - value;
    difference.Squared += d * d / (value * value + 1e-2 * mean * mean);
  }
  difference.Squared /= static_cast<double>(reference.Values.size());
  return difference;
}

// Hills of six waves.
auto MakeHills(int resolution)
{
  return MakeSheet(resolution,
    [](double x, double y)
    {
      double height = 0.0;
      for (int wave = 0; wave < 6; ++wave)
      {
        const double along = std::cos(2.4 * wave) * x - std::sin(2.4 * wave) * y;
        height += 0.14 / (1.0 + wave) * std::sin((4.0 + 2.0 * wave) * along + 1.7 * wave);
      }
      return height;
    });
}
}

// A corner with a box in it, whose contacts a few hundred lights cannot resolve.
VTK_INDIRECT_TEST(LightTreeAgainstAllTexels)
{
  Scene scene(64, 48);
  scene.AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0.8, 0.8, 0.8 });
  scene.AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.3, 0.6, 0.9 });
  scene.AddBox({ 0.6, 0.0, 0.2 }, { 0.9, 0.5, 0.5 }, { 0.9, 0.9, 0.3 });
  scene.SetEye({ 2.2, 1.6, 2.3 }, { 0.4, 0.3, 0.4 }, { 0, 1, 0 }, 36, 0.5, 6);
  scene.AddSpot({ 1, 2, 1 }, { 0.4, 0, 0.4 }, 40, 1, { 1, 0, 0 });
  scene.Pass->SetVisibility(vtkIndirectIlluminationPass::NONE);
  scene.Gather->SetModeToAllTexels();
  scene.Gather->InterpolationOff();
  // Nearer to an edge than the distance of texels this sum goes to zero.
  scene.Pass->SetReflectiveShadowMapResolution(1024);
  scene.Render();
  const Image reference = scene.Copy("bounce");
  scene.Pass->SetReflectiveShadowMapResolution(256);
  vtkNew<vtkUniformLightSampler> uniform;
  vtkNew<vtkLightTreeSampler> tree;
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  scene.Gather->SetModeToVirtualLights();
  for (vtkIndirectEstimatorPass* estimator :
    std::initializer_list<vtkIndirectEstimatorPass*>{ scene.Gather, splatting.Get() })
  {
    const std::string name = estimator->GetMethodName();
    scene.Pass->SetEstimator(estimator);
    scene.Pass->SetSampler(uniform);
    scene.Render();
    const Difference even = Compare(scene.Copy("bounce"), reference);
    scene.Pass->SetSampler(tree);
    scene.Render();
    CheckEqual(name + ": lights", scene.ReadReport("virtual_lights"), 128);
    const Difference cut = Compare(scene.Copy("bounce"), reference);
    scene.CheckBuffers(1);
    CheckAtMost(name + ": over that of as many even lights", cut.Squared / even.Squared, 0.25,
      "with half as many lights; measured 0.012 and 0.079");
    CheckAtMost(name + ": mean squared relative difference", cut.Squared, 1e-2, "smooth surfaces");
    CheckAtMost(name + ": bias", std::abs(cut.Bias), 0.03, "a twentieth where surfaces mix");
  }
  scene.Pass->SetSampler(nullptr);
  scene.Pass->SetEstimator(nullptr);
}

// Rough ground under a setting sun. Texels of the sun's map grow longer along the slopes, and
// clusters mix slopes that the sun reaches.
VTK_INDIRECT_TEST(LightTreeOnHillsUnderALowSun)
{
  Scene scene(96, 72);
  const auto hills = MakeHills(160);
  scene.AddSource(hills, { 0.8, 0.8, 0.8 });
  scene.SetEye({ 0, -3, 3 }, { 0, 0, 0 }, { 0, 0, 1 }, 36, 0.5, 8);
  scene.Pass->SetVisibility(vtkIndirectIlluminationPass::NONE);
  scene.Gather->InterpolationOff();
  vtkNew<vtkLightTreeSampler> tree;
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  for (const double elevation : { 45.0, 15.0, 8.0 })
  {
    scene.Renderer->RemoveAllLights();
    const double angle = vtkMath::RadiansFromDegrees(elevation);
    scene.AddDirectional({ -0.8 * std::cos(angle), 0.6 * std::cos(angle), -std::sin(angle) });
    scene.Pass->SetEstimator(scene.Gather);
    scene.Gather->SetModeToAllTexels();
    scene.Pass->SetSampler(nullptr);
    scene.Pass->SetReflectiveShadowMapResolution(512);
    scene.Render();
    const Image reference = scene.Copy("bounce");
    scene.Gather->SetModeToVirtualLights();
    scene.Pass->SetReflectiveShadowMapResolution(256);
    scene.Pass->SetSampler(tree);
    for (vtkIndirectEstimatorPass* estimator :
      std::initializer_list<vtkIndirectEstimatorPass*>{ scene.Gather, splatting.Get() })
    {
      scene.Pass->SetEstimator(estimator);
      scene.Render();
      const Difference cut = Compare(scene.Copy("bounce"), reference);
      const std::string name = std::string(estimator->GetMethodName()) + ", " +
        std::to_string(static_cast<int>(elevation)) + " degrees";
      CheckAtMost(name + ": mean squared relative difference", cut.Squared, 0.012,
        "half as much again as the measured 0.003 to 0.008");
      CheckAtMost(name + ": bias", std::abs(cut.Bias), 0.065,
        "too dark by 0.042 to 0.057: contacts are softened, and hollows send the light of their "
        "opening");
    }
  }
  scene.Pass->SetSampler(nullptr);
  scene.Pass->SetEstimator(nullptr);
}

// All bounces, with what hills hide: as dark as the first bounce alone, and no darker.
VTK_INDIRECT_TEST(LightTreeOnHillsInAllBounces)
{
  Scene scene(64, 48);
  scene.AddSource(MakeHills(64), { 0.8, 0.8, 0.8 });
  scene.SetEye({ 0, -3, 3 }, { 0, 0, 0 }, { 0, 0, 1 }, 36, 0.5, 8);
  scene.Pass->SetVisibility(vtkIndirectIlluminationPass::AUTO);
  scene.Pass->SetNumberOfBounces(8);
  scene.Gather->SetModeToVirtualLights();
  scene.Gather->InterpolationOff();
  vtkNew<vtkLightTreeSampler> tree;
  vtkNew<vtkRandomWalkLightSampler> walk;
  walk->SetNumberOfLights(2048);
  for (const double elevation : { 15.0, 8.0 })
  {
    scene.Renderer->RemoveAllLights();
    const double angle = vtkMath::RadiansFromDegrees(elevation);
    scene.AddDirectional({ -0.8 * std::cos(angle), 0.6 * std::cos(angle), -std::sin(angle) });
    scene.Pass->SetSampler(walk);
    scene.Render();
    const Image reference = scene.Copy("bounce");
    scene.Pass->SetSampler(tree);
    scene.Render();
    const Difference all = Compare(scene.Copy("bounce"), reference);
    const std::string name = std::to_string(static_cast<int>(elevation)) + " degrees";
    CheckAtLeast(name + ": there is light", reference.Mean(), 1e-3, "the test's own power");
    CheckAtMost(name + ": bias of all bounces", std::abs(all.Bias), 0.045,
      "half as much again as the measured 0.021 and 0.030");
  }
  scene.Pass->SetSampler(nullptr);
}

VTK_INDIRECT_TEST(LightTreeKeepsTheLight)
{
  using Clusters = vtkIndirectSenderClusters;
  constexpr size_t perNode = vtkIndirectKernels::VTKI_BRANCHES_PER_NODE;
  std::vector<Clusters::Sender> senders;
  for (int i = 0; i < 96 * 96; ++i)
  {
    const float x = (static_cast<float>(i % 96) + 0.5f) / 96.0f;
    const float y = (static_cast<float>(i / 96) + 0.5f) / 96.0f;
    const bool wall = i % 2 == 1;
    senders.push_back({ wall ? glm::vec3(0.0f, x, y) : glm::vec3(x, 0.0f, y),
      wall ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f), 2.0f / (96 * 96),
      glm::vec3(1e-4f * (1.0f + x)), 0 });
  }
  Clusters clusters;
  clusters.SetSenders(senders);
  const Clusters::LightTree lights = clusters.MakeLights({ glm::dvec3(1.0) }, 64, 0.03);
  double all = 0.0;
  double sumOfLights = 0.0;
  for (const Clusters::Sender& sender : senders)
  {
    all += static_cast<double>(sender.Reflected.x);
  }
  double worst = 0.0;
  size_t divided = 0;
  for (size_t i = 0; i < lights.Lights.size(); ++i)
  {
    const double whole = lights.Lights[i].DensityArea.x;
    sumOfLights += whole;
    if (!(lights.Lights[i].ChildDistance > 0.0))
    {
      continue;
    }
    ++divided;
    double sum = 0.0;
    for (size_t child = 0; child < perNode; ++child)
    {
      const size_t place = i * vtkIndirectKernels::VTKI_BRANCHES + child * (perNode + 1);
      const double light = lights.Branches[place].DensityArea.x;
      sum += light;
      if (lights.Branches[place].ChildDistance > 0.0)
      {
        double leaves = 0.0;
        for (size_t leaf = 0; leaf < perNode; ++leaf)
        {
          leaves += lights.Branches[place + 1 + leaf].DensityArea.x;
        }
        worst = std::max(worst, std::abs(leaves / light - 1.0));
      }
    }
    worst = std::max(worst, std::abs(sum / whole - 1.0));
  }
  CheckEqual("lights", static_cast<double>(lights.Lights.size()), 64);
  Check("some are divided", divided > 0);
  CheckRelative("light of all", sumOfLights, all, 1e-6, "sums in double precision");
  CheckAtMost("light of branches", worst, 1e-6, "sums in double precision");
  // A single texel has no branches.
  senders.resize(1);
  clusters.SetSenders(senders);
  const Clusters::LightTree one = clusters.MakeLights({ glm::dvec3(1.0) }, 64, 0.03);
  Check("a texel alone has no branches",
    one.Branches.empty() && one.Lights.front().ChildDistance == 0.0);
}
