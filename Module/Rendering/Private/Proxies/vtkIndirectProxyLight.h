// SPDX-License-Identifier: BSD-3-Clause
// An environment in spherical harmonics, and the other input of sums over spheres: a uniform block
// with the light and the flat polygons.
#pragma once

#include "OpenGL/vtkIndirectKey.h"          // for a member
#include "OpenGL/vtkIndirectResource.h"     // for the base class
#include "OpenGL/vtkIndirectUniformBlock.h" // for a member
#include "Proxies/vtkIndirectProxySphere.h" // for polygons

#include <array> // for coefficients

class vtkEnvironmentLight;

class vtkIndirectProxyLight : public vtkIndirectResource
{
public:
  using vtkIndirectResource::vtkIndirectResource;

  static constexpr int NumberOfCoefficients = 16;
  static constexpr size_t MostPolygons = 32;
  static constexpr size_t MostCorners = 8;
  static constexpr size_t MostFinePolygons = 4;
  using Coefficients = std::array<glm::dvec3, NumberOfCoefficients>;

  /** Returns the coefficients of order 4, by l (l + 1) + m, in world coordinates. */
  static Coefficients Project(vtkEnvironmentLight* environment);

  /**
   * Fills the block; null: no light. polygons: from ChoosePolygons; their places are the senders
   * from firstPlace on, one side after the other. Returns true if anything has changed.
   */
  bool Update(vtkOpenGLRenderWindow* window, vtkEnvironmentLight* environment,
    const std::vector<vtkIndirectProxyPolygon>& polygons, int firstPlace, bool changed);
  /** Returns the polygons that count: if there are too many, the largest. */
  static std::vector<vtkIndirectProxyPolygon> ChoosePolygons(
    std::vector<vtkIndirectProxyPolygon> polygons);
  /**
   * Places evenly spread over a polygon, at which its light is computed: four times its number of
   * corners, or just that number if there are more than a few polygons.
   */
  static std::vector<glm::dvec3> FindPlaces(
    const vtkIndirectProxyPolygon& polygon, size_t numberOfPolygons);
  /** Returns the area. */
  static double FindSize(const vtkIndirectProxyPolygon& polygon);
  /** Returns the unit normal. */
  static glm::dvec3 FindNormal(const vtkIndirectProxyPolygon& polygon);

  void Activate(const vtkIndirectProgram& program) const;

protected:
  void ReleaseOwn(vtkWindow*) override { this->Environment.Clear(); }

private:
  void AddPolygons(std::vector<glm::vec4>& rows,
    const std::vector<vtkIndirectProxyPolygon>& polygons, int firstPlace);

  vtkIndirectUniformBlock Block{ this, "vtkiProxyBlock" };
  Coefficients Light;
  vtkIndirectKey Environment;
  int NumberOfPolygons = 0;
};
