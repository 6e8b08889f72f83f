// SPDX-License-Identifier: BSD-3-Clause
// The lobe of a specular sender, in double precision, for vtkRSMReferencePass.
#ifndef vtkIndirectReferenceLobe_h
#define vtkIndirectReferenceLobe_h

#include <glm/glm.hpp> // for vectors
#include <vector>      // for lists

class vtkIndirectVirtualLights;

struct vtkIndirectReferenceLobe
{
  glm::dvec3 Position;
  glm::dvec3 Normal; // unit
  double Area;
  glm::dvec3 Direction;
  double Exponent;
  glm::dvec3 Flux;

  /**
   * Returns the irradiance of a surface that faces a lobe of flux one: vtkiSenderLobeStrength times
   * the distance.
   */
  double FindStrength(const glm::dvec3& toReceiver) const;

  /** Returns the lobes of virtual lights that have one. */
  static std::vector<vtkIndirectReferenceLobe> Read(const vtkIndirectVirtualLights& lights);
};

#endif
