// SPDX-License-Identifier: BSD-3-Clause
// The interior of a surface: voxels with the distance to it, and a test for positions.
#pragma once

#include "vtkProxySurface.h" // for the surface

#include <cstdint> // for labels

class vtkProxySolid
{
public:
  /**
   * Finds the solid with `resolution` voxels along the longest axis. Closed parts of the surface
   * define it by their winding number. For open parts, voxels that the surface passes are walls: a
   * region enclosed by walls is solid; and so is a region with a winding number above one half, if
   * at most `opening` of its border has no wall.
   */
  void Build(const vtkProxySurface& surface, int resolution, double opening);

  /** True if a position is in the solid. */
  bool IsSolid(const glm::dvec3& p) const;

  /** Distance to the surface, negative outside of the solid. */
  double GetDepth(const glm::dvec3& p) const;

  /** Middles of the solid voxels without wall, and their depths. */
  struct Voxel
  {
    glm::dvec3 Middle;
    double Depth;
  };
  const std::vector<Voxel>& GetVoxels() const { return this->Voxels; }
  /** Voxels that no neighbour's ball contains: near the medial axis. */
  std::vector<Voxel> GetMedialVoxels() const;
  double GetVoxelSize() const { return this->Size; }

private:
  bool IsInClosedPart(const glm::dvec3& p) const;
  /** The index of the voxel that contains a position, or -1. */
  int VoxelOf(const glm::dvec3& p) const;

  enum Label : std::uint8_t
  {
    Unknown = 0,
    Wall,
    Outside,
    Solid
  };

  int Index(int x, int y, int z) const { return (z * this->Counts.y + y) * this->Counts.x + x; }
  glm::dvec3 Middle(int x, int y, int z) const
  {
    return this->Origin + this->Size * (glm::dvec3(x, y, z) + 0.5);
  }
  glm::ivec3 Place(int index) const
  {
    return { index % this->Counts.x, index / this->Counts.x % this->Counts.y,
      index / this->Counts.x / this->Counts.y };
  }
  void MarkWalls();
  /** Finds voxels connected with a seed over faces and of its value; sets them to a new value. */
  std::vector<int> Flood(int seed, std::vector<std::uint8_t>& values, std::uint8_t made) const;
  void FindRegions();
  void FindWoundRegions(double opening);

  const vtkProxySurface* Surface = nullptr;
  double Size = 1.0;
  glm::dvec3 Origin{ 0.0 };
  glm::ivec3 Counts{ 0 };
  std::vector<std::uint8_t> Labels;
  std::vector<std::uint8_t> Wound; // 2: in or beside a region with nonzero winding of open parts
  std::vector<Voxel> Voxels;
  std::vector<int> VoxelIndices;
};
