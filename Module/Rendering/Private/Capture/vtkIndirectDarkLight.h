// SPDX-License-Identifier: BSD-3-Clause
// A light that emits nothing, in a renderer that has none, while this lives: without any light VTK
// draws surfaces unlit, in their full colour and without normals.
#ifndef vtkIndirectDarkLight_h
#define vtkIndirectDarkLight_h

#include "Frame/vtkIndirectFrame.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRenderer.h"

class vtkIndirectDarkLight
{
public:
  explicit vtkIndirectDarkLight(const vtkIndirectFrame& frame)
    : Renderer(frame.Lights.empty() ? frame.Renderer : nullptr)
  {
    if (this->Renderer)
    {
      this->Light->SetIntensity(0.0);
      this->Light->SetLightTypeToSceneLight();
      // Not by the renderer, for whom nothing changes.
      this->Renderer->GetLights()->AddItem(this->Light);
      // Mappers that draw before the eye's lights pass shall know it, too.
      auto* renderer = vtkOpenGLRenderer::SafeDownCast(this->Renderer);
      if (renderer)
      {
        renderer->UpdateLights();
      }
    }
  }
  ~vtkIndirectDarkLight()
  {
    if (this->Renderer)
    {
      this->Renderer->GetLights()->RemoveItem(this->Light);
    }
  }
  vtkIndirectDarkLight(const vtkIndirectDarkLight&) = delete;
  void operator=(const vtkIndirectDarkLight&) = delete;

private:
  vtkRenderer* Renderer;
  vtkNew<vtkLight> Light;
};

#endif
