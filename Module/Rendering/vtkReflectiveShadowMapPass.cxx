// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkReflectiveShadowMapPass.h"

#include "Capture/vtkSurfaceCapturePass.h"
#include "Maps/vtkIndirectLightMaps.h"
#include "OpenGL/vtkIndirectKey.h"
#include "Plan/vtkIndirectPlan.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkReflectiveShadowMapPass);

//------------------------------------------------------------------------------
vtkReflectiveShadowMapPass::vtkReflectiveShadowMapPass()
  : Maps(std::make_unique<vtkIndirectLightMaps>(nullptr, this))
{
}

vtkReflectiveShadowMapPass::~vtkReflectiveShadowMapPass() = default;

//------------------------------------------------------------------------------
void vtkReflectiveShadowMapPass::SetResolution(int texels)
{
  const int clamped = texels == 0 ? 0 : std::min(std::max(texels, 1), 16384);
  if (this->Settings.Resolution != clamped)
  {
    this->Settings.Resolution = clamped;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkReflectiveShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Resolution: " << this->Settings.Resolution << "\n";
  this->Maps->Print(os, indent);
}

//------------------------------------------------------------------------------
int vtkReflectiveShadowMapPass::GetNumberOfMaps() const
{
  return this->Maps->GetNumberOfMaps();
}

//------------------------------------------------------------------------------
void vtkReflectiveShadowMapPass::Render(const vtkRenderState* s)
{
  vtkIndirectFrame frame;
  frame.Build(s);
  const vtkIndirectPlan plan = vtkIndirectPlan::Make(frame, {}, {}, {});
  if (!plan.WhyDelegate.empty())
  {
    this->Maps->Clear();
    return;
  }
  vtkNew<vtkSurfaceCapturePass> capture;
  capture->SetOutputs({ false, false, false });
  capture->Attach(frame);
  this->Maps->Update(frame, plan, capture, this->Settings.Resolution);
  capture->Detach();
}

//------------------------------------------------------------------------------
void vtkReflectiveShadowMapPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Maps->Release(window);
}
