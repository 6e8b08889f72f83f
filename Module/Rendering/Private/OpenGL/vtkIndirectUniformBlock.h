// SPDX-License-Identifier: BSD-3-Clause
// A uniform block filled from main memory. OpenGL guarantees 16384 bytes; llvmpipe reads a block
// once for a group of fragments, and plain uniforms once for each fragment.
#ifndef vtkIndirectUniformBlock_h
#define vtkIndirectUniformBlock_h

#include "vtkWeakPointer.h" // for the window

#include <cstddef> // for size_t

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

class vtkIndirectUniformBlock
{
public:
  explicit vtkIndirectUniformBlock(const char* name)
    : Name(name)
  {
  }
  ~vtkIndirectUniformBlock();
  vtkIndirectUniformBlock(const vtkIndirectUniformBlock&) = delete;
  void operator=(const vtkIndirectUniformBlock&) = delete;

  /** Replaces the block's content; in std140 arrays of four floats have no gaps. */
  void Update(vtkOpenGLRenderWindow* window, const void* data, size_t bytes);
  /** Binds it to the block of that name in a program. */
  void Activate(vtkShaderProgram* program) const;

  size_t GetBytes() const { return this->Bytes; }
  /** The buffer's context must be current. */
  void Release();

private:
  const char* Name;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // window of the buffer's context
  unsigned int Buffer = 0;
  size_t Bytes = 0;
};

#endif
