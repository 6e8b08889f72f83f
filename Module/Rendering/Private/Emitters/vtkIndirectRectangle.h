// SPDX-License-Identifier: BSD-3-Clause
// The place of an area light: a rectangle, or a parallelogram.
#pragma once

#include "vtkAreaLight.h" // for places

#include <glm/glm.hpp>          // for vectors
#include <glm/gtc/type_ptr.hpp> // for vectors of VTK

struct vtkIndirectRectangle
{
  glm::dvec3 Corner{ 0.0 };
  glm::dvec3 Edge1{ 0.0 };
  glm::dvec3 Edge2{ 0.0 };
  glm::dvec3 Normal{ 0.0 }; // unit, on the front
  bool TwoSided = false;

  vtkIndirectRectangle() = default;
  /** Takes the place of a light, in units of which a world unit has `scale`, from `center` on. */
  explicit vtkIndirectRectangle(
    vtkAreaLight* light, const glm::dvec3& center = glm::dvec3(0.0), double scale = 1.0)
    : TwoSided(light->GetTwoSided())
  {
    const glm::dvec3 origin = glm::make_vec3(light->GetOrigin());
    this->Corner = (origin - center) * scale;
    this->Edge1 = (glm::make_vec3(light->GetPoint1()) - origin) * scale;
    this->Edge2 = (glm::make_vec3(light->GetPoint2()) - origin) * scale;
    light->GetNormal(&this->Normal[0]);
  }

  double GetArea() const { return glm::length(glm::cross(this->Edge1, this->Edge2)); }
  /** Returns a place from 0 to 1 along the edges. */
  glm::dvec3 GetPlace(const glm::dvec2& along) const
  {
    return this->Corner + along.x * this->Edge1 + along.y * this->Edge2;
  }
};
