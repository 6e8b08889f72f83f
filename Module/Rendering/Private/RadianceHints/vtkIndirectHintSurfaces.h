// SPDX-License-Identifier: BSD-3-Clause
// Groups the hits of rays into surfaces: hits in one block of voxels on one plane make one surface,
// with its own albedo, however near other surfaces are. There are as many surfaces as light can
// reach.
#pragma once

#include <glm/glm.hpp> // for vectors
#include <vector>      // for surfaces

class vtkIndirectHintSurfaces
{
public:
  /** This is a place that a ray meets; coordinates count voxels. */
  struct Hit
  {
    glm::dvec3 Position{ 0.0 };
    glm::dvec3 Normal{ 0.0 }; // the facet's, on the side that the ray comes from
    glm::dvec3 Albedo{ 0.0 }; // over pi where VTK divides by pi
  };

  /** This is the greatest distance of a surface's hit from its plane, in voxels. */
  static constexpr double PlaneDepth = 0.3;

  /** The volume has this many voxels along its axes. */
  explicit vtkIndirectHintSurfaces(const glm::ivec3& size);

  /** Adds a hit; returns the number of its surface. */
  int Add(const Hit& hit);

  int GetNumberOfSurfaces() const { return static_cast<int>(this->Surfaces.size()); }
  /** The mean of a surface's hits; the normal is unit. */
  Hit GetMean(int surface) const;

private:
  struct Surface
  {
    Hit First;
    Hit Sum;
    double Count;
    int Before; // previous surface in the same block
  };

  glm::ivec3 Blocks;
  std::vector<int> Newest; // one entry a block, -1: none
  std::vector<Surface> Surfaces;
};
