// SPDX-License-Identifier: BSD-3-Clause
// Lists of texels, each with the set of lights that it still has to resolve, in a storage buffer,
// with the sizes of the indirect dispatches for them; see vtkIndirectGlossyStorage.glsl. Needs
// OpenGL 4.3.
#pragma once

#include "OpenGL/vtkIndirectCommandBuffer.h" // for a member
#include "OpenGL/vtkIndirectResource.h"      // for the base class

#include <cstddef> // for size_t
#include <vector>  // for the lists

class vtkOpenGLRenderWindow;

class vtkIndirectGlossyLists : public vtkIndirectResource
{
public:
  explicit vtkIndirectGlossyLists(vtkIndirectResource* owner);

  /** Bytes of the lists for this many texels and lights. */
  static size_t CountBytes(size_t entries, int lights);

  /** Empties the lists; list i has space for capacities[i] texels. */
  void Begin(
    vtkOpenGLRenderWindow* window, const std::vector<size_t>& capacities, int numberOfLights);

  /** Binds the buffer to a program. */
  void Activate(const vtkIndirectProgram& program) const;
  /** Begin of a list in the buffer, in words. */
  int GetFirst(size_t list) const { return static_cast<int>(this->First[list]); }

  /** The lists, for programs that run for their entries. */
  const vtkIndirectCommandBuffer& GetBuffer() const { return this->Buffer; }

  /** Entries of a list, and the total number of lights in their sets. Waits for the GPU. */
  struct Size
  {
    size_t Texels = 0;
    size_t Pairs = 0;
  };
  Size Count(size_t list) const;

private:
  size_t GetStride() const;

  vtkIndirectCommandBuffer Buffer;
  int Words = 0; // words of a set
  std::vector<size_t> First;
};
