// SPDX-License-Identifier: BSD-3-Clause
#include "vtkProxyBinding.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace
{
// A sphere's points are chosen from those within this many radii, and from at least this many.
constexpr double Reach = 1.2;
constexpr size_t LeastPool = 16;
}

//------------------------------------------------------------------------------
double vtkProxyBinding::GetSpread(const glm::dvec3* points, int count)
{
  glm::dvec3 mean(0.0);
  for (int i = 0; i < count; ++i)
  {
    mean += points[i] / static_cast<double>(count);
  }
  double sum = 0.0;
  for (int i = 0; i < count; ++i)
  {
    sum += glm::dot(points[i] - mean, points[i] - mean) / count;
  }
  return std::sqrt(sum);
}

//------------------------------------------------------------------------------
std::vector<vtkProxyBinding> vtkProxyBinding::Bind(
  const vtkProxySurface& surface, const std::vector<vtkProxySphere>& spheres)
{
  std::vector<long long> used;
  for (const vtkProxySurface::Triangle& triangle : surface.GetTriangles())
  {
    used.insert(used.end(), triangle.begin(), triangle.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const std::vector<glm::dvec3>& points = surface.GetPoints();

  std::vector<vtkProxyBinding> bindings(spheres.size());
  std::vector<std::pair<double, long long>> near(used.size());
  for (size_t s = 0; s < spheres.size(); ++s)
  {
    const vtkProxySphere& sphere = spheres[s];
    // Collects the points within the sphere's reach, and at least some.
    for (size_t i = 0; i < used.size(); ++i)
    {
      near[i] = { glm::length(points[static_cast<size_t>(used[i])] - sphere.Center), used[i] };
    }
    size_t pool = std::min<size_t>(LeastPool, near.size());
    std::partial_sort(near.begin(), near.begin() + static_cast<long>(pool), near.end());
    const double reach = Reach * sphere.Radius;
    const auto end = std::partition(near.begin() + static_cast<long>(pool), near.end(),
      [reach](const std::pair<double, long long>& n) { return n.first <= reach; });
    std::sort(near.begin() + static_cast<long>(pool), end);
    pool = static_cast<size_t>(end - near.begin());
    // Chooses those that are farthest from each other, all around the sphere.
    vtkProxyBinding& binding = bindings[s];
    std::vector<double> apart(pool, std::numeric_limits<double>::max());
    std::fill(std::begin(binding.Ids), std::end(binding.Ids), near[0].second);
    int count = std::min<int>(Count, static_cast<int>(pool));
    size_t next = 0;
    glm::dvec3 chosen[Count];
    for (int n = 0; n < count; ++n)
    {
      chosen[n] = points[static_cast<size_t>(near[next].second)];
      binding.Ids[n] = near[next].second;
      size_t farthest = 0;
      for (size_t i = 0; i < pool; ++i)
      {
        apart[i] =
          std::min(apart[i], glm::length(points[static_cast<size_t>(near[i].second)] - chosen[n]));
        farthest = apart[i] > apart[farthest] ? i : farthest;
      }
      next = farthest;
      if (!(apart[next] > 0.0))
      {
        count = n + 1; // all others are at the same positions
      }
    }
    // Least-squares weights of sum one whose mean is the center: w = 1/n + D (D^T D)^-1 (center -
    // mean), D the points relative to their mean. A flat set of points has a singular D^T D; a
    // small share of its trace leaves the unreachable part in the offset.
    glm::dvec3 mean(0.0);
    for (int n = 0; n < count; ++n)
    {
      mean += chosen[n] / static_cast<double>(count);
    }
    glm::dmat3 moments(0.0);
    for (int n = 0; n < count; ++n)
    {
      moments += glm::outerProduct(chosen[n] - mean, chosen[n] - mean);
    }
    const double trace = moments[0][0] + moments[1][1] + moments[2][2];
    glm::dvec3 sum(0.0);
    if (trace > 0.0)
    {
      const glm::dmat3 inverse = glm::inverse(moments + glm::dmat3(1e-9 * trace));
      // A second step removes most of the error from the share of the trace.
      glm::dvec3 way = inverse * (sphere.Center - mean);
      way += inverse * (sphere.Center - mean - moments * way);
      for (int n = 0; n < count; ++n)
      {
        binding.Weights[n] = 1.0 / count + glm::dot(chosen[n] - mean, way);
        sum += binding.Weights[n] * chosen[n];
      }
    }
    else
    {
      binding.Weights[0] = 1.0;
      sum = chosen[0];
    }
    binding.Offset = sphere.Center - sum;
    if (glm::length(binding.Offset) < 1e-7)
    {
      binding.Offset = glm::dvec3(0.0);
    }
    binding.Offset *= surface.GetDiagonal();
    binding.Spread = GetSpread(chosen, count) * surface.GetDiagonal();
  }
  return bindings;
}
