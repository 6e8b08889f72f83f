// SPDX-License-Identifier: BSD-3-Clause
// Which triangle of the scene a ray meets first: lists of triangles by voxel.
//
// A voxel says that there is surface, not which, nor how much of it: rays that stop at voxels take
// thin things for as wide as a voxel, and mix the two sides of a wall. Here they are followed from
// voxel to voxel (Amanatides and Woo 1987, "A fast voxel traversal algorithm for ray tracing") and
// tested against the triangles in each (Moeller and Trumbore 1997, "Fast, minimum storage
// ray/triangle intersection").
#ifndef vtkIndirectTriangleGrid_h
#define vtkIndirectTriangleGrid_h

#include <cstdint>     // for indices
#include <glm/glm.hpp> // for vectors
#include <utility>     // for pairs
#include <vector>      // for lists

class vtkIndirectTriangleGrid
{
public:
  /** What a ray meets; coordinates count voxels. */
  struct Hit
  {
    glm::dvec3 Position{ 0.0 };
    glm::dvec3 Normal{ 0.0 }; // of the triangle, on the side that the ray comes from
    glm::dvec3 Albedo{ 0.0 };
  };

  /** Empties the lists and makes them for so many voxels along each axis. */
  void Clear(const glm::ivec3& size);
  /** Adds a triangle (voxel coordinates) that has an area to the voxels that it touches. */
  void Add(
    const glm::dvec3 corners[3], const glm::dvec3& albedo, const std::vector<glm::ivec3>& touched);
  /** Sorts the lists after the last triangle. */
  void Finish();

  /** The first triangle on a ray of unit direction; returns false when there is none. */
  bool FindHit(const glm::dvec3& start, const glm::dvec3& direction, Hit& hit) const;

  /**
   * The plane that all triangles of a voxel share, roughly: its normal, to either side, and its
   * height over the voxel's centre. Returns false when there is none or they differ.
   */
  bool FindPlane(const glm::ivec3& voxel, glm::dvec3& normal, double& height) const;

  size_t GetNumberOfTriangles() const { return this->Triangles.size(); }
  /** Of triangles and lists, which Finish has brought to their size. */
  size_t GetBytes() const
  {
    return this->Triangles.size() * sizeof(Triangle) +
      (this->First.size() + this->Lists.size()) * sizeof(uint32_t);
  }
  const glm::ivec3& GetSize() const { return this->Size; }

private:
  struct Triangle
  {
    glm::vec3 Corners[3];
    glm::vec3 Albedo;
  };
  int Fold(const glm::ivec3& voxel) const
  {
    return voxel.x + this->Size.x * (voxel.y + this->Size.y * voxel.z);
  }

  glm::ivec3 Size{ 0 };
  std::vector<Triangle> Triangles;
  std::vector<std::pair<uint32_t, uint32_t>> Touches; // voxel and triangle, before they are sorted
  std::vector<uint32_t> First;                        // by voxel, of its list
  std::vector<uint32_t> Lists;
};

#endif
