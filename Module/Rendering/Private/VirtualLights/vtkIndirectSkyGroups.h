// SPDX-License-Identifier: BSD-3-Clause
// The sky in a few groups of directions, each a directional light, for what surfaces reflect of it:
// that is a mean over many senders, so it needs fewer directions than what they receive.
#ifndef vtkIndirectSkyGroups_h
#define vtkIndirectSkyGroups_h

#include <glm/glm.hpp> // for directions
#include <vector>      // for lists

class vtkEnvironmentLight;
class vtkIndirectSkyProjection;

namespace vtkIndirectSkyGroups
{
struct Group
{
  int Number = 0;                        // of its direction, the same in any sky
  glm::dvec3 Direction{ 0.0, 1.0, 0.0 }; // where the light comes from: world, unit
  glm::dvec3 Strength{ 0.0 };            // VTK irradiance of a surface that faces it
};

/** Directions all around, without those that may stand by themselves. */
constexpr int NumberOfDirections = 32;

/**
 * Groups that send light. Their directions are fixed in the world, and all of the sky's light is in
 * them. What so much comes from that it is a group's own share, as from a sun, stands by itself.
 */
std::vector<Group> Make(vtkIndirectSkyProjection& projection, vtkEnvironmentLight* environment);
}

#endif
