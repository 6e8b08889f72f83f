// SPDX-License-Identifier: BSD-3-Clause
// How VTK draws the opaque geometry of a prop, as far as indirect light is concerned.
#ifndef vtkIndirectPropKind_h
#define vtkIndirectPropKind_h

class vtkActor;
class vtkProp;

struct vtkIndirectPropKind
{
  /**
   * Whether all that it draws comes from mappers for polygons which see the prop's own property
   * keys, so that the capture's outputs are written. What else VTK draws (annotation, 3D widgets,
   * the skybox) writes its colour alone.
   */
  bool Captured = false;
  /**
   * Why it neither casts shadows nor sends light; null for surfaces, which do both. The property
   * key CASTS_SHADOWS of vtkIndirectIlluminationPass counts before it, except where there is no
   * surface at all.
   */
  const char* NoCaster = nullptr;
  /** Whether what it draws are surfaces, of whatever extent in world units. */
  bool Surface = false;
  /** Whether VTK lights any of it, so that it may receive indirect light. */
  bool Lit = false;
  /** Whether a lit part reflects specularly, by Phong's model. */
  bool Specular = false;
  /** Whether VTK's PBR lights a part of it, which reflects specularly in any case. */
  bool PhysicallyBased = false;
  /** Whether it is drawn with alpha one wherever it draws, so that nothing shines through. */
  bool CoversFully = false;
  /** About how many triangles it draws; 1e9 where its mapper alone knows. */
  double NumberOfTriangles = 0.0;
  /** As many triangles take as long in a depth map; where its mapper alone knows, a guess. */
  double DepthTriangles = 0.0;

  static vtkIndirectPropKind Find(vtkProp* prop);

  /**
   * The actor that a prop is if it refracts light, else null: with VTK's PBR, a BaseIOR above one,
   * an opacity below one, and polygons that the processor can read.
   */
  static vtkActor* FindRefractor(vtkProp* prop);
};

#endif
