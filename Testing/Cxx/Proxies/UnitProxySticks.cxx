// SPDX-License-Identifier: BSD-3-Clause
// Rows of spheres in place of sticks.
#include "vtkIndirectTestUtilities.h"

#include "Proxies/vtkIndirectProxySticks.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace vtkIndirectTest;

//------------------------------------------------------------------------------
// A row's spheres hide, averaged over directions, as much as the stick's mantle: Cauchy's quarter
// of the area of either.
VTK_INDIRECT_TEST(ProxySticksRow)
{
  for (const double radius : { 1e-3, 0.075, 0.15, 2.0 })
  {
    for (const double length : { 1e-2, 0.75, 1.5, 40.0 })
    {
      double own = 0.0;
      const int count = vtkIndirectProxySticks::FindRow(length, radius, own);
      const double mantle = 2.0 * vtkMath::Pi() * radius * length / 4.0;
      const double row = count * vtkMath::Pi() * own * own;
      Check("some, not many", count >= 1 && count <= vtkIndirectProxySticks::MostSpheresOfAStick);
      CheckAtMost("cross sections", std::abs(row / mantle - 1.0), 1e-14, "rounding");
    }
  }
  // A stick of whole spheres: they touch.
  double own = 0.0;
  Check("five of them", vtkIndirectProxySticks::FindRow(1.5, 0.15, own) == 5);
  CheckAtMost("its radius", std::abs(own - 0.15), 1e-15, "rounding");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
  {
    Check("no length", vtkIndirectProxySticks::FindRow(wrong, 1.0, own) == 0);
    Check("no radius", vtkIndirectProxySticks::FindRow(1.0, wrong, own) == 0);
  }
}

//------------------------------------------------------------------------------
// Rows for segments lie inside of the stick, and are hardly thinner from any side.
VTK_INDIRECT_TEST(ProxySticksInside)
{
  for (const double radius : { 1e-3, 0.15, 2.0 })
  {
    for (const double length : { 0.3, 1.5, 40.0 })
    {
      const int count = vtkIndirectProxySticks::FindRowInside(length, radius);
      const double apart = length / count;
      Check("some", count >= 1);
      if (count == vtkIndirectProxySticks::MostSpheresInsideAStick)
      {
        continue;
      }
      CheckAtMost("spacing over the radius", apart / radius, 1.0 + 1e-12, "what it is made for");
      // Mean half width from the side over the radius: that of a circle up to half the spacing.
      double sum = 0.0;
      const int steps = 1000;
      for (int i = 0; i < steps; ++i)
      {
        const double x = 0.5 * apart / radius * (i + 0.5) / steps;
        sum += std::sqrt(std::max(0.0, 1.0 - x * x)) / steps;
      }
      CheckAtLeast("mean width over the stick's", sum, 0.956, "4.4 % at a spacing of a radius");
    }
  }
  CheckEqual("a stick as thin as a hair", vtkIndirectProxySticks::FindRowInside(1.0, 1e-9),
    vtkIndirectProxySticks::MostSpheresInsideAStick);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
  {
    CheckEqual("no length", vtkIndirectProxySticks::FindRowInside(wrong, 1.0), 0);
    CheckEqual("no radius", vtkIndirectProxySticks::FindRowInside(1.0, wrong), 0);
  }
}
