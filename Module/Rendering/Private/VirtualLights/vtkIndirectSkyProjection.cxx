// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualLights/vtkIndirectSkyProjection.h"

#include "VirtualLights/vtkIndirectDirections.h"
#include "vtkEnvironmentLight.h"

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
  for (size_t i = 0; i < cells.size(); ++i)
  {
    const double* const sent = cells[i].Light;
    result.Light[result.Nearest[i]] += glm::dvec3(sent[0], sent[1], sent[2]);
  }
  return result;
}
