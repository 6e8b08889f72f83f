// SPDX-License-Identifier: BSD-3-Clause
// The planes of the surfaces in a grid of voxels: for each voxel the plane that all its triangles
// share, roughly.
#pragma once

#include <cstdint>     // for indices
#include <glm/glm.hpp> // for vectors
#include <vector>      // for planes

class vtkIndirectVoxelPlanes
{
public:
  /** Empties the grid and gives it this many voxels along each axis. */
  void Clear(const glm::ivec3& size);
  /** Adds a triangle (voxel coordinates) that has an area to the voxels that it touches. */
  void Add(const glm::dvec3 corners[3], const std::vector<glm::ivec3>& touched);
  /**
   * Finds the plane of a voxel: its normal, to either side, and its height over the voxel's centre.
   * Returns false where no triangle touches the voxel or its triangles lie in different planes.
   */
  bool Find(const glm::ivec3& voxel, glm::dvec3& normal, double& height) const;
  size_t GetBytes() const
  {
    return this->Index.size() * sizeof(int32_t) + this->Planes.size() * sizeof(Plane);
  }

private:
  struct Plane
  {
    glm::dvec3 Normal{ 0.0 }; // sum over the triangles
    double Height = 0.0;      // sum
    bool Mixed = false;       // two triangles differ
  };
  size_t Fold(const glm::ivec3& voxel) const
  {
    return voxel.x +
      static_cast<size_t>(this->Size.x) * (voxel.y + static_cast<size_t>(this->Size.y) * voxel.z);
  }

  glm::ivec3 Size{ 0 };
  std::vector<int32_t> Index; // number of each voxel's plane; -1: no triangle touches the voxel
  std::vector<Plane> Planes;
};
