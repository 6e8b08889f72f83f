// SPDX-License-Identifier: BSD-3-Clause
// Virtual lights of a headlight that is the only light: the eye sees what it lights, so the
// geometry buffer serves as its map.
#ifndef vtkIndirectHeadlightSampler_h
#define vtkIndirectHeadlightSampler_h

#include "OpenGL/vtkIndirectFullScreenProgram.h"     // for members
#include "VirtualLights/vtkIndirectPatternTexture.h" // for members
#include "vtkVirtualLightSampler.h"

class vtkIndirectHeadlightSampler : public vtkVirtualLightSampler
{
public:
  static vtkIndirectHeadlightSampler* New();
  vtkTypeMacro(vtkIndirectHeadlightSampler, vtkVirtualLightSampler);

  /** Who makes the pattern of places in the view; must be there at Update. */
  void SetPattern(vtkMapLightSampler* pattern) { this->Pattern = pattern; }

  bool Update(const Input& input) override;
  size_t GetBytes() const override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkIndirectHeadlightSampler() = default;
  ~vtkIndirectHeadlightSampler() override = default;

private:
  vtkIndirectHeadlightSampler(const vtkIndirectHeadlightSampler&) = delete;
  void operator=(const vtkIndirectHeadlightSampler&) = delete;

  vtkMapLightSampler* Pattern = nullptr;
  vtkIndirectPatternTexture Texture;
  vtkIndirectFullScreenProgram Program{ "vtkIndirectCameraLightFS.glsl" };
};

#endif
