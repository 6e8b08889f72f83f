// SPDX-License-Identifier: BSD-3-Clause
// How far a sphere has to count, in its radii, for what is cut off beyond to be small under an
// environment.
#ifndef vtkIndirectProxyReach_h
#define vtkIndirectProxyReach_h

#include <array>       // for coefficients
#include <glm/glm.hpp> // for colours

class vtkIndirectProxyReach
{
public:
  /** What may be cut off of one sphere, over the largest irradiance of the environment. */
  static constexpr double Cut = 1.0 / 256.0;
  static constexpr double Least = 2.0;
  static constexpr double Most = 1000.0;
  /** By l (l + 1) + m, as of vtkIndirectProxyLight::Project. */
  using Coefficients = std::array<glm::dvec3, 16>;

  double Hides = Least; // radii within which a sphere hides light
  double Sends = Least; // and within which a white one sends it
  /** The largest radiance over the largest irradiance, of any colour: 1 where it is uniform. */
  double Contrast = 0.0;

  /**
   * The smallest of which this holds: a sphere whose weight ends there (vtkiProxyWithin), at any
   * distance, in any direction, at any normal, of each colour, differs from one that counts
   * everywhere by no more than Cut of the largest irradiance that the open environment gives any
   * normal. All of it as sums over spheres take it: light of order 4, a sphere by its logarithm's
   * exponential. What spheres send is that of nothing that hides the light from them. middle: of
   * Eq 13, else of Eq 15. An environment without light has the least.
   */
  static vtkIndirectProxyReach Find(const Coefficients& light, bool middle);
};
#endif
