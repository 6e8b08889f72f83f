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
   * Takes what windows show from the windows instead of from their maps, and smaller squares of
   * texels around a window. Default off.
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
      for (int row = 0; row * step + step / 2 < source.Size[1]; ++row)
      {
        for (int column = 0; column * step + step / 2 < source.Size[0]; ++column)
        {
          Add(source, row, column, step, pattern);
        }
      }
    }
  }

private:
  // A square is at most this share of the distance to the window's middle wide.
  static constexpr double WidestSquare = 0.125;

  // Returns the share of a square of texels that is beside the source's window.
  static double FindShareBeside(const Source& source, const glm::dvec2& middle, double halfWidth)
  {
    const glm::dvec2 at = middle - source.MiddleOfWindow;
    const glm::dvec2 within =
      glm::min(at + halfWidth, source.HalfWindow) - glm::max(at - halfWidth, -source.HalfWindow);
    const glm::dvec2 share = glm::max(within, 0.0) / (2.0 * halfWidth);
    return 1.0 - share.x * share.y;
  }

  // Adds a square of texels, or its quarters where the window is near.
  static void Add(const Source& source, int row, int column, int step, std::vector<Sample>& pattern)
  {
    const double width = static_cast<double>(step) / source.Size[0];
    double share = 1.0;
    if (source.HalfWindow > 0.0)
    {
      const glm::dvec2 middle = width * glm::dvec2(column + 0.5, row + 0.5);
      const glm::dvec2 away = glm::abs(middle - source.MiddleOfWindow);
      const double distance = std::max({ away.x, away.y, source.HalfWindow });
      share = FindShareBeside(source, middle, 0.5 * width);
      if (step > 1 && share > 0.0 && width > WidestSquare * distance)
      {
        for (int quarter = 0; quarter < 4; ++quarter)
        {
          Add(source, 2 * row + quarter / 2, 2 * column + quarter % 2, step / 2, pattern);
        }
        return;
      }
    }
    if (!(share > 0.0))
    {
      return;
    }
    // Takes each of the four texels around a square's middle equally often: taking always the same
    // one would shift all lights by half a texel.
    const int j = row * step + (step - (row & 1)) / 2;
    const int i = column * step + (step - ((row + column) & 1)) / 2;
    pattern.push_back({ (i + 0.5f) / source.Size[0], (j + 0.5f) / source.Size[1],
      static_cast<float>(source.Layer), static_cast<float>(share * step * step) });
  }

  size_t MostLights = static_cast<size_t>(-1);
  bool Windows = false;
};
