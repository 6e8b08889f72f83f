// SPDX-License-Identifier: BSD-3-Clause
// Area lights and points of them as shaders have them (vtkIndirectAreaLamps.glsl).
#ifndef vtkIndirectAreaBlock_h
#define vtkIndirectAreaBlock_h

#include "OpenGL/vtkIndirectUniformBlock.h" // for a member

#include <string> // for definitions

class vtkIndirectAreaLamps;
class vtkIndirectAreaMaps;

class vtkIndirectAreaBlock
{
public:
  /** Of so many lamps at most, and so many points of each. */
  vtkIndirectAreaBlock(size_t lamps, size_t points);

  /** What shaders must define before they include vtkIndirectAreaLamps.glsl. */
  std::string GetDefinitions() const;

  /** Lamps from `first` on. Without maps they have no points. */
  void Update(vtkOpenGLRenderWindow* window, const vtkIndirectAreaLamps& lamps, size_t first,
    size_t count, const vtkIndirectAreaMaps* maps);
  void Activate(vtkShaderProgram* program) const { this->Block.Activate(program); }

  size_t GetBytes() const { return this->Block.GetBytes(); }
  void Release() { this->Block.Release(); }

private:
  size_t Lamps;
  size_t Points;
  vtkIndirectUniformBlock Block{ "vtkiAreaBlock" };
};

#endif
