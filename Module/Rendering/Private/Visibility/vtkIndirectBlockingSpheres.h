// SPDX-License-Identifier: BSD-3-Clause
// What mappers draw as spheres, in place of polygons. They stand between senders and receivers, and
// rays meet them. Who finds them is a later room (vtkIndirectSphereBlockers).
#ifndef vtkIndirectBlockingSpheres_h
#define vtkIndirectBlockingSpheres_h

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
    bool PhysicallyBased = false; // VTK divides by pi what its own lights give
    bool operator==(const Look& other) const
    {
      return this->Albedo == other.Albedo && this->PhysicallyBased == other.PhysicallyBased;
    }
  };

  std::vector<glm::dvec4> Spheres;                          // center and radius, scene units
  std::vector<Look> Looks;                                  // of each
  std::string What;                                         // how many of what
  std::vector<const vtkProp*> Props;                        // that they are of
  std::vector<const vtkMapper*> Mappers;                    // all that these actors' mappers draw
  std::vector<std::pair<std::string, std::string>> LeftOut; // what else is there and blocks nothing
  size_t NumberOfUpdates = 0;                               // grows when places or radii change
  size_t NumberOfLooks = 0;                                 // grows when looks do
};
#endif
