// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "OpenGL/vtkIndirectArrayTexture.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"

vtkStandardNewMacro(vtkIndirectArrayTexture);

//------------------------------------------------------------------------------
void vtkIndirectArrayTexture::Allocate(
  vtkOpenGLRenderWindow* window, unsigned int internalFormat, int texels, int layers)
{
  const bool depth = internalFormat == GL_DEPTH_COMPONENT32F;
  this->SetContext(window);
  this->Target = GL_TEXTURE_2D_ARRAY;
  this->InternalFormat = internalFormat;
  this->Format = depth ? GL_DEPTH_COMPONENT : GL_RGBA;
  this->Type = GL_FLOAT;
  this->Width = this->Height = static_cast<unsigned int>(texels);
  this->Depth = static_cast<unsigned int>(layers);
  this->SetMinificationFilter(Nearest);
  this->SetMagnificationFilter(Nearest);
  this->SetWrapS(ClampToEdge);
  this->SetWrapT(ClampToEdge);
  this->SetMaxLevel(0);
  // CreateTexture sets them; VTK up to 9.4 cannot set them for layers later on, and asserts.
  this->AutoParametersOff();
  this->Context->ActivateTexture(this);
  this->CreateTexture();
  this->Bind();
  glTexImage3D(this->Target, 0, static_cast<int>(internalFormat), texels, texels, layers, 0,
    this->Format, this->Type, nullptr);
  this->Deactivate();
}

//------------------------------------------------------------------------------
void vtkIndirectArrayTexture::AttachLayer(unsigned int attachment, int layer)
{
  glFramebufferTextureLayer(GL_DRAW_FRAMEBUFFER, attachment, this->Handle, 0, layer);
}
