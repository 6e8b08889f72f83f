// SPDX-License-Identifier: BSD-3-Clause
// Balance of a preset's light and the renderer's lamps, in cases whose answers are known.
#include "vtkIndirectTestUtilities.h"

#include "Picture/vtkIndirectLightBalance.h"

#include <string>
#include <vector>

using namespace vtkIndirectTest;

namespace
{
using Balance = vtkIndirectLightBalance;

// Returns blocks of one pixel each, whose brightest channel is the mean of all.
Balance::Block MakeBlock(double plain, double lamps, double own)
{
  return { plain, lamps, own, { (1.0 - plain) / own, (1.0 - plain + lamps) / own } };
}

double FindBrightness(const Balance& balance, const std::vector<Balance::Block>& blocks)
{
  double picture = 0.0;
  double plain = 0.0;
  for (const Balance::Block& block : blocks)
  {
    picture += block.Plain - balance.Replaced * block.Lamps + balance.Strength * block.Own;
    plain += block.Plain;
  }
  return picture / plain;
}
}

VTK_INDIRECT_TEST(LightBalance)
{
  const char* const why = "rounding, and 24 halvings";
  // With room everything is replaced, at the strength that keeps the picture's brightness.
  const std::vector<Balance::Block> grey(100, MakeBlock(0.5, 0.5, 0.4));
  Balance balance = Balance::Find(grey, 1.0);
  CheckEqual("all is replaced", balance.Replaced, 1.0);
  CheckRelative("as bright as before", balance.Strength, 0.5 / 0.4, 1e-12, why);
  balance = Balance::Find(grey, 0.5);
  CheckEqual("half is replaced", balance.Replaced, 0.5);
  CheckRelative("half as bright as before", balance.Strength, 0.25 / 0.4, 1e-12, why);

  // Highlights and other light that lamps do not give diffusely are kept.
  balance = Balance::Find(std::vector<Balance::Block>(100, MakeBlock(0.5, 0.3, 0.4)), 1.0);
  CheckEqual("all of the lamps' light is replaced", balance.Replaced, 1.0);
  CheckRelative("and nothing else", balance.Strength, 0.3 / 0.4, 1e-12, why);

  // Pixels that would clip bound the strength; the picture may become 8 % darker for this.
  std::vector<Balance::Block> uneven(90, MakeBlock(0.5, 0.5, 0.3));
  uneven.insert(uneven.end(), 10, MakeBlock(0.8, 0.8, 0.9));
  balance = Balance::Find(uneven, 1.0);
  CheckAtMost(
    "nothing clips", 0.8 - balance.Replaced * 0.8 + balance.Strength * 0.9, 1.0 + 1e-6, why);
  CheckRelative("as dark as it may be", FindBrightness(balance, uneven), 0.92, 1e-6, why);
  CheckAtLeast("a part is replaced", balance.Replaced, 0.1, "the whole room is used");

  // In a closed room the sky gives next to nothing: lamps stay, at the greatest strength.
  const std::vector<Balance::Block> closed(100, MakeBlock(0.5, 0.5, 0.1));
  balance = Balance::Find(closed, 1.0);
  CheckRelative("strength in a closed room", balance.Strength, 1.6, 1e-6, why);
  CheckRelative("brightness in a closed room", FindBrightness(balance, closed), 0.92, 1e-6, why);

  // Without light, or without pixels, VTK's picture stays.
  for (const std::vector<Balance::Block>& none :
    { std::vector<Balance::Block>(), std::vector<Balance::Block>(9),
      std::vector<Balance::Block>(9, { 0.5, 0.5, 0.0, { 1e3, 1e3 } }) })
  {
    CheckEqual("nothing is replaced", Balance::Find(none, 1.0).Replaced, 0.0);
  }
}
