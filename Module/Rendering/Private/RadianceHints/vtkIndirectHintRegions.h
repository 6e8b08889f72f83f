// SPDX-License-Identifier: BSD-3-Clause
// Bounds of the grids of radiance hints, and the number of hints along each axis, from the
// properties of vtkRadianceHintsPass.
#pragma once

#include "RadianceHints/vtkIndirectHintGrid.h" // for regions

#include <glm/glm.hpp> // for vectors
#include <vector>      // for regions

struct vtkIndirectFrame;

struct vtkIndirectHintRegions
{
  static constexpr int MaximumResolution = 64;

  bool OfView = false; // only the visible part of the scene
  glm::ivec3 Resolution{ 0 };
  double Tolerance = 0.0; // tolerance for axes of resolution 0; otherwise not read
  bool HasFine = false;
  double FineExtent = 0.4;

  /** Returns the coarse grid, and the fine one if there is one. */
  std::vector<vtkIndirectHintGrid::Region> Find(const vtkIndirectFrame& frame) const;

private:
  vtkIndirectHintGrid::Region FindCoarse(const vtkIndirectFrame& frame) const;
  vtkIndirectHintGrid::Region FindFine(
    const vtkIndirectFrame& frame, const vtkIndirectHintGrid::Region& coarse) const;
  glm::ivec3 FindSize(const glm::dvec3& extent) const;
};
