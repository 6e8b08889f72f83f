// SPDX-License-Identifier: BSD-3-Clause
// Tells how VTK draws the opaque geometry of a prop, as far as indirect light is concerned.
#pragma once

#include <cstddef> // for size_t
#include <string>  // for descriptions

class vtkActor;
class vtkProp;

struct vtkIndirectPropKind
{
  /**
   * It is true if all parts are drawn by mappers for polygons that see the prop's own property
   * keys, so that the capture's outputs are written. All other props of VTK (annotation, 3D
   * widgets, the skybox) write their colour alone.
   */
  bool Captured = false;
  /**
   * The reason why the prop neither casts shadows nor sends light; null for surfaces, which do
   * both. The property key CASTS_SHADOWS of vtkIndirectIlluminationPass has priority, except for
   * props without any surface.
   */
  const char* NoCaster = nullptr;
  /** It is true if it draws surfaces, of any extent in world units. */
  bool Surface = false;
  /** It is true if VTK lights any part of it, so that it may receive indirect light. */
  bool Lit = false;
  /** It is true if a lit part reflects specularly, by Phong's model. */
  bool Specular = false;
  /** It is true if VTK's PBR lights a part of it, which reflects specularly in any case. */
  bool PhysicallyBased = false;
  /** It is true if a part of it has a backface property. */
  bool HasBackface = false;
  /** It is true if it is drawn with alpha one everywhere, so that nothing shines through. */
  bool CoversFully = false;
  /** Approximate number of its triangles; 1e9 if its mapper alone knows. */
  double NumberOfTriangles = 0.0;
  /** Depth maps draw meshes of as many triangles by coarse levels, see vtkIndirectMeshParts. */
  static constexpr size_t DenseTriangles = 4000;
  /**
   * This is the number of triangles that take as long in a depth map; a guess if its mapper alone
   * knows.
   */
  double DepthTriangles = 0.0;

  static vtkIndirectPropKind Find(vtkProp* prop);

  /**
   * Returns true if a prop is drawn on the picture and has nothing in space. Captions do not count:
   * they have a line in space.
   */
  static bool IsFlat(vtkProp* prop);

  /** Returns true if the property key CATCHES_LIGHT asks the prop to show what lies behind it. */
  static bool CatchesLight(vtkProp* prop);

  /**
   * Returns what distinguishes a prop from others of its class: its name in quotes, if it has one,
   * and the classes of its mapper and of its data's source. Empty if it has none of these.
   */
  static std::string Describe(vtkProp* prop);
  /** Returns its class, with that description in parentheses. */
  static std::string GetFullName(vtkProp* prop);

  /**
   * Returns the prop as an actor if it refracts light, else null. It refracts light with VTK's PBR,
   * a BaseIOR above one, an opacity below one, and polygons that the processor can read.
   */
  static vtkActor* FindRefractor(vtkProp* prop);
};
