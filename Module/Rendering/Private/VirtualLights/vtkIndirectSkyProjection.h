// SPDX-License-Identifier: BSD-3-Clause
// An environment's light by directions that are fixed in the world, found once a change for all who
// sum it.
#ifndef vtkIndirectSkyProjection_h
#define vtkIndirectSkyProjection_h

#include "vtkType.h" // for times

#include <glm/glm.hpp> // for directions
#include <map>         // for what is kept
#include <vector>      // for lists

class vtkEnvironmentLight;

class vtkIndirectSkyProjection
{
public:
  /** All of the light: each cell's in the direction nearest to it. */
  struct Result
  {
    std::vector<glm::dvec3> Directions; // a nested lattice, see vtkIndirectDirections
    std::vector<size_t> Nearest;        // a direction for each of the environment's cells
    std::vector<glm::dvec3> Light;      // of directions: radiance times solid angle
    /**
     * Where that light comes from, unit: the middle of what is narrow, such as a sun; else the
     * direction itself, so that a sky that turns changes weights alone.
     */
    std::vector<glm::dvec3> Middles;
  };

  /** That by so many directions, of the environment as it is; kept while it is the same. */
  const Result& Find(vtkEnvironmentLight* environment, int count);

private:
  std::map<int, Result> Results; // by the number of directions
  vtkEnvironmentLight* Environment = nullptr;
  vtkMTimeType Time = 0;
};

#endif
