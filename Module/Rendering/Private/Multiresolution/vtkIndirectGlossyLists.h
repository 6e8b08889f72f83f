// SPDX-License-Identifier: BSD-3-Clause
// Lists of texels with the sets of lights that are still to be resolved for each, in a storage
// buffer, with the sizes of the indirect dispatches that work through them; see
// vtkIndirectGlossyStorage.glsl. Needs OpenGL 4.3.
#ifndef vtkIndirectGlossyLists_h
#define vtkIndirectGlossyLists_h

#include "OpenGL/vtkIndirectCommandBuffer.h" // for a member

#include <cstddef> // for size_t
#include <vector>  // for the lists

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

class vtkIndirectGlossyLists
{
public:
  vtkIndirectGlossyLists();

  /** Bytes that the lists of so many texels and lights take. */
  static size_t GetBytes(size_t entries, int lights);

  /** Empties the lists; capacities[i] texels are room enough for list i. */
  void Begin(
    vtkOpenGLRenderWindow* window, const std::vector<size_t>& capacities, int numberOfLights);

  /** Binds the buffer to a program. */
  void Activate(vtkShaderProgram* program) const;
  /** Where in the buffer a list begins, in words. */
  int GetFirst(size_t list) const { return static_cast<int>(this->First[list]); }
  void Deactivate() const { this->Buffer.Deactivate(); }

  /** Between programs that append and those that read. */
  static void Wait();
  /** One invocation for each entry, rounded up to groups; the program must be current. */
  void Dispatch(size_t list) const { this->Buffer.Dispatch(list); }

  /** Entries of a list, and lights in their sets together. Waits for the GPU. */
  struct Size
  {
    size_t Texels = 0;
    size_t Pairs = 0;
  };
  Size Count(size_t list) const;

  size_t GetBytes() const { return this->Buffer.GetBytes(); }
  /** The buffer's context must be current. */
  void Release() { this->Buffer.Release(); }

private:
  size_t GetStride() const;

  vtkIndirectCommandBuffer Buffer;
  int Words = 0; // of a set
  std::vector<size_t> First;
};

#endif
