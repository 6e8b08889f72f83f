// SPDX-License-Identifier: BSD-3-Clause
// Surfaces lit by the sky, and the light that glass bends, get the number of virtual lights that
// the sampler asks for, with every sampler.
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkEnvironmentLight.h"
#include "vtkImportanceLightSampler.h"
#include "vtkLightTreeSampler.h"
#include "vtkProperty.h"
#include "vtkRSMGatherPass.h"
#include "vtkRandomWalkLightSampler.h"
#include "vtkUniformLightSampler.h"

#include <string>

using namespace vtkIndirectTest;

namespace
{
template <typename SamplerType>
void CheckNumber(const std::string& what)
{
  Scene scene(32, 24);
  scene.AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0.8, 0.8, 0.8 });
  scene.AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.3, 0.6, 0.9 });
  scene.AddPoint({ 0.8, 0.9, 0.8 }, { 0, 0, 1 });
  scene.SetEye({ 2.2, 1.6, 2.3 }, { 0.4, 0.3, 0.4 }, { 0, 1, 0 }, 36, 0.5, 6);
  scene.Gather->SetModeToVirtualLights();
  scene.Pass->SetReflectiveShadowMapResolution(64);
  vtkNew<vtkEnvironmentLight> sky;
  vtkNew<SamplerType> sampler;
  sampler->SetNumberOfLights(40);
  scene.Pass->SetSampler(sampler);
  scene.Render();
  const double own = scene.ReadReport("virtual_lights");
  scene.Pass->SetEnvironment(sky);
  scene.Render();
  CheckAtMost(what + ": lights of the sky", scene.ReadReport("virtual_lights") - own, 40.0,
    "so many are asked for");
  CheckAtLeast(what + ": lights of the sky", scene.ReadReport("virtual_lights") - own, 10.0,
    "the test's own power");
  scene.Pass->SetEnvironment(nullptr);
  scene.Pass->SetSampler(nullptr);
}

// Lights of a ball of glass beside the others of a corner, by a number of lights.
template <typename SamplerType>
double CountLightsOfGlass(int number)
{
  double lights[2] = { 0.0, 0.0 };
  for (const bool glass : { false, true })
  {
    Scene scene(32, 24);
    scene.AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0.8, 0.8, 0.8 });
    scene.AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.3, 0.6, 0.9 });
    scene.AddPoint({ 0.8, 0.9, 0.8 }, { 0, 0, 1 });
    if (glass)
    {
      vtkProperty* property =
        scene.AddSphere({ 0.5, 0.4, 0.5 }, 0.2, 32, { 1, 1, 1 })->GetProperty();
      property->SetInterpolationToPBR();
      property->SetBaseIOR(1.5);
      property->SetOpacity(0.1);
      property->SetRoughness(0.1);
    }
    scene.SetEye({ 2.2, 1.6, 2.3 }, { 0.4, 0.3, 0.4 }, { 0, 1, 0 }, 36, 0.5, 6);
    scene.Gather->SetModeToVirtualLights();
    scene.Pass->SetReflectiveShadowMapResolution(64);
    vtkNew<SamplerType> sampler;
    sampler->SetNumberOfLights(number);
    scene.Pass->SetSampler(sampler);
    scene.Render();
    lights[glass ? 1 : 0] = scene.ReadReport("virtual_lights");
    scene.Pass->SetSampler(nullptr);
  }
  return lights[1] - lights[0];
}

template <typename SamplerType>
void CheckGlass(const std::string& what)
{
  double before = 0.0;
  for (const int number : { 40, 160 })
  {
    const double lights = CountLightsOfGlass<SamplerType>(number);
    const std::string name = what + " of " + std::to_string(number) + ": lights of glass";
    CheckAtMost(name, lights, 2.0 * number, "what is reflected and what is transmitted");
    CheckAtLeast(name, lights, 1.5 * before + 1.0, "four times as many are asked for");
    before = lights;
  }
}
}

VTK_INDIRECT_TEST(NumberOfLightsOfTheSky)
{
  CheckNumber<vtkUniformLightSampler>("uniform");
  CheckNumber<vtkImportanceLightSampler>("importance");
  CheckNumber<vtkLightTreeSampler>("tree");
  CheckNumber<vtkRandomWalkLightSampler>("random walk");
}

VTK_INDIRECT_TEST(NumberOfLightsOfGlass)
{
  CheckGlass<vtkUniformLightSampler>("uniform");
  CheckGlass<vtkImportanceLightSampler>("importance");
  CheckGlass<vtkLightTreeSampler>("tree");
  CheckGlass<vtkRandomWalkLightSampler>("random walk");
}
