// SPDX-License-Identifier: BSD-3-Clause
#include "Emitters/vtkIndirectSkyProjection.h"

#include "Emitters/vtkIndirectDirections.h"
#include "Emitters/vtkIndirectEmitterAccess.h"
#include "vtkEnvironmentLight.h"

#include <glm/gtc/type_ptr.hpp>

namespace
{
// A direction represents about a circle of its share of the sphere. The mean of a uniform sky's
// directions over this circle has the length 1 - 1/count. Light is narrow if its spread is half of
// that or less: for 256 directions, a circle of 5 degrees.
constexpr double NarrowShare = 0.5;
// A direction with more than this share of all light is strong, because its shadow is visible by
// itself: eight grey levels of 256 if it is hidden from a surface that faces it. At most 32
// directions have so much light.
constexpr double StrongShare = 1.0 / 32.0;
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyProjection::Result::IsStrong(size_t direction) const
{
  return SumColors(this->Light[direction]) > StrongShare * SumColors(this->Total);
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyProjection::Result::HasStrong() const
{
  bool strong = false;
  for (size_t i = 0; i < this->Light.size(); ++i)
  {
    strong = strong || this->IsStrong(i);
  }
  return strong;
}

//------------------------------------------------------------------------------
const vtkIndirectSkyProjection::Result& vtkIndirectSkyProjection::Find(
  vtkEnvironmentLight* environment, int count)
{
  // Reading the cells reads the texture, which may change the environment's time.
  const std::vector<vtkIndirectEmitterAccess::Cell>& cells =
    vtkIndirectEmitterAccess::GetCells(environment);
  if (this->Environment.Take({ "environment", environment }))
  {
    for (auto& known : this->Results)
    {
      known.second.Nearest.clear();
      known.second.Light.clear();
    }
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
  result.Total = glm::dvec3(0.0);
  result.Light.assign(result.Directions.size(), glm::dvec3(0.0));
  std::vector<glm::dvec3> means(result.Directions.size(), glm::dvec3(0.0));
  for (const vtkIndirectEmitterAccess::Cell& cell : cells)
  {
    const glm::dvec3 sent = glm::make_vec3(cell.Light);
    const glm::dvec3 direction = glm::make_vec3(cell.Direction);
    const size_t nearest = vtkIndirectDirections::FindNearest(direction, result.Directions);
    result.Nearest.push_back(nearest);
    result.Light[nearest] += sent;
    result.Total += sent;
    means[nearest] += SumColors(sent) * direction;
  }
  result.Middles = result.Directions;
  for (size_t i = 0; i < means.size(); ++i)
  {
    const double length = glm::length(means[i]);
    if (length > (1.0 - NarrowShare / count) * SumColors(result.Light[i]))
    {
      result.Middles[i] = means[i] / length;
    }
  }
  return result;
}
