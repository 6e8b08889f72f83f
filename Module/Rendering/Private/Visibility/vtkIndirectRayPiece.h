// SPDX-License-Identifier: BSD-3-Clause
// What rays meet of one mapper and one vtkPolyData: its triangles, or those of all its glyphs, and
// how VTK shades them.
#ifndef vtkIndirectRayPiece_h
#define vtkIndirectRayPiece_h

#include "Visibility/vtkIndirectPolygons.h" // for a member

#include "vtkDataArray.h"    // for members
#include "vtkSmartPointer.h" // for members

#include <functional>  // for who takes pieces
#include <glm/glm.hpp> // for vectors
#include <memory>      // for pieces
#include <vector>      // for lists

class vtkActor;
class vtkGlyph3DMapper;
struct vtkIndirectFrame;

class vtkIndirectRayPiece
{
public:
  using Triangle = vtkIndirectPolygons::Triangle;
  using Taker = std::function<void(std::unique_ptr<vtkIndirectRayPiece>)>;

  explicit vtkIndirectRayPiece(vtkIndirectPolygons&& polygons);
  /**
   * Hands on the glyphs of a mapper, a piece each data set and source. Returns false where they
   * have more than so many triangles, of which what has been handed on is taken off.
   */
  static bool ReadGlyphs(const vtkIndirectFrame& frame, vtkActor* actor, const glm::dmat4& toWorld,
    size_t& mostTriangles, const Taker& take);

  const vtkIndirectPolygons& GetPolygons() const { return this->Polygons; }
  /** The list is given up when a tree has been made of it. */
  void ForgetTriangles() { this->Polygons.Triangles = {}; }
  bool Culls(bool front) const { return front ? this->CullsFront : this->CullsBack; }
  /** Of a place on a triangle. */
  glm::dvec3 FindAlbedo(const vtkIndirectMaterial::Place& place) const;
  /**
   * By which VTK shades there, unit, turned as VTK turns it; the facet's where data have none.
   * Returns false where theirs is none.
   */
  bool FindNormal(
    const vtkIndirectMaterial::Place& place, const glm::dvec3& facet, glm::dvec3& normal) const;
  /** All that shapes depend on. */
  void AppendShape(std::vector<double>& key) const;
  size_t GetBytes() const;

  bool Sends = true;

private:
  vtkIndirectPolygons Polygons;
  vtkSmartPointer<vtkDataArray> PointNormals;
  vtkSmartPointer<vtkDataArray> CellNormals;
  bool CullsFront = false;
  bool CullsBack = false;
  // Of glyphs: points follow each other glyph by glyph.
  struct Glyph
  {
    vtkIdType Point; // of whose colour it is
    glm::dmat3 NormalsToWorld;
  };
  std::vector<Glyph> Glyphs;
  glm::dmat3 NormalsToWorld{ 1.0 }; // without glyphs
  vtkIdType PointsOfGlyph = 0;
  vtkSmartPointer<vtkDataSet> Places; // that they stand at
};
#endif
