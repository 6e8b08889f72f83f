// SPDX-License-Identifier: BSD-3-Clause
// Antialiased edges: morphological antialiasing of the composed picture.
//
// Reshetov 2009, "Morphological antialiasing"; Jimenez, Echevarria, Sousa, Gutierrez 2012, "SMAA:
// Enhanced subpixel morphological antialiasing". Edges are visible ends of surfaces, at the
// background, at another surface or at a crease; data on a surface stays unchanged. Their runs are
// found in words of 32 bits, and areas are computed rather than looked up. Pixels without an edge,
// and depth, are not written.

#pragma once

#include "OpenGL/vtkIndirectResource.h" // for the base class
#include <memory>                       // for the internals
#include <string>                       // for a reason

class vtkIndirectGeometryBuffer;
struct vtkIndirectFrame;

class vtkIndirectAntialiasing : public vtkIndirectResource
{
public:
  explicit vtkIndirectAntialiasing(vtkIndirectResource* owner);
  ~vtkIndirectAntialiasing() override;

  /**
   * Works on the frame's part of the framebuffer that is bound for drawing, which holds the
   * composed opaque props. If OpenGL refuses, the picture stays unchanged, and after one error
   * there is no further attempt before Release.
   */
  void Apply(const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry);
  /** Reason why the last frame's edges are not antialiased; empty if they are. */
  const std::string& GetWhyNot() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};
