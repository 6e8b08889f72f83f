// SPDX-License-Identifier: BSD-3-Clause
// A uniform block with area lights and points of them for shaders (vtkIndirectAreaLamps.glsl).
#pragma once

#include "OpenGL/vtkIndirectResource.h"     // for the base class
#include "OpenGL/vtkIndirectUniformBlock.h" // for a member

#include <string> // for definitions

class vtkIndirectAreaLamps;
class vtkIndirectAreaMaps;

class vtkIndirectAreaBlock : public vtkIndirectResource
{
public:
  /** Makes a block for at most this many lamps, and this many points of each lamp. */
  vtkIndirectAreaBlock(vtkIndirectResource* owner, size_t lamps, size_t points);

  /** Returns the definitions that shaders need before they include vtkIndirectAreaLamps.glsl. */
  std::string GetDefinitions() const;

  /** Takes `count` lamps from `first` on. Without maps the lamps have no points. */
  void Update(vtkOpenGLRenderWindow* window, const vtkIndirectAreaLamps& lamps, size_t first,
    size_t count, const vtkIndirectAreaMaps* maps);
  void Activate(const vtkIndirectProgram& program) const { this->Block.Activate(program); }

private:
  size_t Lamps;
  size_t Points;
  vtkIndirectUniformBlock Block{ this, "vtkiAreaBlock" };
};
