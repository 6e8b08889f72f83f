// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "OpenGL/vtkIndirectLayeredTarget.h"

#include "OpenGL/vtkIndirectArrayTexture.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
vtkIndirectLayeredTarget::vtkIndirectLayeredTarget(
  vtkIndirectResource* owner, const vtkIndirectChannels& channels, bool depth)
  : vtkIndirectResource(owner)
  , Channels(channels)
  , HasDepth(depth)
  , NumberOfChannels(static_cast<int>(channels.size()))
{
}

vtkIndirectLayeredTarget::~vtkIndirectLayeredTarget() = default;

//------------------------------------------------------------------------------
bool vtkIndirectLayeredTarget::Resize(
  vtkOpenGLRenderWindow* window, int texels, int layers, bool& lost)
{
  lost = false;
  if (this->Window == window && this->Texels == texels && this->Layers >= layers &&
    this->GetNumberOfChannels() == this->NumberOfChannels)
  {
    return true;
  }
  lost = true;
  this->Release(this->Window);
  if (this->RefusedBy == window && this->RefusedTexels == texels && this->RefusedLayers == layers)
  {
    return false;
  }
  this->RefusedBy = window;
  this->RefusedTexels = texels;
  this->RefusedLayers = layers;

  int maximumTexels = 0;
  int maximumLayers = 0;
  vtkOpenGLState* state = window->GetState();
  state->vtkglGetIntegerv(GL_MAX_TEXTURE_SIZE, &maximumTexels);
  state->vtkglGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &maximumLayers);
  if (texels > maximumTexels || layers > maximumLayers)
  {
    vtkErrorWithObjectMacro(window,
      "Light maps of " << texels << " x " << texels << " texels in " << layers
                       << " layers are beyond this OpenGL's limits of " << maximumTexels
                       << " texels and " << maximumLayers << " layers.");
    return false;
  }

  this->Window = window;
  this->Texels = texels;
  this->Layers = layers;
  for (int i = 0; i < this->NumberOfChannels; ++i)
  {
    auto texture = vtkSmartPointer<vtkIndirectArrayTexture>::New();
    texture->Allocate(window, this->Channels[i].InternalFormat, texels, layers);
    this->Textures.push_back(texture);
  }
  if (this->HasDepth)
  {
    this->Depth = vtkSmartPointer<vtkIndirectArrayTexture>::New();
    this->Depth->Allocate(window, GL_DEPTH_COMPONENT32F, texels, layers);
  }
  this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Framebuffer->SetContext(window);

  this->BeginLayer(0);
  const char* reason = "";
  const bool complete = vtkOpenGLFramebufferObject::GetFrameBufferStatus(
    vtkOpenGLFramebufferObject::GetDrawMode(), reason);
  this->End();
  if (!complete)
  {
    vtkErrorWithObjectMacro(window,
      "The framebuffer of the light maps (" << texels << " x " << texels << " texels, " << layers
                                            << " layers) is incomplete: " << reason);
    this->Release(window);
    return false;
  }
  this->RefusedBy = nullptr;
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectLayeredTarget::BeginLayer(int layer)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  for (int i = 0; i < this->NumberOfChannels; ++i)
  {
    this->Textures[i]->AttachLayer(GL_COLOR_ATTACHMENT0 + i, layer);
  }
  this->Framebuffer->ActivateDrawBuffers(static_cast<unsigned int>(this->NumberOfChannels));
  state->vtkglViewport(0, 0, this->Texels, this->Texels);
  state->vtkglScissor(0, 0, this->Texels, this->Texels);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (this->Depth)
  {
    this->Depth->AttachLayer(GL_DEPTH_ATTACHMENT, layer);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    state->vtkglClearDepth(1.0);
    state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectLayeredTarget::End()
{
  this->Window->GetState()->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void vtkIndirectLayeredTarget::Activate(int channel, const vtkIndirectProgram& program)
{
  program.Bind(this->Textures[channel], this->Channels[channel].Uniform);
}

//------------------------------------------------------------------------------
int vtkIndirectLayeredTarget::Activate(int channel)
{
  this->Textures[channel]->Activate();
  return this->Textures[channel]->GetTextureUnit();
}

//------------------------------------------------------------------------------
int vtkIndirectLayeredTarget::ActivateShadow()
{
  this->Depth->Activate();
  return this->Depth->GetTextureUnit();
}

//------------------------------------------------------------------------------
void vtkIndirectLayeredTarget::Deactivate()
{
  for (const auto& texture : this->Textures)
  {
    texture->Deactivate();
  }
  if (this->Depth)
  {
    this->Depth->Deactivate();
  }
}

//------------------------------------------------------------------------------
size_t vtkIndirectLayeredTarget::GetOwnBytes() const
{
  size_t perTexel = this->HasDepth ? 4 : 0;
  for (int i = 0; i < this->NumberOfChannels; ++i)
  {
    perTexel += vtkIndirectTarget::FindBytes(this->Channels[i].InternalFormat);
  }
  return perTexel * this->Texels * this->Texels * this->Layers;
}

//------------------------------------------------------------------------------
void vtkIndirectLayeredTarget::ReleaseOwn(vtkWindow* window)
{
  if (this->Framebuffer)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Framebuffer = nullptr;
  }
  for (const auto& texture : this->Textures)
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->Textures.clear();
  if (this->Depth)
  {
    this->Depth->ReleaseGraphicsResources(window);
    this->Depth = nullptr;
  }
  this->Texels = this->Layers = 0;
  this->Window = nullptr;
}
