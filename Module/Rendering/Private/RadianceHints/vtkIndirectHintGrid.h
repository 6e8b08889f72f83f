// SPDX-License-Identifier: BSD-3-Clause
// Where the hints are and what of the scene they see: all that depends on geometry alone.
//
// Hints of all grids make one list; hint i is texel (i mod RowLength, i div RowLength). A hint that
// would lie in a wall is moved to the nearest free voxel of its cell. Hints that no surface needs
// are inactive.
//
// From the occupancy volume come, for every voxel, which of the eight hints around it can be
// reached in a straight line; for every hint and direction, which surface a ray meets; and the
// surfaces themselves, two sides of each block of voxels where both are free.
#ifndef vtkIndirectHintGrid_h
#define vtkIndirectHintGrid_h

#include "OpenGL/vtkIndirectKernels.h"           // for the row length
#include "RadianceHints/vtkIndirectHintTables.h" // for members

#include <glm/glm.hpp> // for vectors
#include <string>      // for reasons
#include <vector>      // for tables

class vtkIndirectOccupancyVolume;
class vtkIndirectSurfaces;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

class vtkIndirectHintGrid
{
public:
  static constexpr int RowLength = vtkIndirectKernels::VTKI_ROW_LENGTH;
  static constexpr int MaximumNumberOfGrids = 2;
  /** Rays of all hints: 1 GiB in main memory, and as much in the texture. */
  static constexpr double MaximumNumberOfHits = 268435456.0;

  /** Box (scene units) and hints along each axis. */
  struct Region
  {
    glm::dvec3 Lower{ 0.0 };
    glm::dvec3 Upper{ 0.0 };
    glm::ivec3 Size{ 1 };
    bool operator==(const Region& other) const
    {
      return this->Lower == other.Lower && this->Upper == other.Upper && this->Size == other.Size;
    }
  };

  struct Settings
  {
    std::vector<Region> Regions; // the coarsest first
    bool Masks = false;          // voxels know which hints they see
    bool SkipEmpty = false;
    double Reach = 0.0;   // cells that a look-up may lie from its surface
    int NumberOfRays = 0; // at least; 0: no rays, no surfaces
    bool operator==(const Settings& other) const
    {
      return this->Regions == other.Regions && this->Masks == other.Masks &&
        this->SkipEmpty == other.SkipEmpty && this->Reach == other.Reach &&
        this->NumberOfRays == other.NumberOfRays;
    }
  };

  /** A side of a surface that rays can meet. */
  struct Surfel
  {
    glm::vec3 Position;
    glm::vec3 Normal;
    glm::vec3 Albedo;
    float Depth; // how far parts of the surface may lie behind its plane, scene units
  };

  vtkIndirectHintGrid();
  ~vtkIndirectHintGrid();

  ///@{
  /**
   * Why textures of an edge of so many texels at most cannot hold the tables, in a sentence; empty
   * when they can. Before Build from the settings, after it from what was found.
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
  const Settings& GetSettings() const { return this->Current; }
  glm::dvec3 GetCell(int grid) const;

  // For tests.
  const std::vector<glm::vec4>& GetHints() const { return this->Hints; }
  const std::vector<Surfel>& GetSurfels() const { return this->Surfels; }
  unsigned char GetMask(int grid, const glm::ivec3& voxel) const;
  int GetHit(int hint, int ray) const;
  /** Direction and solid angle of a bin of the octahedral map of rays. */
  static glm::dvec4 GetDirection(int ray, int edge);

  ///@{
  /** Bind the tables for vtkIndirectHintPlaces.glsl and its users; one Deactivate for all. */
  void Activate(vtkOpenGLRenderWindow* window, vtkShaderProgram* program);
  void ActivateMasks(vtkOpenGLRenderWindow* window, vtkShaderProgram* program);
  void ActivateRays(vtkOpenGLRenderWindow* window, vtkShaderProgram* program);
  void ActivateAlbedo(vtkOpenGLRenderWindow* window, vtkShaderProgram* program);
  void ActivateSurfels(vtkOpenGLRenderWindow* window, vtkShaderProgram* program);
  void Deactivate() { this->Textures.Deactivate(); }
  ///@}
  int GetNumberOfGrids() const { return static_cast<int>(this->Current.Regions.size()); }

  size_t GetBytes() const { return this->Textures.GetBytes(); }
  size_t GetMainMemoryBytes() const;
  void Release(vtkWindow* window) { this->Textures.Release(window); }

private:
  using Tables = vtkIndirectHintTables;
  using Table = Tables::Table;

  void Place(int grid);
  void FindMasks(int grid);
  void FindPlanes();
  void FindHits(const vtkIndirectSurfaces& surfaces);
  // A table's texture, made when there is none.
  void Bind(
    Table table, vtkOpenGLRenderWindow* window, vtkShaderProgram* program, const char* uniform);
  void Make(Table table, vtkOpenGLRenderWindow* window);
  // Along the edge of the octahedral map of at least so many rays, an even number.
  static int FindRayEdge(int rays);

  Settings Current;
  const vtkIndirectOccupancyVolume* Volume = nullptr; // while tables are made
  std::vector<int> First;                             // hint of each grid
  std::vector<glm::vec4> Hints;                       // position (scene units), 1 active or 0
  // Two a voxel: free, one a grid; occupied, 16 bits of vtkiPackPlane.
  std::vector<unsigned char> Masks;
  glm::ivec3 MaskSize{ 0 };
  std::vector<float> Hits; // surfel of each ray of each hint, -1: none
  std::vector<glm::vec4> Directions;
  std::vector<Surfel> Surfels;
  std::vector<glm::vec4> Albedo; // of what a hint sees around it
  int NumberOfActive = 0;
  int RayEdge = 0;
  int RayRowLength = 0; // texels in a row of the table of rays
  Tables Textures;
};

#endif
