// SPDX-License-Identifier: BSD-3-Clause
// A frame's virtual lights in a uniform buffer; see vtkIndirectLightUniforms.glsl. On llvmpipe
// the sum over lights takes 0.6 times as long as from textures.
#pragma once

#include "OpenGL/vtkIndirectUniformBlock.h" // for a member

#include <string> // for definitions

class vtkIndirectVirtualLights;
class vtkOpenGLRenderWindow;

class vtkIndirectLightBlock : public vtkIndirectResource
{
public:
  using vtkIndirectResource::vtkIndirectResource;

  /**
   * Returns the largest number of lights of the block: 256 to 1024, as the context's uniform blocks
   * allow.
   */
  int GetCapacity(vtkOpenGLRenderWindow* window);
  /** Returns the definitions for the block's declaration and for the sum over lights. */
  std::string GetDefinitions() const;

  /**
   * Takes the lights of a frame, or `count` of them from `first` on (a multiple of
   * vtkIndirectSampler::RowLength). Copies them into the buffer, on the GPU, if the block can hold
   * them all; shaders read more lights from the table.
   */
  void Update(vtkOpenGLRenderWindow* window, const vtkIndirectVirtualLights& lights);
  void Update(
    vtkOpenGLRenderWindow* window, const vtkIndirectVirtualLights& lights, int first, int count);
  int GetNumberOfLights() const { return this->Count; }
  /** Binds the block and the table. */
  void Activate(const vtkIndirectProgram& program) const;

protected:
  void ReleaseOwn(vtkWindow*) override { this->Capacity = 0; }

private:
  const vtkIndirectVirtualLights* Lights = nullptr; // lights of the last Update
  int First = 0;
  int Count = 0;
  int Capacity = 0;
  vtkIndirectUniformBlock Block{ this, "vtkiLightBlock" };
};
