// SPDX-License-Identifier: BSD-3-Clause
// Numbers of a context's OpenGL objects.
#ifndef vtkIndirectGLNames_h
#define vtkIndirectGLNames_h

#include <ostream> // for printing

class vtkRenderWindow;

namespace contract
{
/** Names in use in the current context, found by probing. */
struct Names
{
  int Textures = 0;
  int Framebuffers = 0;
  int Renderbuffers = 0;
  int Buffers = 0;
  int VertexArrays = 0;
  int Programs = 0;

  bool operator==(const Names& other) const;
};

std::ostream& operator<<(std::ostream& os, const Names& names);

Names CountNames(vtkRenderWindow* window);
/** Checks all but programs, which belong to the window's cache. */
void CheckGivenBack(const Names& before, const Names& after);
}
#endif
