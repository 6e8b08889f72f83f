// SPDX-License-Identifier: BSD-3-Clause
// Spheres bound to points of a surface, which they follow.
#pragma once

#include "vtkProxySurface.h" // for the surface

/**
 * Unused points have the id of the first and no weight. A center is a sum of up to Count points
 * with weights of sum one, so that any affine motion of the points moves it exactly. The radius
 * scales with the points' root mean square distance from their mean.
 */
struct vtkProxyBinding
{
  static constexpr int Count = 8;
  long long Ids[Count] = {};
  double Weights[Count] = {};
  double Spread = 0.0;      // spread of the points about their mean, in the input's lengths
  glm::dvec3 Offset{ 0.0 }; // part out of reach of the weights: center minus sum; usually 0

  /** Bindings of spheres to the points of a surface's triangles. */
  static std::vector<vtkProxyBinding> Bind(
    const vtkProxySurface& surface, const std::vector<vtkProxySphere>& spheres);

  static double GetSpread(const glm::dvec3* points, int count);
};
