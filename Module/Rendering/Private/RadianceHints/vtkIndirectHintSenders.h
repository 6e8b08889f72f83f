// SPDX-License-Identifier: BSD-3-Clause
// Blocks of the lights' map texels as virtual lights, a coarser level of the maps that hints sum
// over.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "Senders/vtkIndirectSampler.h"
#include "vtkNew.h"                 // for members
#include "vtkUniformLightSampler.h" // for the headlight's pattern

class vtkIndirectHintSenders : public vtkIndirectSampler
{
public:
  /** caller: the object whose error it is that the maps are too many. */
  explicit vtkIndirectHintSenders(vtkObject* caller);

  /** Number of blocks along an edge of each map's face. */
  void SetBlocksPerEdge(int blocks) { this->BlocksPerEdge = blocks; }

  bool Update(const Input& input) override;
  /** The headlight's map has no blocks: it gets more lights than usual, as many as another map. */
  vtkIndirectMapSampler* GetHeadlightPattern() override;
  vtkIndirectSamplerAbilities GetAbilities() const override;

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  vtkObject* Caller;
  int BlocksPerEdge = 24;
  vtkNew<vtkUniformLightSampler> HeadlightPattern;
  vtkIndirectFullScreenProgram Program{ this, "vtkIndirectHintSendersFS.glsl" };
  // Inputs of the current lights.
  vtkMTimeType MapTime = 0;
  int Blocks = 0;
};
