// SPDX-License-Identifier: BSD-3-Clause
// A coarser level of the lights' maps: blocks of their texels as virtual lights, which hints sum
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

  /** Along an edge of each map's face. */
  void SetBlocksPerEdge(int blocks) { this->BlocksPerEdge = blocks; }

  bool Update(const Input& input) override;
  /** What the eye sees has no blocks: more lights than usual, as many as a map has. */
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
  // What the lights were made from.
  vtkMTimeType MapTime = 0;
  int Blocks = 0;
};

#endif
