// SPDX-License-Identifier: BSD-3-Clause
// Sums virtual lights and their lobes within their bounds: by compute shaders in tiles of 16 x 16
// pixels, or without compute shaders by blended splats. Both give the same result within rounding.
#pragma once

#include "OpenGL/vtkIndirectComputeProgram.h" // for a member
#include "OpenGL/vtkIndirectPointProgram.h"   // for members
#include "OpenGL/vtkIndirectResource.h"       // for the base class
#include "Plan/vtkIndirectEstimate.h"         // for the input
#include "Splatting/vtkIndirectSplatMesh.h"   // for a member

class vtkIndirectSplatTable;
class vtkIndirectTarget;

class vtkIndirectSplats : public vtkIndirectResource
{
public:
  using vtkIndirectResource::vtkIndirectResource;

  /**
   * Fills `sum`, of the frame's size and RGBA32F; its fourth component is the number of splats at a
   * pixel. Without tiles the target shares the geometry buffer's depth. Within a
   * vtkIndirectFullScreenState. Returns false if a program does not compile.
   */
  bool Sum(const vtkIndirectEstimateInput& input, const vtkIndirectSplatTable& table,
    vtkIndirectTarget& sum);

  /**
   * Fills `glossy`, of the frame's size and RGBA32F, with the specular reflection of the lights and
   * their lobes by receivers. Only with tiles; without them vtkIndirectGlossyGather and
   * vtkIndirectLobeGather sum the same. Otherwise as Sum.
   */
  bool SumGlossy(const vtkIndirectEstimateInput& input, const vtkIndirectSplatTable& table,
    vtkIndirectTarget& glossy);

private:
  bool SumBlended(const vtkIndirectEstimateInput& input, const vtkIndirectSplatTable& table,
    vtkIndirectTarget& sum);
  bool Draw(const vtkIndirectEstimateInput& input, const vtkIndirectSplatTable& table,
    const vtkIndirectProgram& program);
  // Runs the compute program for blocks of lights.
  static bool SumInTiles(const vtkIndirectEstimateInput& input, const vtkIndirectSplatTable& table,
    vtkIndirectComputeProgram& tiles, vtkIndirectTarget& sum);

  vtkIndirectSplatMesh Mesh{ this };
  // A splat has few pixels for each triangle: more varyings cost more than they save.
  vtkIndirectPointProgram OfLights{ this, "vtkIndirectSplatVS.glsl", "vtkIndirectSplatFS.glsl",
    64 };
  vtkIndirectPointProgram OfLobes{ this, "vtkIndirectSplatVS.glsl", "vtkIndirectSplatFS.glsl", 64 };
  vtkIndirectComputeProgram Tiles{ this, "vtkIndirectSplatTilesCS.glsl" };
  vtkIndirectComputeProgram GlossyTiles{ this, "vtkIndirectGlossyTilesCS.glsl" };
};
