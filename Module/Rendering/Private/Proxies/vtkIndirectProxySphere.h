// SPDX-License-Identifier: BSD-3-Clause
// What hides light and sends it in place of surfaces: spheres and flat convex polygons.
#ifndef vtkIndirectProxySphere_h
#define vtkIndirectProxySphere_h

#include <glm/glm.hpp> // for places
#include <vector>      // for corners

struct vtkIndirectProxySphere
{
  glm::dvec3 Center{ 0.0 };
  double Radius = 0.0;
  glm::vec3 Albedo{ 0.0f };
  bool PhysicallyBased = false; // see vtkIndirectMaterial
  bool Exact = false;           // it is drawn as it is; else it stands for a surface nearby
};

struct vtkIndirectProxyPolygon
{
  std::vector<glm::dvec3> Corners; // three or more, around it
  glm::vec3 Albedo{ 0.0f };
};
#endif
