// SPDX-License-Identifier: BSD-3-Clause
// The polygons that a prop's mappers draw, as triangles that the processor can read: places in
// scene units, and of which colour VTK draws them. A piece is what one mapper draws of one
// vtkPolyData.
#ifndef vtkIndirectPolygons_h
#define vtkIndirectPolygons_h

#include "vtkSmartPointer.h"      // for members
#include "vtkType.h"              // for ids
#include "vtkUnsignedCharArray.h" // for members

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
  bool PhysicallyBased = false; // lit by VTK's PBR, which divides by pi

  ///@{
  /** Reflected by diffusion, of the light that VTK does not divide by pi; by a triangle's corner.
   */
  glm::dvec3 GetAlbedo(vtkIdType cell, vtkIdType point) const;
  bool HasColorsOfPoints() const { return this->Colors && !this->ColorsAreOfCells; }
  bool HasColorsOfCells() const { return this->Colors && this->ColorsAreOfCells; }
  ///@}

  using Taker = std::function<void(vtkIndirectPolygons& piece)>;
  /**
   * Hands on all pieces of a prop, which may be taken. Returns whether the prop draws nothing but
   * these polygons: not so with glyphs, impostors, lines, points, levels of detail, or shaders of
   * the user's own.
   */
  static bool Read(const vtkIndirectFrame& frame, vtkProp* prop, const Taker& take);

private:
  void Fill(const vtkIndirectFrame& frame);
  void FillColors();

  glm::dvec3 Color{ 0.0 }; // without scalars
  double Diffuse = 1.0;    // of scalars' colours
  bool Encoded = false;    // these are, times the coefficient, with gamma 2.2
  vtkSmartPointer<vtkUnsignedCharArray> Colors;
  bool ColorsAreOfCells = false;
};

#endif
