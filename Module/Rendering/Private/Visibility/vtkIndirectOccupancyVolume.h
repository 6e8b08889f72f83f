// SPDX-License-Identifier: BSD-3-Clause
// The parts of the scene's space that hold surface: a bit a voxel, for obstacles between two
// points.
//
// Every voxel that a triangle touches is set (the separating-axis test of Akenine-Moeller 2001,
// "Fast 3D triangle-box overlap testing"), and a segment is tested in every voxel that it touches:
// no segment gets through a wall, however thin, slanted or finely cut. The price is that walls are
// up to two voxels thick. The voxels of a segment's two ends do not block it.
//
// The triangles are the polygons of vtkIndirectSurfaces. Planes and the mean albedo are kept on
// request, for radiance hints.
#pragma once

#include "OpenGL/vtkIndirectDataTexture.h"     // for a member
#include "OpenGL/vtkIndirectKey.h"             // for keys
#include "OpenGL/vtkIndirectResource.h"        // for the base class
#include "Scene/vtkIndirectFrame.h"            // for casters
#include "Visibility/vtkIndirectVoxelPlanes.h" // for a member

#include <glm/glm.hpp> // for vectors
#include <memory>      // for the distance field
#include <string>      // for reasons
#include <vector>      // for columns

class vtkIndirectDistanceField;
class vtkIndirectSurfaces;
class vtkOpenGLRenderWindow;

class vtkIndirectOccupancyVolume : public vtkIndirectResource
{
public:
  explicit vtkIndirectOccupancyVolume(vtkIndirectResource* owner = nullptr);
  ~vtkIndirectOccupancyVolume() override;

  /**
   * Brings the volume up to date with `resolution` (8 to 128) voxels along the longest edge of the
   * scene. Reads the polygons from `surfaces`. Returns true if the volume has changed.
   */
  bool Update(const vtkIndirectFrame& frame, const vtkIndirectSurfaces& surfaces, int resolution);

  /**
   * Makes each following Update find the planes in voxels and the mean albedo, too. glyphs: true if
   * the volume also holds the glyphs of the surfaces' list.
   */
  void KeepSurfaces(bool glyphs = false);
  /** Returns the planes in voxels, after KeepSurfaces. */
  const vtkIndirectVoxelPlanes& GetPlanes() const { return this->Planes; }

  /** Makes the next Update start anew. */
  void Forget() { this->Key.Clear(); }
  /**
   * Makes an empty volume over these bounds (scene units), which AddTriangle fills. For Update and
   * tests.
   */
  void Clear(const glm::dvec3& lower, const glm::dvec3& upper, int resolution);
  /** Adds a triangle; corners are in scene units. */
  void AddTriangle(const glm::dvec3 corners[3], const glm::dvec3& albedo);
  /** Finishes the mean albedo after the last triangle. */
  void Finish() { this->MeanAlbedo /= this->Area > 0.0 ? this->Area : 1.0; }

  bool IsEmpty() const { return this->NumberOfTriangles == 0; }
  /**
   * Returns true if occupied voxels hold all that the last Update's frame can draw. False with
   * glyphs, impostors, lines, points, levels of detail, or shaders of the user's own.
   */
  bool HoldsAll() const { return this->AllIsHeld; }
  const glm::ivec3& GetSize() const { return this->Size; }
  double GetVoxelSize() const { return this->VoxelSize; } // scene units
  glm::dvec3 ToVoxels(const glm::dvec3& position) const
  {
    return (position - this->Origin) / this->VoxelSize;
  }
  glm::dvec3 ToScene(const glm::dvec3& voxels) const
  {
    return this->Origin + this->VoxelSize * voxels;
  }
  bool IsOccupied(const glm::ivec3& voxel) const;
  /** Returns true if any voxel from lower to upper, both included, is occupied. */
  bool IsAnyOccupied(const glm::ivec3& lower, const glm::ivec3& upper) const;
  /** Returns true if the segment between two points (voxel coordinates) meets no occupied voxel. */
  bool IsFree(const glm::vec3& start, const glm::vec3& end) const;
  size_t GetNumberOfOccupiedVoxels() const;
  /** Returns the columns by x + GetSize().x y; bit z of a column is a voxel. */
  const std::vector<glm::uvec4>& GetColumns() const { return this->Columns; }
  /** Returns the distances to occupied voxels, which are made on the first request. */
  const vtkIndirectDistanceField& GetDistanceField() const;

  /** Returns the mean albedo of all surfaces, weighted by area, after KeepSurfaces. */
  const glm::dvec3& GetMeanAlbedo() const { return this->MeanAlbedo; }

  /** This is a prop that blocks no light in the volume, and the reason. */
  struct LeftOutProp
  {
    const vtkProp* Prop;
    std::string What;
    std::string Why;
  };
  const std::vector<LeftOutProp>& GetLeftOut() const { return this->LeftOut; }

  /** Binds the bits for vtkIndirectOccupancy.glsl. */
  void Activate(vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program) const;
  /** Returns the bytes of voxels, their distances and their planes. */
  size_t GetMainMemoryBytes() const;

private:
  void AddPolygons(const vtkIndirectFrame& frame, const vtkIndirectSurfaces& surfaces);
  void Mark(const glm::ivec3& voxel);

  glm::dvec3 Origin{ 0.0 };
  double VoxelSize = 1.0;
  glm::ivec3 Size{ 0 };
  size_t NumberOfTriangles = 0;
  bool AllIsHeld = true;
  std::vector<glm::uvec4> Columns; // by x + Size.x y
  bool SurfacesAreKept = false;
  bool GlyphsAreTaken = false;
  vtkIndirectVoxelPlanes Planes;
  double Area = 0.0; // voxels squared
  glm::dvec3 MeanAlbedo{ 0.0 };
  std::vector<glm::ivec3> Touched; // voxels that the current triangle touches
  vtkIndirectKey Key;
  // The distances are computed on the first request.
  const std::unique_ptr<vtkIndirectDistanceField> DistanceField;
  mutable bool DistanceFieldIsCurrent = false;
  std::vector<LeftOutProp> LeftOut;
  mutable vtkIndirectDataTexture Texture{ this };
};
