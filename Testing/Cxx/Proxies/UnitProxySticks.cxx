// SPDX-License-Identifier: BSD-3-Clause
// Rows of spheres in place of sticks.
#include "vtkIndirectTestUtilities.h"

#include "Proxies/vtkIndirectProxySticks.h"
#include "vtkMath.h"

#include <cmath>
#include <limits>

using namespace vtkIndirectTest;

//------------------------------------------------------------------------------
// What spheres of a row hide, meaned over directions, is what the mantle does: Cauchy's quarter of
// the area of either.
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
