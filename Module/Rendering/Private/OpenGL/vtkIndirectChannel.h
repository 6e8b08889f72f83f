// SPDX-License-Identifier: BSD-3-Clause
// Description of a stage's textures, declared once: these tables give texture formats, uniform
// names, PrintSelf and the documentation.
#pragma once

#include "vtkIndent.h" // for printing

#include <ostream> // for printing
#include <vector>  // for tables

struct vtkIndirectChannel
{
  const char* Name;    // public name
  const char* Uniform; // sampler in shaders
  const char* Meaning;
  unsigned int InternalFormat; // OpenGL
  const char* Space;
  const char* Unit;
};

using vtkIndirectChannels = std::vector<vtkIndirectChannel>;

inline void vtkIndirectPrintChannels(
  std::ostream& os, vtkIndent indent, const vtkIndirectChannels& channels)
{
  for (const vtkIndirectChannel& c : channels)
  {
    os << indent << c.Name << ": " << c.Meaning << " (" << c.Space << ", " << c.Unit << ")\n";
  }
}
