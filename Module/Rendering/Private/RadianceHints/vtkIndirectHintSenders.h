// SPDX-License-Identifier: BSD-3-Clause
// Blocks of the lights' map texels as virtual lights, a coarser level of the maps that hints sum
// over.
#ifndef vtkIndirectHintSenders_h
#define vtkIndirectHintSenders_h

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "vtkNew.h"                              // for members
#include "vtkUniformLightSampler.h"              // for the headlight's pattern
#include "vtkVirtualLightSampler.h"

class vtkIndirectHintSenders : public vtkVirtualLightSampler
{
public:
  static vtkIndirectHintSenders* New();
  vtkTypeMacro(vtkIndirectHintSenders, vtkVirtualLightSampler);

  /** Number of blocks along an edge of each map's face. */
  void SetBlocksPerEdge(int blocks) { this->BlocksPerEdge = blocks; }

  bool Update(const Input& input) override;
  /** The headlight's map has no blocks: it gets more lights than usual, as many as another map. */
  vtkMapLightSampler* GetViewPattern() override { return this->ViewPattern; }
  int GetNumberOfLights() override { return this->ViewPattern->GetNumberOfLights(); }
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkIndirectHintSenders();
  ~vtkIndirectHintSenders() override = default;

private:
  vtkIndirectHintSenders(const vtkIndirectHintSenders&) = delete;
  void operator=(const vtkIndirectHintSenders&) = delete;

  int BlocksPerEdge = 24;
  vtkNew<vtkUniformLightSampler> ViewPattern;
  vtkIndirectFullScreenProgram Program{ "vtkIndirectHintSendersFS.glsl" };
  // Inputs of the current lights.
  vtkMTimeType MapTime = 0;
  int Blocks = 0;
};

#endif
