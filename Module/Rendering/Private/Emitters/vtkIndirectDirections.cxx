// SPDX-License-Identifier: BSD-3-Clause
#include "Emitters/vtkIndirectDirections.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <utility>

//------------------------------------------------------------------------------
std::vector<glm::dvec3> vtkIndirectDirections::MakeLattice(int count)
{
  std::vector<glm::dvec3> lattice;
  lattice.reserve(static_cast<size_t>(std::max(count, 0)));
  const double goldenAngle = vtkMath::Pi() * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i)
  {
    // The lattice's axis is y, because most skies have their zenith there.
    const double y = 1.0 - (2.0 * i + 1.0) / count;
    const double r = std::sqrt(std::max(0.0, 1.0 - y * y));
    const double angle = i * goldenAngle;
    lattice.emplace_back(r * std::cos(angle), y, r * std::sin(angle));
  }
  return lattice;
}

namespace
{
// Orders [first, end) so that each direction is the farthest from all directions before it.
void SpreadOut(std::vector<glm::dvec3>& directions, size_t first, size_t end)
{
  // Each direction has the cosine to the nearest direction before it.
  std::vector<double> nearest(end, -1.0);
  auto add = [&](size_t added, size_t from)
  {
    for (size_t i = from; i < end; ++i)
    {
      nearest[i] = std::max(nearest[i], glm::dot(directions[i], directions[added]));
    }
  };
  for (size_t k = 0; k < first; ++k)
  {
    add(k, first);
  }
  for (size_t k = first; k < end; ++k)
  {
    const auto farthest =
      std::min_element(nearest.begin() + static_cast<std::ptrdiff_t>(k), nearest.end());
    const size_t chosen = static_cast<size_t>(farthest - nearest.begin());
    std::swap(directions[k], directions[chosen]);
    std::swap(nearest[k], nearest[chosen]);
    add(k, k + 1);
  }
}
}

//------------------------------------------------------------------------------
std::vector<glm::dvec3> vtkIndirectDirections::MakeNestedLattice(int count)
{
  std::vector<glm::dvec3> nested = MakeLattice(count);
  for (int coarse = count / 4; coarse >= 16; coarse /= 4)
  {
    // Each place of a coarser lattice takes the nearest remaining direction.
    const std::vector<glm::dvec3> wanted = MakeLattice(coarse);
    for (size_t k = 0; k < wanted.size(); ++k)
    {
      size_t nearest = k;
      for (size_t i = k; i < 4 * wanted.size(); ++i)
      {
        nearest =
          glm::dot(wanted[k], nested[i]) > glm::dot(wanted[k], nested[nearest]) ? i : nearest;
      }
      std::swap(nested[k], nested[nearest]);
    }
  }
  size_t end = nested.size();
  while (end / 4 >= 16)
  {
    end /= 4;
  }
  for (size_t first = 0; first < nested.size(); first = end, end *= 4)
  {
    SpreadOut(nested, first, end);
  }
  return nested;
}

namespace
{
// Finds the nearest one of the directions from begin to end.
size_t FindNearestWithin(
  const glm::dvec3& direction, const std::vector<glm::dvec3>& directions, size_t begin, size_t end)
{
  size_t nearest = begin;
  double most = -2.0;
  for (size_t i = begin; i < end; ++i)
  {
    const double cosine = glm::dot(direction, directions[i]);
    if (cosine > most)
    {
      most = cosine;
      nearest = i;
    }
  }
  return nearest;
}
}

//------------------------------------------------------------------------------
size_t vtkIndirectDirections::FindNearest(
  const glm::dvec3& direction, const std::vector<glm::dvec3>& directions)
{
  return FindNearestWithin(direction, directions, 0, directions.size());
}

//------------------------------------------------------------------------------
size_t vtkIndirectDirections::FindNearestOfLattice(
  const glm::dvec3& direction, const std::vector<glm::dvec3>& lattice)
{
  // No direction is further than 3 / sqrt(n) from the nearest one, nor further away in height.
  const double count = static_cast<double>(lattice.size());
  const double middle = 0.5 * (1.0 - direction.y) * count;
  const double reach = 1.5 * std::sqrt(count) + 1.0;
  return FindNearestWithin(direction, lattice, static_cast<size_t>(std::max(middle - reach, 0.0)),
    static_cast<size_t>(std::min(middle + reach, count)));
}

//------------------------------------------------------------------------------
std::vector<std::pair<size_t, double>> vtkIndirectDirections::FindAround(
  const glm::dvec3& direction, const std::vector<glm::dvec3>& directions)
{
  // Among the triples of directions whose cone holds the direction, the plane of the hull's face
  // is the farthest from the origin along the direction. The sum of the weights is one over that
  // distance.
  std::vector<std::pair<size_t, double>> around;
  double least = 0.0;
  for (size_t i = 0; i < directions.size(); ++i)
  {
    for (size_t j = i + 1; j < directions.size(); ++j)
    {
      const glm::dvec3 normal = glm::cross(directions[i], directions[j]);
      for (size_t k = j + 1; k < directions.size(); ++k)
      {
        const double volume = glm::dot(normal, directions[k]);
        if (std::abs(volume) < 1e-6)
        {
          continue;
        }
        const glm::dvec3 weights =
          glm::dvec3(glm::dot(glm::cross(directions[j], directions[k]), direction),
            glm::dot(glm::cross(directions[k], directions[i]), direction),
            glm::dot(normal, direction)) /
          volume;
        const double sum = weights.x + weights.y + weights.z;
        if (std::min({ weights.x, weights.y, weights.z }) >= -1e-9 &&
          (around.empty() || sum < least))
        {
          least = sum;
          around = { { i, weights.x }, { j, weights.y }, { k, weights.z } };
        }
      }
    }
  }
  around.erase(std::remove_if(around.begin(), around.end(),
                 [](const auto& entry) { return !(entry.second > 0.0); }),
    around.end());
  return around;
}
