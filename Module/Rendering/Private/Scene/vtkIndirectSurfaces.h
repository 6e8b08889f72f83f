// SPDX-License-Identifier: BSD-3-Clause
// The scene's surfaces on the processor: one list of triangles, glyphs and spheres, read once after
// a change of the scene, and one tree over it. The tree answers which surface a ray meets first,
// and whether a segment is blocked.
//
// A meeting says how VTK would light the surface for a camera where the ray starts. The normal is
// the interpolated one, or the cell's or the facet's where VTK takes these, turned as VTK turns it:
// by the winding, towards the ray's start. Rays pass through faces that a mapper culls. Spheres are
// given by vtkIndirectSphereBlockers; rays meet their outside, which impostors draw. Colours are
// those of vtkIndirectMaterial.
#pragma once

#include "OpenGL/vtkIndirectKey.h"            // for keys
#include "Scene/vtkIndirectBlockingSpheres.h" // for members
#include "Scene/vtkIndirectPolygons.h"        // for members
#include "Scene/vtkIndirectTriangleTree.h"    // for members
#include "vtkTimeStamp.h"                     // for a member

#include <cstdint>               // for numbers
#include <functional>            // for the function that takes pieces
#include <glm/glm.hpp>           // for vectors
#include <glm/gtc/constants.hpp> // for pi
#include <string>                // for reasons
#include <utility>               // for pairs
#include <vector>                // for pieces

struct vtkIndirectCaster;
struct vtkIndirectFrame;

class vtkIndirectSurfaces
{
public:
  /**
   * These are the triangles of all glyphs together, at most; rays pass through the glyphs beyond
   * them.
   */
  static constexpr size_t MostTrianglesOfGlyphs = size_t(1) << 21;

  /** This is a place on a surface, in scene units. */
  struct Meeting
  {
    glm::dvec3 Position{ 0.0 };
    glm::dvec3 Normal{ 0.0, 0.0, 1.0 }; // shading normal of VTK, unit; may face away from the ray
    glm::dvec3 FacetNormal{ 0.0, 0.0, 1.0 }; // unit, towards the ray's start
    glm::dvec3 Albedo{ 0.0 };                // for light that VTK does not divide by pi
    bool PhysicallyBased = false;            // VTK divides the light of its own lights by pi
    bool Sends = false;                      // lit, with a normal, and not told to send nothing
    uint32_t Triangle = vtkIndirectTriangleTree::None; // or sphere
    double Distance = 0.0;

    /** Returns the share of vtkLights' light that VTK does not divide away. */
    double GetShareOfVTKLights() const
    {
      return this->PhysicallyBased ? glm::one_over_pi<double>() : 1.0;
    }
  };

  /**
   * Brings list and tree up to date with the frame's casters. spheres: the spheres that the frame's
   * mappers draw; null if spheres were not searched for.
   */
  void Update(const vtkIndirectFrame& frame, const vtkIndirectBlockingSpheres* spheres = nullptr);
  /** Makes the next Update read everything anew. */
  void Forget() { this->IsThere = false; }
  void Clear();
  /** Grows when anything has changed, over all objects of this class. */
  vtkMTimeType GetTime() const { return this->Time.GetMTime(); }
  /** Returns how often the tree has been made. */
  size_t GetNumberOfBuilds() const { return this->NumberOfBuilds; }

  /**
   * Hands on the polygons of the frame's casters, with the caster's number. They come from the
   * list, glyphs included, if the list is of this frame; otherwise they are read without glyphs,
   * and not kept. Returns for each caster whether it draws polygons alone.
   */
  std::vector<bool> ReadPolygons(const vtkIndirectFrame& frame,
    const std::function<void(size_t caster, const vtkIndirectPolygons& piece)>& take) const;

  /**
   * Finds the first surface that a ray of this unit direction meets, except the triangle of number
   * `except`. culled: faces that a mapper culls are met, too. Several threads may call it at once.
   * Returns false if the ray meets no surface.
   */
  bool Meet(const glm::dvec3& start, const glm::dvec3& direction, uint32_t except, Meeting& meeting,
    bool culled = false) const;
  const vtkIndirectTriangleTree& GetTree() const { return this->Tree; }

  /**
   * Returns the things that rays do not meet, or meet in another shape than VTK draws, and the
   * reasons.
   */
  const std::vector<std::pair<std::string, std::string>>& GetLeftOut() const
  {
    return this->LeftOut;
  }
  size_t GetBytes() const;

private:
  struct Piece
  {
    vtkIndirectPolygons Polygons;
    size_t Caster;
    uint32_t FirstTriangle; // its number in the tree
  };

  static vtkIndirectKey MakeKey(const vtkIndirectFrame& frame);
  void Read(const vtkIndirectFrame& frame, const vtkIndirectBlockingSpheres* spheres,
    vtkIndirectKey& shape);
  void ReadGlyphs(const vtkIndirectFrame& frame, size_t number,
    const vtkIndirectBlockingSpheres* spheres, size_t& mostTriangles);
  void Take(const vtkIndirectCaster& caster, size_t number, vtkIndirectPolygons& polygons);
  void MakeTree();
  void LeaveOut(const std::string& what, const std::string& why);

  std::vector<Piece> Pieces;
  std::vector<bool> DrawPolygonsAlone; // by caster
  uint32_t NumberOfTriangles = 0;      // with those without area; the numbers of spheres follow
  std::vector<vtkIndirectBlockingSpheres::Look> Looks; // by sphere
  std::vector<glm::dvec4> Spheres;
  vtkIndirectTriangleTree Tree;
  vtkIndirectKey Key;        // the casters of the list
  vtkIndirectKey SpheresKey; // the state of its spheres
  vtkIndirectKey Shape;      // the shapes in the tree
  bool IsThere = false;
  vtkTimeStamp Time;
  std::vector<std::pair<std::string, std::string>> LeftOut;
  size_t NumberOfBuilds = 0;
};
