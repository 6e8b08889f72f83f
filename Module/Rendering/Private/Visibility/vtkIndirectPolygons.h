// SPDX-License-Identifier: BSD-3-Clause
// The polygons that a prop's mappers draw, as triangles that the processor can read: places in
// scene units, and of which material VTK draws them. A piece is what one mapper draws of one
// vtkPolyData; blocks that a composite mapper does not draw, or draws translucent, are not there.
#ifndef vtkIndirectPolygons_h
#define vtkIndirectPolygons_h

#include "Frame/vtkIndirectMaterial.h" // for a member
#include "vtkType.h"                   // for ids

#include <functional>  // for who takes pieces
#include <glm/glm.hpp> // for vectors
#include <vector>      // for places

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
    vtkIdType Cell; // of the data
    vtkIdType Points[3];
  };

  vtkActor* Actor = nullptr;
  vtkMapper* Mapper = nullptr;
  vtkPolyData* Data = nullptr;
  glm::dmat4 ToWorld{ 1.0 };
  std::vector<glm::dvec3> Positions; // by point, scene units
  /** Polygons as fans, strips as VTK winds them; those that clipping planes leave out are not here,
   * one that a plane cuts is here as a whole. */
  std::vector<Triangle> Triangles;
  vtkIndirectMaterial Material; // in the numbers of the data's points and cells

  using Taker = std::function<void(vtkIndirectPolygons& piece)>;
  /**
   * Hands on all pieces of a prop, which may be taken. Returns whether the prop draws nothing but
   * these polygons: not so with glyphs, impostors, lines, points, levels of detail, or shaders of
   * the user's own.
   */
  static bool Read(const vtkIndirectFrame& frame, vtkProp* prop, const Taker& take);
  /**
   * Fills places and triangles with the data at each of these places of ToWorld, one after the
   * other. Returns false, with nothing, where there would be more than so many triangles.
   */
  bool Repeat(
    const vtkIndirectFrame& frame, const std::vector<glm::dmat4>& places, size_t mostTriangles);

private:
  void Fill(const vtkIndirectFrame& frame, const glm::dmat4& place);
};

#endif
