// SPDX-License-Identifier: BSD-3-Clause
// A shader program in use, with the textures that are bound for it. They are unbound, and their
// texture units free, when this object ends or takes another program.
#pragma once

#include "vtkSmartPointer.h"  // for textures
#include "vtkTextureObject.h" // for textures

#include <cstddef> // for nullptr_t
#include <vector>  // for textures

class vtkShaderProgram;

class vtkIndirectProgram
{
public:
  /** program: may be null. */
  explicit vtkIndirectProgram(vtkShaderProgram* program)
    : Program(program)
  {
  }
  vtkIndirectProgram(std::nullptr_t) {}
  ~vtkIndirectProgram();
  vtkIndirectProgram(vtkIndirectProgram&& other) noexcept;
  vtkIndirectProgram& operator=(vtkIndirectProgram&& other) noexcept;

  /** Returns VTK's program, for setting uniforms; null if it does not compile. */
  operator vtkShaderProgram*() const { return this->Program; }
  vtkShaderProgram* operator->() const { return this->Program; }

  /** Binds a texture, and sets the sampler of this name to its texture unit. */
  void Bind(vtkTextureObject* texture, const char* uniform) const;

private:
  vtkShaderProgram* Program = nullptr;
  mutable std::vector<vtkSmartPointer<vtkTextureObject>> Textures;
};
