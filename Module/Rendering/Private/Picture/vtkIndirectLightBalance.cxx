// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/vtkIndirectLightBalance.h"

#include <algorithm>

namespace
{
// The picture's mean over plain VTK's that the balance aims at, and the least mean.
constexpr double Brightness = 1.0;
constexpr double LeastBrightness = 0.92;

// The greatest strength. Where the own light is weaker than this makes up for, as inside a closed
// room, lamps are kept.
constexpr double MostStrength = 1.6;

// The share of blocks with a pixel that may clip: single pixels at silhouettes bound no picture.
constexpr double Clipping = 0.002;
}

//------------------------------------------------------------------------------
vtkIndirectLightBalance vtkIndirectLightBalance::Find(const std::vector<Block>& blocks, double most)
{
  Block sum;
  std::vector<const Block*> drawn;
  for (const Block& block : blocks)
  {
    if (block.Plain > 0.0)
    {
      drawn.push_back(&block);
      sum.Plain += block.Plain;
      sum.Lamps += block.Lamps;
      sum.Own += block.Own;
    }
  }
  vtkIndirectLightBalance found;
  // The comparisons are false for what is not a number.
  if (!(sum.Own > 1e-6 * sum.Plain) || !(sum.Plain > 0.0))
  {
    return found;
  }
  std::vector<double> rooms(drawn.size());
  const auto findMost = [&](double replaced)
  {
    std::transform(drawn.begin(), drawn.end(), rooms.begin(),
      [replaced](const Block* block)
      { return (1.0 - replaced) * block->Room[0] + replaced * block->Room[1]; });
    const auto place =
      rooms.begin() + static_cast<std::ptrdiff_t>(Clipping * static_cast<double>(rooms.size()));
    std::nth_element(rooms.begin(), place, rooms.end());
    return std::min(*place, MostStrength);
  };
  // The strength that gives the picture this mean over plain VTK's.
  const auto findStrength = [&sum](double replaced, double brightness)
  { return ((brightness - 1.0) * sum.Plain + replaced * sum.Lamps) / sum.Own; };
  const auto fits = [&](double replaced)
  { return findStrength(replaced, LeastBrightness) <= findMost(replaced); };
  found.Replaced = most;
  if (!fits(most))
  {
    // All constraints are linear in share and strength, and none of both fits.
    double low = 0.0;
    for (int i = 0; i < 24; ++i)
    {
      const double middle = 0.5 * (low + found.Replaced);
      (fits(middle) ? low : found.Replaced) = middle;
    }
    found.Replaced = low;
  }
  found.Strength =
    std::max(std::min(findStrength(found.Replaced, Brightness), findMost(found.Replaced)), 0.0);
  return found;
}
