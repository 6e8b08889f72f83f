// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "OpenGL/vtkIndirectCommandBuffer.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <array>
#include <vector>

namespace
{
using Command = std::array<unsigned int, 4>;
constexpr unsigned int StorageBinding = 0;
}

vtkIndirectCommandBuffer::~vtkIndirectCommandBuffer()
{
  if (this->Window)
  {
    this->Window->MakeCurrent();
    this->Release(this->Window);
  }
}

//------------------------------------------------------------------------------
size_t vtkIndirectCommandBuffer::CountBytes(size_t lists, size_t words)
{
  return lists * sizeof(Command) + words * sizeof(unsigned int);
}

//------------------------------------------------------------------------------
vtkOpenGLRenderWindow* vtkIndirectCommandBuffer::GetWindow() const
{
  return this->Window;
}

//------------------------------------------------------------------------------
void vtkIndirectCommandBuffer::Begin(vtkOpenGLRenderWindow* window, size_t words)
{
  const size_t bytes = CountBytes(this->NumberOfLists, words);
  if (this->Handle == 0)
  {
    this->Window = window;
    glGenBuffers(1, &this->Handle);
  }
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Handle);
  if (bytes != this->Bytes)
  {
    glBufferData(GL_SHADER_STORAGE_BUFFER, bytes, nullptr, GL_DYNAMIC_COPY);
    this->Bytes = bytes;
  }
  const std::vector<Command> commands(this->NumberOfLists, Command{ 0, 1, 1, 0 });
  glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, commands.size() * sizeof(Command), commands.data());
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
}

//------------------------------------------------------------------------------
void vtkIndirectCommandBuffer::Activate(const vtkIndirectProgram& program, const char* block) const
{
  const auto handle = static_cast<GLuint>(program->GetHandle());
  glShaderStorageBlockBinding(
    handle, glGetProgramResourceIndex(handle, GL_SHADER_STORAGE_BLOCK, block), StorageBinding);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, StorageBinding, this->Handle);
}

//------------------------------------------------------------------------------
void vtkIndirectCommandBuffer::Dispatch(size_t list) const
{
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, this->Handle);
  glDispatchComputeIndirect(static_cast<GLintptr>(list * sizeof(Command)));
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
}

//------------------------------------------------------------------------------
unsigned int vtkIndirectCommandBuffer::Count(size_t list) const
{
  Command command{};
  glBindBuffer(GL_ARRAY_BUFFER, this->Handle);
  glGetBufferSubData(GL_ARRAY_BUFFER, list * sizeof(Command), sizeof(Command), command.data());
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  return command[3];
}

//------------------------------------------------------------------------------
void vtkIndirectCommandBuffer::Read(size_t first, size_t count, unsigned int* words) const
{
  if (count > 0)
  {
    glBindBuffer(GL_ARRAY_BUFFER, this->Handle);
    glGetBufferSubData(
      GL_ARRAY_BUFFER, this->GetOffset(first), count * sizeof(unsigned int), words);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectCommandBuffer::ReleaseOwn(vtkWindow*)
{
  if (this->Handle)
  {
    glDeleteBuffers(1, &this->Handle);
    this->Handle = 0;
  }
  this->Window = nullptr;
  this->Bytes = 0;
}
