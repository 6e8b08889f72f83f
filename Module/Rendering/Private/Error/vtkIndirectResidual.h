// SPDX-License-Identifier: BSD-3-Clause
// The difference between what path tracing finds at a pixel and what a picture shows there. Filter
// takes the noise out of an image of differences: noise is independent from pixel to pixel, and the
// errors of a picture extend over neighbouring pixels of a surface.
//
// The image is split into details of one, two, four, ... pixels and a smooth rest, by weighted
// means of 5 x 5 pixels at growing distances (Starck and Murtagh 1994, "Image restoration with
// noise suppression using the wavelet transform"), where pixels of other surfaces have no weight
// (Dammertz, Sewtz, Hanika, Lensch 2010, "Edge-avoiding a-trous wavelet transform for fast global
// illumination filtering"). Each detail is multiplied by the share of its power, in the mean around
// the pixel, that the noise does not explain (Wiener 1949). So a picture that is right stays as it
// is, and smaller details appear as the noise falls.
#pragma once

#include <glm/glm.hpp> // for vectors
#include <vector>      // for images

struct vtkIndirectResidual
{
  glm::vec3 Position{ 0.0f }; // of the surface, scene units
  glm::vec3 Normal{ 0.0f };   // unit; zero: no surface, and no difference
  glm::vec3 Value{ 0.0f };    // the difference; without noise after Filter
  float Variance = 0.0f;      // of Value by its noise, mean of the three channels

  bool HasSurface() const { return this->Normal != glm::vec3(0.0f); }
  /** Returns 1 for another pixel of the same plane, down to 0 for one of another surface. */
  float FindLikeness(const vtkIndirectResidual& other) const;

  /** Filters an image of rows of this width. */
  static void Filter(std::vector<vtkIndirectResidual>& image, int width);
};
