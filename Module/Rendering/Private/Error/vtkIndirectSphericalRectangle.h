// SPDX-License-Identifier: BSD-3-Clause
// A rectangle as a place sees it: its solid angle, and directions spread evenly over it. Urena,
// Fajardo, King 2013, "An area-preserving parametrization for spherical rectangles".
#pragma once

#include "Emitters/vtkIndirectRectangle.h" // for rectangles

#include <algorithm>   // for bounds
#include <cmath>       // for angles
#include <glm/glm.hpp> // for vectors

class vtkIndirectSphericalRectangle
{
public:
  vtkIndirectSphericalRectangle(const vtkIndirectRectangle& rectangle, const glm::dvec3& place)
    : X(glm::normalize(rectangle.Edge1))
    , Y(glm::normalize(rectangle.Edge2))
    , Lower(rectangle.Corner - place)
    , Size(glm::length(rectangle.Edge1), glm::length(rectangle.Edge2))
  {
    const glm::dvec3 lower(glm::dot(this->Lower, this->X), glm::dot(this->Lower, this->Y), 0.0);
    this->From = glm::dvec2(lower);
    this->To = this->From + this->Size;
    this->Away = -std::abs(glm::dot(this->Lower, glm::normalize(glm::cross(this->X, this->Y))));
    const auto side = [this](double ax, double ay, double bx, double by)
    {
      return glm::normalize(
        glm::cross(glm::dvec3(ax, ay, this->Away), glm::dvec3(bx, by, this->Away)));
    };
    const glm::dvec3 sides[] = { side(this->From.x, this->From.y, this->To.x, this->From.y),
      side(this->To.x, this->From.y, this->To.x, this->To.y),
      side(this->To.x, this->To.y, this->From.x, this->To.y),
      side(this->From.x, this->To.y, this->From.x, this->From.y) };
    double angles[4];
    for (int i = 0; i < 4; ++i)
    {
      angles[i] = std::acos(std::clamp(-glm::dot(sides[i], sides[(i + 1) % 4]), -1.0, 1.0));
    }
    this->First = sides[0].z;
    this->Third = sides[2].z;
    this->Begin = 6.28318530717958648 - angles[2] - angles[3];
    this->SolidAngle = angles[0] + angles[1] - this->Begin;
  }

  /**
   * Returns the solid angle, in steradians; not positive, or no number, where it is too small to be
   * told, and where the place is in the rectangle's plane. The edges must be at right angles.
   */
  double GetSolidAngle() const { return this->SolidAngle; }

  /** Returns the place along the edges, from 0 to 1, of a direction; at: in the unit square. */
  glm::dvec2 GetPlace(const glm::dvec2& at) const
  {
    const double angle = at.x * this->SolidAngle + this->Begin;
    const double f = (std::cos(angle) * this->First - this->Third) / std::sin(angle);
    const double cosine =
      std::clamp(std::copysign(1.0, f) / std::sqrt(f * f + this->First * this->First), -1.0, 1.0);
    const double x =
      std::clamp(-cosine * this->Away / std::sqrt(1.0 - cosine * cosine), this->From.x, this->To.x);
    const double squared = x * x + this->Away * this->Away;
    const double h0 = this->From.y / std::sqrt(squared + this->From.y * this->From.y);
    const double h1 = this->To.y / std::sqrt(squared + this->To.y * this->To.y);
    const double h = h0 + at.y * (h1 - h0);
    const double y = h * h < 1.0 - 1e-12 ? h * std::sqrt(squared / (1.0 - h * h)) : this->To.y;
    return glm::clamp((glm::dvec2(x, y) - this->From) / this->Size, 0.0, 1.0);
  }

private:
  glm::dvec3 X;
  glm::dvec3 Y;
  glm::dvec3 Lower; // corner
  glm::dvec2 Size;  // lengths of the edges
  glm::dvec2 From{ 0.0 };
  glm::dvec2 To{ 0.0 };
  double Away = 0.0; // along the axis from the rectangle to the place, not above 0
  double First = 0.0;
  double Third = 0.0;
  double Begin = 0.0;
  double SolidAngle = 0.0;
};
