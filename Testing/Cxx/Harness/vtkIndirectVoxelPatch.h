// SPDX-License-Identifier: BSD-3-Clause
// Walls for tests of voxels.
#ifndef vtkIndirectVoxelPatch_h
#define vtkIndirectVoxelPatch_h

#include "Visibility/vtkIndirectOccupancyVolume.h" // for its use

namespace vtkIndirectTest
{
/** A parallelogram as two triangles, or divided into n x n pieces of two each. */
inline void AddPatch(vtkIndirectOccupancyVolume& volume, const glm::dvec3& origin,
  const glm::dvec3& u, const glm::dvec3& v, int n)
{
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const glm::dvec3 a = origin + (u * (1.0 * i) + v * (1.0 * j)) / (1.0 * n);
      const glm::dvec3 b = a + u / (1.0 * n);
      const glm::dvec3 c = a + v / (1.0 * n);
      const glm::dvec3 d = b + v / (1.0 * n);
      const glm::dvec3 first[3] = { a, b, d };
      const glm::dvec3 second[3] = { a, d, c };
      volume.AddTriangle(first, glm::dvec3(0.5));
      volume.AddTriangle(second, glm::dvec3(0.5));
    }
  }
}
}
#endif
