// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualLights/vtkIndirectSkyProjection.h"

#include "VirtualLights/vtkIndirectDirections.h"
#include "vtkEnvironmentLight.h"

namespace
{
// A direction represents about a circle of its share of the sphere. The mean of a uniform sky's
// directions over this circle has the length 1 - 1/count. Light is narrow if its spread is half of
// that or less: for 256 directions, a circle of 5 degrees.
constexpr double NarrowShare = 0.5;
}

//------------------------------------------------------------------------------
const vtkIndirectSkyProjection::Result& vtkIndirectSkyProjection::Find(
  vtkEnvironmentLight* environment, int count)
{
  const vtkMTimeType time = environment->GetMTime();
  if (environment != this->Environment || time != this->Time)
  {
    for (auto& known : this->Results)
    {
      known.second.Nearest.clear();
      known.second.Light.clear();
    }
    this->Environment = environment;
    this->Time = time;
  }
  Result& result = this->Results[count];
  if (!result.Light.empty())
  {
    return result;
  }
  if (result.Directions.empty())
  {
    result.Directions = vtkIndirectDirections::MakeNestedLattice(count);
  }
  const std::vector<vtkEnvironmentLight::Cell>& cells = environment->GetCells();
  result.Nearest =
    vtkIndirectDirections::FindNearest(cells, result.Directions, result.Directions.size());
  result.Light.assign(result.Directions.size(), glm::dvec3(0.0));
  std::vector<glm::dvec3> means(result.Directions.size(), glm::dvec3(0.0));
  for (size_t i = 0; i < cells.size(); ++i)
  {
    const double* const sent = cells[i].Light;
    const double* const from = cells[i].Direction;
    result.Light[result.Nearest[i]] += glm::dvec3(sent[0], sent[1], sent[2]);
    means[result.Nearest[i]] +=
      (sent[0] + sent[1] + sent[2]) * glm::dvec3(from[0], from[1], from[2]);
  }
  result.Middles = result.Directions;
  for (size_t i = 0; i < means.size(); ++i)
  {
    const double length = glm::length(means[i]);
    const glm::dvec3& light = result.Light[i];
    if (length > (1.0 - NarrowShare / count) * (light.x + light.y + light.z))
    {
      result.Middles[i] = means[i] / length;
    }
  }
  return result;
}
