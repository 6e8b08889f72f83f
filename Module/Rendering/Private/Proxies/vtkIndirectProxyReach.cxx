// SPDX-License-Identifier: BSD-3-Clause
#include "Proxies/vtkIndirectProxyReach.h"

#include "Emitters/vtkIndirectDirections.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "Proxies/vtkIndirectCoefficient.h"
#include "Proxies/vtkIndirectProxyTable.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace vtkIndirectKernels;

namespace
{
constexpr int Directions = 256;
constexpr int Pairs = 8; // starting points of the search

// Climbs from two directions to a maximum of a function of both.
double Climb(const std::function<double(const vec3&, const vec3&)>& f, vec3& a, vec3& b)
{
  double best = f(a, b);
  for (float step = 0.12f; step > 2e-3f; step *= 0.5f)
  {
    for (bool better = true; better;)
    {
      better = false;
      for (int i = 0; i < 12; ++i)
      {
        vec3 to(0.0f);
        to[i % 3] = i % 6 < 3 ? step : -step;
        const vec3 x = i < 6 ? glm::normalize(a + to) : a;
        const vec3 y = i < 6 ? b : glm::normalize(b + to);
        const double value = f(x, y);
        if (value > best * (1.0 + 1e-6))
        {
          best = value;
          a = x;
          b = y;
          better = true;
        }
      }
    }
  }
  return best;
}

// Bands of the visibility that a sphere removes, turned to a direction, times its weight.
vec4 FindTaken(double sine, float weight)
{
  const double row =
    vtkiProxyRow(static_cast<float>(sine)) * static_cast<double>(vtkIndirectProxyEntries - 1);
  const int low = std::min(static_cast<int>(row), vtkIndirectProxyEntries - 2);
  vec4 zonal;
  for (int i = 0; i < 4; ++i)
  {
    const float first = vtkIndirectProxyTable[low][i];
    zonal[i] = weight * vtkiProxyRow(static_cast<float>(sine)) *
      (first + static_cast<float>(row - low) * (vtkIndirectProxyTable[low + 1][i] - first));
  }
  const vtkiHarmonics4 seen = vtkiHarmonicsExp(vtkiZonalTo(zonal, vec3(0.0f, 0.0f, 1.0f)));
  return vec4(1.0f / VTKI_HARMONICS_Y00 - seen.A.x, -seen.A.z, -seen.B.z, -seen.D.x);
}

// Distances over the reach at which the cut-off error may be largest: there the weight begins to
// fall more slowly than the sphere's solid angle.
const double Places[] = { 1.0, 0.99, 0.985, 0.98, 0.97, 0.95 };

// Returns the smallest reach whose cut-off error is at most this.
double Solve(const std::function<double(double sine, float weight)>& change, double most)
{
  auto isSmall = [&](double reach)
  {
    return std::all_of(std::begin(Places), std::end(Places),
      [&](double place)
      {
        return change(1.0 / (place * reach), vtkiProxyWithin(static_cast<float>(place), 1.0f)) <=
          most;
      });
  };
  double low = vtkIndirectProxyReach::Least;
  double high = vtkIndirectProxyReach::Most;
  if (isSmall(low))
  {
    return low;
  }
  while (high - low > 1e-4 * low)
  {
    const double middle = 0.5 * (low + high);
    (isSmall(middle) ? high : low) = middle;
  }
  return high;
}

// Returns the reach for one colour.
vtkIndirectProxyReach FindColor(const vtkiHarmonics4& light, bool middle)
{
  vtkIndirectProxyReach reach;
  const vtkiLightMatrix matrix = vtkiMakeLightMatrix(light);
  std::vector<vec3> directions;
  std::vector<vtkiHarmonics4> lit;
  std::vector<vtkiHarmonics4> at;
  double irradiance = 0.0;
  double radiance = 0.0;
  vec3 brightest(0.0f, 0.0f, 1.0f);
  for (const glm::dvec3& exact : vtkIndirectDirections::MakeLattice(Directions))
  {
    const vec3 d(exact);
    directions.push_back(d);
    lit.push_back(vtkiLitCosine(matrix, d));
    at.push_back(vtkiHarmonics4At(d));
    radiance = std::max(radiance, static_cast<double>(vtkiHarmonicsDot(light, at.back())));
    const double own = vtkiHarmonicsDot(light, vtkiClampedCosine(d));
    brightest = own > irradiance ? d : brightest;
    irradiance = std::max(irradiance, own);
  }
  vec3 unused(0.0f, 0.0f, 1.0f);
  irradiance = Climb([&](const vec3& n, const vec3&)
    { return static_cast<double>(vtkiHarmonicsDot(light, vtkiClampedCosine(n))); },
    brightest, unused);
  if (!(irradiance > 0.0))
  {
    return reach;
  }
  reach.Contrast = radiance / irradiance;

  // Pairs of a normal and a direction in which a small sphere removes or rings most.
  struct Pair
  {
    double Value;
    vec3 Normal;
    vec3 Direction;
  };
  std::vector<Pair> pairs;
  for (size_t n = 0; n < directions.size(); ++n)
  {
    for (size_t d = 0; d < directions.size(); ++d)
    {
      pairs.push_back({ std::abs(static_cast<double>(vtkiHarmonicsDot(lit[n], at[d]))),
        directions[n], directions[d] });
    }
  }
  std::partial_sort(pairs.begin(), pairs.begin() + Pairs, pairs.end(),
    [](const Pair& a, const Pair& b) { return a.Value > b.Value; });
  pairs.resize(Pairs);
  for (Pair& pair : pairs)
  {
    Climb(
      [&](const vec3& n, const vec3& d)
      {
        return std::abs(
          static_cast<double>(vtkiHarmonicsDot(vtkiLitCosine(matrix, n), vtkiHarmonics4At(d))));
      },
      pair.Normal, pair.Direction);
  }
  reach.Hides = Solve(
    [&](double sine, float weight)
    {
      const vec4 taken = FindTaken(sine, 1.0f) - FindTaken(sine, weight);
      double most = 0.0;
      for (const Pair& pair : pairs)
      {
        most = std::max(most,
          std::abs(static_cast<double>(vtkiHarmonicsDot(
            vtkiLitCosine(matrix, pair.Normal), vtkiZonalTo(taken, pair.Direction)))));
      }
      return most;
    },
    vtkIndirectProxyReach::Cut * irradiance);

  // A normal that faces the sphere gets most of its light.
  auto send = [&](const vec3& d, double sine)
  {
    return static_cast<double>(middle ? vtkiProxyRadianceAtMiddle(light, d)
                                      : vtkiProxyRadiance(light, d, static_cast<float>(sine)));
  };
  vec3 from = -brightest;
  Climb([&](const vec3& d, const vec3&) { return send(d, 0.0); }, from, unused);
  reach.Sends = Solve(
    [&](double sine, float weight) {
      return (1.0 - weight) * vtkiDiskIrradiance(static_cast<float>(sine), 1.0f) * send(from, sine);
    },
    vtkIndirectProxyReach::Cut * irradiance);
  return reach;
}
}

//------------------------------------------------------------------------------
vtkIndirectProxyReach vtkIndirectProxyReach::Find(const Coefficients& light, bool middle)
{
  vtkIndirectProxyReach reach;
  for (int color = 0; color < 3; ++color)
  {
    double size = 0.0;
    for (const glm::dvec3& c : light)
    {
      size = std::max(size, std::abs(c[color]));
    }
    if (!(size > 0.0) || !std::isfinite(size))
    {
      continue;
    }
    vtkiHarmonics4 one;
    for (int i = 0; i < 16; ++i)
    {
      vtkIndirectCoefficient(one, i) =
        static_cast<float>(light[static_cast<size_t>(i)][color] / size);
    }
    const vtkIndirectProxyReach own = FindColor(one, middle);
    reach.Hides = std::max(reach.Hides, own.Hides);
    reach.Sends = std::max(reach.Sends, own.Sends);
    reach.Contrast = std::max(reach.Contrast, own.Contrast);
  }
  return reach;
}
