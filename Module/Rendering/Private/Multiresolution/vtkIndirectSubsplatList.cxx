// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Multiresolution/vtkIndirectSubsplatList.h"

#include "vtkShaderProgram.h"

namespace
{
constexpr size_t MaximumLists = 16; // VTKI_LISTS
}

vtkIndirectSubsplatList::vtkIndirectSubsplatList(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Buffer(this, MaximumLists)
{
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatList::Begin(
  vtkOpenGLRenderWindow* window, const std::vector<size_t>& capacities)
{
  size_t entries = 0;
  this->First.clear();
  for (size_t capacity : capacities)
  {
    this->First.push_back(static_cast<unsigned int>(entries));
    entries += capacity;
  }
  this->Buffer.Begin(window, entries);
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatList::End()
{
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
    GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatList::Activate(const vtkIndirectProgram& program, size_t list) const
{
  this->Buffer.Activate(program, "vtkiSubsplatLists");
  program->SetUniformi("vtkiList", static_cast<int>(list));
  program->SetUniformi("vtkiListFirst", static_cast<int>(this->First[list]));
}
