// SPDX-License-Identifier: BSD-3-Clause
// The lights of a preset, in the axes of the camera: x to the right, y up, z to the viewer. No VTK
// objects in it.
//
// Light that has no place and no hard shadow is radiance of a sky: the same from everywhere, and
// lobes of a power of the cosine, each given by what it sends to a surface that faces it, so that a
// lobe stands for a light of that strength whatever its width.
//
// A picture is as bright as plain VTK's on whatever it shows only where both kinds of light agree
// for every direction that surfaces can have. So a preset keeps a share of the renderer's own
// lights, as VTK draws them, which nothing hides; and the light that takes the place of the rest
// comes from where it came from, and gives a ball as much as it gave.
//
// Surfaces reflect the light that takes the place, and nothing of what is kept. Of albedo a, a
// concave part whose surfaces see each other in a share F of their hemispheres has G = 1 / (1 - a
// F) of what falls on it, all bounces taken together. What is nearly white has no room for that. So
// where s stands for a share r, 1 - r + s G may not be more than white leaves to what plain VTK
// draws: 1 / (a P), with P the most that the renderer's lights give any surface.
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

/** Of the surfaces that a rig lights, as far as their colours are known; zero: not at all. */
struct vtkIndirectRigAlbedo
{
  double Brightest = 0.0; // of all channels, which may become white
  double Mean = 0.0;      // of red, green and blue, of the lightest: what bounces
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
  vtkIndirectLamp Key;                // sharp; black: none
  double KeyShadow = 1.0;             // the share of the key that shadows take away
  std::vector<vtkIndirectLamp> Fills; // sharp, without shadows

  /** Of the sky: ambient light and lobes. */
  glm::dvec3 GetRadiance(const glm::dvec3& direction) const;
  /**
   * The mean irradiance, of red, green and blue, of a ball that a camera far away sees and that
   * nothing hides any light from.
   */
  double GetIrradianceOfBall() const;
  /** The same of a lamp: (2 / 3 pi) (sin a + (pi - a) cos a), at an angle a from the camera. */
  static double GetIrradianceOfBall(const vtkIndirectLamp& lamp);

  /**
   * The rig of a preset (vtkIndirectLightingType). lamps: the renderer's own lights that follow its
   * camera; none stands for a headlight of strength 1, as VTK makes it.
   */
  static vtkIndirectLightRig Make(int preset, std::vector<vtkIndirectLamp> lamps,
    const vtkIndirectRigAlbedo& albedo = vtkIndirectRigAlbedo());
  /** The most that lamps give a surface, whatever it faces. */
  static double FindMostIrradiance(const std::vector<vtkIndirectLamp>& lamps);
  /** Angles in degrees, as vtkLight::SetDirectionAngle has them. */
  static glm::dvec3 FromAngles(double elevation, double azimuth);
};

#endif
