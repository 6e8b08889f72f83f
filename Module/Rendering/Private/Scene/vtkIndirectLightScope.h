// SPDX-License-Identifier: BSD-3-Clause
// Replaces the lights of a renderer during the object's lifetime, without events and modification
// times. The renderer's own collection stays unchanged.
#pragma once

#include "Scene/vtkIndirectRendererAccess.h"
#include "vtkLightCollection.h"
#include "vtkOpenGLRenderer.h"

class vtkIndirectLightScope
{
public:
  /**
   * Replaces the lights; null lights change nothing. The lights must outlive this object. Call
   * Read before drawing.
   */
  vtkIndirectLightScope(vtkRenderer* renderer, vtkLightCollection* lights)
    : Renderer(lights ? renderer : nullptr)
  {
    if (this->Renderer)
    {
      this->Replaced = vtkIndirectRendererAccess::LightsInUse(this->Renderer);
      vtkIndirectRendererAccess::LightsInUse(this->Renderer) = lights;
    }
  }
  ~vtkIndirectLightScope()
  {
    if (this->Renderer)
    {
      vtkIndirectRendererAccess::LightsInUse(this->Renderer) = this->Replaced;
      Read(this->Renderer);
    }
  }
  vtkIndirectLightScope(const vtkIndirectLightScope&) = delete;
  void operator=(const vtkIndirectLightScope&) = delete;

  /** Returns the lights that were replaced; null if nothing was replaced. */
  vtkLightCollection* GetReplaced() const { return this->Replaced; }

  /** Makes the renderer count its lights for mappers. A renderer without lights may create one. */
  static void Read(vtkRenderer* renderer)
  {
    auto* opengl = vtkOpenGLRenderer::SafeDownCast(renderer);
    if (opengl &&
      (opengl->GetLights()->GetNumberOfItems() > 0 || !opengl->GetAutomaticLightCreation()))
    {
      opengl->UpdateLights();
    }
  }

private:
  vtkRenderer* Renderer;
  vtkLightCollection* Replaced = nullptr;
};
