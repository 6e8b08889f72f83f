// SPDX-License-Identifier: BSD-3-Clause
#include "Proxies/vtkIndirectProxySilhouette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
constexpr double Pi = 3.14159265358979323846;
// Ranges of the table: ratios of radii from 0 to 1, distances from 0 to Farthest times both radii.
constexpr int Ratios = 16;
constexpr int Distances = 64;
constexpr double Farthest = 2.0;

// Returns the area of the intersection of two disks at this distance, over pi; first >= second.
double FindLens(double first, double second, double apart)
{
  if (apart >= first + second)
  {
    return 0.0;
  }
  if (apart <= first - second)
  {
    return second * second;
  }
  const double a2 = first * first;
  const double b2 = second * second;
  const double toFirst = (apart * apart + a2 - b2) / (2.0 * apart);
  const double toSecond = apart - toFirst;
  const double half = std::sqrt(std::max(a2 - toFirst * toFirst, 0.0));
  return (a2 * std::atan2(half, toFirst) + b2 * std::atan2(half, toSecond) - apart * half) / Pi;
}

// Returns the overlap over the smaller disk's area; distance: over the sum of the radii.
double Integrate(double ratio, double distance)
{
  constexpr int steps = 64;
  const double apart = distance * (1.0 + ratio);
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const double cosine = (i + 0.5) / steps;
    sum += FindLens(1.0, ratio, apart * std::sqrt(1.0 - cosine * cosine));
  }
  return sum / (steps * ratio * ratio);
}

using OverlapTable = std::array<std::array<double, Distances + 1>, Ratios + 1>;

OverlapTable MakeOverlapTable()
{
  OverlapTable table;
  for (int i = 0; i <= Ratios; ++i)
  {
    // The least ratio is that of a point anywhere behind a disk.
    const double ratio = std::max(static_cast<double>(i) / Ratios, 1e-3);
    for (int k = 0; k <= Distances; ++k)
    {
      table[static_cast<size_t>(i)][static_cast<size_t>(k)] =
        Integrate(ratio, Farthest * k / Distances);
    }
  }
  return table;
}
}

//------------------------------------------------------------------------------
double vtkIndirectProxySilhouette::FindOverlap(double first, double second, double distance)
{
  static const OverlapTable table = MakeOverlapTable();
  const double large = std::max(first, second);
  const double small = std::min(first, second);
  const double place = distance / (first + second) * (Distances / Farthest);
  if (!(place < Distances))
  {
    // The product of both areas over that of the sphere of directions, with its second-order term.
    const double share = large * large / (distance * distance);
    return 0.5 * share + 0.125 * share * (share + small * small / (distance * distance));
  }
  const double row = Ratios * small / large;
  const size_t i = std::min(static_cast<size_t>(row), static_cast<size_t>(Ratios - 1));
  const size_t k = static_cast<size_t>(place);
  const double u = row - static_cast<double>(i);
  const double v = place - static_cast<double>(k);
  return (1.0 - u) * ((1.0 - v) * table[i][k] + v * table[i][k + 1]) +
    u * ((1.0 - v) * table[i + 1][k] + v * table[i + 1][k + 1]);
}

//------------------------------------------------------------------------------
double vtkIndirectProxySilhouette::FindArea(const Ball* balls, int count)
{
  double area = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const Ball& ball = balls[i];
    const double own = ball.Radius * ball.Radius;
    double left = ball.Share;
    for (int k = 0; k < i; ++k)
    {
      const Ball& other = balls[k];
      const double smaller = std::min(own, other.Radius * other.Radius);
      const double covered =
        FindOverlap(ball.Radius, other.Radius, glm::length(ball.Center - other.Center)) * smaller;
      left *= 1.0 - std::min(other.Share * covered / own, 1.0);
    }
    area += own * left;
  }
  return area;
}
