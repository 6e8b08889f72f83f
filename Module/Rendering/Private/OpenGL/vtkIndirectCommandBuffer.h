// SPDX-License-Identifier: BSD-3-Clause
// A storage buffer of lists that shaders append to: first a command for each list, then their
// entries. A command is three numbers of groups, as an indirect dispatch reads them, and the number
// of entries.
#ifndef vtkIndirectCommandBuffer_h
#define vtkIndirectCommandBuffer_h

#include "vtkWeakPointer.h" // for the window

#include <cstddef> // for size_t

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

class vtkIndirectCommandBuffer
{
public:
  explicit vtkIndirectCommandBuffer(size_t lists)
    : NumberOfLists(lists)
  {
  }
  ~vtkIndirectCommandBuffer();

  /** Empties the lists; words is room for the entries of all. */
  void Begin(vtkOpenGLRenderWindow* window, size_t words);
  /** Replaces all of it, where shaders cannot write; words begin with the commands. */
  void Fill(vtkOpenGLRenderWindow* window, const unsigned int* words, size_t count);

  /** Binds the buffer to a program's storage block of that name. */
  void Activate(vtkShaderProgram* program, const char* block) const;
  void Deactivate() const;

  /** One invocation for each entry of a list, rounded up to groups; the program must be current. */
  void Dispatch(size_t list) const;

  /** Entries in a list. Waits for the GPU; the buffer's context must be current. */
  unsigned int Count(size_t list) const;
  /** Words of entries, from the first on; as above. */
  void Read(size_t first, size_t count, unsigned int* words) const;

  unsigned int GetHandle() const { return this->Handle; }
  /** Where in the buffer that word of the entries is. */
  size_t GetOffset(size_t word) const;
  /** Null where there is no buffer. */
  vtkOpenGLRenderWindow* GetWindow() const;
  size_t GetBytes() const { return this->Bytes; }
  /** What a buffer takes whose entries have so many words. */
  static size_t GetBytes(size_t lists, size_t words);
  /** The buffer's context must be current. */
  void Release();

private:
  void Create(vtkOpenGLRenderWindow* window);

  size_t NumberOfLists;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the buffer
  unsigned int Handle = 0;
  size_t Bytes = 0;
};

#endif
