// SPDX-License-Identifier: BSD-3-Clause
// Access to members of a renderer while a stage draws, without the events and modification times of
// their setters.
#pragma once

#include "vtkRenderer.h"

class vtkIndirectRendererAccess : public vtkRenderer
{
public:
  /** SetActiveCamera also frees a camera that only the renderer holds. */
  static vtkCamera*& Camera(vtkRenderer* renderer)
  {
    return renderer->*(&vtkIndirectRendererAccess::ActiveCamera);
  }
  /** SetLightCollection changes the renderer's modification time. */
  static vtkLightCollection*& LightsInUse(vtkRenderer* renderer)
  {
    return renderer->*(&vtkIndirectRendererAccess::Lights);
  }
  /** Returns the flag by which passes with a camera clear their framebuffer. */
  static vtkTypeBool& Clearing(vtkRenderer* renderer)
  {
    return renderer->*(&vtkIndirectRendererAccess::Erase);
  }
};
