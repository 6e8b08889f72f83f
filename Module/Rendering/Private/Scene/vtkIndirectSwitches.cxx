// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectSwitches.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAlgorithm.h"
#include "vtkHiddenLineRemovalPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkMapper.h"
#include "vtkMapper2D.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

namespace
{
// Returns true if an algorithm's data come from a vtkSelectVisiblePoints. known: algorithms already
// visited.
bool ComesFromVisiblePoints(vtkAlgorithm* algorithm, std::set<vtkAlgorithm*>& known)
{
  if (algorithm->IsA("vtkSelectVisiblePoints"))
  {
    return true;
  }
  if (!known.insert(algorithm).second)
  {
    return false;
  }
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      vtkAlgorithm* source = algorithm->GetInputAlgorithm(port, i);
      if (source && ComesFromVisiblePoints(source, known))
      {
        return true;
      }
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
bool vtkIndirectSwitches::RemovesHiddenLines(const vtkRenderState* s)
{
  return s->GetRenderer()->GetUseHiddenLineRemoval() &&
    vtkHiddenLineRemovalPass::WireframePropsExist(s->GetPropArray(), s->GetPropArrayCount());
}

//------------------------------------------------------------------------------
bool vtkIndirectSwitches::LooksDepthUp(const vtkRenderState* s)
{
  std::set<vtkAlgorithm*> known;
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = s->GetPropArray()[i];
    auto* flat = vtkActor2D::SafeDownCast(prop);
    auto* actor = vtkActor::SafeDownCast(prop);
    vtkAlgorithm* const mapper = flat ? static_cast<vtkAlgorithm*>(flat->GetMapper())
      : actor                         ? actor->GetMapper()
                                      : nullptr;
    if (mapper && ComesFromVisiblePoints(mapper, known))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
std::string vtkIndirectSwitches::FindRefusal(const vtkRenderState* s)
{
  static const struct
  {
    const char* Pass;
    const char* Why;
  } refused[] = { { "vtkSSAOPass",
                    " reads positions and normals that mappers draw into its own images" },
    { "vtkOutlineGlowPass", " draws the props that it is given as a mask" } };
  for (vtkRenderPass* pass = s->GetRenderer()->GetPass(); pass;)
  {
    for (const auto& entry : refused)
    {
      if (pass->IsA(entry.Pass))
      {
        return std::string(entry.Pass) + " around the pass" + entry.Why;
      }
    }
    auto* around = vtkImageProcessingPass::SafeDownCast(pass);
    pass = around ? around->GetDelegatePass() : nullptr;
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkIndirectSwitches::Update(const vtkRenderState* s, bool ownDelegate)
{
  vtkRenderer* renderer = s->GetRenderer();
  this->LeftOut.clear();
  if (ownDelegate && RemovesHiddenLines(s))
  {
    this->LeftOut.emplace_back("hidden-line removal of the renderer",
      "DelegatePass draws the lines; a vtkHiddenLineRemovalPass in it removes hidden ones");
  }
  if (renderer->GetUseSSAO())
  {
    this->LeftOut.emplace_back("UseSSAO of the renderer",
      "what surfaces hide from each other is in the light of the sky and of lights");
  }
  if (renderer->GetUseShadows())
  {
    this->LeftOut.emplace_back(
      "UseShadows of the renderer", "the pass has shadows of its own, property Shadows");
  }
  vtkTexture* environment =
    renderer->GetUseImageBasedLighting() ? renderer->GetEnvironmentTexture() : nullptr;
  if (environment && environment->GetCubeMap())
  {
    this->LeftOut.emplace_back("light of the renderer's environment texture",
      "it is a cube map; an image of latitudes and longitudes lights surfaces, with shadows");
  }
  std::set<std::string> still;
  for (const auto& entry : this->LeftOut)
  {
    if (this->Said.count(entry.first) > 0)
    {
      still.insert(entry.first);
    }
  }
  this->Said = still;
}
