// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Multiresolution/vtkIndirectGlossyLists.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <bitset>

namespace
{
constexpr size_t MaximumGlossyLists = 32; // VTKI_GLOSSY_LISTS
constexpr size_t Header = 2;              // VTKI_GLOSSY_HEADER

size_t CountWords(int lights)
{
  return static_cast<size_t>(lights + 31) / 32;
}
}

vtkIndirectGlossyLists::vtkIndirectGlossyLists(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Buffer(this, MaximumGlossyLists)
{
}

//------------------------------------------------------------------------------
size_t vtkIndirectGlossyLists::GetStride() const
{
  return Header + static_cast<size_t>(this->Words);
}

//------------------------------------------------------------------------------
size_t vtkIndirectGlossyLists::CountBytes(size_t entries, int lights)
{
  return vtkIndirectCommandBuffer::CountBytes(
    MaximumGlossyLists, entries * (Header + CountWords(lights)));
}

//------------------------------------------------------------------------------
void vtkIndirectGlossyLists::Begin(
  vtkOpenGLRenderWindow* window, const std::vector<size_t>& capacities, int numberOfLights)
{
  this->Words = static_cast<int>(CountWords(numberOfLights));
  size_t entries = 0;
  this->First.clear();
  for (size_t capacity : capacities)
  {
    this->First.push_back(entries * this->GetStride());
    entries += capacity;
  }
  this->Buffer.Begin(window, entries * this->GetStride());
}

//------------------------------------------------------------------------------
void vtkIndirectGlossyLists::Activate(const vtkIndirectProgram& program) const
{
  this->Buffer.Activate(program, "vtkiGlossyLists");
  program->SetUniformi("vtkiGlossyWords", this->Words);
}

//------------------------------------------------------------------------------
vtkIndirectGlossyLists::Size vtkIndirectGlossyLists::Count(size_t list) const
{
  Size size;
  if (!this->Buffer.GetWindow())
  {
    return size;
  }
  this->Buffer.GetWindow()->MakeCurrent();
  size.Texels = this->Buffer.Count(list);
  std::vector<unsigned int> entries(size.Texels * this->GetStride());
  this->Buffer.Read(this->First[list], entries.size(), entries.data());
  for (size_t i = 0; i < entries.size(); ++i)
  {
    size.Pairs += i % this->GetStride() < Header ? 0 : std::bitset<32>(entries[i]).count();
  }
  return size;
}
