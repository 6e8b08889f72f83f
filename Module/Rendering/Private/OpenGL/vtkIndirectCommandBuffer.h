// SPDX-License-Identifier: BSD-3-Clause
// A storage buffer of lists that shaders append to: first a command for each list, then their
// entries. A command is three numbers of groups, as an indirect dispatch reads them, and the number
// of entries.
#pragma once

#include "OpenGL/vtkIndirectProgram.h"  // for programs
#include "OpenGL/vtkIndirectResource.h" // for the base class
#include "vtkWeakPointer.h"             // for the window

class vtkOpenGLRenderWindow;

class vtkIndirectCommandBuffer : public vtkIndirectResource
{
public:
  vtkIndirectCommandBuffer(vtkIndirectResource* owner, size_t lists)
    : vtkIndirectResource(owner)
    , NumberOfLists(lists)
  {
  }
  ~vtkIndirectCommandBuffer() override;

  /** Empties the lists; words: space for the entries of all lists. */
  void Begin(vtkOpenGLRenderWindow* window, size_t words);

  /** Binds the buffer to a program's storage block of that name. */
  void Activate(const vtkIndirectProgram& program, const char* block) const;

  /** One invocation for each entry of a list, rounded up to groups; the program must be current. */
  void Dispatch(size_t list) const;

  /** Returns the entries in a list. Waits for the GPU; the buffer's context must be current. */
  unsigned int Count(size_t list) const;
  /** Reads words of entries, from the first on. Waits for the GPU; the buffer's context must be
   * current. */
  void Read(size_t first, size_t count, unsigned int* words) const;

  /** Returns the offset of a word of the entries in the buffer. */
  size_t GetOffset(size_t word) const { return CountBytes(this->NumberOfLists, word); }
  /** Null without a buffer. */
  vtkOpenGLRenderWindow* GetWindow() const;
  /** Returns the bytes of a buffer whose entries have this many words. */
  static size_t CountBytes(size_t lists, size_t words);

protected:
  size_t GetOwnBytes() const override { return this->Bytes; }
  void ReleaseOwn(vtkWindow* window) override;

private:
  size_t NumberOfLists;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // window of the buffer's context
  unsigned int Handle = 0;
  size_t Bytes = 0;
};
