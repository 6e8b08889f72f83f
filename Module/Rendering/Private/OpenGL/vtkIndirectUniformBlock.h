// SPDX-License-Identifier: BSD-3-Clause
// A uniform block filled from main memory. OpenGL guarantees 16384 bytes; llvmpipe reads a block
// once for a group of fragments, and plain uniforms once for each fragment.
#pragma once

#include "OpenGL/vtkIndirectProgram.h"  // for programs
#include "OpenGL/vtkIndirectResource.h" // for the base class
#include "vtkWeakPointer.h"             // for the window

class vtkOpenGLRenderWindow;

class vtkIndirectUniformBlock : public vtkIndirectResource
{
public:
  vtkIndirectUniformBlock(vtkIndirectResource* owner, const char* name)
    : vtkIndirectResource(owner)
    , Name(name)
  {
  }
  ~vtkIndirectUniformBlock() override;

  /**
   * Replaces the block's content; in std140 arrays of four floats have no gaps. data: null makes
   * room alone.
   */
  void Update(vtkOpenGLRenderWindow* window, const void* data, size_t bytes);
  /** Binds it to the block of that name in a program. */
  void Activate(const vtkIndirectProgram& program) const;
  /** Returns the buffer of the last Update in OpenGL. */
  unsigned int GetBuffer() const { return this->Buffer; }

protected:
  size_t GetOwnBytes() const override { return this->Bytes; }
  void ReleaseOwn(vtkWindow* window) override;

private:
  const char* Name;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // window of the buffer's context
  unsigned int Buffer = 0;
  size_t Bytes = 0;
};
