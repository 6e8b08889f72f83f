// SPDX-License-Identifier: BSD-3-Clause
// Spheres and flat convex polygons that occlude and send light in place of surfaces.
#pragma once

#include <glm/glm.hpp> // for places
#include <vector>      // for corners

struct vtkIndirectProxySphere
{
  glm::dvec3 Center{ 0.0 };
  double Radius = 0.0;
  glm::vec3 Albedo{ 0.0f };
  bool PhysicallyBased = false; // see vtkIndirectMaterial
  bool Exact = false;           // drawn as a sphere; else it represents a surface nearby
};

struct vtkIndirectProxyPolygon
{
  std::vector<glm::dvec3> Corners; // three or more, in order around it
  glm::vec3 Albedo{ 0.0f };
};
