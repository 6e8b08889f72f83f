// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "OpenGL/vtkIndirectUniformBlock.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

namespace
{
constexpr unsigned int Binding = 0;
}

//------------------------------------------------------------------------------
vtkIndirectUniformBlock::~vtkIndirectUniformBlock()
{
  if (this->Window)
  {
    this->Window->MakeCurrent();
    this->Release(this->Window);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectUniformBlock::Update(vtkOpenGLRenderWindow* window, const void* data, size_t bytes)
{
  if (this->Buffer == 0)
  {
    this->Window = window;
    glGenBuffers(1, &this->Buffer);
  }
  glBindBuffer(GL_UNIFORM_BUFFER, this->Buffer);
  glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_DRAW);
  glBindBuffer(GL_UNIFORM_BUFFER, 0);
  this->Bytes = bytes;
}

//------------------------------------------------------------------------------
void vtkIndirectUniformBlock::Activate(const vtkIndirectProgram& program) const
{
  const auto handle = static_cast<GLuint>(program->GetHandle());
  const GLuint index = glGetUniformBlockIndex(handle, this->Name);
  if (index != GL_INVALID_INDEX) // compilers drop unread blocks
  {
    glUniformBlockBinding(handle, index, Binding);
  }
  glBindBufferBase(GL_UNIFORM_BUFFER, Binding, this->Buffer);
}

//------------------------------------------------------------------------------
void vtkIndirectUniformBlock::ReleaseOwn(vtkWindow*)
{
  if (this->Buffer)
  {
    glDeleteBuffers(1, &this->Buffer);
    this->Buffer = 0;
  }
  this->Window = nullptr;
  this->Bytes = 0;
}
