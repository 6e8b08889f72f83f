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
// Surfaces reflect the replacing light, and nothing of the kept light. A concave part of albedo a,
// whose surfaces see each other in a share F of their hemispheres, receives G = 1 / (1 - a F) times
// the light that falls on it, all bounces taken together. Nearly white surfaces have no room for
// that. So where strength s replaces a share r, 1 - r + s G must not exceed the ratio of white to
// plain VTK's brightest surface: 1 / (a P), where P is the greatest irradiance that the renderer's
// lights give any surface.
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
 * This is the albedo of the surfaces that the lights shine on, as far as their colours are known;
 * zero: unknown.
 */
struct vtkIndirectPresetAlbedo
{
  double Brightest = 0.0; // greatest of all channels, which may become white
  double Mean = 0.0;      // of red, green and blue, of the lightest surface: for bounces
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
   * follow its camera; an empty list means a headlight of strength 1, as VTK makes it.
   */
  static vtkIndirectPresetLights Make(int preset, std::vector<vtkIndirectDistantLight> lamps,
    const vtkIndirectPresetAlbedo& albedo = vtkIndirectPresetAlbedo());
  /** Returns the greatest irradiance that lamps give a surface of any direction. */
  static double FindMostIrradiance(const std::vector<vtkIndirectDistantLight>& lamps);
  /** Returns the direction for angles in degrees, as in vtkLight::SetDirectionAngle. */
  static glm::dvec3 FromAngles(double elevation, double azimuth);
};
