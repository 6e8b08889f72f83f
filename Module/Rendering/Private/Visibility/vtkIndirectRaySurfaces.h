// SPDX-License-Identifier: BSD-3-Clause
// The scene's surfaces for rays on the processor: which one a ray meets first, and how VTK would
// light it for a camera where the ray comes from.
//
// Triangles are those of vtkIndirectRayPiece, glyphs included. The normal is the interpolated one,
// or the cell's or the facet's where VTK takes these, turned as VTK turns it: by the winding,
// towards the ray's start. What a mapper culls is not there. Spheres are given by who finds them:
// their outside, as impostors are drawn. Colours are those of vtkIndirectMaterial.
#ifndef vtkIndirectRaySurfaces_h
#define vtkIndirectRaySurfaces_h

#include "Visibility/vtkIndirectBlockingSpheres.h" // for members
#include "Visibility/vtkIndirectTriangleTree.h"    // for members

#include <cstdint>     // for numbers
#include <glm/glm.hpp> // for vectors
#include <memory>      // for pieces
#include <string>      // for reasons
#include <utility>     // for pairs
#include <vector>      // for triangles

class vtkIndirectRayPiece;
struct vtkIndirectCaster;
struct vtkIndirectFrame;

class vtkIndirectRaySurfaces
{
public:
  /** Of all glyphs together; beyond them rays pass through what is left. */
  static constexpr size_t MostTrianglesOfGlyphs = size_t(1) << 21;

  /** A place on a surface, in scene units. */
  struct Meeting
  {
    glm::dvec3 Position{ 0.0 };
    glm::dvec3 Normal{ 0.0, 0.0, 1.0 }; // by which VTK shades, unit; may face away from the ray
    glm::dvec3 FacetNormal{ 0.0, 0.0, 1.0 }; // unit, towards the ray's start
    glm::dvec3 Albedo{ 0.0 };                // of light that VTK does not divide by pi
    bool PhysicallyBased = false;            // VTK divides by pi what its own lights give
    bool Sends = false;                      // lit, with a normal, and not told to send nothing
    uint32_t Triangle = vtkIndirectTriangleTree::None; // or sphere
    double Distance = 0.0;
  };

  vtkIndirectRaySurfaces();
  ~vtkIndirectRaySurfaces();

  /**
   * Brings the surfaces up to date. Returns whether anything of them has changed. spheres: what the
   * frame's mappers draw as such; null where nobody has looked for them.
   */
  bool Update(const vtkIndirectFrame& frame, const vtkIndirectBlockingSpheres* spheres = nullptr);
  /** How often the tree has been made. */
  size_t GetNumberOfBuilds() const { return this->NumberOfBuilds; }

  /**
   * The first surface that a ray of this unit direction meets, but for the triangle of that number.
   * May be asked from several threads. False where there is none.
   */
  bool Meet(
    const glm::dvec3& start, const glm::dvec3& direction, uint32_t except, Meeting& meeting) const;

  size_t GetNumberOfTriangles() const { return this->Triangles.size(); }
  size_t GetNumberOfSpheres() const { return this->Spheres.size(); }
  /** What rays do not meet, or not as VTK draws it, and why. */
  const std::vector<std::pair<std::string, std::string>>& GetLeftOut() const
  {
    return this->LeftOut;
  }
  size_t GetBytes() const;
  void Clear();

private:
  struct Triangle
  {
    uint32_t Piece;
    uint32_t Cell;
    uint32_t Points[3];
  };
  struct Sphere
  {
    glm::dvec3 Center;
    double Radius;
    vtkIndirectBlockingSpheres::Look Look;
  };

  void Read(const vtkIndirectFrame& frame, const vtkIndirectBlockingSpheres* spheres,
    std::vector<double>& shape);
  void ReadGlyphs(const vtkIndirectFrame& frame, const vtkIndirectCaster& caster,
    const vtkIndirectBlockingSpheres* spheres, size_t& mostTriangles);
  void ReadSpheres(const vtkIndirectBlockingSpheres* spheres);
  void MakeTree();
  void LeaveOut(const std::string& what, const std::string& why);

  std::vector<std::unique_ptr<vtkIndirectRayPiece>> Pieces;
  std::vector<Triangle> Triangles; // by their numbers in the tree
  std::vector<Sphere> Spheres;     // whose numbers follow
  vtkIndirectTriangleTree Tree;
  std::vector<double> Key;   // what all was read from
  std::vector<double> Shape; // what the tree was made from
  std::vector<std::pair<std::string, std::string>> LeftOut;
  size_t NumberOfBuilds = 0;
};

#endif
