// SPDX-License-Identifier: BSD-3-Clause
// What receivers reflect of area lights in their specular lobes, at every pixel that is specular.
// Where no receiver is, nobody asks for it.
#ifndef vtkIndirectAreaLobes_h
#define vtkIndirectAreaLobes_h

#include "Gather/vtkIndirectAreaLamps.h"         // for lamps
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectTarget.h"            // for members
#include "OpenGL/vtkIndirectUniformBlock.h"      // for members

class vtkIndirectAreaMaps;
class vtkIndirectGeometryBuffer;
class vtkWindow;
struct vtkIndirectFrame;

class vtkIndirectAreaLobes
{
public:
  vtkIndirectAreaLobes();

  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectGeometryBuffer& Geometry;
    const vtkIndirectAreaLamps& Lamps; // their texture up to date
    const vtkIndirectAreaMaps* Maps;   // null: nothing hides them
    size_t Points;                     // of each lamp, to look up at most
    double Tolerance;
  };

  /** Within a vtkIndirectFullScreenState. Returns false, after an error. */
  bool Sum(const Input& input);

  /** Radiance in VTK's units, of a pixel's own reflectance. */
  const vtkIndirectTarget& GetReflected() const { return this->Reflected; }

  size_t GetBytes() const;
  void Release(vtkWindow* window);

private:
  using Lamp = vtkIndirectAreaLamps::Lamp;

  bool UpdateTables(const Input& input);
  bool AddLamp(const Input& input, size_t number);
  void SetPoints(const Input& input, vtkShaderProgram* program, size_t number);

  vtkIndirectUniformBlock Block{ "vtkiAreaLobeBlock" };
  vtkIndirectFullScreenProgram Kernels[2]; // of one radiance, of images
  vtkIndirectTarget Tables;                // transforms, integrals
  vtkIndirectTarget Reflected;
};

#endif
