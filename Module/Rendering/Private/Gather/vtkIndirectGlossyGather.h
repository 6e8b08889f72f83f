// SPDX-License-Identifier: BSD-3-Clause
// Indirect light in receivers' specular lobes, summed over the senders at every specular pixel.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectResource.h"          // for the base class
#include "Plan/vtkIndirectEstimate.h"            // for the input

class vtkIndirectTarget;

class vtkIndirectGlossyGather : public vtkIndirectResource
{
public:
  using vtkIndirectResource::vtkIndirectResource;

  /** Texels around a receiver's place in each map, for an estimator without a sampler. */
  struct Neighborhood
  {
    int NumberOfSamples = 0;
    double Radius = 0.0; // fraction of the map's width
  };

  /**
   * Fills `glossy`, of the frame's size, where a value of one means `unit`. Must be called within a
   * vtkIndirectFullScreenState.
   */
  bool Sum(const vtkIndirectEstimateInput& input, vtkIndirectTarget& glossy, double unit,
    const Neighborhood& neighborhood);

private:
  vtkIndirectFullScreenProgram Lights{ this, "vtkIndirectGlossyFS.glsl",
    "vtkIndirectGatherVirtualLights.glsl" };
  vtkIndirectFullScreenProgram Neighbors{ this, "vtkIndirectGlossyFS.glsl",
    "vtkIndirectGatherNeighborhood.glsl" };
};
