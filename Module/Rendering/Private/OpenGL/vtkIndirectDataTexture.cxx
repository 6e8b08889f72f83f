// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "OpenGL/vtkIndirectDataTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace
{
// FormatsOfBytes of one to four components.
constexpr unsigned int ByteFormats[] = { GL_R8, GL_RG8, GL_RGB8, GL_RGBA8 };
constexpr unsigned int IntegerByteFormats[] = { GL_R8UI, GL_RG8UI, GL_RGB8UI, GL_RGBA8UI };
constexpr unsigned int IntegerFormats[] = { GL_R32UI, GL_RG32UI, GL_RGB32UI, GL_RGBA32UI };
constexpr unsigned int FormatsOfBytes[] = { GL_RED, GL_RG, GL_RGB, GL_RGBA };
constexpr unsigned int FormatsOfIntegers[] = { GL_RED_INTEGER, GL_RG_INTEGER, GL_RGB_INTEGER,
  GL_RGBA_INTEGER };
}

vtkIndirectDataTexture::vtkIndirectDataTexture(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
{
}

vtkIndirectDataTexture::~vtkIndirectDataTexture() = default;

//------------------------------------------------------------------------------
bool vtkIndirectDataTexture::Set(vtkOpenGLRenderWindow* window, ContentType content, int components,
  const glm::ivec3& size, const void* data, bool linear)
{
  const bool bytes = content == BYTES || content == INTEGER_BYTES;
  const int type = content == FLOATS ? VTK_FLOAT : bytes ? VTK_UNSIGNED_CHAR : VTK_UNSIGNED_INT;
  if (!this->Texture)
  {
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  }
  vtkTextureObject* texture = this->Texture;
  texture->SetContext(window);
  if (content != FLOATS)
  {
    texture->SetInternalFormat(content == BYTES ? ByteFormats[components - 1]
        : content == INTEGERS                   ? IntegerFormats[components - 1]
                                                : IntegerByteFormats[components - 1]);
    texture->SetFormat((content == BYTES ? FormatsOfBytes : FormatsOfIntegers)[components - 1]);
    texture->SetDataType(bytes ? GL_UNSIGNED_BYTE : GL_UNSIGNED_INT);
    window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  }
  const int filter = linear ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  texture->SetMinificationFilter(filter);
  texture->SetMagnificationFilter(filter);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  const auto extent = glm::uvec3(size);
  void* const texels = const_cast<void*>(data);
  const bool done = size.z > 0
    ? texture->Create3DFromRaw(extent.x, extent.y, extent.z, components, type, texels)
    : texture->Create2DFromRaw(extent.x, extent.y, components, type, texels);
  this->Bytes = static_cast<size_t>(extent.x) * extent.y * std::max(1u, extent.z) *
    static_cast<size_t>(components) * (bytes ? 1 : 4);
  return done;
}

//------------------------------------------------------------------------------
void vtkIndirectDataTexture::Activate(const vtkIndirectProgram& program, const char* uniform) const
{
  program.Bind(this->Texture, uniform);
}

//------------------------------------------------------------------------------
void vtkIndirectDataTexture::ReleaseOwn(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
  }
  this->Clear();
}

//------------------------------------------------------------------------------
void vtkIndirectDataTexture::Clear()
{
  this->Texture = nullptr;
  this->Bytes = 0;
}
