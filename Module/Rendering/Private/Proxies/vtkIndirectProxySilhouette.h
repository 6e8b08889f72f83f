// SPDX-License-Identifier: BSD-3-Clause
// What spheres hide together from afar, of whom some are in front of others: the area of their
// silhouette, meaned over all directions. Areas are over pi, so that a sphere has r^2.
#ifndef vtkIndirectProxySilhouette_h
#define vtkIndirectProxySilhouette_h

#include <glm/glm.hpp> // for places

class vtkIndirectProxySilhouette
{
public:
  /**
   * What two balls cover of each other's disks: the area that both have, meaned over directions,
   * over that of the smaller one. Radii are positive; distance is that of their centres, from 0 on.
   * Within 0.01 of the integral, 0.05 where a small one is just hidden wholly.
   */
  static double FindOverlap(double first, double second, double distance);

  /** A ball that hides the share of its disk. */
  struct Ball
  {
    glm::dvec3 Center;
    double Radius;
    double Share;
  };
  /**
   * The area of the silhouette of some balls: of each what those before it leave, as if what they
   * cover of it were in no relation to each other.
   */
  static double FindArea(const Ball* balls, int count);
};
#endif
