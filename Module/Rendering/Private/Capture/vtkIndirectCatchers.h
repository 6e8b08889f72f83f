// SPDX-License-Identifier: BSD-3-Clause
// Props that catch light (vtkIndirectIlluminationPass::CATCHES_LIGHT), as VTK's lights would light
// them if nothing hid any: the same shaders draw them once more, without shadows. The composite
// compares the light that they receive with this light.
#pragma once

#include "OpenGL/vtkIndirectResource.h" // for the base class
#include "OpenGL/vtkIndirectTarget.h"   // for a member

class vtkSurfaceCapturePass;
struct vtkIndirectFrame;

class vtkIndirectCatchers : public vtkIndirectResource
{
public:
  explicit vtkIndirectCatchers(vtkIndirectResource* owner);

  /**
   * Draws the frame's catchers, while the capture is attached to them. Without any it releases the
   * image. Returns false, after an error, if OpenGL refuses.
   */
  bool Update(const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture);

  /** Returns the image of that light, at the pixels where the picture may show a catcher. */
  const vtkIndirectTarget& GetOpen() const { return this->Open; }

private:
  vtkIndirectTarget Open;
};
