// SPDX-License-Identifier: BSD-3-Clause
#include "CardMethods.h"

#include "CardScene.h"

#include "vtkIndirectIlluminationPass.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRadianceHintsPass.h"

#include <stdexcept>
#include <string>

namespace
{
using Pass = vtkIndirectIlluminationPass;

// A method of one estimator, which `set` changes from its defaults.
template <typename Estimator, typename Function>
std::function<void(Pass*)> With(Function set)
{
  return [set](Pass* pass)
  {
    vtkNew<Estimator> estimator;
    set(estimator.Get(), pass);
    pass->SetEstimator(estimator);
  };
}
}

//------------------------------------------------------------------------------
const std::vector<card::Method>& card::GetMethods()
{
  using Gather = vtkRSMGatherPass;
  using Multiresolution = vtkMultiresolutionSplattingPass;
  using Hints = vtkRadianceHintsPass;
  constexpr double edges = 0.01; // see Method::Share
  constexpr double grazing = 0.06;
  constexpr double walked = 1.0;
  static const std::vector<Method> methods = {
    { "vtk", "VTK's plain frame", {}, edges },
    { "ssao", "VTK's screen-space ambient occlusion", {}, edges },
    { "automatic", "the pass with nothing set", [](Pass*) {}, walked },
    { "gather", "256 virtual lights, every fourth pixel", With<Gather>([](Gather*, Pass*) {}),
      walked },
    { "gather-every-pixel", "256 virtual lights",
      With<Gather>([](Gather* gather, Pass*) { gather->InterpolationOff(); }), walked },
    { "gather-neighborhood", "256 texels about the receiver's place in each map",
      With<Gather>([](Gather* gather, Pass*) { gather->SetModeToNeighborhood(); }), grazing },
    { "multiresolution-half", "finest subsplats of two by two pixels",
      With<Multiresolution>(
        [](Multiresolution* splatting, Pass*) { splatting->SetFinestLevelToHalfResolution(); }),
      walked },
    { "multiresolution-occupancy", "with visibility by voxels",
      With<Multiresolution>([](Multiresolution*, Pass* pass) { pass->SetVisibilityToVoxels(); }),
      walked },
    { "hints", "radiance hints, one bounce", With<Hints>([](Hints*, Pass*) {}), grazing },
    { "hints-8", "radiance hints, eight bounces",
      With<Hints>([](Hints*, Pass* pass) { pass->SetNumberOfBounces(8); }), grazing },
  };
  return methods;
}

//------------------------------------------------------------------------------
const card::Method& card::FindMethod(const std::string& name)
{
  std::string known;
  for (const Method& method : GetMethods())
  {
    if (method.Name == name)
    {
      return method;
    }
    known += std::string(known.empty() ? "" : ", ") + method.Name;
  }
  throw std::runtime_error("there is no method '" + name + "', but " + known);
}

//------------------------------------------------------------------------------
vtkIndirectIlluminationPass* card::Enable(Scene& scene, const Method& method)
{
  scene.Renderer->SetUseSSAO(false);
  if (!method.SetUp)
  {
    scene.Renderer->SetPass(nullptr);
    if (method.Name == std::string("ssao"))
    {
      // Usual choices for these: a tenth and a thousandth of the scene.
      scene.Renderer->SetSSAORadius(0.1 * scene.GetDiagonal());
      scene.Renderer->SetSSAOBias(0.001 * scene.GetDiagonal());
      scene.Renderer->SetSSAOKernelSize(32);
      scene.Renderer->SSAOBlurOn();
      scene.Renderer->SetUseSSAO(true);
    }
    return nullptr;
  }
  vtkNew<vtkIndirectIlluminationPass> pass;
  method.SetUp(pass);
  scene.Renderer->SetPass(pass);
  return pass;
}
