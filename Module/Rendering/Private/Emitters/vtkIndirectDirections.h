// SPDX-License-Identifier: BSD-3-Clause
// Directions in which an environment is sampled; each of them represents what is nearest to it.
#pragma once

#include <glm/glm.hpp> // for directions
#include <utility>     // for weights
#include <vector>      // for lists

namespace vtkIndirectDirections
{
/**
 * Makes a Fibonacci lattice on the sphere (Gonzalez 2010, "Measurement of areas on a sphere using
 * Fibonacci and latitude-longitude lattices"): places of equal area, fixed in the world.
 */
std::vector<glm::dvec3> MakeLattice(int count);

/**
 * Makes the same places in a nested order. The first quarter of them is spread evenly over the
 * sphere, as is the first quarter of that quarter, and so on down to sixteen: they are the places
 * nearest to a lattice of their number. Between these, each place is the farthest from all places
 * before it (Gonzalez 1985, "Clustering to minimize the maximum intercluster distance"), so that
 * any number of first places is spread out.
 */
std::vector<glm::dvec3> MakeNestedLattice(int count);

/** Returns the number of the one of `directions` that is nearest to a direction; all are unit. */
size_t FindNearest(const glm::dvec3& direction, const std::vector<glm::dvec3>& directions);

/**
 * Returns the same number for a lattice of MakeLattice, by comparing with those of its directions
 * that are as high.
 */
size_t FindNearestOfLattice(const glm::dvec3& direction, const std::vector<glm::dvec3>& lattice);

/**
 * Returns three directions around a direction, and weights, none below zero, with which their sum
 * is the direction itself. The directions are a face of the convex hull of all of them, so that the
 * weights change smoothly with the direction. Fewer directions are returned if they suffice.
 */
std::vector<std::pair<size_t, double>> FindAround(
  const glm::dvec3& direction, const std::vector<glm::dvec3>& directions);
}
