// SPDX-License-Identifier: BSD-3-Clause
// The sky in a few groups of directions, each a directional light, for the light that surfaces
// reflect. Reflected light is a mean over many senders, so it needs fewer directions than received
// light.
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
  int Number = 0;                        // number of its direction, the same in any sky
  glm::dvec3 Direction{ 0.0, 1.0, 0.0 }; // direction that the light comes from: world, unit
  glm::dvec3 Strength{ 0.0 };            // VTK irradiance of a surface that faces it
};

/** Number of directions all around, without those that may be groups of their own. */
constexpr int NumberOfDirections = 32;

/**
 * Makes the groups that send light. Their directions are fixed in the world, and they hold all of
 * the sky's light. A direction with more light than a group's mean share, such as a sun's, is a
 * group of its own.
 */
std::vector<Group> Make(vtkIndirectSkyProjection& projection, vtkEnvironmentLight* environment);
}

#endif
