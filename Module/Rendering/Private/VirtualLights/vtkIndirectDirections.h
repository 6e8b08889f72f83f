// SPDX-License-Identifier: BSD-3-Clause
// Directions in which an environment is sampled, and what each of them stands for.
#ifndef vtkIndirectDirections_h
#define vtkIndirectDirections_h

#include <glm/glm.hpp> // for directions
#include <vector>      // for lists

class vtkEnvironmentLight;

namespace vtkIndirectDirections
{
/**
 * A Fibonacci lattice on the sphere (Gonzalez 2010, "Measurement of areas on a sphere using
 * Fibonacci and latitude-longitude lattices"): places of equal area, fixed in the world.
 */
std::vector<glm::dvec3> MakeLattice(int count);

/**
 * What the directions stand for: each cell of the sky goes to the direction nearest to it, so that
 * all of the light is there. Radiance times solid angle, a value for each direction.
 */
std::vector<glm::dvec3> Project(
  vtkEnvironmentLight* environment, const std::vector<glm::dvec3>& directions);
}

#endif
