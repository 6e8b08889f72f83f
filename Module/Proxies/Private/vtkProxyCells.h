// SPDX-License-Identifier: BSD-3-Clause
// Positions sorted into cells of space.
#pragma once

#include <algorithm>   // for bounds
#include <cmath>       // for cells
#include <glm/glm.hpp> // for vectors
#include <limits>      // for bounds
#include <vector>      // for the members

/** Items with a Point, in cells of space, to find those that may lie in a ball. */
class vtkProxyCells
{
public:
  template <typename T>
  explicit vtkProxyCells(const std::vector<T>& items)
  {
    this->Low = glm::dvec3(std::numeric_limits<double>::max());
    this->High = -this->Low;
    for (const T& item : items)
    {
      this->Low = glm::min(this->Low, item.Point);
      this->High = glm::max(this->High, item.Point);
    }
    const glm::dvec3 extent = this->High - this->Low + 1e-6;
    this->Size = std::max(std::cbrt(extent.x * extent.y * extent.z / (items.size() / 4.0 + 1.0)),
      std::max(extent.x, std::max(extent.y, extent.z)) / 64.0);
    this->Counts = glm::ivec3(extent / this->Size) + 1;
    this->Starts.assign(
      static_cast<size_t>(this->Counts.x) * this->Counts.y * this->Counts.z + 1, 0);
    std::vector<int> cells(items.size());
    for (size_t i = 0; i < items.size(); ++i)
    {
      const glm::ivec3 c = this->CellOf(items[i].Point);
      cells[i] = (c.z * this->Counts.y + c.y) * this->Counts.x + c.x;
      ++this->Starts[static_cast<size_t>(cells[i]) + 1];
    }
    for (size_t i = 1; i < this->Starts.size(); ++i)
    {
      this->Starts[i] += this->Starts[i - 1];
    }
    std::vector<int> next(this->Starts.begin(), this->Starts.end() - 1);
    this->Items.resize(items.size());
    for (size_t i = 0; i < items.size(); ++i)
    {
      this->Items[static_cast<size_t>(next[static_cast<size_t>(cells[i])]++)] = static_cast<int>(i);
    }
  }

  template <typename F>
  void ForBall(const glm::dvec3& center, double radius, F&& function) const
  {
    const glm::ivec3 first = this->CellOf(center - radius);
    const glm::ivec3 last = this->CellOf(center + radius);
    for (int z = first.z; z <= last.z; ++z)
    {
      for (int y = first.y; y <= last.y; ++y)
      {
        const int row = (z * this->Counts.y + y) * this->Counts.x;
        const int end = this->Starts[static_cast<size_t>(row + last.x) + 1];
        for (int i = this->Starts[static_cast<size_t>(row + first.x)]; i < end; ++i)
        {
          function(this->Items[static_cast<size_t>(i)]);
        }
      }
    }
  }

private:
  glm::ivec3 CellOf(const glm::dvec3& p) const
  {
    const glm::dvec3 c = glm::floor((p - this->Low) / this->Size);
    return glm::ivec3(glm::clamp(c, glm::dvec3(0.0), glm::dvec3(this->Counts - 1)));
  }

  glm::dvec3 Low{ 0.0 };
  glm::dvec3 High{ 0.0 };
  double Size = 1.0;
  glm::ivec3 Counts{ 1 };
  std::vector<int> Starts;
  std::vector<int> Items;
};
