// SPDX-License-Identifier: BSD-3-Clause
// The lights of a preset, in the axes of the camera: x to the right, y up, z to the viewer. They
// hold no VTK objects.
//
// Light without a place and without hard shadows is radiance of a sky: uniform radiance from
// everywhere, and lobes of a power of the cosine. A lobe is given by the irradiance of a surface
// that faces it, so that it replaces a light of that strength whatever the lobe's width.
//
// A picture is as bright as plain VTK's for every scene only if both kinds of light agree for every
// direction of surfaces. So a preset keeps a share of the renderer's own lights, as VTK draws them,
// which nothing hides. The light that replaces the rest comes from the same directions, and gives a
// ball the same irradiance.
//
// Surfaces reflect the replacing light, and nothing of the kept light. A concave part receives G
// times the light that falls on it, all bounces taken together (FindGain). Nearly white surfaces
// have no room for that. So where strength s replaces a share r, (1 - r) P + s G Q must not exceed
// 1 / a in any channel for a surface of any direction, where a is the albedo, P the irradiance by
// the renderer's lights and Q that by the lights that replace them.
#pragma once

#include <glm/glm.hpp> // for directions and colours
#include <vector>      // for lists

/** A light from infinitely far away. */
struct vtkIndirectDistantLight
{
  glm::dvec3 Direction{ 0.0, 0.0, 1.0 }; // to the light, unit
  glm::dvec3 Color{ 0.0 };               // VTK irradiance of a surface that faces it
};

/**
 * This is the albedo of the surfaces that the lights shine on.
 */
struct vtkIndirectPresetAlbedo
{
  double Brightest = 0.0; // greatest of all channels of actors of one colour; 0: there is none
  // Data or textures give colours. A place may be as bright as white in a channel; bounces among
  // them are taken as small.
  bool OfData = false;
};

struct vtkIndirectPresetLights
{
  struct Lobe
  {
    vtkIndirectDistantLight Lamp;
    double Exponent = 1.0; // exponent of the cosine; 0: uniform radiance from a hemisphere
  };

  glm::dvec3 Ambient{ 0.0 }; // radiance from everywhere
  std::vector<Lobe> Lobes;
  vtkIndirectDistantLight Key;                // sharp; black: none
  double KeyShadow = 1.0;                     // share of the key that shadows remove
  std::vector<vtkIndirectDistantLight> Fills; // sharp, without shadows
  /**
   * This is the greatest share of the fills that the sky may replace, as the frame measures
   * (vtkIndirectLightBalance); 0: nothing is left to measure, because the sky replaces nothing
   * more.
   */
  double MostReplaced = 0.0;

  /** Returns the radiance of the sky: ambient light and lobes. */
  glm::dvec3 GetRadiance(const glm::dvec3& direction) const;
  /**
   * Returns the mean irradiance, of red, green and blue, of an unoccluded ball as a camera far away
   * sees it.
   */
  double GetIrradianceOfBall() const;
  /**
   * Returns the same for a lamp: (2 / 3 pi) (sin a + (pi - a) cos a), at an angle a from the
   * camera.
   */
  static double GetIrradianceOfBall(const vtkIndirectDistantLight& lamp);

  /**
   * Makes the lights of a preset (vtkIndirectLightingType). lamps: the renderer's own lights that
   * follow its camera; an empty list means a headlight of strength 1, as VTK makes it. hasOwnSky:
   * false where another environment has the place of the preset's sky.
   */
  static vtkIndirectPresetLights Make(int preset, std::vector<vtkIndirectDistantLight> lamps,
    const vtkIndirectPresetAlbedo& albedo = vtkIndirectPresetAlbedo(), bool hasOwnSky = true);
  /**
   * Returns the light that a cavity of this albedo receives where it receives most, with all
   * bounces, over the light that falls there directly.
   */
  static double FindGain(double albedo);
  /** Returns the direction for angles in degrees, as in vtkLight::SetDirectionAngle. */
  static glm::dvec3 FromAngles(double elevation, double azimuth);
};
