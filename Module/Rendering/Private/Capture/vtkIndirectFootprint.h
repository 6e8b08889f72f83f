// SPDX-License-Identifier: BSD-3-Clause
// The footprint of a box in an image that is drawn from an emitter, to tell whether any of the box
// can be there.
#pragma once

#include <glm/glm.hpp> // for corners
#include <limits>      // for empty footprints

class vtkIndirectFootprint
{
public:
  /**
   * Adds a corner. place: to the right and up; width: half of the image's extent there, not
   * positive behind the emitter; tooNear: true if the corner lies in front of the image's near
   * plane.
   */
  void Add(const glm::dvec2& place, const glm::dvec2& width, bool tooNear)
  {
    unsigned int outside = tooNear ? 16u : 0u;
    outside |= place.x > width.x ? 1u : 0u;
    outside |= place.x < -width.x ? 2u : 0u;
    outside |= place.y > width.y ? 4u : 0u;
    outside |= place.y < -width.y ? 8u : 0u;
    this->OutsideAll &= outside;
    this->Ahead = this->Ahead && width.x > 0.0;
    this->Lower = glm::min(this->Lower, place / width);
    this->Upper = glm::max(this->Upper, place / width);
  }

  /**
   * Returns true if an image of this many texels along its edges can hold any of the box: not all
   * corners lie on one outer side, and the box is not so small that it lies between the texels'
   * centres.
   */
  bool IsHeld(const glm::dvec2& texels) const
  {
    return this->OutsideAll == 0 &&
      (!this->Ahead || HasTexelCenter(this->Lower, this->Upper, texels));
  }

  /**
   * Returns true if a texel's centre lies between two corners of a rectangle, from -1 to 1, of an
   * image of this many texels along its edges.
   */
  static bool HasTexelCenter(
    const glm::dvec2& lower, const glm::dvec2& upper, const glm::dvec2& texels)
  {
    // OpenGL places corners at steps of 1/256 of a texel or less, and matrices are rounded.
    constexpr double margin = 1.0 / 16.0;
    const glm::dvec2 first = glm::ceil(0.5 * texels * (lower + 1.0) - 0.5 - margin);
    const glm::dvec2 last = glm::floor(0.5 * texels * (upper + 1.0) - 0.5 + margin);
    return first.x <= last.x && first.y <= last.y;
  }

private:
  unsigned int OutsideAll = 0x1f; // outer sides on which all corners lie
  bool Ahead = true;
  glm::dvec2 Lower{ std::numeric_limits<double>::infinity() };
  glm::dvec2 Upper{ -std::numeric_limits<double>::infinity() };
};
