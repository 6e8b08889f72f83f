// SPDX-License-Identifier: BSD-3-Clause
// Lists of spheres by the cells of a uniform grid, for segments between two points. The grid does
// for spheres what voxels do for triangles, but exactly. A segment is followed from cell to cell
// (Amanatides and Woo 1987, "A fast voxel traversal algorithm for ray tracing") and tested against
// the spheres of each cell.
//
// A list holds copies of its spheres, so that a shader reads them one after the other. A cell
// inside a sphere does not list the sphere: a segment that the sphere blocks passes its surface.
#pragma once

#include "OpenGL/vtkIndirectDataTexture.h" // for members
#include "OpenGL/vtkIndirectResource.h"    // for the base class

#include <cstddef>     // for size_t
#include <cstdint>     // for indices
#include <glm/glm.hpp> // for vectors
#include <vector>      // for lists

class vtkOpenGLRenderWindow;

class vtkIndirectSphereGrid : public vtkIndirectResource
{
public:
  /**
   * These are the cells along an edge at most: no OpenGL has smaller three-dimensional textures.
   */
  static constexpr int MaximumSize = 256;
  /** These are the spheres in a row of the table that shaders read. */
  static constexpr int RowLength = 1024;
  /** Entries of all lists together, by default: 128 MB. */
  static constexpr size_t MaximumNumberOfEntries = size_t(1) << 23;

  using vtkIndirectResource::vtkIndirectResource;

  /**
   * Makes lists from the center and radius of each sphere, in scene units; radii are positive, and
   * all numbers finite. The grid has four cells for each sphere over their bounds, more where
   * spheres lie so close together that lists would be long, and fewer where lists would have more
   * than `entries` entries. Returns false, with no spheres, when there are more spheres than
   * entries.
   */
  bool Build(const std::vector<glm::dvec4>& spheres, size_t entries = MaximumNumberOfEntries);
  /** Does the same with this many cells for each sphere. */
  bool Build(const std::vector<glm::dvec4>& spheres, double cellsOfSphere, size_t entries);
  void Clear();

  bool IsEmpty() const { return this->Lists.empty(); }
  size_t GetNumberOfSpheres() const { return this->NumberOfSpheres; }
  size_t GetNumberOfEntries() const { return this->Lists.size(); }
  size_t GetLongestList() const;
  const glm::ivec3& GetSize() const { return this->Size; }
  glm::dvec3 ToCells(const glm::dvec3& position) const
  {
    return (position - this->Origin) * this->Scale;
  }

  /**
   * Returns true if no sphere blocks the segment between two places (scene units), by the shaders'
   * own kernel. steps, if given, receives the rounds of a shader's loop: one for each cell and each
   * sphere on the segment.
   */
  bool IsFree(const glm::dvec3& start, const glm::dvec3& end, int* steps = nullptr) const;
  /**
   * Returns the mean number of steps of segments from around the spheres to them, and between them.
   */
  double GetNumberOfSteps() const { return this->NumberOfSteps; }

  /** Binds lists and spheres for vtkIndirectSphereSegments.glsl. */
  void Activate(vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program) const;
  size_t GetMainMemoryBytes() const;

private:
  void SetSize(const glm::dvec3& extent, double cells);
  size_t Count(const std::vector<glm::dvec4>& spheres, std::vector<std::uint32_t>& counts) const;
  void Fill(const std::vector<glm::dvec4>& spheres, const std::vector<std::uint32_t>& counts);
  void FindNumberOfSteps(
    const std::vector<glm::dvec4>& spheres, const glm::dvec3& lower, const glm::dvec3& upper);
  void Upload(vtkOpenGLRenderWindow* window) const;
  glm::vec4 ToCells(const glm::dvec4& sphere) const
  {
    return { glm::vec3(this->ToCells(glm::dvec3(sphere))),
      static_cast<float>(sphere.w * this->Scale) };
  }
  size_t Fold(int x, int y, int z) const
  {
    return x + static_cast<size_t>(this->Size.x) * (y + static_cast<size_t>(this->Size.y) * z);
  }
  template <typename F>
  void ForEachTouched(const glm::vec4& sphere, const F& call) const;

  glm::dvec3 Origin{ 0.0 };
  double Scale = 1.0; // cells per scene unit
  glm::ivec3 Size{ 1 };
  size_t NumberOfSpheres = 0;
  double NumberOfSteps = 0.0;
  std::vector<glm::uvec2> Cells; // first entry and length of a list
  std::vector<glm::vec4> Lists;  // cells
  mutable vtkIndirectDataTexture CellTexture{ this };
  mutable vtkIndirectDataTexture ListTexture{ this };
};
