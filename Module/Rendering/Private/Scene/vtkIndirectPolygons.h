// SPDX-License-Identifier: BSD-3-Clause
// The polygons that one mapper draws of one vtkPolyData, as triangles that the processor can read:
// their places in scene units, and how VTK shades them. The glyphs of one vtkGlyph3DMapper that
// share a data set and a source are one such piece too. Blocks that a composite mapper does not
// draw, or draws translucent, are not read.
#pragma once

#include "Scene/vtkIndirectMaterial.h" // for a member

#include "vtkDataArray.h"    // for members
#include "vtkDataSet.h"      // for a member
#include "vtkSmartPointer.h" // for members
#include "vtkType.h"         // for ids

#include <cstdint>     // for indices
#include <functional>  // for the function that takes pieces
#include <glm/glm.hpp> // for vectors
#include <vector>      // for places

class vtkIndirectKey;
class vtkActor;
class vtkMapper;
class vtkPolyData;
class vtkProp;
struct vtkIndirectFrame;

class vtkIndirectPolygons
{
public:
  struct Triangle
  {
    uint32_t Cell; // the number of the data's cell
    uint32_t Points[3];
  };

  std::vector<glm::dvec3> Positions; // by point, scene units; points of glyphs glyph by glyph
  /**
   * Polygons as fans, strips as VTK winds them. A triangle that clipping planes leave out is not
   * in the list; a triangle that a plane cuts is in it as a whole.
   */
  std::vector<Triangle> Triangles;
  vtkIndirectMaterial Material; // in the numbers of the data's points and cells
  bool IsOfGlyphs = false;
  bool Sends = true; // the reader of a scene clears it for props that are told to send no light

  using Taker = std::function<void(vtkIndirectPolygons& piece)>;
  /**
   * Hands on all pieces of a prop except glyphs; the function may move the pieces. Returns true if
   * the prop draws nothing but these polygons: false with glyphs, impostors, lines, points, levels
   * of detail, or shaders of the user's own.
   */
  static bool Read(const vtkIndirectFrame& frame, vtkProp* prop, const Taker& take);
  /**
   * Hands on the glyphs of an actor's mapper, a piece for each data set and source. Returns false
   * if the glyphs have more than `mostTriangles` triangles. The triangles of each piece that is
   * handed on are subtracted from that number.
   */
  static bool ReadGlyphs(const vtkIndirectFrame& frame, vtkActor* actor, const glm::dmat4& toWorld,
    size_t& mostTriangles, const Taker& take);

  /** Returns true if VTK culls the faces that are seen from this side. */
  bool Culls(bool front) const { return front ? this->CullsFront : this->CullsBack; }
  /** Returns the albedo at a place on a triangle. */
  glm::dvec3 FindAlbedo(const vtkIndirectMaterial::Place& place) const;
  /** Returns the mean albedo over the front of a triangle. */
  glm::dvec3 FindMeanAlbedo(const Triangle& triangle) const;
  /**
   * Finds the unit normal by which VTK shades the place, turned as VTK turns it; the facet's normal
   * where the data have no normals. Returns false where the data's normal has no direction.
   */
  bool FindNormal(
    const vtkIndirectMaterial::Place& place, const glm::dvec3& facet, glm::dvec3& normal) const;
  /** Appends all that the shape depends on to a key. */
  void AppendShape(vtkIndirectKey& key) const;
  size_t GetBytes() const;

private:
  struct Glyph
  {
    vtkIdType Point; // the point of the data set whose colour the glyph has
    glm::dmat3 NormalsToWorld;
  };

  void Begin(vtkActor* actor, vtkMapper* mapper, vtkPolyData* data, const glm::dmat4& toWorld);
  void Fill(const vtkIndirectFrame& frame, const glm::dmat4& place);
  const Glyph& GetGlyph(vtkIdType point) const
  {
    return this->Glyphs[static_cast<size_t>(point / this->PointsOfGlyph)];
  }

  // These three are only used while the piece is read.
  vtkMapper* Mapper = nullptr;
  vtkPolyData* Data = nullptr;
  glm::dmat4 ToWorld{ 1.0 };

  vtkSmartPointer<vtkDataArray> PointNormals;
  vtkSmartPointer<vtkDataArray> CellNormals;
  glm::dmat3 NormalsToWorld{ 1.0 }; // without glyphs
  bool CullsFront = false;
  bool CullsBack = false;
  std::vector<Glyph> Glyphs;
  vtkIdType PointsOfGlyph = 0;
  vtkSmartPointer<vtkDataSet> GlyphPlaces; // the data set at whose points glyphs stand
};
