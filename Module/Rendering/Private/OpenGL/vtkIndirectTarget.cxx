// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "OpenGL/vtkIndirectTarget.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace
{
struct Format
{
  unsigned int Internal;
  unsigned int External;
  unsigned int Type;
  int Components;
  int VTKType;
  size_t Bytes;
};

const Format Formats[] = {
  { GL_RGBA32F, GL_RGBA, GL_FLOAT, 4, VTK_FLOAT, 16 },
  { GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, 4, VTK_FLOAT, 8 },
  { GL_RG32F, GL_RG, GL_FLOAT, 2, VTK_FLOAT, 8 },
  { GL_R32F, GL_RED, GL_FLOAT, 1, VTK_FLOAT, 4 },
  { GL_RG16F, GL_RG, GL_HALF_FLOAT, 2, VTK_FLOAT, 4 },
  { GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4, VTK_UNSIGNED_CHAR, 4 },
  { GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 4, VTK_UNSIGNED_INT, 16 },
};

const Format& FindFormat(unsigned int internalFormat)
{
  for (const Format& format : Formats)
  {
    if (format.Internal == internalFormat)
    {
      return format;
    }
  }
  return Formats[0];
}

// Copies between the framebuffers bound for reading and drawing; true on success. The method of
// VTK's state may read OpenGL's error itself, or return silently.
bool Blit(vtkOpenGLState* state, const int from[2], const int to[2], int width, int height,
  unsigned int what)
{
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  // Errors of earlier calls stay until somebody asks: VTK's depth peeling leaves one. A lost
  // context has one after another.
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
  }
  glBlitFramebuffer(from[0], from[1], from[0] + width, from[1] + height, to[0], to[1],
    to[0] + width, to[1] + height, what, GL_NEAREST);
  return glGetError() == GL_NO_ERROR;
}

// vtkTextureObject's name for the depth format of the framebuffer that is bound for drawing; -1 if
// it has none, has samples or stencil, or is the window's own.
int FindBoundDepthFormat()
{
  GLint name = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &name);
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  auto get = [](GLenum attachment, GLenum parameter)
  {
    GLint value = GL_NONE;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, parameter, &value);
    return value;
  };
  const GLenum type = GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE;
  if (name == 0 || samples > 0 || get(GL_DEPTH_ATTACHMENT, type) == GL_NONE ||
    get(GL_STENCIL_ATTACHMENT, type) != GL_NONE)
  {
    return -1;
  }
  const bool isFloat =
    get(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
  switch (get(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE))
  {
    case 16:
      return vtkTextureObject::Fixed16;
    case 24:
      return vtkTextureObject::Fixed24;
    case 32:
      return isFloat ? vtkTextureObject::Float32 : vtkTextureObject::Fixed32;
    default:
      return -1;
  }
}
}

//------------------------------------------------------------------------------
size_t vtkIndirectTarget::FindBytes(unsigned int internalFormat)
{
  return FindFormat(internalFormat).Bytes;
}

//------------------------------------------------------------------------------
vtkIndirectTarget::vtkIndirectTarget(
  vtkIndirectResource* owner, const vtkIndirectChannels& channels, bool depth, int depthBits)
  : vtkIndirectResource(owner)
  , Channels(channels)
  , WithDepth(depth)
  , DepthBits(depthBits)
{
}

vtkIndirectTarget::~vtkIndirectTarget() = default;

//------------------------------------------------------------------------------
bool vtkIndirectTarget::Resize(
  vtkOpenGLRenderWindow* window, int width, int height, const vtkIndirectTarget* shared)
{
  const size_t channels = std::min(this->Limit, this->Channels.size());
  const int depthFormat = this->DepthFormat >= 0
    ? this->DepthFormat
    : (this->DepthBits == 16 ? vtkTextureObject::Fixed16 : vtkTextureObject::Float32);
  const bool otherDepth = this->Depth && depthFormat != this->AllocatedDepth;
  vtkTextureObject* sharedDepth = shared ? shared->GetDepthTexture() : nullptr;
  const bool detaches = this->SharedDepth && !sharedDepth;
  if (this->Framebuffer && (channels != this->Textures.size() || otherDepth || detaches))
  {
    this->Release(this->Window);
  }
  if (this->Framebuffer && window == this->Window && width == this->Width &&
    height == this->Height && sharedDepth == this->SharedDepth)
  {
    return true;
  }
  if (this->Framebuffer && window != this->Window)
  {
    this->Release(this->Window);
  }
  const int most = vtkTextureObject::GetMaximumTextureSize(window);
  if (width > most || height > most)
  {
    vtkErrorWithObjectMacro(window,
      "Indirect illumination needs an image of "
        << width << " x " << height << " pixels ("
        << (this->Channels.empty() ? "depth" : this->Channels[0].Name)
        << "); this OpenGL has images of " << most << " pixels along an edge at most.");
    this->Release(this->Window);
    return false;
  }
  this->Window = window;
  this->Width = width;
  this->Height = height;

  if (!this->Framebuffer)
  {
    this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Framebuffer->SetContext(window);
    for (size_t i = 0; i < channels; ++i)
    {
      const Format& format = FindFormat(this->Channels[i].InternalFormat);
      vtkNew<vtkTextureObject> texture;
      texture->SetContext(window);
      texture->SetInternalFormat(format.Internal);
      texture->SetFormat(format.External);
      texture->SetDataType(format.Type);
      texture->SetMinificationFilter(vtkTextureObject::Nearest);
      texture->SetMagnificationFilter(vtkTextureObject::Nearest);
      texture->SetWrapS(vtkTextureObject::ClampToEdge);
      texture->SetWrapT(vtkTextureObject::ClampToEdge);
      texture->Allocate2D(width, height, format.Components, format.VTKType);
      this->Textures.emplace_back(texture);
    }
    if (this->WithDepth)
    {
      this->Depth = vtkSmartPointer<vtkTextureObject>::New();
      this->Depth->SetContext(window);
      this->Depth->SetMinificationFilter(vtkTextureObject::Nearest);
      this->Depth->SetMagnificationFilter(vtkTextureObject::Nearest);
      this->Depth->AllocateDepth(width, height, depthFormat);
      this->AllocatedDepth = depthFormat;
    }
  }
  else
  {
    for (auto& texture : this->Textures)
    {
      texture->Resize(width, height);
    }
    if (this->Depth)
    {
      this->Depth->Resize(width, height);
    }
  }

  window->GetState()->PushFramebufferBindings();
  this->Framebuffer->Bind();
  for (size_t i = 0; i < this->Textures.size(); ++i)
  {
    this->Framebuffer->AddColorAttachment(static_cast<unsigned int>(i), this->Textures[i]);
  }
  this->SharedDepth = sharedDepth;
  if (this->Depth || sharedDepth)
  {
    this->Framebuffer->AddDepthAttachment(this->Depth ? this->Depth.Get() : sharedDepth);
  }
  this->ActivateChannels();
  const char* reason = "";
  const bool complete = vtkOpenGLFramebufferObject::GetFrameBufferStatus(
    vtkOpenGLFramebufferObject::GetDrawMode(), reason);
  window->GetState()->PopFramebufferBindings();
  if (!complete)
  {
    vtkErrorWithObjectMacro(window,
      "A framebuffer of " << width << " x " << height
                          << " pixels for indirect illumination is incomplete: " << reason);
    this->Release(window);
  }
  return complete;
}

//------------------------------------------------------------------------------
void vtkIndirectTarget::MatchDepth()
{
  const int format = FindBoundDepthFormat();
  this->DepthRefused = this->DepthRefused && format == this->DepthFormat;
  this->DepthFormat = format;
}

//------------------------------------------------------------------------------
bool vtkIndirectTarget::CopyDepth(const int origin[2]) const
{
  if (this->DepthFormat < 0 || this->DepthRefused)
  {
    return false;
  }
  vtkOpenGLState* state = this->Window->GetState();
  state->PushReadFramebufferBinding();
  this->Framebuffer->Bind(vtkOpenGLFramebufferObject::GetReadMode());
  const int own[2] = { 0, 0 };
  // A driver may report the size of its storage rather than the name of the format.
  this->DepthRefused = !Blit(state, own, origin, this->Width, this->Height, GL_DEPTH_BUFFER_BIT);
  state->PopReadFramebufferBinding();
  return !this->DepthRefused;
}

//------------------------------------------------------------------------------
unsigned int vtkIndirectTarget::FindBoundColorFormat()
{
  GLint name = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &name);
  GLint buffer = GL_NONE;
  glGetIntegerv(GL_DRAW_BUFFER, &buffer);
  if (name == 0 || buffer == GL_NONE)
  {
    return GL_RGBA8;
  }
  auto get = [buffer](GLenum parameter)
  {
    GLint value = GL_NONE;
    glGetFramebufferAttachmentParameteriv(
      GL_DRAW_FRAMEBUFFER, static_cast<GLenum>(buffer), parameter, &value);
    return value;
  };
  if (get(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) != GL_FLOAT)
  {
    return get(GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE) <= 8 ? GL_RGBA8 : GL_RGBA32F;
  }
  return get(GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE) <= 16 ? GL_RGBA16F : GL_RGBA32F;
}

//------------------------------------------------------------------------------
bool vtkIndirectTarget::CopyBoundColor(const int origin[2])
{
  vtkOpenGLState* state = this->Window->GetState();
  GLint name = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &name);
  GLint buffer = GL_NONE;
  glGetIntegerv(GL_DRAW_BUFFER, &buffer);
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned int>(name));
  GLint before = GL_NONE;
  glGetIntegerv(GL_READ_BUFFER, &before);
  state->vtkglReadBuffer(static_cast<unsigned int>(buffer));
  this->Framebuffer->Bind(vtkOpenGLFramebufferObject::GetDrawMode());
  this->Framebuffer->ActivateDrawBuffers(1);
  const int own[2] = { 0, 0 };
  const bool copied = Blit(state, origin, own, this->Width, this->Height, GL_COLOR_BUFFER_BIT);
  state->vtkglReadBuffer(static_cast<unsigned int>(before));
  state->PopFramebufferBindings();
  if (!copied)
  {
    vtkErrorWithObjectMacro(
      this->Window, "The picture cannot be copied for antialiasing; set Antialiasing off.");
  }
  return copied;
}

//------------------------------------------------------------------------------
bool vtkIndirectTarget::CopyFrom(const vtkIndirectTarget& source, int channel)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  source.Framebuffer->Bind(vtkOpenGLFramebufferObject::GetReadMode());
  source.Framebuffer->ActivateReadBuffer(static_cast<unsigned int>(channel));
  this->Framebuffer->Bind(vtkOpenGLFramebufferObject::GetDrawMode());
  this->Framebuffer->ActivateDrawBuffers(1);
  const int own[2] = { 0, 0 };
  const bool copied = Blit(state, own, own, this->Width, this->Height, GL_COLOR_BUFFER_BIT);
  state->PopFramebufferBindings();
  if (!copied)
  {
    vtkErrorWithObjectMacro(
      this->Window, "OpenGL cannot copy " << source.Channels[channel].Name << "; set Caching off.");
  }
  return copied;
}

//------------------------------------------------------------------------------
double vtkIndirectTarget::GetDepthStep() const
{
  switch (this->AllocatedDepth)
  {
    case vtkTextureObject::Fixed16:
      return std::ldexp(1.0, -16);
    case vtkTextureObject::Fixed32:
      return std::ldexp(1.0, -32);
    default:
      // Floats have 24 bits.
      return std::ldexp(1.0, -24);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectTarget::ActivateChannels()
{
  if (!this->Textures.empty())
  {
    this->Framebuffer->ActivateDrawBuffers(static_cast<unsigned int>(this->Textures.size()));
    return;
  }
  unsigned int none = GL_NONE;
  this->Window->GetState()->vtkglDrawBuffers(1, &none);
}

//------------------------------------------------------------------------------
void vtkIndirectTarget::Begin()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->ActivateChannels();
  if (!this->SharedDepth && !this->Textures.empty())
  {
    // Requires attachments of one size.
    this->Framebuffer->StartNonOrtho(this->Width, this->Height);
  }
  state->vtkglViewport(0, 0, this->Width, this->Height);
  state->vtkglScissor(0, 0, this->Width, this->Height);
}

//------------------------------------------------------------------------------
void vtkIndirectTarget::End()
{
  this->Window->GetState()->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void vtkIndirectTarget::Clear()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  unsigned int bits = GL_COLOR_BUFFER_BIT;
  if (this->Depth)
  {
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglClearDepth(1.0);
    bits |= GL_DEPTH_BUFFER_BIT;
  }
  state->vtkglClear(bits);
}

//------------------------------------------------------------------------------
void vtkIndirectTarget::ClearDepth()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_DEPTH_BUFFER_BIT);
}

//------------------------------------------------------------------------------
void vtkIndirectTarget::Activate(int channel, const vtkIndirectProgram& program) const
{
  this->Activate(channel, program, this->Channels[channel].Uniform);
}

//------------------------------------------------------------------------------
void vtkIndirectTarget::Activate(
  int channel, const vtkIndirectProgram& program, const char* uniform) const
{
  program.Bind(this->Textures[channel], uniform);
}

//------------------------------------------------------------------------------
void vtkIndirectTarget::ActivateDepth(const vtkIndirectProgram& program, const char* uniform) const
{
  program.Bind(this->Depth, uniform);
}

//------------------------------------------------------------------------------
std::vector<float> vtkIndirectTarget::ReadBack(int channel) const
{
  const bool depth = channel == DepthChannel;
  std::vector<float> values(static_cast<size_t>(this->Width) * this->Height * (depth ? 1 : 4));
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  if (!depth)
  {
    this->Framebuffer->ActivateReadBuffer(static_cast<unsigned int>(channel));
  }
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(
    0, 0, this->Width, this->Height, depth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, values.data());
  state->PopFramebufferBindings();
  return values;
}

//------------------------------------------------------------------------------
void vtkIndirectTarget::Write(int channel, const std::vector<float>& values, int row)
{
  vtkTextureObject* texture = this->Textures[channel];
  texture->Activate();
  this->Window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const int rows = static_cast<int>(values.size() / 4 / static_cast<size_t>(this->Width));
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, row, this->Width, std::min(rows, this->Height - row),
    GL_RGBA, GL_FLOAT, values.data());
  texture->Deactivate();
}

//------------------------------------------------------------------------------
void vtkIndirectTarget::WriteDepth(const int first[2], const int size[2], const float* values)
{
  this->Depth->Activate();
  this->Window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(
    GL_TEXTURE_2D, 0, first[0], first[1], size[0], size[1], GL_DEPTH_COMPONENT, GL_FLOAT, values);
  this->Depth->Deactivate();
}

//------------------------------------------------------------------------------
size_t vtkIndirectTarget::GetOwnBytes() const
{
  size_t perPixel = this->Depth ? this->DepthBits / 8 : 0;
  for (size_t i = 0; i < this->Textures.size(); ++i)
  {
    perPixel += FindBytes(this->Channels[i].InternalFormat);
  }
  return this->Framebuffer ? perPixel * this->Width * this->Height : 0;
}

//------------------------------------------------------------------------------
void vtkIndirectTarget::Print(std::ostream& os, vtkIndent indent) const
{
  os << indent << "Size: " << this->Width << " x " << this->Height << ", " << this->GetBytes()
     << " bytes\n";
  vtkIndirectPrintChannels(os, indent, this->Channels);
}

//------------------------------------------------------------------------------
void vtkIndirectTarget::ReleaseOwn(vtkWindow* window)
{
  if (this->Framebuffer)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Framebuffer = nullptr;
  }
  for (auto& texture : this->Textures)
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->Textures.clear();
  if (this->Depth)
  {
    this->Depth->ReleaseGraphicsResources(window);
    this->Depth = nullptr;
  }
  this->SharedDepth = nullptr;
  this->Width = this->Height = 0;
  this->Window = nullptr;
}
