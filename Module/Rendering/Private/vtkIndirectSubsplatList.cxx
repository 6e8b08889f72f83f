// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectGL.h"

#include "vtkIndirectSubsplatList.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>

#ifdef GL_SHADER_STORAGE_BUFFER
namespace
{
// Three numbers of groups, as the indirect dispatch reads them, and the number of entries.
using Command = std::array<unsigned int, 4>;
constexpr size_t MaximumLists = 16; // VTKI_LISTS
constexpr unsigned int Binding = 0;
}
#endif

vtkIndirectSubsplatList::~vtkIndirectSubsplatList() = default;

//------------------------------------------------------------------------------
void vtkIndirectSubsplatList::Begin(const std::vector<size_t>& capacities)
{
#ifdef GL_SHADER_STORAGE_BUFFER
  size_t entries = 0;
  this->First.clear();
  for (size_t capacity : capacities)
  {
    this->First.push_back(static_cast<unsigned int>(entries));
    entries += capacity;
  }
  const size_t bytes = MaximumLists * sizeof(Command) + entries * sizeof(unsigned int);
  if (this->Buffer == 0)
  {
    glGenBuffers(1, &this->Buffer);
  }
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Buffer);
  if (bytes != this->Bytes)
  {
    glBufferData(GL_SHADER_STORAGE_BUFFER, bytes, nullptr, GL_DYNAMIC_COPY);
    this->Bytes = bytes;
  }
  std::array<Command, MaximumLists> commands;
  commands.fill({ 0, 1, 1, 0 });
  glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof(commands), commands.data());
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
#else
  (void)capacities;
#endif
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatList::Activate(vtkShaderProgram* program, size_t list) const
{
#ifdef GL_SHADER_STORAGE_BUFFER
  const auto handle = static_cast<GLuint>(program->GetHandle());
  glShaderStorageBlockBinding(handle,
    glGetProgramResourceIndex(handle, GL_SHADER_STORAGE_BLOCK, "vtkiSubsplatLists"), Binding);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, Binding, this->Buffer);
  program->SetUniformi("vtkiList", static_cast<int>(list));
  program->SetUniformi("vtkiListFirst", static_cast<int>(this->First[list]));
#else
  (void)program, (void)list;
#endif
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatList::Deactivate() const
{
#ifdef GL_SHADER_STORAGE_BUFFER
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, Binding, 0);
#endif
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatList::Dispatch(size_t list) const
{
#ifdef GL_SHADER_STORAGE_BUFFER
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, this->Buffer);
  glDispatchComputeIndirect(static_cast<GLintptr>(list * sizeof(Command)));
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
#else
  (void)list;
#endif
}

//------------------------------------------------------------------------------
int vtkIndirectSubsplatList::Count(size_t list) const
{
#ifdef GL_SHADER_STORAGE_BUFFER
  Command command{};
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Buffer);
  glGetBufferSubData(
    GL_SHADER_STORAGE_BUFFER, list * sizeof(Command), sizeof(Command), command.data());
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  return static_cast<int>(command[3]);
#else
  (void)list;
  return 0;
#endif
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatList::Release()
{
  if (this->Buffer)
  {
    glDeleteBuffers(1, &this->Buffer);
    this->Buffer = 0;
  }
  this->Bytes = 0;
}
