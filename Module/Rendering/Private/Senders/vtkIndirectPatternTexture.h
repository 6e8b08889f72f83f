// SPDX-License-Identifier: BSD-3-Clause
// A sampler's pattern of map coordinates as a texture. It is made anew when its sources or the
// sampler have changed.
#pragma once

#include "OpenGL/vtkIndirectDataTexture.h" // for the base class
#include "Senders/vtkIndirectMapSampler.h" // for sources

#include <vector> // for sources

class vtkOpenGLRenderWindow;

class vtkIndirectPatternTexture : public vtkIndirectDataTexture
{
public:
  using vtkIndirectDataTexture::vtkIndirectDataTexture;

  /** Brings the texture up to date. Returns true if it has changed. */
  bool Update(vtkOpenGLRenderWindow* window, vtkIndirectMapSampler& sampler,
    const std::vector<vtkIndirectMapSampler::Source>& sources);

  int GetNumberOfSamples() const { return this->NumberOfSamples; }

  /** Binds the texture. */
  void Activate(const vtkIndirectProgram& program) const
  {
    this->vtkIndirectDataTexture::Activate(program, "vtkiPattern");
  }

private:
  std::vector<vtkIndirectMapSampler::Source> Sources;
  const vtkIndirectMapSampler* Sampler = nullptr; // sampler that made it
  vtkMTimeType Time = 0;                          // time of that sampler
  int NumberOfSamples = 0;
};
