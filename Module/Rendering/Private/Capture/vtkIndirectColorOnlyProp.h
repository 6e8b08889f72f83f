// SPDX-License-Identifier: BSD-3-Clause
// Stands in for a prop that writes only colour while the geometry buffer is drawn. Outputs that a
// shader does not write are undefined, so this draws the prop into the colour, and then once more
// without blending into the surface: zero, which is no surface. Without a prop it ends the list of
// captured props: passes that draw after it write only colour.
#ifndef vtkIndirectColorOnlyProp_h
#define vtkIndirectColorOnlyProp_h

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

  double* GetBounds() override;
  vtkMTimeType GetRedrawMTime() override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override;
  vtkTypeBool HasOpaqueGeometry() override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;
  int RenderVolumetricGeometry(vtkViewport* viewport) override;
  int RenderOverlay(vtkViewport* viewport) override;

protected:
  vtkIndirectColorOnlyProp();
  ~vtkIndirectColorOnlyProp() override;

private:
  vtkIndirectColorOnlyProp(const vtkIndirectColorOnlyProp&) = delete;
  void operator=(const vtkIndirectColorOnlyProp&) = delete;

  vtkProp* Prop = nullptr;
  vtkSurfaceCapturePass* Capture = nullptr;
  vtkLightCollection* Lights = nullptr;
};

#endif
