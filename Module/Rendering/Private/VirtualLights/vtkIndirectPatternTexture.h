// SPDX-License-Identifier: BSD-3-Clause
// A sampler's pattern of map coordinates as a texture. It is made anew when its sources or the
// sampler have changed.
#ifndef vtkIndirectPatternTexture_h
#define vtkIndirectPatternTexture_h

#include "VirtualLights/vtkIndirectMapSampler.h" // for sources
#include "vtkSmartPointer.h"                     // for the texture

#include <vector> // for sources

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class vtkIndirectPatternTexture
{
public:
  vtkIndirectPatternTexture();
  ~vtkIndirectPatternTexture();

  /** Brings the texture up to date. Returns true if it has changed. */
  bool Update(vtkOpenGLRenderWindow* window, vtkIndirectMapSampler& sampler,
    const std::vector<vtkIndirectMapSampler::Source>& sources);

  int GetNumberOfSamples() const { return this->NumberOfSamples; }

  /** Binds the texture; pair with Deactivate. */
  void Activate(vtkShaderProgram* program) const;
  void Deactivate() const;

  size_t GetBytes() const;
  void Release(vtkWindow* window);

private:
  std::vector<vtkIndirectMapSampler::Source> Sources;
  const vtkIndirectMapSampler* Sampler = nullptr; // sampler that made it
  vtkMTimeType Time = 0;                          // time of that sampler
  int NumberOfSamples = 0;
  vtkSmartPointer<vtkTextureObject> Texture;
};

#endif
