// SPDX-License-Identifier: BSD-3-Clause
// Spheres that mappers draw in place of polygons. They block light between senders and receivers,
// and rays meet them. vtkIndirectSphereBlockers finds them.
#pragma once

#include <cstddef>     // for size_t
#include <glm/glm.hpp> // for places
#include <string>      // for reasons
#include <utility>     // for pairs
#include <vector>      // for lists

class vtkMapper;
class vtkProp;

struct vtkIndirectBlockingSpheres
{
  struct Look
  {
    glm::vec3 Albedo{ 0.0f };     // see vtkIndirectMaterial
    bool PhysicallyBased = false; // VTK divides the light of its own lights by pi
    bool operator==(const Look& other) const
    {
      return this->Albedo == other.Albedo && this->PhysicallyBased == other.PhysicallyBased;
    }
  };

  std::vector<glm::dvec4> Spheres;                          // center and radius, scene units
  std::vector<Look> Looks;                                  // one for each sphere
  std::string What;                                         // their number and kind, for the report
  std::vector<const vtkProp*> Props;                        // props that draw them
  std::vector<const vtkMapper*> Mappers;                    // mappers that draw nothing else
  std::vector<std::pair<std::string, std::string>> LeftOut; // things that block nothing, and why
  size_t NumberOfUpdates = 0;                               // grows when places or radii change
  size_t NumberOfLooks = 0;                                 // grows when looks change
};
