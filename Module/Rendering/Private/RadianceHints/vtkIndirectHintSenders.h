// SPDX-License-Identifier: BSD-3-Clause
// A coarser level of the lights' maps: blocks of their texels as virtual lights, which hints sum
// over.
#ifndef vtkIndirectHintSenders_h
#define vtkIndirectHintSenders_h

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "VirtualLights/vtkIndirectSampler.h"
#include "vtkNew.h"                 // for members
#include "vtkUniformLightSampler.h" // for the headlight's pattern

class vtkIndirectHintSenders : public vtkIndirectSampler
{
public:
  /** caller: the object whose error it is that the maps are too many. */
  explicit vtkIndirectHintSenders(vtkObject* caller);

  /** Along an edge of each map's face. */
  void SetBlocksPerEdge(int blocks) { this->BlocksPerEdge = blocks; }

  bool Update(const Input& input) override;
  /** Surfaces that the eye sees have no blocks: there are more lights than usual, as many as a map
   * has. */
  vtkIndirectMapSampler* GetViewPattern() override;
  vtkIndirectSamplerAbilities GetAbilities() const override;

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  vtkObject* Caller;
  int BlocksPerEdge = 24;
  vtkNew<vtkUniformLightSampler> ViewPattern;
  vtkIndirectFullScreenProgram Program{ "vtkIndirectHintSendersFS.glsl" };
  // These numbers tell what the lights were made from.
  vtkMTimeType MapTime = 0;
  int Blocks = 0;
};

#endif
