// SPDX-License-Identifier: BSD-3-Clause
// Directions in which an environment is sampled, and what each of them stands for.
#ifndef vtkIndirectDirections_h
#define vtkIndirectDirections_h

#include "vtkEnvironmentLight.h" // for its cells

#include <glm/glm.hpp> // for directions
#include <vector>      // for lists

namespace vtkIndirectDirections
{
/**
 * A Fibonacci lattice on the sphere (Gonzalez 2010, "Measurement of areas on a sphere using
 * Fibonacci and latitude-longitude lattices"): places of equal area, fixed in the world.
 */
std::vector<glm::dvec3> MakeLattice(int count);

/**
 * The same places in an order of which the first quarter is spread evenly over the sphere, the
 * first quarter of that again, and so on down to sixteen: those nearest to a lattice of so many.
 * In between each is the one that is farthest from all before it (Gonzalez 1985, "Clustering to
 * minimize the maximum intercluster distance"), so that the first ones are spread, however many.
 */
std::vector<glm::dvec3> MakeNestedLattice(int count);

/** For each cell the direction nearest to it, of the first `count`. */
std::vector<size_t> FindNearest(const std::vector<vtkEnvironmentLight::Cell>& cells,
  const std::vector<glm::dvec3>& directions, size_t count);
}

#endif
