// SPDX-License-Identifier: BSD-3-Clause
// Pixels from one receiver of proxies to the next: by radii in pixels, with hysteresis at the
// limits.
#include "vtkIndirectTestUtilities.h"

#include "Proxies/vtkIndirectProxyStep.h"

#include <limits>
#include <string>

using namespace vtkIndirectTest;

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(ProxyStepBySpheres)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  struct Case
  {
    int Size[2];
    double Radius;
    int Step;
  };
  // About 16,384 receivers; four times as many, at most 8 pixels apart, if spheres are small.
  for (const Case& c : { Case{ { 128, 96 }, none, 1 }, Case{ { 384, 288 }, none, 3 },
         Case{ { 384, 288 }, 3.0, 3 }, Case{ { 384, 288 }, 2.9, 2 }, Case{ { 384, 288 }, 0.1, 1 },
         Case{ { 1024, 1024 }, none, 8 }, Case{ { 1024, 1024 }, 5.5, 5 },
         Case{ { 1024, 1024 }, 2.0, 4 }, Case{ { 4096, 4096 }, none, 8 } })
  {
    vtkIndirectProxyStep step;
    CheckEqual(
      "spheres of " + std::to_string(c.Radius) + " pixels", step.Find(c.Size, c.Radius), c.Step);
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(ProxyStepKeeps)
{
  const int size[2] = { 1024, 1024 };
  const int other[2] = { 1024, 1000 };
  vtkIndirectProxyStep step;
  CheckEqual("at first", step.Find(size, 5.9), 5);
  // Back and forth across 6 pixels, within 0.15 of the radius; then beyond.
  for (const double radius : { 6.1, 5.9, 6.8, 5.0, 4.4, 6.9 })
  {
    CheckEqual(std::to_string(radius) + " pixels", step.Find(size, radius), 5);
  }
  CheckEqual("beyond", step.Find(size, 7.1), 7);
  CheckEqual("and back", step.Find(size, 6.9), 7);
  CheckEqual("within what 7 is kept for", step.Find(size, 6.2), 7);
  CheckEqual("far below", step.Find(size, 5.9), 5);
  CheckEqual("in another size", step.Find(other, 6.1), 6);
  CheckEqual("kept there", step.Find(other, 5.9), 6);
  step.Forget();
  CheckEqual("forgotten", step.Find(other, 5.9), 5);
}
