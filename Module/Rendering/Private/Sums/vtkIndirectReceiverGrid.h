// SPDX-License-Identifier: BSD-3-Clause
// Samples of light at every few pixels of a frame, from border to border, which other pixels
// interpolate where they lie on the same surface (glsl/Sums/vtkIndirectReceiverGrid.glsl). The
// last samples lie on the border and may be closer together.
#pragma once

#include "OpenGL/vtkIndirectTarget.h" // for the base class

#include <string> // for definitions

struct vtkIndirectFrame;

class vtkIndirectReceiverGrid : public vtkIndirectTarget
{
public:
  vtkIndirectReceiverGrid(vtkIndirectResource* owner, const vtkIndirectChannels& channels)
    : vtkIndirectTarget(owner, channels, false)
  {
  }

  /**
   * Makes room for samples that are `step` pixels apart. Returns false, after an error, if OpenGL
   * refuses.
   */
  bool Resize(const vtkIndirectFrame& frame, int step);
  /** Returns the pixels between samples; 1: a sample for each pixel. */
  int GetStep() const { return this->Step; }
  /** Returns the number of samples along an edge of this many pixels. */
  static int Count(int pixels, int step) { return (pixels + 2 * step - 2) / step; }

  /** Returns a definition that makes the step a literal of a shader. */
  static std::string DefineStep(int step)
  {
    return "#define VTKI_STEP " + std::to_string(step) + "\n";
  }
  /** Sets the step and the number of samples, for shaders that make samples. */
  void SetUniforms(const vtkIndirectProgram& program) const;
  /** Binds all channels and sets these uniforms, for shaders that interpolate. */
  void ActivateAll(const vtkIndirectProgram& program) const;

private:
  int Step = 1;
};
