// SPDX-License-Identifier: BSD-3-Clause
// Adds a light that emits nothing to a renderer without lights, for the lifetime of this object:
// without any light VTK draws surfaces unlit, in their full colour and without normals.
#pragma once

#include "Scene/vtkIndirectFrame.h"
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
      // Added directly to the collection, so that the renderer is not modified.
      this->Renderer->GetLights()->AddItem(this->Light);
      // Mappers that draw before the eye's lights pass must know the light, too.
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
