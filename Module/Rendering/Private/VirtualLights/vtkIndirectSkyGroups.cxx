// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualLights/vtkIndirectSkyGroups.h"

#include "VirtualLights/vtkIndirectDirections.h"
#include "VirtualLights/vtkIndirectSkyProjection.h"
#include "vtkMath.h"

namespace
{
// Number of directions that may become groups of their own. vtkIndirectSkyGather sums over as many,
// so that the light of a sun is reflected at the place where it falls.
constexpr int NumberOfFineDirections = 256;

double Sum(const glm::dvec3& light)
{
  return light.x + light.y + light.z;
}

size_t FindNearest(const glm::dvec3& direction, const std::vector<glm::dvec3>& lattice)
{
  size_t nearest = 0;
  for (size_t i = 1; i < lattice.size(); ++i)
  {
    if (glm::dot(direction, lattice[i]) > glm::dot(direction, lattice[nearest]))
    {
      nearest = i;
    }
  }
  return nearest;
}
}

//------------------------------------------------------------------------------
std::vector<vtkIndirectSkyGroups::Group> vtkIndirectSkyGroups::Make(
  vtkIndirectSkyProjection& projection, vtkEnvironmentLight* environment)
{
  const vtkIndirectSkyProjection::Result& sky =
    projection.Find(environment, NumberOfFineDirections);
  const std::vector<glm::dvec3>& fine = sky.Directions;
  const std::vector<glm::dvec3>& light = sky.Light;
  const std::vector<glm::dvec3> coarse = vtkIndirectDirections::MakeLattice(NumberOfDirections);
  std::vector<Group> all;
  for (const glm::dvec3& direction : coarse)
  {
    all.push_back({ static_cast<int>(all.size()), direction, glm::dvec3(0.0) });
  }
  double total = 0.0;
  for (const glm::dvec3& l : light)
  {
    total += Sum(l);
  }
  for (size_t i = 0; i < fine.size(); ++i)
  {
    const glm::dvec3 strength = light[i] / vtkMath::Pi();
    if (Sum(light[i]) * NumberOfDirections > total)
    {
      all.push_back({ NumberOfDirections + static_cast<int>(i), sky.Middles[i], strength });
    }
    else
    {
      all[FindNearest(fine[i], coarse)].Strength += strength;
    }
  }
  std::vector<Group> lit;
  for (const Group& group : all)
  {
    if (Sum(group.Strength) > 0.0)
    {
      lit.push_back(group);
    }
  }
  return lit;
}
