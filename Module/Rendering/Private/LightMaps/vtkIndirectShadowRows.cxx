// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "LightMaps/vtkIndirectShadowRows.h"

#include "OpenGL/vtkIndirectArrayTexture.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "vtkOpenGLFramebufferObject.h"

#include <algorithm>

vtkIndirectShadowRows::vtkIndirectShadowRows(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Kernel(this, "vtkIndirectShadowRowsFS.glsl")
{
}

vtkIndirectShadowRows::~vtkIndirectShadowRows() = default;

//------------------------------------------------------------------------------
void vtkIndirectShadowRows::Forget(int layer)
{
  if (layer < static_cast<int>(this->Valid.size()))
  {
    this->Valid[layer] = false;
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectShadowRows::Update(
  vtkOpenGLRenderWindow* window, int unit, int slopes, int texels, int layers)
{
  if (this->Window != window || this->Texels != texels ||
    static_cast<int>(this->Valid.size()) < layers)
  {
    this->Release(this->Window);
    this->Texture = vtkSmartPointer<vtkIndirectArrayTexture>::New();
    this->Texture->Allocate(window, GL_RGBA32F, texels, layers);
    this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Framebuffer->SetContext(window);
    this->Window = window;
    this->Texels = texels;
    this->Valid.assign(layers, false);
  }
  if (std::find(this->Valid.begin(), this->Valid.begin() + layers, false) ==
    this->Valid.begin() + layers)
  {
    return true;
  }
  vtkOpenGLState* state = window->GetState();
  vtkIndirectFullScreenState kernelState(window);
  vtkIndirectProgram program = this->Kernel.Use(window);
  if (!program)
  {
    return false;
  }
  program->SetUniformi("vtkiShadowMaps", unit);
  program->SetUniformi("vtkiMapSlope", slopes);
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  state->vtkglViewport(0, 0, texels, texels);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  bool complete = true;
  for (int layer = 0; layer < layers && complete; ++layer)
  {
    if (!this->Valid[layer])
    {
      this->Texture->AttachLayer(GL_COLOR_ATTACHMENT0, layer);
      this->Framebuffer->ActivateDrawBuffers(1);
      const char* reason = "";
      complete = vtkOpenGLFramebufferObject::GetFrameBufferStatus(
        vtkOpenGLFramebufferObject::GetDrawMode(), reason);
      if (!complete)
      {
        vtkErrorWithObjectMacro(window,
          "Rows of light maps (" << texels << " x " << texels << " texels, " << layers
                                 << " layers) cannot be drawn: " << reason);
        break;
      }
      program->SetUniformi("vtkiLayer", layer);
      this->Kernel.Draw();
      this->Valid[layer] = true;
    }
  }
  state->PopFramebufferBindings();
  return complete;
}

//------------------------------------------------------------------------------
int vtkIndirectShadowRows::Activate()
{
  this->Texture->Activate();
  return this->Texture->GetTextureUnit();
}

//------------------------------------------------------------------------------
void vtkIndirectShadowRows::Deactivate()
{
  if (this->Texture)
  {
    this->Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
size_t vtkIndirectShadowRows::GetOwnBytes() const
{
  return 16 * this->Valid.size() * this->Texels * this->Texels;
}

//------------------------------------------------------------------------------
void vtkIndirectShadowRows::ReleaseOwn(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Texture->ReleaseGraphicsResources(window);
    this->Framebuffer = nullptr;
    this->Texture = nullptr;
  }
  this->Valid.clear();
  this->Texels = 0;
  this->Window = nullptr;
}
