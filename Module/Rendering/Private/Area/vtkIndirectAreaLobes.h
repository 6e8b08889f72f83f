// SPDX-License-Identifier: BSD-3-Clause
// The light of area lights that receivers reflect in their specular lobes, at every specular pixel.
// It is not summed in a scene without specular receivers.
#pragma once

#include "Area/vtkIndirectAreaBlock.h"           // for a member
#include "Area/vtkIndirectAreaLamps.h"           // for lamps
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectResource.h"          // for the base class
#include "OpenGL/vtkIndirectTarget.h"            // for members

class vtkIndirectAreaMaps;
class vtkIndirectGeometryBuffer;
struct vtkIndirectFrame;

class vtkIndirectAreaLobes : public vtkIndirectResource
{
public:
  explicit vtkIndirectAreaLobes(vtkIndirectResource* owner);

  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectGeometryBuffer& Geometry;
    const vtkIndirectAreaLamps& Lamps; // with an up-to-date texture
    const vtkIndirectAreaMaps* Maps;   // null: nothing hides the lamps
    size_t Points;                     // largest number of points of each lamp to look up
    double Tolerance;
  };

  /** Sums the lobes, within a vtkIndirectFullScreenState. Returns false, after an error. */
  bool Sum(const Input& input);

  /** Returns radiance in VTK's units, with each pixel's own reflectance. */
  vtkIndirectTarget& GetReflected() { return this->Reflected; }

private:
  bool UpdateTables(const Input& input);
  bool AddLamp(const Input& input, size_t number);

  vtkIndirectAreaBlock Block{ this, 1, vtkIndirectAreaLamps::MostPoints };
  vtkIndirectFullScreenProgram Kernels[2]; // for one radiance, for images
  vtkIndirectTarget Tables;                // transforms, integrals
  vtkIndirectTarget Reflected;
};
