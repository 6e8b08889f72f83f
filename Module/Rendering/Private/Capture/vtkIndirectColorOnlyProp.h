// SPDX-License-Identifier: BSD-3-Clause
// Stands for a prop that writes colour alone while the geometry buffer is drawn. What a shader does
// not write is undefined in all other channels, so this lets the prop draw into the colour, and
// then once more, with nothing blended, into the surface: zero, which is no surface. Without a prop
// it ends the list of those that are captured: whatever a pass draws after them is colour alone.
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
   * All must outlive what is drawn through this. prop may be null. lights: those to draw it with;
   * null: the ones that the renderer has then.
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
