// SPDX-License-Identifier: BSD-3-Clause
// The surfaces that rays meet: what they meet in one block of voxels on one plane is one surface,
// with its own albedo however near to it others are. There are as many as light can reach.
#ifndef vtkIndirectHintSurfaces_h
#define vtkIndirectHintSurfaces_h

#include "Visibility/vtkIndirectTriangleGrid.h" // for what rays meet

#include <glm/glm.hpp> // for vectors
#include <vector>      // for surfaces

class vtkIndirectHintSurfaces
{
public:
  /** Voxels that what belongs to a surface may be off its plane. */
  static constexpr double PlaneDepth = 0.3;

  /** For a volume of so many voxels. */
  explicit vtkIndirectHintSurfaces(const glm::ivec3& size);

  /** Adds what a ray meets; returns the number of its surface. */
  int Add(const vtkIndirectTriangleGrid::Hit& hit);

  int GetNumberOfSurfaces() const { return static_cast<int>(this->Surfaces.size()); }
  /** Mean of all that belongs to a surface; the normal is unit. */
  vtkIndirectTriangleGrid::Hit GetMean(int surface) const;

private:
  struct Surface
  {
    vtkIndirectTriangleGrid::Hit First;
    vtkIndirectTriangleGrid::Hit Sum;
    double Count;
    int Before; // in the same block
  };

  glm::ivec3 Blocks;
  std::vector<int> Newest; // by block, -1: none
  std::vector<Surface> Surfaces;
};

#endif
