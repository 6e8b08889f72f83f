// SPDX-License-Identifier: BSD-3-Clause
// Antialiased edges: morphological antialiasing of the picture that has been composed.
//
// Reshetov 2009, "Morphological antialiasing"; Jimenez, Echevarria, Sousa, Gutierrez 2012, "SMAA:
// Enhanced subpixel morphological antialiasing". Edges are where a surface ends, at the background,
// at another or at a crease, and is seen to: data on a surface stays as it is. Their runs are found
// in words of 32 bits, and areas are computed rather than looked up. Pixels without an edge are not
// written, and depth is not either.

#ifndef vtkIndirectAntialiasing_h
#define vtkIndirectAntialiasing_h

#include <cstddef> // for size_t
#include <memory>  // for the internals
#include <string>  // for a reason

class vtkIndirectGeometryBuffer;
class vtkWindow;
struct vtkIndirectFrame;

class vtkIndirectAntialiasing
{
public:
  vtkIndirectAntialiasing();
  ~vtkIndirectAntialiasing();

  /**
   * Works on the frame's part of the framebuffer that is bound for drawing, where the opaque props
   * have been composed. Where OpenGL refuses, that picture is left as it is, and after one error
   * nothing is tried again before Release.
   */
  void Apply(const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry);
  /** Why the last frame's edges are left as they are; empty where they are not. */
  const std::string& GetWhyNot() const;

  size_t GetBytes() const;
  void Release(vtkWindow* window);

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
