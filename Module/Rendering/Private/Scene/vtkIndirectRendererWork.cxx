// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Scene/vtkIndirectRendererWork.h"

#include "Scene/vtkIndirectPropKind.h"
#include "vtkCamera.h"
#include "vtkImageProcessingPass.h"
#include "vtkLightsPass.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderState.h"

#include <algorithm>

namespace
{
// A camera that tells whether it is one eye of two. vtkCamera::Render, which a renderer without a
// pass calls, also sets that, but clears the window instead of the framebuffer of a pass around
// this one.
class StereoCamera : public vtkCamera
{
public:
  static void Update(vtkCamera* camera, vtkRenderWindow* window)
  {
    camera->*(&StereoCamera::Stereo) = window->GetStereoRender();
  }
};

// Returns true if the renderer's FXAA runs: it does not in framebuffers of other passes.
bool HasFXAA(const vtkRenderState* s)
{
  return s->GetRenderer()->GetUseFXAA() && !s->GetFrameBuffer();
}
}

vtkIndirectRendererWork::vtkIndirectRendererWork() = default;
vtkIndirectRendererWork::~vtkIndirectRendererWork() = default;

//------------------------------------------------------------------------------
bool vtkIndirectRendererWork::Begin(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  if (!renderer->IsActiveCameraCreated())
  {
    renderer->GetActiveCamera();
    renderer->ResetCamera();
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  StereoCamera::Update(renderer->GetActiveCamera(), window);
  int size[2];
  int origin[2] = { 0, 0 };
  if (auto* framebuffer = vtkOpenGLFramebufferObject::SafeDownCast(s->GetFrameBuffer()))
  {
    framebuffer->GetLastSize(size);
  }
  else
  {
    renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  }
  vtkOpenGLState* state = window->GetState();
  state->vtkglViewport(origin[0], origin[1], size[0], size[1]);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(origin[0], origin[1], size[0], size[1]);
  const bool erased = window->GetErase() && renderer->GetErase();
  if (erased)
  {
    renderer->Clear();
  }
  this->Lights->Render(s);
  return erased && !renderer->GetPreserveDepthBuffer();
}

//------------------------------------------------------------------------------
std::string vtkIndirectRendererWork::FindAntialiasing(const vtkRenderState* s, bool remaining)
{
  if (remaining && HasFXAA(s))
  {
    return "the renderer's FXAA";
  }
  for (vtkRenderPass* pass = s->GetRenderer()->GetPass(); pass;)
  {
    if (pass->IsA("vtkOpenGLFXAAPass") || pass->IsA("vtkSSAAPass"))
    {
      return pass->GetClassName();
    }
    auto* around = vtkImageProcessingPass::SafeDownCast(pass);
    pass = around ? around->GetDelegatePass() : nullptr;
  }
  return {};
}

//------------------------------------------------------------------------------
int vtkIndirectRendererWork::RenderFlat(const vtkRenderState* s)
{
  int drawn = 0;
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = s->GetPropArray()[i];
    const bool asked = !s->GetRequiredKeys() || prop->HasKeys(s->GetRequiredKeys());
    drawn +=
      asked && vtkIndirectPropKind::IsFlat(prop) ? prop->RenderOpaqueGeometry(s->GetRenderer()) : 0;
  }
  return drawn;
}

//------------------------------------------------------------------------------
int vtkIndirectRendererWork::RenderRemaining(const vtkRenderState* s)
{
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(s->GetRenderer());
  vtkProp** props = s->GetPropArray();
  const int count = s->GetPropArrayCount();
  int drawn = 0;
  const bool translucent = std::any_of(props, props + count,
    [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry() != 0; });
  if (translucent)
  {
    renderer->DeviceRenderTranslucentPolygonalGeometry(s->GetFrameBuffer());
  }
  if (HasFXAA(s))
  {
    if (!this->FXAA)
    {
      this->FXAA = vtkSmartPointer<vtkOpenGLFXAAFilter>::New();
    }
    if (renderer->GetFXAAOptions())
    {
      this->FXAA->UpdateConfiguration(renderer->GetFXAAOptions());
    }
    this->FXAA->Execute(renderer);
  }
  if (!translucent || !renderer->GetUseDepthPeeling() || !renderer->GetUseDepthPeelingForVolumes())
  {
    for (int i = 0; i < count; ++i)
    {
      drawn += props[i]->RenderVolumetricGeometry(renderer);
    }
  }
  for (int i = 0; i < count; ++i)
  {
    drawn += props[i]->RenderOverlay(renderer);
  }
  return drawn;
}

//------------------------------------------------------------------------------
void vtkIndirectRendererWork::Release(vtkWindow* window)
{
  this->Lights->ReleaseGraphicsResources(window);
  if (this->FXAA)
  {
    this->FXAA->ReleaseGraphicsResources();
    this->FXAA = nullptr;
  }
}
