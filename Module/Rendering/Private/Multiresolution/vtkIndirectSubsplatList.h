// SPDX-License-Identifier: BSD-3-Clause
// Lists of split texels, one for each level, in a storage buffer, with the sizes of the indirect
// dispatches for them; see vtkIndirectSubsplatStorage.glsl. Needs OpenGL 4.3.
#pragma once

#include "OpenGL/vtkIndirectCommandBuffer.h" // for a member
#include "OpenGL/vtkIndirectResource.h"      // for the base class

#include <cstddef> // for size_t
#include <vector>  // for the levels

class vtkOpenGLRenderWindow;

class vtkIndirectSubsplatList : public vtkIndirectResource
{
public:
  explicit vtkIndirectSubsplatList(vtkIndirectResource* owner);

  /** Empties the lists; list i has space for capacities[i] entries. */
  void Begin(vtkOpenGLRenderWindow* window, const std::vector<size_t>& capacities);

  /** Follows the last program that appends: makes the lists visible to programs that read them. */
  void End();

  /** Binds the buffer to a program that appends to, or reads, one of the lists. */
  void Activate(const vtkIndirectProgram& program, size_t list) const;

  /** The lists, for programs that run for their entries. */
  const vtkIndirectCommandBuffer& GetBuffer() const { return this->Buffer; }

  /** Returns the entries in a list. Waits for the GPU. */
  int Count(size_t list) const { return static_cast<int>(this->Buffer.Count(list)); }

private:
  vtkIndirectCommandBuffer Buffer;
  std::vector<unsigned int> First; // begin of each list, in entries
};
