// SPDX-License-Identifier: BSD-3-Clause
// Positions of the hints and the surfaces visible from them: all data that depend only on geometry.
//
// Hints of all grids make one list; hint i is texel (i mod RowLength, i div RowLength). A hint
// inside a wall is moved to the nearest free voxel of its cell. Hints that no surface needs are
// inactive.
//
// The occupancy volume gives, for every voxel, the hints among the eight around it that a straight
// line reaches; for every hint and direction, the surface that a ray meets; and the surfaces
// themselves, two sides of each block of voxels if both are free.
#pragma once

#include "OpenGL/vtkIndirectDataTexture.h" // for members
#include "OpenGL/vtkIndirectKernels.h"     // for the row length
#include "OpenGL/vtkIndirectResource.h"    // for the base class

#include <glm/glm.hpp> // for vectors
#include <string>      // for reasons
#include <vector>      // for tables

class vtkIndirectOccupancyVolume;
class vtkIndirectSurfaces;
class vtkOpenGLRenderWindow;

class vtkIndirectHintGrid : public vtkIndirectResource
{
public:
  static constexpr int RowLength = vtkIndirectKernels::VTKI_ROW_LENGTH;
  /** These are the rays of all hints: 1 GiB in main memory, and as much in the texture. */
  static constexpr double MaximumNumberOfHits = 268435456.0;

  /** Box (scene units) and hints along each axis. */
  struct Region
  {
    glm::dvec3 Lower{ 0.0 };
    glm::dvec3 Upper{ 0.0 };
    glm::ivec3 Size{ 1 };
    /** Returns the edges of a cell, scene units. */
    glm::dvec3 GetCell() const { return (this->Upper - this->Lower) / glm::dvec3(this->Size); }
    bool operator==(const Region& other) const
    {
      return this->Lower == other.Lower && this->Upper == other.Upper && this->Size == other.Size;
    }
  };

  struct Settings
  {
    std::vector<Region> Regions; // the coarsest first
    bool Masks = false;          // voxels store the hints visible from them
    bool SkipEmpty = false;
    double Reach = 0.0;   // greatest distance of a look-up from its surface, in cells
    int NumberOfRays = 0; // at least; 0: no rays, no surfaces
    bool operator==(const Settings& other) const
    {
      return this->Regions == other.Regions && this->Masks == other.Masks &&
        this->SkipEmpty == other.SkipEmpty && this->Reach == other.Reach &&
        this->NumberOfRays == other.NumberOfRays;
    }
  };

  /** This is a side of a surface that rays can meet. */
  struct Surfel
  {
    glm::vec3 Position;
    glm::vec3 Normal;
    glm::vec3 Albedo;
    float Depth; // greatest depth of the surface behind its plane, scene units
  };

  explicit vtkIndirectHintGrid(vtkIndirectResource* owner = nullptr);
  ~vtkIndirectHintGrid() override;

  ///@{
  /**
   * Reason why textures of at most this edge length cannot hold the tables, in a sentence; empty if
   * they can. Before Build from the settings, after Build from the actual sizes.
   */
  static std::string FindObstacle(const Settings& settings, int longestEdge);
  std::string FindObstacle(int longestEdge) const;
  ///@}

  /** Forgets all hints. */
  void Clear();
  /**
   * Makes the tables anew. volume: null where nothing is known of the scene. surfaces: what rays
   * meet; may be null where the settings have no rays.
   */
  void Build(const Settings& settings, const vtkIndirectOccupancyVolume* volume,
    const vtkIndirectSurfaces* surfaces);

  int GetNumberOfHints() const { return static_cast<int>(this->Hints.size()); }
  int GetNumberOfActiveHints() const { return this->NumberOfActive; }
  int GetNumberOfRows() const { return (this->GetNumberOfHints() + RowLength - 1) / RowLength; }
  int GetNumberOfSurfelRows() const;
  int GetNumberOfRays() const { return this->Current.NumberOfRays; }
  glm::dvec3 GetCell(int grid) const;

  // Only tests call the next functions.
  const std::vector<glm::vec4>& GetHints() const { return this->Hints; }
  const std::vector<Surfel>& GetSurfels() const { return this->Surfels; }
  unsigned char GetMask(int grid, const glm::ivec3& voxel) const;
  int GetHit(int hint, int ray) const;
  /** Direction and solid angle of a bin of the octahedral map of rays. */
  static glm::dvec4 GetDirection(int ray, int edge);

  ///@{
  /** Bind the tables for vtkIndirectHintPlaces.glsl and its users. */
  void Activate(vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program);
  void ActivateMasks(vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program);
  void ActivateRays(vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program);
  void ActivateAlbedo(vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program);
  void ActivateSurfels(vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program);
  ///@}
  int GetNumberOfGrids() const { return static_cast<int>(this->Current.Regions.size()); }

  size_t GetMainMemoryBytes() const;

private:
  enum Table
  {
    HintTable,
    MaskTable,
    RayTable,
    DirectionTable,
    SurfelPosition,
    SurfelNormal,
    SurfelAlbedo,
    AlbedoTable,
    NumberOfTables
  };

  void Place(int grid);
  void FindMasks(int grid);
  void FindPlanes();
  void FindHits(const vtkIndirectSurfaces& surfaces);
  // Binds a table's texture, which it makes if there is none.
  void Bind(Table table, vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program,
    const char* uniform);
  void Make(Table table, vtkOpenGLRenderWindow* window);
  // Edge of the octahedral map of at least this many rays, an even number.
  static int FindRayEdge(int rays);

  Settings Current;
  const vtkIndirectOccupancyVolume* Volume = nullptr; // while tables are made
  std::vector<int> First;                             // first hint of each grid
  std::vector<glm::vec4> Hints;                       // position (scene units), 1 active or 0
  // Two bytes a voxel: if free, one for each grid; if occupied, 16 bits of vtkiPackPlane.
  std::vector<unsigned char> Masks;
  glm::ivec3 MaskSize{ 0 };
  std::vector<float> Hits; // surfel of each ray of each hint, -1: none
  std::vector<glm::vec4> Directions;
  std::vector<Surfel> Surfels;
  std::vector<glm::vec4> Albedo; // mean albedo of the surfaces around each hint
  int NumberOfActive = 0;
  int RayEdge = 0;
  int RayRowLength = 0; // texels in a row of the table of rays
  // Each is made when it is first bound.
  vtkIndirectDataTexture Textures[NumberOfTables]{ { this }, { this }, { this }, { this }, { this },
    { this }, { this }, { this } };
};
