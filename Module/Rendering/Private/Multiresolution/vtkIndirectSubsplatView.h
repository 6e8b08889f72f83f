// SPDX-License-Identifier: BSD-3-Clause
// Debug views of multiresolution splatting: the paper's figures 3, 4 and 5 for any scene.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectResource.h"          // for the base class

#include <string> // for names
#include <vector> // for names

class vtkIndirectGeometryBuffer;
class vtkIndirectSubsplatIllumination;
class vtkIndirectSubsplatPyramid;
class vtkIndirectTarget;
struct vtkIndirectFrame;

class vtkIndirectSubsplatView : public vtkIndirectResource
{
public:
  using vtkIndirectResource::vtkIndirectResource;

  /**
   * Returns the names of the views for that many levels: subsplat.level, each pixel's level;
   * subsplat.outline, the subsplats over the irradiance; subsplat.evaluated<n>, the illumination of
   * level n's leaves; subsplat.upsampled<n>, level n with the interpolation of coarser levels.
   * Level 0 is pixels.
   */
  static std::vector<std::string> GetNames(size_t levels);

  /** Draws a view into the bound target of the frame's size. Returns its number of components, 0 if
   * the name is no view. */
  int Draw(const std::string& name, const vtkIndirectFrame& frame,
    const vtkIndirectGeometryBuffer& geometry, const vtkIndirectSubsplatPyramid& pyramid,
    const vtkIndirectSubsplatIllumination& illumination, const vtkIndirectTarget& pixels,
    double unit);

private:
  vtkIndirectFullScreenProgram View{ this, "vtkIndirectSubsplatViewFS.glsl" };
};
