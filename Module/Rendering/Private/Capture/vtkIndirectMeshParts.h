// SPDX-License-Identifier: BSD-3-Clause
// A mesh in parts, each of which has coarse levels: depth maps draw the parts that they see, and of
// each part the level that deviates from the mesh by less than a share of a texel. Parts share the
// points at their borders in all levels, so that parts of different levels leave no gap.
#pragma once

#include "Scene/vtkIndirectPropKind.h" // for the number of triangles
#include "vtkSmartPointer.h"           // for members

#include <array>   // for bounds
#include <cstddef> // for size_t
#include <glm/glm.hpp>
#include <memory> // for the result
#include <vector> // for members

class vtkOpenGLBufferObject;
class vtkPolyData;

struct vtkIndirectMeshParts
{
  /** Meshes of fewer triangles are drawn as fast as their parts. */
  static constexpr size_t FewestTriangles = vtkIndirectPropKind::DenseTriangles;

  using Triangle = std::array<unsigned int, 3>; // numbers of points

  struct Level
  {
    size_t First = 0; // of the indices
    size_t Count = 0;
    double Error = 0.0; // distance from the mesh, in its units
    size_t FirstPiece = 0;
    size_t NumberOfPieces = 0; // 0: views that see the part draw the whole level
  };
  /** This is a compact share of a level's triangles; views draw those pieces that they see. */
  struct Piece
  {
    size_t First = 0; // of the indices
    size_t Count = 0;
    std::array<double, 6> Bounds{}; // with the insets, in the mesh's coordinates
    size_t FirstPoint = 0;          // of PiecePoints
    size_t NumberOfPoints = 0;
  };
  struct Part
  {
    std::array<double, 6> Bounds{}; // in the mesh's coordinates
    std::vector<Level> Levels;      // coarsest first

    /** Returns the number of the coarsest level within an error, or -1: only the mesh itself is. */
    int FindLevel(double mostError) const;
  };

  /** These are the positions relative to Middle, each followed by its inset: the way by which the
   * point is drawn farther from the emitter, or its opposite. */
  std::vector<float> Points;
  static constexpr size_t FloatsOfPoint = 6;
  std::vector<unsigned int> Indices;
  glm::dvec3 Middle{ 0.0 };
  size_t NumberOfLevels = 0;
  bool HasInsets = false; // false: levels are drawn farther by their errors
  std::vector<Part> Parts;
  std::vector<Piece> Pieces; // of a level one after the other
  /** These are the points of each piece one after the other, and the indices by their numbers
   * within a piece, for the processor, which keeps few points at hand. GatherPieces makes them. */
  std::vector<float> PiecePoints;
  std::vector<unsigned int> PieceIndices;
  vtkSmartPointer<vtkOpenGLBufferObject> PointBuffer;
  vtkSmartPointer<vtkOpenGLBufferObject> IndexBuffer;

  /**
   * Makes the parts of a mesh and of the triangles that its mapper draws; the last level is the
   * mesh itself. Points of a level are the means of the points in a grid's cells (Rossignac and
   * Borrel 1993, "Multi-resolution 3D approximations for rendering complex scenes"), where edges
   * connect them. A point's inset is its greatest distance from the planes of the triangles around
   * the points that it replaces (Ronfard and Rossignac 1996, "Full-range approximation of
   * triangulated polyhedra"). A part's error is twice the root of the mean square of these
   * distances. Points of edges that do not have two triangles of the same orientation stay, and so
   * do points of several parts. Null for meshes of fewer than FewestTriangles, for those with
   * points too far apart, and for those of which no level has clearly fewer triangles.
   */
  static std::unique_ptr<vtkIndirectMeshParts> Make(
    vtkPolyData* mesh, std::vector<Triangle> triangles);

  /** Sorts a level's triangles into pieces. */
  void Divide(Level& level);
  /** Makes the points of pieces, if they are not there; all levels have pieces. */
  void GatherPieces();
  /** Adds a point without an inset. Returns its number. */
  unsigned int AddPoint(const glm::dvec3& p);
  size_t CountPoints() const { return this->Points.size() / FloatsOfPoint; }
  size_t GetBytes() const
  {
    return (this->Points.size() + this->PiecePoints.size()) * sizeof(float) +
      (this->Indices.size() + this->PieceIndices.size()) * sizeof(unsigned int) +
      this->Pieces.size() * sizeof(Piece);
  }
};
