// SPDX-License-Identifier: BSD-3-Clause
// The surface that each pixel's own surface meets in a concave crease near by, for stages whose
// depth maps let light into creases; see glsl/lib/vtkIndirectLibCrease.glsl. Kept for a frame.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for a member
#include "OpenGL/vtkIndirectTarget.h"            // for a member

class vtkIndirectGeometryBuffer;
struct vtkIndirectFrame;

class vtkIndirectCreases : public vtkIndirectResource
{
public:
  explicit vtkIndirectCreases(vtkIndirectResource* owner);

  /** Forgets the creases of the last frame. */
  void Begin() { this->AreFound = false; }
  /**
   * Finds the creases of the frame's surfaces at every so many pixels, if no stage has asked for as
   * many before. Returns false, after an error, when OpenGL refuses. A frame with lit props that
   * cast no shadows has no creases.
   */
  bool Update(const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry, int step);
  /** Binds the creases, for shaders that include vtkIndirectCrease.glsl. */
  void Activate(const vtkIndirectProgram& program) const;

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  vtkIndirectTarget Target;
  vtkIndirectFullScreenProgram Kernel{ this, "vtkIndirectCreaseFS.glsl" };
  bool AreFound = false;
  int Step = 1;
};
