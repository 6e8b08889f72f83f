// SPDX-License-Identifier: BSD-3-Clause
#include "Emitters/vtkIndirectSkyProjection.h"

#include "Emitters/vtkIndirectDirections.h"
#include "vtkEnvironmentLight.h"

#include <algorithm>
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
  const Cells& cells = vtkIndirectEmitterAccess::GetCells(environment);
  if (this->Environment.Take({ "environment", environment }))
  {
    for (auto& known : this->Results)
    {
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
  result.Directions.resize(static_cast<size_t>(count));
  result.Nearest.clear();
  for (const vtkIndirectEmitterAccess::Cell& cell : cells)
  {
    result.Nearest.push_back(
      vtkIndirectDirections::FindNearest(glm::make_vec3(cell.Direction), result.Directions));
  }
  Sum(result, cells, count);
  if (Refine(result, cells, count))
  {
    Sum(result, cells, count);
  }
  return result;
}

//------------------------------------------------------------------------------
// Sums the cells' light by direction, and finds the middles of narrow light.
void vtkIndirectSkyProjection::Sum(Result& result, const Cells& cells, int count)
{
  result.Total = glm::dvec3(0.0);
  result.Light.assign(result.Directions.size(), glm::dvec3(0.0));
  std::vector<glm::dvec3> means(result.Directions.size(), glm::dvec3(0.0));
  for (size_t i = 0; i < cells.size(); ++i)
  {
    const glm::dvec3 sent = glm::make_vec3(cells[i].Light);
    const size_t nearest = result.Nearest[i];
    result.Light[nearest] += sent;
    result.Total += sent;
    means[nearest] += SumColors(sent) * glm::make_vec3(cells[i].Direction);
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
}

//------------------------------------------------------------------------------
// Adds the directions of a lattice of four times as many around strong light that is not narrow,
// and gives them their cells. Returns true if there are any. Light of one direction of that lattice
// is narrow.
bool vtkIndirectSkyProjection::Refine(Result& result, const Cells& cells, int count)
{
  std::vector<bool> wide;
  for (size_t i = 0; i < result.Directions.size(); ++i)
  {
    wide.push_back(result.IsStrong(i) && result.Middles[i] == result.Directions[i]);
  }
  if (std::find(wide.begin(), wide.end(), true) == wide.end())
  {
    return false;
  }
  std::vector<glm::dvec3> added;
  for (const glm::dvec3& direction : vtkIndirectDirections::MakeLattice(4 * count))
  {
    if (wide[vtkIndirectDirections::FindNearest(direction, result.Directions)])
    {
      added.push_back(direction);
    }
  }
  for (size_t i = 0; i < cells.size(); ++i)
  {
    if (wide[result.Nearest[i]])
    {
      result.Nearest[i] = result.Directions.size() +
        vtkIndirectDirections::FindNearest(glm::make_vec3(cells[i].Direction), added);
    }
  }
  result.Directions.insert(result.Directions.end(), added.begin(), added.end());
  return true;
}
