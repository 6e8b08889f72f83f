// SPDX-License-Identifier: BSD-3-Clause
// What a context holds of OpenGL.
#ifndef vtkIndirectGLNames_h
#define vtkIndirectGLNames_h

#include <ostream> // for printing

class vtkRenderWindow;

namespace contract
{
/** Names of the current context that are in use, by probing. */
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
/** Checks all but programs, which are the window's own cache's. */
void CheckGivenBack(const Names& before, const Names& after);
}
#endif
