// SPDX-License-Identifier: BSD-3-Clause
// Other lights in a renderer while this lives, without events and modification times: its own
// collection is not touched.
#ifndef vtkIndirectLightScope_h
#define vtkIndirectLightScope_h

#include "Frame/vtkIndirectRendererAccess.h"
#include "vtkLightCollection.h"
#include "vtkOpenGLRenderer.h"

class vtkIndirectLightScope
{
public:
  /** Without lights nothing changes. They must outlive this. Read is to be called before drawing.
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

  /** Those that were there before; null where nothing has changed. */
  vtkLightCollection* GetReplaced() const { return this->Replaced; }

  /** Lets the renderer count its lights, which mappers ask it for. Of none it may make one. */
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

#endif
