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

  /** What a lobe of flux one gives a surface that faces it: vtkiSenderLobeStrength times the
   * distance. */
  double FindStrength(const glm::dvec3& toReceiver) const;

  /** Those of virtual lights that have some. */
  static std::vector<vtkIndirectReferenceLobe> Read(const vtkIndirectVirtualLights& lights);
};

#endif
