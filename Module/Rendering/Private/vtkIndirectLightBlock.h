// SPDX-License-Identifier: BSD-3-Clause
// A sampler's virtual lights in a uniform buffer; see vtkIndirectLightUniforms.glsl. On llvmpipe
// the sum over lights takes 0.6 times as long as from textures.
#ifndef vtkIndirectLightBlock_h
#define vtkIndirectLightBlock_h

#include "vtkWeakPointer.h" // for the window

#include <cstddef> // for size_t
#include <string>  // for definitions

class vtkIndirectOccupancyVolume;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkVirtualLightSampler;

class vtkIndirectLightBlock
{
public:
  ~vtkIndirectLightBlock();

  /** Lights that the block holds at most: what the context's uniform blocks can, 256 to 1024. */
  int GetCapacity(vtkOpenGLRenderWindow* window);
  /** Voxels that hide lights from receivers, or null; for the two methods below. */
  void SetVoxels(vtkIndirectOccupancyVolume* voxels) { this->Voxels = voxels; }
  /** Definitions that the block's declaration, and the sum over the lights, need. */
  std::string GetDefinitions(vtkOpenGLRenderWindow* window);

  /** Copies the sampler's first lights into the buffer, on the GPU. */
  void Update(vtkOpenGLRenderWindow* window, vtkVirtualLightSampler& sampler);
  /** Binds the block, the textures with the lights beyond its capacity, and the voxels. */
  void Activate(vtkShaderProgram* program, vtkVirtualLightSampler& sampler) const;

  size_t GetBytes() const { return this->Bytes; }
  /** The buffer's context must be current. */
  void Release();

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the buffer
  vtkIndirectOccupancyVolume* Voxels = nullptr;
  int Capacity = 0;
  unsigned int Buffer = 0;
  size_t Bytes = 0;
};

#endif
