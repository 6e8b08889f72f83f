// SPDX-License-Identifier: BSD-3-Clause
// The scene's surfaces for rays on the processor: which one a ray meets first, and how VTK would
// light it for a camera where the ray comes from.
//
// Triangles are those of vtkIndirectPolygons. The normal is the interpolated one, or the cell's or
// the facet's where VTK takes these, turned as VTK turns it: by the winding, towards the ray's
// start. What a mapper culls is not there. The albedo follows properties (of the back, too),
// scalars' colours, also where VTK interpolates scalars before it maps them, and the actor's
// texture. Left out: textures of VTK's PBR, albedo by a composite mapper's blocks, shaders of the
// user's own.
#ifndef vtkIndirectRaySurfaces_h
#define vtkIndirectRaySurfaces_h

#include "Visibility/vtkIndirectTriangleTree.h" // for members

#include <cstdint>     // for numbers
#include <glm/glm.hpp> // for vectors
#include <memory>      // for pieces
#include <string>      // for reasons
#include <utility>     // for pairs
#include <vector>      // for triangles

struct vtkIndirectFrame;

class vtkIndirectRaySurfaces
{
public:
  /** A place on a surface, in scene units. */
  struct Meeting
  {
    glm::dvec3 Position{ 0.0 };
    glm::dvec3 Normal{ 0.0, 0.0, 1.0 }; // by which VTK shades, unit; may face away from the ray
    glm::dvec3 FacetNormal{ 0.0, 0.0, 1.0 }; // unit, towards the ray's start
    glm::dvec3 Albedo{ 0.0 };                // of light that VTK does not divide by pi
    bool PhysicallyBased = false;            // VTK divides by pi what its own lights give
    bool Sends = false;                      // lit, with a normal, and not told to send nothing
    uint32_t Triangle = vtkIndirectTriangleTree::None;
    double Distance = 0.0;
  };

  vtkIndirectRaySurfaces();
  ~vtkIndirectRaySurfaces();

  /** Brings the surfaces up to date. Returns whether anything of them has changed. */
  bool Update(const vtkIndirectFrame& frame);
  /** How often the tree has been made. */
  size_t GetNumberOfBuilds() const { return this->NumberOfBuilds; }

  /**
   * The first surface that a ray of this unit direction meets, but for the triangle of that number.
   * May be asked from several threads. False where there is none.
   */
  bool Meet(
    const glm::dvec3& start, const glm::dvec3& direction, uint32_t except, Meeting& meeting) const;

  size_t GetNumberOfTriangles() const { return this->Triangles.size(); }
  /** Props that rays do not meet, and why. */
  const std::vector<std::pair<std::string, std::string>>& GetLeftOut() const
  {
    return this->LeftOut;
  }
  size_t GetBytes() const;
  void Clear();

private:
  struct Piece;
  struct Triangle
  {
    uint32_t Piece;
    uint32_t Cell;
    uint32_t Points[3];
  };

  void Read(const vtkIndirectFrame& frame, std::vector<double>& shape);
  void MakeTree();
  void Shade(const Triangle& triangle, const vtkIndirectTriangleTree::Hit& hit, bool front,
    Meeting& meeting) const;

  std::vector<std::unique_ptr<Piece>> Pieces;
  std::vector<Triangle> Triangles; // by their numbers in the tree
  vtkIndirectTriangleTree Tree;
  std::vector<double> Key;   // what all was read from
  std::vector<double> Shape; // what the tree was made from
  std::vector<std::pair<std::string, std::string>> LeftOut;
  size_t NumberOfBuilds = 0;
};

#endif
