// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Capture/vtkIndirectCatchers.h"

#include "Capture/vtkSurfaceCapturePass.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderer.h"

namespace
{
const vtkIndirectChannels CatcherChannels = {
  { "catchers.open", "vtkiOpenLit", "VTK's shading of props that catch light, without shadows",
    GL_RGBA32F, "view", "VTK radiance" },
};
}

//------------------------------------------------------------------------------
vtkIndirectCatchers::vtkIndirectCatchers(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Open(this, CatcherChannels, true)
{
}

//------------------------------------------------------------------------------
bool vtkIndirectCatchers::Update(const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture)
{
  if (frame.Catchers.empty())
  {
    this->Release(frame.Window);
    return true;
  }
  if (!this->Open.Resize(frame.Window, frame.Size[0], frame.Size[1]))
  {
    return false;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  this->Open.Begin();
  this->Open.Clear();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDisable(GL_BLEND);
  capture->BeginEye(frame, nullptr, this->Open.GetFramebuffer(), this->Open.GetNumberOfChannels());
  for (vtkProp* prop : frame.Catchers)
  {
    prop->RenderOpaqueGeometry(frame.Renderer);
  }
  capture->EndStage();
  this->Open.End();
  return true;
}
