// SPDX-License-Identifier: BSD-3-Clause
// Virtual lights of rectangles that send light: few where the light is uniform, more where it is
// not.
//
// MakeLights halves the piece whose light lies farthest from its mean, over all rectangles, again
// and again; near receivers sum the halves of a piece in its place. MakeMinMaxLights begins with
// many lights and joins those of a square without a discontinuity (Nichols and Wyman 2009). A
// piece's light is the sum of its pixels' light, so no light is lost; it comes from the pixels'
// mean place. A piece's area is the area that its light covers: a single bright pixel has its own
// area, not that of the dark piece around it.
#pragma once

#include "Emitters/vtkIndirectRectangle.h"     // for places
#include "Senders/vtkIndirectSenderClusters.h" // for lights

#include <vector> // for lists

class vtkIndirectAreaClusters
{
public:
  /** This is a rectangle of pixels of equal size, in scene units. */
  struct Image : vtkIndirectRectangle
  {
    using vtkIndirectRectangle::vtkIndirectRectangle;
    int Columns = 1; // along Edge1
    int Rows = 1;
    const float* Radiances = nullptr; // three numbers a pixel
  };
  /** DensityArea: radiance times area. */
  using Light = vtkIndirectSenderClusters::Light;
  using LightTree = vtkIndirectSenderClusters::LightTree;

  /**
   * Makes at most this many lights, but at least one for each side of an image that is not dark.
   * Pieces are no smaller than pixels, a 64th of an edge where pixels are larger, a 512th where
   * pixels are smaller. Receivers sum the branches of a light where the error of the whole light's
   * irradiance exceeds `limit`; 0: never.
   */
  static LightTree MakeLights(const std::vector<Image>& images, int count, double limit);

  /**
   * Makes at most this many lights, but at least one for each side, of squares whose radiances
   * differ by as little as that many lights allow: 64 x 64 of an image where they differ most, and
   * as many as fit into a quarter of `count` where they do not differ.
   */
  static std::vector<Light> MakeMinMaxLights(const std::vector<Image>& images, int count);
};
