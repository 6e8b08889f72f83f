// SPDX-License-Identifier: BSD-3-Clause
#include "vtkProxyMeasures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr int SurfaceSamples = 20000;
constexpr int VolumeSamples = 100000;
constexpr double BesideSample = 1e-5;

// Signed distance to the union of spheres: exact outside, a bound of the depth inside.
double DistanceToUnion(const std::vector<vtkProxySphere>& spheres, const glm::dvec3& p)
{
  double least = std::numeric_limits<double>::max();
  for (const vtkProxySphere& sphere : spheres)
  {
    const glm::dvec3 way = p - sphere.Center;
    const double reach = least + sphere.Radius;
    const double length2 = glm::dot(way, way);
    // Avoids a square root if the sphere cannot be nearer.
    if (!(reach > 0.0) || length2 >= reach * reach)
    {
      continue;
    }
    least = std::min(least, std::sqrt(length2) - sphere.Radius);
  }
  return least;
}
}

//------------------------------------------------------------------------------
void vtkProxyMeasures::Measure(const vtkProxySurface& surface, const vtkProxySolid& solid,
  const std::vector<vtkProxySphere>& spheres, double error)
{
  *this = vtkProxyMeasures();
  if (spheres.empty())
  {
    return;
  }
  int seen = 0;
  int covered = 0;
  double squares = 0.0;
  for (const vtkProxySurface::Sample& sample : surface.MakeSamples(SurfaceSamples))
  {
    if (solid.IsSolid(sample.Point + BesideSample * sample.Normal) &&
      solid.IsSolid(sample.Point - BesideSample * sample.Normal))
    {
      continue;
    }
    const double d = DistanceToUnion(spheres, sample.Point);
    ++seen;
    covered += d <= error ? 1 : 0;
    squares += d * d;
    this->MaximumGap = std::max(this->MaximumGap, d);
  }
  this->CoveredArea = seen ? static_cast<double>(covered) / seen : 1.0;
  this->RootMeanSquareError = seen ? std::sqrt(squares / seen) : 0.0;

  glm::dvec3 low = surface.GetLow();
  glm::dvec3 high = surface.GetHigh();
  for (const vtkProxySphere& sphere : spheres)
  {
    this->MaximumProtrusion =
      std::max(this->MaximumProtrusion, sphere.Radius - solid.GetDepth(sphere.Center));
    low = glm::min(low, sphere.Center - sphere.Radius);
    high = glm::max(high, sphere.Center + sphere.Radius);
  }
  const glm::dvec3 extent = high - low;
  int inside = 0;
  int insideBoth = 0;
  int outside = 0;
  for (int i = 0; i < VolumeSamples; ++i)
  {
    // Evenly spread over the box: Roberts 2018.
    const glm::dvec3 at = 0.5 +
      glm::dvec3(0.8191725133961645, 0.6710436067037893, 0.5497004779019703) *
        static_cast<double>(i);
    const glm::dvec3 p = low + extent * glm::fract(at);
    const bool inSolid = solid.IsSolid(p);
    const bool inUnion = DistanceToUnion(spheres, p) <= 0.0;
    inside += inSolid ? 1 : 0;
    insideBoth += inSolid && inUnion ? 1 : 0;
    outside += !inSolid && inUnion ? 1 : 0;
  }
  const double part = extent.x * extent.y * extent.z / VolumeSamples;
  this->SolidVolume = inside * part;
  this->CoveredVolume = inside ? static_cast<double>(insideBoth) / inside : 1.0;
  this->ProtrudingVolume = outside * part;
}
