// SPDX-License-Identifier: BSD-3-Clause
#include "Visibility/vtkIndirectVoxelPlanes.h"

#include <algorithm>
#include <cmath>

namespace
{
// The least cosine between normals of one surface, which may be bent a little or be a wall's two
// sides.
constexpr double LeastCosine = 0.9;
}

//------------------------------------------------------------------------------
void vtkIndirectVoxelPlanes::Clear(const glm::ivec3& size)
{
  this->Size = size;
  this->Index.clear();
  this->Planes.clear();
}

//------------------------------------------------------------------------------
void vtkIndirectVoxelPlanes::Add(
  const glm::dvec3 corners[3], const std::vector<glm::ivec3>& touched)
{
  if (this->Index.empty())
  {
    this->Index.assign(static_cast<size_t>(this->Size.x) * this->Size.y * this->Size.z, -1);
  }
  const glm::dvec3 facet =
    glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  for (const glm::ivec3& voxel : touched)
  {
    int32_t& index = this->Index[this->Fold(voxel)];
    if (index < 0)
    {
      index = static_cast<int32_t>(this->Planes.size());
      this->Planes.emplace_back();
    }
    Plane& plane = this->Planes[static_cast<size_t>(index)];
    const double cosine = glm::dot(facet, plane.Normal);
    if (plane.Mixed || std::abs(cosine) < LeastCosine * glm::length(plane.Normal))
    {
      plane.Mixed = true;
      continue;
    }
    const glm::dvec3 normal = cosine < 0.0 ? -facet : facet;
    plane.Normal += normal;
    plane.Height += glm::dot(normal, corners[0] - (glm::dvec3(voxel) + 0.5));
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectVoxelPlanes::Find(const glm::ivec3& voxel, glm::dvec3& normal, double& height) const
{
  const int32_t index = this->Index.empty() ? -1 : this->Index[this->Fold(voxel)];
  if (index < 0 || this->Planes[static_cast<size_t>(index)].Mixed)
  {
    return false;
  }
  const Plane& plane = this->Planes[static_cast<size_t>(index)];
  const double size = std::max(glm::length(plane.Normal), 1.0);
  height = plane.Height / size;
  normal = plane.Normal / size;
  return std::abs(height) <= 1.0;
}
