// SPDX-License-Identifier: BSD-3-Clause
// An environment's light by directions that are fixed in the world. It is found once for each
// change and shared by all stages that sum it.
#pragma once

#include "Emitters/vtkIndirectEmitterAccess.h" // for cells
#include "OpenGL/vtkIndirectKey.h"             // for a member

#include <glm/glm.hpp> // for directions
#include <map>         // for kept results
#include <vector>      // for lists

class vtkEnvironmentLight;

class vtkIndirectSkyProjection
{
public:
  /** All of the light: each cell's light is in the direction nearest to it. */
  struct Result
  {
    /**
     * This is a nested lattice, see vtkIndirectDirections. Behind it stand the directions of a
     * finer lattice around strong light that is wide, such as a studio's soft boxes: by one
     * direction its shadow would have one sharp edge.
     */
    std::vector<glm::dvec3> Directions;
    std::vector<size_t> Nearest;   // nearest direction of each of the environment's cells
    std::vector<glm::dvec3> Light; // light of directions: radiance times solid angle
    /**
     * These are the unit directions that the light comes from: the middle of narrow light, such as
     * a sun's; otherwise the lattice's direction itself, so that a turning sky changes weights
     * alone.
     */
    std::vector<glm::dvec3> Middles;
    glm::dvec3 Total{ 0.0 }; // light of all directions

    /** Returns true if a direction has more than a 32nd of all light. */
    bool IsStrong(size_t direction) const;
    bool HasStrong() const;
  };

  /**
   * At least this many directions tell which light is strong: each of fewer directions may have
   * such a share.
   */
  static constexpr int FineDirections = 256;

  /**
   * Returns the environment's light by this many directions; it is kept while the environment is
   * the same.
   */
  const Result& Find(vtkEnvironmentLight* environment, int count = FineDirections);
  /** Returns light summed over the colours, by which directions are compared. */
  static double SumColors(const glm::dvec3& light) { return light.x + light.y + light.z; }

private:
  using Cells = std::vector<vtkIndirectEmitterAccess::Cell>;
  static void Sum(Result& result, const Cells& cells, int count);
  static bool Refine(Result& result, const Cells& cells, int count);

  std::map<int, Result> Results; // by the number of directions
  vtkIndirectKey Environment;
};
