// SPDX-License-Identifier: BSD-3-Clause
// Makes every texel of every map a virtual light of its own: the reference that other samplers
// converge to. If there are too many texels, it makes one light for each square of 2 x 2, 4 x 4,
// ... texels.
#pragma once

#include "Senders/vtkIndirectMapSampler.h"

#include <algorithm> // for the smallest map

class vtkIndirectAllTexelsSampler : public vtkIndirectMapSampler
{
public:
  vtkIndirectSamplerAbilities GetAbilities() const override
  {
    vtkIndirectSamplerAbilities abilities;
    abilities.NumberOfLights = VTK_INT_MAX;
    return abilities;
  }
  /**
   * Sets the largest number of lights; it is kept as long as there are two texels along an edge.
   */
  void SetMostLights(size_t count) { this->MostLights = count; }

  /**
   * Adds the texels of windows, which show a part of their maps again: the caller drops one of
   * both. Default off.
   */
  void SetWindows(bool windows) { this->Windows = windows; }
  bool TakesWindows() const override { return this->Windows; }

  void MakePattern(const std::vector<Source>& sources, std::vector<Sample>& pattern) override
  {
    size_t all = 0;
    int edge = VTK_INT_MAX;
    for (const Source& source : sources)
    {
      all += static_cast<size_t>(source.Size[0]) * static_cast<size_t>(source.Size[1]);
      edge = std::min({ edge, source.Size[0], source.Size[1] });
    }
    int step = 1;
    while (all / static_cast<size_t>(step) / static_cast<size_t>(step) > this->MostLights &&
      edge % (2 * step) == 0)
    {
      step *= 2;
    }
    for (const Source& source : sources)
    {
      // Takes each of the four texels around a square's middle equally often: taking always the
      // same one would shift all lights by half a texel.
      for (int row = 0; row * step + step / 2 < source.Size[1]; ++row)
      {
        const int j = row * step + (step - (row & 1)) / 2;
        for (int column = 0; column * step + step / 2 < source.Size[0]; ++column)
        {
          const int i = column * step + (step - ((row + column) & 1)) / 2;
          pattern.push_back({ (i + 0.5f) / source.Size[0], (j + 0.5f) / source.Size[1],
            static_cast<float>(source.Layer), static_cast<float>(step * step) });
        }
      }
    }
  }

private:
  size_t MostLights = static_cast<size_t>(-1);
  bool Windows = false;
};
