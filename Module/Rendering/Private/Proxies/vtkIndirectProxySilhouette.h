// SPDX-License-Identifier: BSD-3-Clause
// Joint occlusion by spheres from afar, with mutual overlap: the area of their silhouette, averaged
// over all directions. Areas are over pi, so that a sphere has r^2.
#pragma once

#include <glm/glm.hpp> // for places

class vtkIndirectProxySilhouette
{
public:
  /**
   * Returns the overlap of two balls' disks: the area of their intersection, averaged over
   * directions, over that of the smaller one. Radii are positive; distance is that of their
   * centres, from 0 on. Within 0.01 of the integral, 0.05 if a small ball is barely hidden.
   */
  static double FindOverlap(double first, double second, double distance);

  /** A ball with the hidden share of its disk. */
  struct Ball
  {
    glm::dvec3 Center;
    double Radius;
    double Share;
  };
  /**
   * Returns the area of the silhouette of some balls: of each ball the part that the balls before
   * it leave, as if their overlaps were independent.
   */
  static double FindArea(const Ball* balls, int count);
};
