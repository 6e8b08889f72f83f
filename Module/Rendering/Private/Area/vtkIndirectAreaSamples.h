// SPDX-License-Identifier: BSD-3-Clause
// Irradiance that comes directly from area lights in moving frames. It is computed in closed form,
// and for images by their descent, at every eighth pixel of every eighth row, and wherever surfaces
// or light vary between these. Its visible share comes from 16 points of each lamp, which four
// pixels of each block of 4 x 4 share among them.
//
// Limits: edges of shadows finer than four pixels are lost; steps between the 16 points show.
#pragma once

#include "Area/vtkIndirectAreaBlock.h"           // for a member
#include "Area/vtkIndirectAreaLamps.h"           // for lamps
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectResource.h"          // for the base class
#include "OpenGL/vtkIndirectTarget.h"            // for targets
#include "Sums/vtkIndirectReceiverGrid.h"        // for members

class vtkIndirectAreaMaps;
class vtkIndirectGeometryBuffer;

class vtkIndirectAreaSamples : public vtkIndirectResource
{
public:
  explicit vtkIndirectAreaSamples(vtkIndirectResource* owner);

  /** This is the number of points of a lamp that are looked up. */
  static constexpr int NumberOfPoints = 16;
  ///@{
  /** These are the distances in moving frames, and in still ones. */
  static constexpr int DistancesOfMoving = 14;
  static constexpr int DistancesOfStill = 28;
  ///@}

  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectGeometryBuffer& Geometry;
    const vtkIndirectAreaLamps& Lamps;
    const vtkIndirectAreaMaps* Maps; // null: nothing hides lamps
    double Tolerance;                // tolerance of an image's mean
    int Distances; // distance, over that of samples, from which on light is interpolated
  };

  /**
   * Adds the light to a cleared target of the frame's size, with blending functions of one and one,
   * in a vtkIndirectFullScreenState. Returns false, after an error.
   */
  bool Sum(const Input& input, vtkIndirectTarget& irradiance);

private:
  // The lamps of one draw.
  struct Batch
  {
    size_t First;
    size_t Count;
    int Images;
  };

  vtkIndirectProgram Use(
    const Input& input, const Batch& batch, vtkIndirectFullScreenProgram& kernel, int step);
  bool FindOpen(const Input& input, const Batch& batch);
  bool FindSamples(const Input& input, const Batch& batch);
  bool Interpolate(const Input& input, const Batch& batch, vtkIndirectTarget& irradiance);

  vtkIndirectAreaBlock Block;
  vtkIndirectReceiverGrid Open;
  vtkIndirectReceiverGrid Samples;
  vtkIndirectFullScreenProgram OpenKernel{ this, "vtkIndirectAreaOpenFS.glsl" };
  vtkIndirectFullScreenProgram SampleKernel{ this, "vtkIndirectAreaSamplesFS.glsl" };
  vtkIndirectFullScreenProgram SumKernel{ this, "vtkIndirectAreaSumFS.glsl" };
};
