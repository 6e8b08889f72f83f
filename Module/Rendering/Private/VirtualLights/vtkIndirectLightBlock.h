// SPDX-License-Identifier: BSD-3-Clause
// A frame's virtual lights in a uniform buffer; see vtkIndirectLightUniforms.glsl. On llvmpipe
// the sum over lights takes 0.6 times as long as from textures.
#ifndef vtkIndirectLightBlock_h
#define vtkIndirectLightBlock_h

#include "vtkWeakPointer.h" // for the window

#include <cstddef> // for size_t
#include <string>  // for definitions

class vtkIndirectVirtualLights;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

class vtkIndirectLightBlock
{
public:
  ~vtkIndirectLightBlock();

  /** Lights that the block holds at most: what the context's uniform blocks can, 256 to 1024. */
  int GetCapacity(vtkOpenGLRenderWindow* window);
  /** Definitions that the block's declaration, and the sum over the lights, need. */
  std::string GetDefinitions() const;

  /**
   * Takes the lights of a frame, or `count` of them from `first` on, a multiple of
   * vtkIndirectSampler::RowLength; as many as it holds are copied into the buffer, on the GPU.
   */
  void Update(vtkOpenGLRenderWindow* window, const vtkIndirectVirtualLights& lights);
  void Update(
    vtkOpenGLRenderWindow* window, const vtkIndirectVirtualLights& lights, int first, int count);
  int GetNumberOfLights() const { return this->Count; }
  /** Binds the block, and the table with the lights beyond its capacity; pair. */
  void Activate(vtkShaderProgram* program) const;
  void Deactivate() const;

  size_t GetBytes() const { return this->Bytes; }
  /** The buffer's context must be current. */
  void Release();

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;     // of the buffer
  const vtkIndirectVirtualLights* Lights = nullptr; // of the last Update
  int First = 0;
  int Count = 0;
  int Capacity = 0;
  unsigned int Buffer = 0;
  size_t Bytes = 0;
};

#endif
