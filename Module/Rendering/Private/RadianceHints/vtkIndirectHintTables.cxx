// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "RadianceHints/vtkIndirectHintTables.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

vtkIndirectHintTables::vtkIndirectHintTables() = default;
vtkIndirectHintTables::~vtkIndirectHintTables() = default;

//------------------------------------------------------------------------------
vtkTextureObject* vtkIndirectHintTables::Begin(Table table, vtkOpenGLRenderWindow* window)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  this->Textures[table] = texture;
  return texture;
}

//------------------------------------------------------------------------------
void vtkIndirectHintTables::Make(
  Table table, vtkOpenGLRenderWindow* window, std::vector<glm::vec4> texels, int width)
{
  const size_t rows = std::max<size_t>(1, (texels.size() + width - 1) / width);
  texels.resize(rows * width, glm::vec4(0.0f));
  this->Begin(table, window)
    ->Create2DFromRaw(static_cast<unsigned int>(width), static_cast<unsigned int>(rows), 4,
      VTK_FLOAT, &texels[0].x);
}

//------------------------------------------------------------------------------
void vtkIndirectHintTables::Make(Table table, vtkOpenGLRenderWindow* window, const glm::ivec3& size,
  const std::vector<unsigned char>& bytes)
{
  vtkTextureObject* texture = this->Begin(table, window);
  texture->SetInternalFormat(GL_RG8);
  texture->SetFormat(GL_RG);
  texture->SetDataType(GL_UNSIGNED_BYTE);
  texture->Create3DFromRaw(static_cast<unsigned int>(size.x), static_cast<unsigned int>(size.y),
    static_cast<unsigned int>(size.z), 2, VTK_UNSIGNED_CHAR,
    const_cast<unsigned char*>(bytes.data()));
}

//------------------------------------------------------------------------------
void vtkIndirectHintTables::Clear()
{
  for (auto& texture : this->Textures)
  {
    texture = nullptr;
  }
}

//------------------------------------------------------------------------------
void vtkIndirectHintTables::Bind(Table table, vtkShaderProgram* program, const char* uniform)
{
  this->Textures[table]->Activate();
  program->SetUniformi(uniform, this->Textures[table]->GetTextureUnit());
}

//------------------------------------------------------------------------------
void vtkIndirectHintTables::Deactivate()
{
  for (auto& texture : this->Textures)
  {
    if (texture)
    {
      texture->Deactivate();
    }
  }
}

//------------------------------------------------------------------------------
size_t vtkIndirectHintTables::GetBytes() const
{
  size_t bytes = 0;
  for (int i = 0; i < NumberOfTables; ++i)
  {
    if (const auto& texture = this->Textures[i])
    {
      const size_t texels = static_cast<size_t>(texture->GetWidth()) * texture->GetHeight() *
        std::max(1u, texture->GetDepth());
      bytes += texels * (i == Masks ? 2 : sizeof(glm::vec4));
    }
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkIndirectHintTables::Release(vtkWindow* window)
{
  for (auto& texture : this->Textures)
  {
    if (texture)
    {
      texture->ReleaseGraphicsResources(window);
      texture = nullptr;
    }
  }
}
