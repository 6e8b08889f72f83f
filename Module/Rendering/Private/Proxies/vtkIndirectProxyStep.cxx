// SPDX-License-Identifier: BSD-3-Clause
#include "Proxies/vtkIndirectProxyStep.h"

#include "Scene/vtkIndirectFrame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Returns the median radius of spheres in front of the eye, in pixels; infinite without spheres.
// Samples large sets.
double FindRadiusInPixels(
  const vtkIndirectFrame& frame, const std::vector<vtkIndirectProxySphere>& spheres)
{
  constexpr size_t most = 512;
  const glm::dmat4 sceneToView = glm::inverse(frame.ViewToScene);
  const size_t count = std::min(spheres.size(), most);
  std::vector<double> radii;
  for (size_t i = 0; i < count; ++i)
  {
    const vtkIndirectProxySphere& sphere = spheres[i * spheres.size() / count];
    const double depth = -(sceneToView * glm::dvec4(sphere.Center, 1.0)).z;
    const double pixel =
      glm::length(frame.RayOrigin[0] + depth * frame.RayDirection[0]) * 2.0 / frame.Size[0];
    if (depth > 0.0 && pixel > 0.0)
    {
      radii.push_back(sphere.Radius / pixel);
    }
  }
  if (radii.empty())
  {
    return std::numeric_limits<double>::infinity();
  }
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return *middle;
}

// A view with this many receivers is about as fine as thousands of spheres; the cost goes with
// their number. Pixels between receivers on different spheres have no light of their own: if the
// next receiver would be on another sphere, there are up to four times as many.
int FindStep(const int size[2], double radius)
{
  constexpr double receivers = 16384.0;
  const double pixels = static_cast<double>(size[0]) * size[1];
  const auto step = [&](double number)
  {
    return std::min(std::max(static_cast<int>(std::lround(std::sqrt(pixels / number))), 1),
      vtkIndirectProxyStep::Most);
  };
  const int usual = step(receivers);
  return radius < usual ? std::min(usual, std::max(step(4.0 * receivers), static_cast<int>(radius)))
                        : usual;
}
}

//------------------------------------------------------------------------------
int vtkIndirectProxyStep::Find(
  const vtkIndirectFrame& frame, const std::vector<vtkIndirectProxySphere>& spheres)
{
  return this->Find(frame.Size, FindRadiusInPixels(frame, spheres));
}

//------------------------------------------------------------------------------
int vtkIndirectProxyStep::Find(const int size[2], double radius)
{
  const bool first = this->Last == 0 || !std::equal(size, size + 2, this->Size);
  // Steps grow with the radius: the steps at both ends of the margin enclose all between.
  if (first || this->Last < FindStep(size, (1.0 - Margin) * radius) ||
    this->Last > FindStep(size, (1.0 + Margin) * radius))
  {
    this->Last = FindStep(size, radius);
    std::copy(size, size + 2, this->Size);
  }
  return this->Last;
}
