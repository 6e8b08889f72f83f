// SPDX-License-Identifier: BSD-3-Clause
// Visibility between two points on surfaces by the occupied voxels of a scene, with the kernels of
// the shaders.
#ifndef vtkIndirectVoxelLines_h
#define vtkIndirectVoxelLines_h

#include <glm/glm.hpp> // for vectors

class vtkIndirectDistanceField;

class vtkIndirectVoxelLines
{
public:
  /** An end of a segment: a place on a surface. */
  struct End
  {
    glm::vec3 Position; // voxels
    glm::vec3 Normal;
    glm::vec3 Open; // place nearby where no voxel of its own surface blocks; see FindEnd
  };

  /** Uses the distances and makes no copy. */
  explicit vtkIndirectVoxelLines(const vtkIndirectDistanceField& field)
    : Field(field)
  {
  }

  /**
   * Returns true if a segment (voxel coordinates) meets no occupied voxel except those of its ends.
   */
  bool IsFree(const glm::vec3& start, const glm::vec3& end) const;
  /**
   * Makes an end from a position in scene units and a unit normal. Its open place lies above the
   * surface's own voxels and, if another surface occupies that place, beside the voxels of that
   * surface where possible.
   */
  End FindEnd(const glm::dvec3& position, const glm::dvec3& direction) const;
  /**
   * Returns true if nothing blocks the segment between two places that face each other; the voxels
   * of their own planes do not count.
   */
  bool IsVisible(const End& receiver, const End& sender) const;

private:
  const vtkIndirectDistanceField& Field;
};

#endif
