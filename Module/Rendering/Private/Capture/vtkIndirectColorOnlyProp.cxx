// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/vtkIndirectColorOnlyProp.h"

#include "Capture/vtkSurfaceCapturePass.h"
#include "Scene/vtkIndirectLightScope.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkIndirectColorOnlyProp);

//------------------------------------------------------------------------------
void vtkIndirectColorOnlyProp::Set(
  vtkProp* prop, vtkSurfaceCapturePass* capture, vtkLightCollection* lights)
{
  this->Prop = prop;
  this->Lights = lights;
  this->Capture = capture;
  this->SetUseBounds(prop && prop->GetUseBounds());
  if (prop)
  {
    // Passes choose props by their keys.
    this->SetPropertyKeys(prop->GetPropertyKeys());
  }
}

//------------------------------------------------------------------------------
int vtkIndirectColorOnlyProp::RenderOpaqueGeometry(vtkViewport* viewport)
{
  this->Capture->DrawChannel(vtkSurfaceCapturePass::Color);
  if (!this->Prop)
  {
    return 0;
  }
  // The sky's light does not illuminate props without a surface.
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  const vtkIndirectLightScope lights(renderer, this->Lights);
  if (lights.GetReplaced())
  {
    vtkIndirectLightScope::Read(renderer);
  }
  const int drawn = this->Prop->RenderOpaqueGeometry(viewport);
  if (drawn > 0)
  {
    this->Capture->DrawChannel(vtkSurfaceCapturePass::NoSurface);
    this->Prop->RenderOpaqueGeometry(viewport);
    this->Capture->DrawChannel(vtkSurfaceCapturePass::Color);
  }
  return drawn;
}
