// SPDX-License-Identifier: BSD-3-Clause
// Virtual lights of a headlight that is the only light. The eye sees all surfaces that it lights,
// so the geometry buffer serves as its map.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "Senders/vtkIndirectPatternTexture.h"   // for members
#include "Senders/vtkIndirectSampler.h"

class vtkIndirectHeadlightSampler : public vtkIndirectSampler
{
public:
  /** Sets the sampler that makes the pattern of places in the view; it must exist at Update. */
  void SetPattern(vtkIndirectMapSampler* pattern) { this->Pattern = pattern; }

  bool Update(const Input& input) override;

private:
  vtkIndirectMapSampler* Pattern = nullptr;
  vtkIndirectPatternTexture Texture{ this };
  vtkIndirectFullScreenProgram Program{ this, "vtkIndirectHeadlightFS.glsl" };
};
