// SPDX-License-Identifier: BSD-3-Clause
// A body that refracts light: a closed surface between air and a material of another index.
#pragma once

#include "Scene/vtkIndirectSurfaces.h" // for a member

#include <glm/glm.hpp> // for vectors

class vtkActor;
struct vtkIndirectFrame;

class vtkIndirectRefraction
{
public:
  /**
   * Takes the surface of one of the frame's refractors, where the actor places it.
   */
  void SetBody(const vtkIndirectFrame& frame, vtkActor* actor);

  struct Path
  {
    glm::dvec3 Position; // place where the path leaves the body, scene units
    glm::dvec3 Normal;   // unit normal there, outwards
    glm::dvec3 Direction;
    double Share = 0.0; // the share of the light that has come through; 0: none
  };

  /**
   * Traces light through the body. Light is refracted where it enters and where it leaves, and
   * mirrored where it cannot leave, by Fresnel's equations for glass; light that is mirrored
   * elsewhere is lost. Faces let 1 - opacity through, as in VTK's picture. origin: scene units;
   * direction: unit.
   */
  Path Trace(const glm::dvec3& origin, const glm::dvec3& direction) const;

  /**
   * Returns the refracted direction; zero at total reflection. normal: unit, against the direction.
   */
  static glm::dvec3 Refract(
    const glm::dvec3& direction, const glm::dvec3& normal, double indexBefore, double indexBehind);
  /** Returns the share of unpolarised light that a face mirrors (Fresnel 1823). */
  static double Reflectance(double cosine, double indexBefore, double indexBehind);

  size_t GetBytes() const { return this->Surfaces.GetBytes(); }

private:
  // Finds the first face along a path, and its normal there against the path.
  bool Meet(const glm::dvec3& from, const glm::dvec3& direction, glm::dvec3& place,
    glm::dvec3& normal) const;

  vtkIndirectSurfaces Surfaces;
  double Index = 1.0;
  double Transmission = 1.0; // share that a face lets through
  double Size = 0.0;         // diagonal of its bounds, scene units
};
