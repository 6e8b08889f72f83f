// SPDX-License-Identifier: BSD-3-Clause
// Surfaces lit by the sky get the number of virtual lights that the sampler asks for, with every
// sampler.
#include "vtkIndirectTestUtilities.h"

#include "vtkEnvironmentLight.h"
#include "vtkImportanceLightSampler.h"
#include "vtkLightTreeSampler.h"
#include "vtkRSMGatherPass.h"
#include "vtkRandomWalkLightSampler.h"
#include "vtkUniformLightSampler.h"

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
}

VTK_INDIRECT_TEST(NumberOfLightsOfTheSky)
{
  CheckNumber<vtkUniformLightSampler>("uniform");
  CheckNumber<vtkImportanceLightSampler>("importance");
  CheckNumber<vtkLightTreeSampler>("tree");
  CheckNumber<vtkRandomWalkLightSampler>("random walk");
}
