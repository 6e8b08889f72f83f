// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualLights/vtkIndirectDirections.h"

#include "vtkEnvironmentLight.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
std::vector<glm::dvec3> vtkIndirectDirections::MakeLattice(int count)
{
  std::vector<glm::dvec3> lattice;
  lattice.reserve(static_cast<size_t>(std::max(count, 0)));
  const double goldenAngle = vtkMath::Pi() * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i)
  {
    // World axes have no part in it: y is where most skies have their zenith.
    const double y = 1.0 - (2.0 * i + 1.0) / count;
    const double r = std::sqrt(std::max(0.0, 1.0 - y * y));
    const double angle = i * goldenAngle;
    lattice.emplace_back(r * std::cos(angle), y, r * std::sin(angle));
  }
  return lattice;
}

//------------------------------------------------------------------------------
std::vector<glm::dvec3> vtkIndirectDirections::Project(
  vtkEnvironmentLight* environment, const std::vector<glm::dvec3>& directions)
{
  std::vector<glm::dvec3> light(directions.size(), glm::dvec3(0.0));
  if (directions.empty())
  {
    return light;
  }
  for (const vtkEnvironmentLight::Cell& cell : environment->GetCells())
  {
    const glm::dvec3 d(cell.Direction[0], cell.Direction[1], cell.Direction[2]);
    size_t nearest = 0;
    double most = -2.0;
    for (size_t i = 0; i < directions.size(); ++i)
    {
      const double cosine = glm::dot(d, directions[i]);
      if (cosine > most)
      {
        most = cosine;
        nearest = i;
      }
    }
    light[nearest] += glm::dvec3(cell.Light[0], cell.Light[1], cell.Light[2]);
  }
  return light;
}
