// SPDX-License-Identifier: BSD-3-Clause
// Lights sampled by importance: their distribution, their sum, and their error against the sum over
// all texels, compared with evenly spread ones.
#include "Senders/vtkIndirectSampler.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkImportanceLightSampler.h"
#include "vtkLight.h"
#include "vtkRSMGatherPass.h"
#include "vtkRenderWindow.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace vtkIndirectTest;

namespace
{
constexpr int Edge = 4; // patches of the floor

struct PatchScene : Scene
{
  vtkNew<vtkImportanceLightSampler> Importance;
  std::vector<double> Albedos;

  // A floor of patches, the first of which is black, under parallel light.
  PatchScene()
    : Scene(24, 18)
  {
    for (int i = 0; i < Edge * Edge; ++i)
    {
      const double albedo = i == 0 ? 0.0 : 0.9 * i * i / (Edge * Edge) / (Edge * Edge);
      const glm::dvec3 corner(i % Edge, i / Edge, 0.0);
      this->Albedos.push_back(albedo);
      this->AddQuad(corner, corner + glm::dvec3(1, 0, 0), corner + glm::dvec3(0, 1, 0),
        { albedo, 0.5 * albedo, 0.25 * albedo });
    }
    this->Pass->SetVisibility(vtkIndirectIlluminationPass::NONE);
    this->Pass->SetReflectiveShadowMapResolution(128);
    this->SetEye({ 2, -6, 4 }, { 2, 2, 0 }, { 0, 0, 1 }, 40, 0.5, 20);
  }
  ~PatchScene() { this->Pass->SetSampler(nullptr); }

  std::vector<VirtualLight> DrawAll()
  {
    this->Gather->SetModeToAllTexels();
    this->Render();
    return this->CopyLights();
  }
  std::vector<VirtualLight> Draw(int count)
  {
    this->Gather->SetModeToVirtualLights();
    this->Pass->SetSampler(this->Importance);
    this->Importance->SetNumberOfLights(count);
    this->Render();
    return this->CopyLights();
  }
};

double Sum(const std::vector<VirtualLight>& lights, int source = -1)
{
  double sum = 0.0;
  for (const VirtualLight& light : lights)
  {
    sum += source < 0 || light.Source == source
      ? light.DensityArea.x + light.DensityArea.y + light.DensityArea.z
      : 0.0;
  }
  return sum;
}

int CountDark(const std::vector<VirtualLight>& lights)
{
  return static_cast<int>(std::count_if(lights.begin(), lights.end(),
    [](const VirtualLight& light) { return !(light.DensityArea.x > 0.0); }));
}
}

// The number of lights on a patch is its share of the flux, zero on the black one; each light sends
// the same, and their sum is that of all texels.
VTK_INDIRECT_TEST(ImportanceDistribution)
{
  PatchScene scene;
  scene.AddDirectional({ 0.2, 0.1, -1 });
  scene.Importance->SetEvenness(0.0);
  scene.Importance->SetOcclusion(0.0);
  const double all = Sum(scene.DrawAll());
  const double albedos = std::accumulate(scene.Albedos.begin(), scene.Albedos.end(), 0.0);
  for (const int count : { 100, 1000, 4000 })
  {
    const std::vector<VirtualLight> lights = scene.Draw(count);
    std::vector<double> found(Edge * Edge, 0.0);
    double worst = 0.0;
    for (const VirtualLight& light : lights)
    {
      const int x = std::min(static_cast<int>(std::max(light.Position.x, 0.0)), Edge - 1);
      const int y = std::min(static_cast<int>(std::max(light.Position.y, 0.0)), Edge - 1);
      found[static_cast<size_t>(y) * Edge + x] += 1.0;
      worst = std::max(worst, std::abs(Sum({ light }) * count / all - 1.0));
    }
    double chiSquare = 0.0;
    for (size_t i = 1; i < found.size(); ++i)
    {
      const double expected = count * scene.Albedos[i] / albedos;
      chiSquare += std::pow(found[i] - expected, 2.0) / expected;
    }
    const std::string what = std::to_string(count) + " lights: ";
    CheckEqual(what + "on the black patch", found[0], 0);
    CheckEqual(what + "without light", CountDark(lights), 0);
    // Random ones would have 14 with a deviation of 5.3; a lattice has less, and rows of texels on
    // the patches' borders count for either.
    CheckAtMost(what + "chi-square of the patches' lights", chiSquare, 14.0 + 5.0 * 5.3,
      "fourteen degrees of freedom, five standard deviations");
    CheckAtMost(what + "a light's flux over the mean, less one", worst, 1e-4, "rounding");
    CheckRelative(what + "sum", Sum(lights), all, 2e-5, "rounding of weights");
  }
}

// Weights make the sum right for any importance.
VTK_INDIRECT_TEST(ImportanceUnbiased)
{
  PatchScene scene;
  scene.AddBox({ 1, 1, 0 }, { 2, 2, 1.2 }, { 0.8, 0.3, 0.1 });
  scene.AddSpot({ 5, 1, 4 }, { 1.5, 1.5, 0 }, 40.0, 1.0, { 0, 0, 1 });
  scene.AddPoint({ 0.5, 3.0, 1.5 }, { 1, 0, 0 });
  const double all = Sum(scene.DrawAll());
  for (const int method : { vtkImportanceLightSampler::APART, vtkImportanceLightSampler::TOGETHER })
  {
    for (const int levels : { 0, 1, 3 })
    {
      for (const double evenness : { 0.0, 0.25, 1.0 })
      {
        for (const double occlusion : { 0.0, 1.0 })
        {
          scene.Importance->SetWarping(method);
          scene.Importance->SetLevels(levels);
          scene.Importance->SetEvenness(evenness);
          scene.Importance->SetOcclusion(occlusion);
          const std::vector<VirtualLight> lights = scene.Draw(8192);
          const std::string what = "method " + std::to_string(method) + ", levels " +
            std::to_string(levels) + ", evenness " + std::to_string(evenness) + ", occlusion " +
            std::to_string(occlusion) + ": ";
          CheckEqual(what + "lights without light", CountDark(lights), 0);
          CheckRelative(what + "sum", Sum(lights), all, 0.02,
            "8192 lights whose flux differs by up to the albedos' 200");
        }
      }
    }
  }
  scene.CheckBuffers(2);
}

// One budget, divided by flux; lights without lit surfaces get no share.
VTK_INDIRECT_TEST(ImportanceBudget)
{
  PatchScene scene;
  scene.Importance->SetOcclusion(0.0);
  vtkLight* strong = scene.AddDirectional({ 0, 0.1, -1 });
  vtkLight* weak = scene.AddSpot({ 2, 2, 3 }, { 2, 2, 0 }, 30.0, 0.0, { 1, 0, 0 });
  scene.AddBox({ 8, 8, 0 }, { 9, 9, 1 }, { 0, 0, 0 });
  scene.AddSpot({ 8.5, 8.5, 4 }, { 8.5, 8.5, 0 }, 5.0, 0.0, { 1, 0, 0 });
  for (const double ratio : { 1.0, 0.1, 1e-6 })
  {
    for (const double scale : { 1e-9, 1.0, 1e6 })
    {
      strong->SetIntensity(scale);
      weak->SetIntensity(ratio * scale);
      const std::vector<VirtualLight> texels = scene.DrawAll();
      const double share = Sum(texels, 1) / Sum(texels);
      const std::vector<VirtualLight> lights = scene.Draw(500);
      const auto ofWeak = std::count_if(
        lights.begin(), lights.end(), [](const VirtualLight& light) { return light.Source == 1; });
      const std::string what =
        "1 : " + std::to_string(ratio) + " at " + std::to_string(scale) + ": ";
      CheckAbsolute(what + "lights of the weaker one", static_cast<double>(ofWeak), 500.0 * share,
        1.0, "a lattice along the sum of both");
      CheckEqual(what + "lights without light", CountDark(lights), 0);
      CheckRelative(what + "sum", Sum(lights), Sum(texels), 0.02,
        "500 lights, of which a quarter is spread evenly over albedos that differ");
    }
  }
  scene.CheckBuffers(3);
  // Nothing is lit.
  strong->SwitchOff();
  weak->SwitchOff();
  const std::vector<VirtualLight> none = scene.Draw(100);
  CheckEqual(
    "nothing lit: lights with light", static_cast<double>(none.size()) - CountDark(none), 0);
  scene.CheckBuffers(1);
}

// With a small bright patch half as many lights leave less error; in other scenes no more.
VTK_INDIRECT_TEST(ImportanceAgainstEven)
{
  for (const bool patch : { true, false })
  {
    Scene scene(48, 36);
    vtkNew<vtkImportanceLightSampler> importance;
    scene.AddQuad({ 0, 0, 0 }, { 0, 0, 4 }, { 4, 0, 0 }, glm::dvec3(patch ? 0.02 : 0.7));
    scene.AddQuad({ 0, 0, 0 }, { 0, 3, 0 }, { 0, 0, 4 }, glm::dvec3(patch ? 0.02 : 0.7));
    scene.AddQuad({ 2.5, 0.01, 2.5 }, { 2.5, 0.01, 3.0 }, { 3.0, 0.01, 2.5 }, glm::dvec3(0.9));
    scene.AddDirectional({ -0.7, -1, -0.4 });
    scene.SetEye({ 6, 4, 6 }, { 1.5, 0.8, 1.5 }, { 0, 1, 0 }, 40, 0.5, 20);
    scene.Pass->SetVisibility(vtkIndirectIlluminationPass::NONE);
    scene.Pass->SetReflectiveShadowMapResolution(128);
    scene.Gather->InterpolationOff();
    scene.Render();
    const Image truth = scene.Copy("irradiance");
    scene.Gather->SetModeToVirtualLights();
    const Image normal = scene.Copy("normal");
    auto measure = [&](vtkVirtualLightSampler* sampler)
    {
      scene.Pass->SetSampler(sampler);
      scene.Render();
      return FindRelativeError(scene.Copy("irradiance"), truth, normal);
    };
    double ratio = 1.0;
    for (const int count : { 64, 128, 256, 512 })
    {
      scene.Sampler->SetNumberOfLights(count);
      importance->SetNumberOfLights(patch ? count / 2 : count);
      ratio *= std::pow(measure(importance) / measure(scene.Sampler), 0.25);
    }
    CheckAtMost(patch ? "a small bright patch: error of half as many over that of even ones"
                      : "alike surfaces: error over that of even ones",
      ratio, patch ? 1.0 : 1.1, patch ? "the promise" : "other places of the same lattice");
    scene.Pass->SetSampler(nullptr);
  }
}

// A small motion of a light moves its virtual lights by little.
VTK_INDIRECT_TEST(ImportanceDoesNotJump)
{
  PatchScene scene;
  scene.AddBox({ 1, 1, 0 }, { 2, 2, 1.2 }, { 0.8, 0.3, 0.1 });
  scene.Gather->InterpolationOff();
  vtkLight* light = scene.AddSpot({ 5, 1, 4 }, { 1.5, 1.5, 0 }, 40.0, 1.0, { 1, 0, 0 });
  auto follow = [&](bool all, vtkVirtualLightSampler* sampler, int step)
  {
    all ? scene.Gather->SetModeToAllTexels() : scene.Gather->SetModeToVirtualLights();
    scene.Pass->SetSampler(sampler);
    Image last;
    double squares = 0.0;
    for (int frame = 0; frame < 10; ++frame)
    {
      light->SetPosition(5.0 - 0.01 * frame, 1.0 + 0.02 * frame, 4.0);
      scene.Sampler->SetNumberOfLights((12 + step * frame) * (12 + step * frame));
      scene.Render();
      const Image image = scene.Copy("irradiance");
      for (size_t i = 0; i < last.Values.size(); ++i)
      {
        squares += std::pow(static_cast<double>(image.Values[i]) - last.Values[i], 2.0);
      }
      last = image;
    }
    return std::sqrt(squares);
  };
  const double truth = follow(true, scene.Sampler, 0);
  CheckAtLeast("all texels: change", truth, 1e-3, "the test's own power");
  const double change = follow(false, scene.Importance, 0) / truth;
  CheckAtMost("change over that of all texels", change, 3.5,
    "one of 256 lights is near some receivers, and moves by texels; measured 2.75");
  scene.Sampler->SetPatternToJittered();
  CheckAtLeast("other random lights in each frame: over that",
    follow(false, scene.Sampler, 1) / truth / change, 2.0, "the test's own power");
}

// The sampler releases its resources, and makes them again.
VTK_INDIRECT_TEST(ImportanceRelease)
{
  PatchScene scene;
  scene.AddDirectional({ 0.2, 0.1, -1 });
  const double before = Sum(scene.Draw(64));
  Check(
    "it holds something", vtkIndirectSampler::Get(scene.Importance)->GetBytes() > 128u * 128u * 8u);
  scene.Importance->ReleaseGraphicsResources(nullptr);
  Check("without a window it keeps it",
    vtkIndirectSampler::Get(scene.Importance)->GetBytes() > 128u * 128u * 8u);
  scene.Importance->ReleaseGraphicsResources(scene.Window.Get());
  CheckEqual("bytes that are left",
    static_cast<double>(vtkIndirectSampler::Get(scene.Importance)->GetBytes()), 0);
  scene.Pass->SetSampler(nullptr);
  scene.Render();
  CheckEqual("the same again", Sum(scene.Draw(64)), before);
}
