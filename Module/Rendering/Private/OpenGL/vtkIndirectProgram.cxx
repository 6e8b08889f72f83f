// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectProgram.h"

#include "vtkShaderProgram.h"

#include <utility>

vtkIndirectProgram::~vtkIndirectProgram()
{
  for (const auto& texture : this->Textures)
  {
    texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
vtkIndirectProgram::vtkIndirectProgram(vtkIndirectProgram&& other) noexcept
  : Program(other.Program)
  , Textures(std::move(other.Textures))
{
}

//------------------------------------------------------------------------------
vtkIndirectProgram& vtkIndirectProgram::operator=(vtkIndirectProgram&& other) noexcept
{
  // The other object then unbinds the textures of the program until now.
  std::swap(this->Program, other.Program);
  std::swap(this->Textures, other.Textures);
  return *this;
}

//------------------------------------------------------------------------------
void vtkIndirectProgram::Bind(vtkTextureObject* texture, const char* uniform) const
{
  texture->Activate();
  this->Program->SetUniformi(uniform, texture->GetTextureUnit());
  this->Textures.emplace_back(texture);
}
