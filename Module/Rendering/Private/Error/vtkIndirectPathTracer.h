// SPDX-License-Identifier: BSD-3-Clause
// Path tracing from a few places, on the processor: the irradiance of all bounces, with true
// visibility. It is the judge of a picture at run time (vtkIndirectErrorProbe), and shares nothing
// with the sums but the list of surfaces, so that the errors of maps, clusters and walks show.
//
// Kajiya 1986, "The rendering equation". At each vertex of a path one emitter is chosen, in
// proportion to what each would give if nothing hid it, and one ray tells whether something does
// (Shirley, Wang, Zimmerman 1996, "Monte Carlo techniques for direct lighting calculations"). Paths
// end by chance where surfaces absorb light. The result is unbiased for surfaces that reflect
// diffusely. It leaves out the size of lights, specular reflection between surfaces, glass, and
// whatever vtkIndirectSurfaces leaves out.
#pragma once

#include "Emitters/vtkIndirectRectangle.h" // for members
#include "Scene/vtkIndirectFrame.h"        // for lights
#include "Scene/vtkIndirectSurfaces.h"     // for meetings
#include "vtkSmartPointer.h"               // for lights

#include <cstdint>     // for seeds
#include <glm/glm.hpp> // for vectors
#include <vector>      // for lists

class vtkAreaLight;
class vtkEnvironmentLight;

class vtkIndirectPathTracer
{
public:
  using Place = vtkIndirectSurfaces::Meeting;

  /**
   * environment: null if there is no sky. bounces: 0 for all of them. Frame and surfaces must
   * outlive the tracer.
   */
  vtkIndirectPathTracer(const vtkIndirectFrame& frame, const vtkIndirectSurfaces& surfaces,
    vtkEnvironmentLight* environment, const std::vector<vtkSmartPointer<vtkAreaLight>>& areaLights,
    int bounces = 0);

  /**
   * Estimates the VTK irradiance (physical over pi) at a place: direct light of the sky and of area
   * lights, and all light that surfaces reflect, without direct light of vtkLights. Other seeds
   * give independent estimates. Several threads may call it at once.
   */
  glm::dvec3 FindIrradiance(const Place& place, std::uint32_t seed, int paths) const;
  /**
   * Adds the irradiance that each of further paths gives to a sum, and the mean square of its three
   * channels to `squares`. first: number of paths of this seed that have been summed before.
   */
  void AddPaths(const Place& place, std::uint32_t seed, int first, int paths, glm::vec3& sum,
    float& squares) const;

  const vtkIndirectSurfaces& GetSurfaces() const { return this->Surfaces; }

private:
  struct Rectangle
  {
    vtkIndirectRectangle Shape; // scene units
    std::vector<float> Radiances;
    int Columns = 1;
    int Rows = 1;
    bool IsRectangular = true;
  };
  struct Candidate
  {
    glm::dvec3 Light{ 0.0 }; // VTK irradiance if nothing hides the emitter
    glm::dvec3 End{ 0.0 };   // of the ray to it, scene units
  };
  using Candidates = std::vector<Candidate>;

  void AddLights(const Place& place, Candidates& candidates) const;
  void AddSky(const Place& place, double number, Candidates& candidates) const;
  void AddRectangles(const Place& place, const glm::dvec2& at, Candidates& candidates) const;
  glm::dvec3 FindDirect(const Place& place, bool withLights, const glm::dvec2& at,
    const glm::dvec2& choice, Candidates& candidates) const;
  glm::dvec3 TracePath(
    const Place& place, std::uint32_t number, std::uint32_t seed, Candidates& candidates) const;

  const vtkIndirectFrame& Frame;
  const vtkIndirectSurfaces& Surfaces;
  const int LastBounce;
  std::vector<vtkIndirectLight> Lights;
  std::vector<Rectangle> Rectangles;
  std::vector<glm::dvec3> SkyDirections; // of cells of the sky
  std::vector<glm::dvec3> SkyLight;      // radiance times solid angle
  std::vector<double> SkySums;           // of the cells' luminance, up to and with each cell
};
