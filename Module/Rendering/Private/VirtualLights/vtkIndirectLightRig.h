// SPDX-License-Identifier: BSD-3-Clause
// The lights of a preset, in the axes of the camera: x to the right, y up, z to the viewer. No VTK
// objects in it.
//
// Light that has no place and no hard shadow is radiance of a sky: the same from everywhere, and
// lobes of a power of the cosine, each given by what it sends to a surface that faces it, so that a
// lobe stands for a light of that strength whatever its width.
#ifndef vtkIndirectLightRig_h
#define vtkIndirectLightRig_h

#include <glm/glm.hpp> // for directions and colours
#include <vector>      // for lists

/** A light from infinitely far away. */
struct vtkIndirectLamp
{
  glm::dvec3 Direction{ 0.0, 0.0, 1.0 }; // to the light, unit
  glm::dvec3 Color{ 0.0 };               // VTK irradiance of a surface that faces it
};

struct vtkIndirectLightRig
{
  struct Lobe
  {
    vtkIndirectLamp Lamp;
    double Exponent = 1.0; // of the cosine; 0: the same from a whole hemisphere
  };

  glm::dvec3 Ambient{ 0.0 }; // radiance from everywhere
  std::vector<Lobe> Lobes;
  vtkIndirectLamp Key;         // sharp, with shadows; black: none
  glm::dvec3 Headlight{ 0.0 }; // sharp; of its shadows the viewer sees none

  /** Of the sky: without the key and the headlight. */
  glm::dvec3 GetRadiance(const glm::dvec3& direction) const;

  /**
   * The rig of a preset (vtkIndirectLightingType). kit: the renderer's own lights that follow its
   * camera. Where they are a kit (see IsKit) their directions and ratios count, and in any case how
   * strong they are.
   */
  static vtkIndirectLightRig Make(int preset, const std::vector<vtkIndirectLamp>& kit);
  /** Whether the renderer's lights are a kit: a headlight alone says nothing of directions. */
  static bool IsKit(const std::vector<vtkIndirectLamp>& lamps) { return lamps.size() > 1; }
  /** Angles in degrees, as vtkLight::SetDirectionAngle has them. */
  static glm::dvec3 FromAngles(double elevation, double azimuth);
};

#endif
