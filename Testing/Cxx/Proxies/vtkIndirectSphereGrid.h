// SPDX-License-Identifier: BSD-3-Clause
// Spheres in the cells of a uniform grid, for segments: what could take the place of voxels between
// a virtual light and a receiver. It is measured (Testing/Benchmark/sphere_blockers.py), not used.
#ifndef vtkIndirectSphereGrid_h
#define vtkIndirectSphereGrid_h

#include "OpenGL/vtkIndirectKernels.h" // for the language of shaders

#include <algorithm>   // for bounds
#include <cmath>       // for the size of cells
#include <cstdint>     // for indices
#include <glm/glm.hpp> // for vectors
#include <vector>      // for lists

namespace vtkIndirectKernels
{
namespace
{
#include "SphereSegments.glsl"
}
}

class vtkIndirectSphereGrid
{
public:
  /**
   * Center and radius of each, in any unit; cellsOfSphere: how many cells there are for each, over
   * their bounds. Radii are positive, all finite.
   */
  void Build(const std::vector<glm::dvec4>& spheres, double cellsOfSphere)
  {
    glm::dvec3 lower(0.0);
    glm::dvec3 upper(0.0);
    for (size_t i = 0; i < spheres.size(); ++i)
    {
      const glm::dvec3 center(spheres[i]);
      lower = i == 0 ? center - spheres[i].w : glm::min(lower, center - spheres[i].w);
      upper = i == 0 ? center + spheres[i].w : glm::max(upper, center + spheres[i].w);
    }
    const glm::dvec3 extent = upper - lower;
    const double cells = std::max(1.0, cellsOfSphere * static_cast<double>(spheres.size()));
    const double edge = std::cbrt(extent.x * extent.y * extent.z / cells);
    this->Origin = lower;
    this->Scale = edge > 0.0 ? 1.0 / edge : 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Size[axis] =
        std::clamp(static_cast<int>(std::ceil(extent[axis] * this->Scale)), 1, MaximumSize);
    }
    this->Spheres.clear();
    for (const glm::dvec4& sphere : spheres)
    {
      this->Spheres.emplace_back(
        glm::vec3(this->ToCells(glm::dvec3(sphere))), static_cast<float>(sphere.w * this->Scale));
    }
    // Twice the same walk: to count, and to fill.
    const size_t count = static_cast<size_t>(this->Size.x) * this->Size.y * this->Size.z;
    this->First.assign(count + 1, 0);
    this->ForEachTouch([this](size_t cell, std::uint32_t) { ++this->First[cell + 1]; });
    for (size_t i = 0; i < count; ++i)
    {
      this->First[i + 1] += this->First[i];
    }
    this->Lists.resize(this->First[count]);
    std::vector<std::uint32_t> next(this->First.begin(), this->First.end() - 1);
    this->ForEachTouch([this, &next](size_t cell, std::uint32_t sphere)
      { this->Lists[next[cell]++] = this->Spheres[sphere]; });
  }

  glm::dvec3 ToCells(const glm::dvec3& position) const
  {
    return (position - this->Origin) * this->Scale;
  }

  /** Whether no sphere stands between two places (cell coordinates). */
  bool IsFree(const glm::vec3& start, const glm::vec3& end) const
  {
    using namespace vtkIndirectKernels;
    const glm::vec3 along = end - start;
    const float length2 = glm::dot(along, along);
    vtkiCells walk = vtkiBeginCells(start, along, this->Size);
    for (bool more = walk.inside; more; more = vtkiNextCell(walk))
    {
      const size_t cell = this->Fold(walk.cell.x, walk.cell.y, walk.cell.z);
      const std::uint32_t beyond = this->First[cell + 1];
      for (std::uint32_t i = this->First[cell]; i < beyond; ++i)
      {
        if (vtkiSphereBlocks(start, along, length2, this->Lists[i]))
        {
          return false;
        }
      }
    }
    return true;
  }

  const glm::ivec3& GetSize() const { return this->Size; }
  size_t GetBytes() const
  {
    return this->Lists.size() * sizeof(glm::vec4) + this->First.size() * sizeof(std::uint32_t);
  }

  const glm::dvec3& GetOrigin() const { return this->Origin; }
  double GetScale() const { return this->Scale; }
  ///@{
  /** For textures: the first of each cell's list and how many (8 bits, 255 at most); the lists, in
   * rows. */
  std::vector<std::uint32_t> GetPackedLists() const
  {
    std::vector<std::uint32_t> lists;
    for (size_t i = 0; i + 1 < this->First.size(); ++i)
    {
      const std::uint32_t count = this->First[i + 1] - this->First[i];
      lists.push_back(this->First[i] << 8 | std::min<std::uint32_t>(count, 255u));
    }
    return lists;
  }
  int GetNumberOfRows(int width) const
  {
    return std::max(1, (static_cast<int>(this->Lists.size()) + width - 1) / width);
  }
  std::vector<float> GetSpheresAsRows(int width) const
  {
    std::vector<float> rows;
    for (const glm::vec4& sphere : this->Lists)
    {
      rows.insert(rows.end(), { sphere.x, sphere.y, sphere.z, sphere.w });
    }
    rows.resize(static_cast<size_t>(4) * width * this->GetNumberOfRows(width), 0.0f);
    return rows;
  }
  ///@}

private:
  static constexpr int MaximumSize = 256;

  size_t Fold(int x, int y, int z) const
  {
    return x + static_cast<size_t>(this->Size.x) * (y + static_cast<size_t>(this->Size.y) * z);
  }

  template <typename F>
  void ForEachTouch(const F& f) const
  {
    // Segments are followed in single precision, and may be a little beside their cell.
    constexpr float slack = 1e-3f;
    for (size_t i = 0; i < this->Spheres.size(); ++i)
    {
      const glm::vec3 center(this->Spheres[i]);
      const float radius = this->Spheres[i].w + slack;
      const glm::ivec3 first = glm::max(glm::ivec3(glm::floor(center - radius)), glm::ivec3(0));
      const glm::ivec3 last = glm::min(glm::ivec3(glm::floor(center + radius)), this->Size - 1);
      for (int z = first.z; z <= last.z; ++z)
      {
        for (int y = first.y; y <= last.y; ++y)
        {
          for (int x = first.x; x <= last.x; ++x)
          {
            const glm::vec3 corner(x, y, z);
            const glm::vec3 away = center - glm::clamp(center, corner, corner + 1.0f);
            if (glm::dot(away, away) <= radius * radius)
            {
              f(this->Fold(x, y, z), static_cast<std::uint32_t>(i));
            }
          }
        }
      }
    }
  }

  glm::dvec3 Origin{ 0.0 };
  double Scale = 1.0;
  glm::ivec3 Size{ 1 };
  std::vector<glm::vec4> Spheres;   // cells
  std::vector<std::uint32_t> First; // by cell, of its list
  std::vector<glm::vec4> Lists;
};

#endif
