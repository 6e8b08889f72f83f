// SPDX-License-Identifier: BSD-3-Clause
// Indirect light in receivers' specular lobes, summed over the senders at every specular pixel.
#ifndef vtkIndirectGlossyGather_h
#define vtkIndirectGlossyGather_h

#include "vtkIndirectEstimatorPass.h" // for its input
#include "vtkIndirectKernelProgram.h" // for members

class vtkIndirectOccupancyVolume;
class vtkIndirectTarget;

class vtkIndirectGlossyGather
{
public:
  /** Texels around a receiver's place in each map, where the estimator has no sampler. */
  struct Neighborhood
  {
    int NumberOfSamples = 0;
    double Radius = 0.0; // fraction of the map's width
  };

  /**
   * Fills `glossy`, of the frame's size, in which one stands for `unit`. voxels hide senders; none
   * where nothing does. Within a vtkIndirectKernelState.
   */
  bool Sum(const vtkIndirectEstimatorPass::Input& input, vtkIndirectTarget& glossy, double unit,
    vtkIndirectOccupancyVolume* voxels, const Neighborhood& neighborhood);

  void Release();

private:
  vtkIndirectKernelProgram Lights{ "vtkIndirectGlossyFS.glsl",
    "vtkIndirectGatherVirtualLights.glsl" };
  vtkIndirectKernelProgram Around{ "vtkIndirectGlossyFS.glsl",
    "vtkIndirectGatherNeighborhood.glsl" };
};

#endif
