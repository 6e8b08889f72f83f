// SPDX-License-Identifier: BSD-3-Clause
#include "Visibility/vtkIndirectTriangleGrid.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void vtkIndirectTriangleGrid::Clear(const glm::ivec3& size)
{
  this->Size = size;
  this->Triangles.clear();
  this->Touches.clear();
  this->First.clear();
  this->Lists.clear();
}

//------------------------------------------------------------------------------
void vtkIndirectTriangleGrid::Add(
  const glm::dvec3 corners[3], const glm::dvec3& albedo, const std::vector<glm::ivec3>& touched)
{
  const uint32_t index = static_cast<uint32_t>(this->Triangles.size());
  this->Triangles.push_back(
    { { glm::vec3(corners[0]), glm::vec3(corners[1]), glm::vec3(corners[2]) }, glm::vec3(albedo) });
  for (const glm::ivec3& voxel : touched)
  {
    this->Touches.emplace_back(static_cast<uint32_t>(this->Fold(voxel)), index);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectTriangleGrid::Finish()
{
  // A sort by counting: triangles stay in their order.
  this->First.assign(static_cast<size_t>(this->Size.x) * this->Size.y * this->Size.z + 1, 0);
  for (const auto& touch : this->Touches)
  {
    ++this->First[touch.first + 1];
  }
  for (size_t i = 1; i < this->First.size(); ++i)
  {
    this->First[i] += this->First[i - 1];
  }
  this->Lists.resize(this->Touches.size());
  std::vector<uint32_t> next(this->First.begin(), this->First.end() - 1);
  for (const auto& touch : this->Touches)
  {
    this->Lists[next[touch.first]++] = touch.second;
  }
  this->Touches.clear();
  this->Touches.shrink_to_fit();
  this->Triangles.shrink_to_fit();
  this->Lists.shrink_to_fit();
}

//------------------------------------------------------------------------------
bool vtkIndirectTriangleGrid::FindHit(
  const glm::dvec3& start, const glm::dvec3& direction, Hit& hit) const
{
  if (this->Lists.empty())
  {
    return false;
  }
  // A ray that grazes the edge of two triangles must meet one of them.
  constexpr double slack = 1e-6;
  // Rays that start outside enter the grid first.
  double enter = 0.0;
  double leave = INFINITY;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double d = direction[axis];
    const double size = this->Size[axis];
    if (d == 0.0)
    {
      leave = start[axis] >= 0.0 && start[axis] <= size ? leave : -1.0;
      continue;
    }
    const double a = -start[axis] / d;
    const double b = (size - start[axis]) / d;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (!(enter <= leave))
  {
    return false;
  }
  const glm::dvec3 inside = start + enter * direction;
  glm::ivec3 voxel =
    glm::clamp(glm::ivec3(glm::floor(inside)), glm::ivec3(0), this->Size - glm::ivec3(1));
  glm::ivec3 step;
  glm::dvec3 next;
  glm::dvec3 delta;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double d = direction[axis];
    step[axis] = d >= 0.0 ? 1 : -1;
    delta[axis] = d != 0.0 ? 1.0 / std::abs(d) : INFINITY;
    next[axis] = d != 0.0 ? (voxel[axis] + (d > 0.0 ? 1.0 : 0.0) - start[axis]) / d : INFINITY;
  }
  double nearest = INFINITY;
  uint32_t found = 0;
  while (true)
  {
    const int at = this->Fold(voxel);
    for (uint32_t i = this->First[at]; i < this->First[at + 1]; ++i)
    {
      const Triangle& triangle = this->Triangles[this->Lists[i]];
      const glm::dvec3 corner(triangle.Corners[0]);
      const glm::dvec3 edge1 = glm::dvec3(triangle.Corners[1]) - corner;
      const glm::dvec3 edge2 = glm::dvec3(triangle.Corners[2]) - corner;
      const glm::dvec3 p = glm::cross(direction, edge2);
      const double determinant = glm::dot(edge1, p);
      if (determinant == 0.0)
      {
        continue;
      }
      const glm::dvec3 offset = start - corner;
      const glm::dvec3 q = glm::cross(offset, edge1);
      const double u = glm::dot(offset, p) / determinant;
      const double v = glm::dot(direction, q) / determinant;
      const double t = glm::dot(edge2, q) / determinant;
      if (u >= -slack && v >= -slack && u + v <= 1.0 + slack && t > 0.0 && t < nearest)
      {
        nearest = t;
        found = this->Lists[i];
      }
    }
    const int axis = next.x <= next.y ? (next.x <= next.z ? 0 : 2) : (next.y <= next.z ? 1 : 2);
    // What lies in a later voxel may be behind what is met there.
    if (nearest <= next[axis] + slack)
    {
      break;
    }
    voxel[axis] += step[axis];
    next[axis] += delta[axis];
    if (voxel[axis] < 0 || voxel[axis] >= this->Size[axis])
    {
      break;
    }
  }
  if (!std::isfinite(nearest))
  {
    return false;
  }
  const Triangle& triangle = this->Triangles[found];
  const glm::dvec3 corner(triangle.Corners[0]);
  const glm::dvec3 normal = glm::normalize(
    glm::cross(glm::dvec3(triangle.Corners[1]) - corner, glm::dvec3(triangle.Corners[2]) - corner));
  hit.Position = start + nearest * direction;
  hit.Normal = glm::dot(normal, direction) > 0.0 ? -normal : normal;
  hit.Albedo = glm::dvec3(triangle.Albedo);
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectTriangleGrid::FindPlane(
  const glm::ivec3& voxel, glm::dvec3& normal, double& height) const
{
  // Cosine between normals of one surface, bent a little, or of a wall's two sides.
  constexpr double leastCosine = 0.9;
  if (this->Lists.empty())
  {
    return false;
  }
  const int at = this->Fold(voxel);
  const glm::dvec3 centre = glm::dvec3(voxel) + 0.5;
  normal = glm::dvec3(0.0);
  height = 0.0;
  for (uint32_t i = this->First[at]; i < this->First[at + 1]; ++i)
  {
    const Triangle& triangle = this->Triangles[this->Lists[i]];
    const glm::dvec3 corner(triangle.Corners[0]);
    glm::dvec3 n = glm::normalize(glm::cross(
      glm::dvec3(triangle.Corners[1]) - corner, glm::dvec3(triangle.Corners[2]) - corner));
    const double cosine = glm::dot(n, normal);
    n *= cosine < 0.0 ? -1.0 : 1.0;
    if (std::abs(cosine) < leastCosine * glm::length(normal))
    {
      return false;
    }
    normal += n;
    height += glm::dot(n, corner - centre);
  }
  const double size = glm::length(normal);
  height /= std::max(size, 1.0);
  normal /= std::max(size, 1.0);
  return size > 0.0 && std::abs(height) <= 1.0;
}
