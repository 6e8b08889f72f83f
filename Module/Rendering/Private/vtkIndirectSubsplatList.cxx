// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectGL.h"

#include "vtkIndirectSubsplatList.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>

namespace
{
// Three numbers of groups, as the indirect dispatch reads them, and the number of entries.
using Command = std::array<unsigned int, 4>;
constexpr size_t MaximumLists = 16; // VTKI_LISTS
#ifdef GL_SHADER_STORAGE_BUFFER
constexpr unsigned int Binding = 0;
#endif
}

vtkIndirectSubsplatList::~vtkIndirectSubsplatList()
{
  if (this->Window)
  {
    this->Window->MakeCurrent();
    this->Release();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatList::Create(vtkOpenGLRenderWindow* window)
{
  if (this->Buffer == 0)
  {
    this->Window = window;
    glGenBuffers(1, &this->Buffer);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatList::Begin(
  vtkOpenGLRenderWindow* window, const std::vector<size_t>& capacities)
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
  this->Create(window);
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
  (void)window, (void)capacities;
#endif
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatList::End()
{
#ifdef GL_SHADER_STORAGE_BUFFER
  this->Deactivate();
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
    GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
#endif
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatList::Fill(
  vtkOpenGLRenderWindow* window, const std::vector<std::vector<unsigned int>>& lists)
{
  std::vector<unsigned int> words(MaximumLists * 4, 0);
  this->First.clear();
  for (size_t i = 0; i < lists.size(); ++i)
  {
    this->First.push_back(static_cast<unsigned int>(words.size() - MaximumLists * 4));
    words[4 * i + 3] = static_cast<unsigned int>(lists[i].size());
    words.insert(words.end(), lists[i].begin(), lists[i].end());
  }
  this->Create(window);
  this->Bytes = words.size() * sizeof(unsigned int);
  glBindBuffer(GL_ARRAY_BUFFER, this->Buffer);
  glBufferData(GL_ARRAY_BUFFER, this->Bytes, words.data(), GL_DYNAMIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

//------------------------------------------------------------------------------
size_t vtkIndirectSubsplatList::GetOffset(size_t list) const
{
  return MaximumLists * sizeof(Command) + this->First[list] * sizeof(unsigned int);
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
  Command command{};
  glBindBuffer(GL_ARRAY_BUFFER, this->Buffer);
  glGetBufferSubData(GL_ARRAY_BUFFER, list * sizeof(Command), sizeof(Command), command.data());
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  return static_cast<int>(command[3]);
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatList::Release()
{
  if (this->Buffer)
  {
    glDeleteBuffers(1, &this->Buffer);
    this->Buffer = 0;
  }
  this->Window = nullptr;
  this->Bytes = 0;
}
