// SPDX-License-Identifier: BSD-3-Clause
// Virtual lights of rectangles that send light: few where the light is uniform, more where it is
// not.
//
// The piece whose light lies farthest from its mean, over all rectangles, is halved again and
// again. (Nichols and Wyman 2009 begin with many lights instead, and join those of a piece without
// a discontinuity.) A piece's light is the sum of its pixels' light, so no light is lost; it comes
// from the pixels' mean place. A piece's area is the area that its light covers: a single bright
// pixel has its own area, not that of the dark piece around it.
#pragma once

#include "VirtualLights/vtkIndirectRectangle.h" // for places

#include <vector> // for lists

class vtkIndirectAreaClusters
{
public:
  /** A rectangle of pixels of equal size, in scene units. */
  struct Image : vtkIndirectRectangle
  {
    using vtkIndirectRectangle::vtkIndirectRectangle;
    int Columns = 1; // along Edge1
    int Rows = 1;
    const float* Radiances = nullptr; // three numbers a pixel
  };
  struct Light
  {
    glm::dvec3 Position{ 0.0 };
    glm::dvec3 Normal{ 0.0, 0.0, 1.0 };
    double Area = 1.0;
    glm::dvec3 RadianceArea{ 0.0 };
  };

  /**
   * Makes at most this many lights, but at least one for each side of an image that is not dark.
   * Pieces are no smaller than pixels, a 64th of an edge where pixels are larger, a 512th where
   * pixels are smaller.
   */
  static std::vector<Light> MakeLights(const std::vector<Image>& images, int count);
};
