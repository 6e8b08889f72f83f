// SPDX-License-Identifier: BSD-3-Clause
// Stands in for a prop that writes only colour while the geometry buffer is drawn. Outputs that a
// shader does not write are undefined, so this draws the prop into the colour, and then once more
// without blending into the surface: zero, which is no surface. Without a prop it ends the list of
// captured props: passes that draw after it write only colour.
#pragma once

#include "vtkProp.h"

class vtkLightCollection;
class vtkSurfaceCapturePass;

class vtkIndirectColorOnlyProp : public vtkProp
{
public:
  static vtkIndirectColorOnlyProp* New();
  vtkTypeMacro(vtkIndirectColorOnlyProp, vtkProp);

  /**
   * All must outlive the draws through this. prop may be null. lights: lights to draw it with;
   * null: those that the renderer has at that time.
   */
  void Set(vtkProp* prop, vtkSurfaceCapturePass* capture, vtkLightCollection* lights);

  double* GetBounds() override { return this->Prop ? this->Prop->GetBounds() : nullptr; }
  vtkMTimeType GetRedrawMTime() override
  {
    return this->Prop ? this->Prop->GetRedrawMTime() : this->GetMTime();
  }
  vtkTypeBool HasTranslucentPolygonalGeometry() override
  {
    return this->Prop && this->Prop->HasTranslucentPolygonalGeometry();
  }
  vtkTypeBool HasOpaqueGeometry() override { return this->Prop && this->Prop->HasOpaqueGeometry(); }
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override
  {
    return this->Prop ? this->Prop->RenderTranslucentPolygonalGeometry(viewport) : 0;
  }
  int RenderVolumetricGeometry(vtkViewport* viewport) override
  {
    return this->Prop ? this->Prop->RenderVolumetricGeometry(viewport) : 0;
  }
  int RenderOverlay(vtkViewport* viewport) override
  {
    return this->Prop ? this->Prop->RenderOverlay(viewport) : 0;
  }

private:
  vtkProp* Prop = nullptr;
  vtkSurfaceCapturePass* Capture = nullptr;
  vtkLightCollection* Lights = nullptr;
};
