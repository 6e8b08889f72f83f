// SPDX-License-Identifier: BSD-3-Clause
// The same in shaders: sums over all lights at each pixel of a small picture.
#ifndef BlockersShaders_h
#define BlockersShaders_h

#include "BlockersScene.h" // for places

#include <string> // for names

class BlockersMaps;
class vtkIndirectDistanceField;
class vtkIndirectSphereGrid;

/** Prints a row for each way: what a picture of 128 x 128 receivers costs. For scenes of spheres.
 */
void MeasureShaders(const std::string& name, const BlockersScene& scene,
  const vtkIndirectDistanceField& voxels, const BlockersMaps& maps,
  const vtkIndirectSphereGrid& grid);

#endif
