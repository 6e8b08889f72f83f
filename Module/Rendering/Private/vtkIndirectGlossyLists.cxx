// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectGL.h"

#include "vtkIndirectGlossyLists.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <array>
#include <bitset>

namespace
{
// Three numbers of groups, as the indirect dispatch reads them, and the number of entries.
using Command = std::array<unsigned int, 4>;
constexpr size_t MaximumLists = 32; // VTKI_GLOSSY_LISTS
constexpr size_t Header = 2;        // VTKI_GLOSSY_HEADER
#ifdef GL_SHADER_STORAGE_BUFFER
constexpr unsigned int Binding = 0;
#endif

size_t CountWords(int lights)
{
  return static_cast<size_t>(lights + 31) / 32;
}
}

vtkIndirectGlossyLists::~vtkIndirectGlossyLists()
{
  if (this->Window)
  {
    this->Window->MakeCurrent();
    this->Release();
  }
}

//------------------------------------------------------------------------------
size_t vtkIndirectGlossyLists::GetStride() const
{
  return Header + static_cast<size_t>(this->Words);
}

//------------------------------------------------------------------------------
size_t vtkIndirectGlossyLists::GetBytes(size_t entries, int lights)
{
  return MaximumLists * sizeof(Command) +
    entries * (Header + CountWords(lights)) * sizeof(unsigned int);
}

//------------------------------------------------------------------------------
void vtkIndirectGlossyLists::Begin(
  vtkOpenGLRenderWindow* window, const std::vector<size_t>& capacities, int numberOfLights)
{
#ifdef GL_SHADER_STORAGE_BUFFER
  this->Words = static_cast<int>(CountWords(numberOfLights));
  size_t entries = 0;
  this->First.clear();
  for (size_t capacity : capacities)
  {
    this->First.push_back(entries * this->GetStride());
    entries += capacity;
  }
  if (this->Buffer == 0)
  {
    this->Window = window;
    glGenBuffers(1, &this->Buffer);
  }
  const size_t bytes = GetBytes(entries, numberOfLights);
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
  (void)window, (void)capacities, (void)numberOfLights;
#endif
}

//------------------------------------------------------------------------------
void vtkIndirectGlossyLists::Activate(vtkShaderProgram* program) const
{
#ifdef GL_SHADER_STORAGE_BUFFER
  const auto handle = static_cast<GLuint>(program->GetHandle());
  glShaderStorageBlockBinding(
    handle, glGetProgramResourceIndex(handle, GL_SHADER_STORAGE_BLOCK, "vtkiGlossyLists"), Binding);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, Binding, this->Buffer);
  program->SetUniformi("vtkiGlossyWords", this->Words);
#else
  (void)program;
#endif
}

//------------------------------------------------------------------------------
void vtkIndirectGlossyLists::Deactivate() const
{
#ifdef GL_SHADER_STORAGE_BUFFER
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, Binding, 0);
#endif
}

//------------------------------------------------------------------------------
void vtkIndirectGlossyLists::Wait()
{
#ifdef GL_SHADER_STORAGE_BUFFER
  glMemoryBarrier(
    GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
#endif
}

//------------------------------------------------------------------------------
void vtkIndirectGlossyLists::Dispatch(size_t list) const
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
vtkIndirectGlossyLists::Size vtkIndirectGlossyLists::Count(size_t list) const
{
  Size size;
  if (!this->Window)
  {
    return size;
  }
  this->Window->MakeCurrent();
  Command command{};
  glBindBuffer(GL_ARRAY_BUFFER, this->Buffer);
  glGetBufferSubData(GL_ARRAY_BUFFER, list * sizeof(Command), sizeof(Command), command.data());
  size.Texels = command[3];
  std::vector<unsigned int> entries(size.Texels * this->GetStride());
  if (!entries.empty())
  {
    glGetBufferSubData(GL_ARRAY_BUFFER,
      MaximumLists * sizeof(Command) + this->First[list] * sizeof(unsigned int),
      entries.size() * sizeof(unsigned int), entries.data());
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  for (size_t i = 0; i < entries.size(); ++i)
  {
    size.Pairs += i % this->GetStride() < Header ? 0 : std::bitset<32>(entries[i]).count();
  }
  return size;
}

//------------------------------------------------------------------------------
void vtkIndirectGlossyLists::Release()
{
  if (this->Buffer)
  {
    glDeleteBuffers(1, &this->Buffer);
    this->Buffer = 0;
  }
  this->Window = nullptr;
  this->Bytes = 0;
}
