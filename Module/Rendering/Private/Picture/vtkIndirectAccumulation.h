// SPDX-License-Identifier: BSD-3-Clause
// Light of a finer picture, whose virtual lights are too many for one frame: each frame adds the
// light of a batch of them, in 32-bit floats. Until all are there the picture shows the light that
// was there before.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for a member
#include "OpenGL/vtkIndirectResource.h"          // for the base class
#include "OpenGL/vtkIndirectTarget.h"            // for members
#include "Plan/vtkIndirectEstimate.h"            // for contributions

#include <memory> // for members
#include <vector> // for lists

struct vtkIndirectFrame;

class vtkIndirectAccumulation : public vtkIndirectResource
{
public:
  using Contributions = std::vector<vtkIndirectContribution>;

  explicit vtkIndirectAccumulation(vtkIndirectResource* owner);

  /**
   * Keeps the light that the picture shows. Returns false, after an error, if OpenGL refuses; so do
   * the other functions.
   */
  bool Keep(const vtkIndirectFrame& frame, const Contributions& picture);
  /** Adds a batch's light of the picture's contribution of this number; first: it is the first. */
  bool Add(
    const vtkIndirectFrame& frame, size_t number, const vtkIndirectContribution& light, bool first);
  /** Keeps the sum of all batches, and the light before for Show. */
  void Finish();
  /** Sums the light that is kept, as if it were that of all batches. */
  bool Repeat(const vtkIndirectFrame& frame);
  /** Adds light, four floats a pixel, to the first contribution that is kept. */
  bool Correct(const vtkIndirectFrame& frame, const std::vector<float>& light);
  /** Writes this share of the light that is kept, and the rest of the light before, into images. */
  bool Show(const vtkIndirectFrame& frame, const Contributions& picture, double share);

private:
  using Images = std::vector<std::unique_ptr<vtkIndirectTarget>>; // of each contribution

  bool Resize(const vtkIndirectFrame& frame, size_t count, Images& images);
  bool Draw(const vtkIndirectFrame& frame, const vtkIndirectTarget& from, int channel, double scale,
    bool adds, vtkIndirectTarget& to);

  Images Before;
  Images Kept;
  Images Sums;
  Images Added;
  vtkIndirectFullScreenProgram Copy{ this, "vtkIndirectAccumulateFS.glsl" };
};
