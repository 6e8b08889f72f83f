// SPDX-License-Identifier: BSD-3-Clause
// Distance, in its radii, within which a sphere has to count for a small cut-off error under an
// environment.
#pragma once

#include <array>       // for coefficients
#include <glm/glm.hpp> // for colours

class vtkIndirectProxyReach
{
public:
  /** Bound of one sphere's cut-off error over the largest irradiance of the environment. */
  static constexpr double Cut = 1.0 / 256.0;
  static constexpr double Least = 2.0;
  static constexpr double Most = 1000.0;
  /** The index is l (l + 1) + m, as from vtkIndirectProxyLight::Project. */
  using Coefficients = std::array<glm::dvec3, 16>;

  double Hides = Least; // radii within which a sphere hides light
  double Sends = Least; // radii within which a white sphere sends light
  /** This is the largest radiance over the largest irradiance, of any colour: 1 for a uniform
   * environment. */
  double Contrast = 0.0;

  /**
   * Returns the smallest reach with this property: a sphere whose weight ends there
   * (vtkiProxyWithin), at any distance, in any direction, at any normal, in each colour, differs
   * from a sphere that counts everywhere by at most Cut of the largest irradiance of any normal
   * under the open environment. Computed as in sums over spheres: light of order 4, visibility by
   * the exponential of the sphere's logarithm. Spheres send light that nothing occludes. middle: by
   * Eq 13, else by Eq 15. An environment without light has the least reach.
   */
  static vtkIndirectProxyReach Find(const Coefficients& light, bool middle);
};
