// SPDX-License-Identifier: BSD-3-Clause
// Hierarchical warping with the shaders' own source: selection, frequency and weight of samples.
#include "OpenGL/vtkIndirectKernels.h"
#include "Senders/vtkIndirectSamplePattern.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

namespace
{
// A chart with sums over its squares, added in double precision.
class Chart
{
public:
  Chart(int levels, const std::function<double(int, int)>& importance)
    : Levels(levels)
    , Cells(1 << levels)
  {
    this->Sums.resize(static_cast<size_t>(levels) + 1);
    for (int y = 0; y < this->Cells; ++y)
    {
      for (int x = 0; x < this->Cells; ++x)
      {
        this->Sums[0].push_back(importance(x, y));
      }
    }
    for (int level = 1; level <= levels; ++level)
    {
      const int edge = this->Cells >> level;
      for (int y = 0; y < edge; ++y)
      {
        for (int x = 0; x < edge; ++x)
        {
          this->Sums[level].push_back(this->At(level - 1, 2 * x, 2 * y) +
            this->At(level - 1, 2 * x + 1, 2 * y) + this->At(level - 1, 2 * x, 2 * y + 1) +
            this->At(level - 1, 2 * x + 1, 2 * y + 1));
        }
      }
    }
  }

  struct Choice
  {
    ivec2 Cell{ 0, 0 };
    double Probability = 1.0;
    vec2 Place;
  };
  // levels: number of warped levels, from the top on.
  Choice Draw(vec2 place, int method, int levels) const
  {
    Choice choice;
    float probability = 1.0f;
    for (int level = this->Levels - 1; level >= 0; --level)
    {
      const int x = 2 * choice.Cell.x;
      const int y = 2 * choice.Cell.y;
      const vec4 quadrants(this->At(level, x, y), this->At(level, x + 1, y),
        this->At(level, x, y + 1), this->At(level, x + 1, y + 1));
      const int how = this->Levels - level > levels ? VTKI_WARP_EVENLY : method;
      choice.Cell = 2 * choice.Cell + vtkiWarpQuadrant(quadrants, how, place, probability);
    }
    choice.Probability = static_cast<double>(probability);
    choice.Place = place;
    return choice;
  }

  double At(int level, int x, int y) const
  {
    return this->Sums[level][static_cast<size_t>(y) * (this->Cells >> level) + x];
  }
  double GetTotal() const { return this->Sums[this->Levels][0]; }

  int Levels;
  int Cells;

private:
  std::vector<std::vector<double>> Sums;
};

// Rare bright cells and empty ones, with whole empty quadrants.
double Patchy(int x, int y)
{
  Random random(static_cast<unsigned int>(1000 * y + x));
  const double value = random.Next(0.0, 1.0);
  const bool empty = (x < 8 && y >= 8) || value < 0.4;
  return empty ? 0.0 : (value > 0.97 ? 100.0 : 0.01 + value);
}
}

// Cells are drawn in proportion to their importance, and the probability equals that exactly.
VTK_INDIRECT_TEST(ImportanceWarpDistribution)
{
  const Chart chart(4, Patchy);
  constexpr int draws = 400000;
  Random random(7);
  std::vector<double> counts(256, 0.0);
  double worst = 0.0;
  int empty = 0;
  for (int i = 0; i < draws; ++i)
  {
    const vec2 place(random.Next(0.0, 1.0), random.Next(0.0, 1.0));
    const Chart::Choice choice =
      chart.Draw(glm::min(place, vec2(VTKI_BELOW_ONE)), VTKI_WARP_APART, 99);
    const double own = chart.At(0, choice.Cell.x, choice.Cell.y);
    empty += own > 0.0 ? 0 : 1;
    worst = std::max(worst, std::abs(choice.Probability / (own / chart.GetTotal()) - 1.0));
    counts[16 * choice.Cell.y + choice.Cell.x] += 1.0;
  }
  double chiSquare = 0.0;
  int freedom = -1;
  for (int i = 0; i < 256; ++i)
  {
    const double expected = draws * chart.At(0, i % 16, i / 16) / chart.GetTotal();
    if (expected > 0.0)
    {
      chiSquare += std::pow(counts[i] - expected, 2.0) / expected;
      ++freedom;
    }
  }
  CheckEqual("empty cells that were drawn", empty, 0);
  CheckAtMost("probability over share of the importance, less one", worst, 2e-6,
    "thirty roundings of sums, divisions and products, 6e-8 each");
  // Mean f, variance 2 f: five standard deviations.
  CheckAtMost("chi-square of drawn cells", chiSquare, freedom + 5.0 * std::sqrt(2.0 * freedom),
    "five standard deviations");
  CheckAtLeast("degrees of freedom", freedom, 80, "the test's own power");
}

// For every method and number of levels weights make sums right, and no empty cell is drawn.
VTK_INDIRECT_TEST(ImportanceWarpMethods)
{
  const Chart chart(4, Patchy);
  for (const int method : { VTKI_WARP_APART, VTKI_WARP_TOGETHER, VTKI_WARP_EVENLY })
  {
    for (const int levels : { 0, 1, 2, 3, 4, 99 })
    {
      constexpr int edge = 1000;
      double sum = 0.0;
      double area = 0.0;
      int empty = 0;
      for (int i = 0; i < edge * edge; ++i)
      {
        const vec2 place((i % edge + 0.5) / edge, (i / edge + 0.5) / edge);
        const Chart::Choice choice = chart.Draw(place, method, levels);
        const double own = chart.At(0, choice.Cell.x, choice.Cell.y);
        empty += own > 0.0 ? 0 : 1;
        sum += own / choice.Probability / edge / edge;
        area += 1.0 / choice.Probability / edge / edge;
      }
      double cells = 0.0;
      for (int i = 0; i < 256; ++i)
      {
        cells += chart.At(0, i % 16, i / 16) > 0.0 ? 1.0 : 0.0;
      }
      const std::string what =
        "method " + std::to_string(method) + ", " + std::to_string(levels) + " levels: ";
      CheckEqual(what + "empty cells that were drawn", empty, 0);
      CheckRelative(what + "weighted sum", sum, chart.GetTotal(), 0.02,
        "a grid of a million over parts of a ten-thousandth and more");
      CheckRelative(what + "sum of weights", area, cells, 0.02,
        "a grid of a million over parts of a ten-thousandth and more");
    }
  }
}

VTK_INDIRECT_TEST(ImportanceWarpEdges)
{
  // An even chart keeps each place, up to rounding.
  const Chart even(5, [](int, int) { return 3.0; });
  double worst = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    const double u = (i + 0.5) / 1000;
    const double v = vtkIndirectSamplePattern::GoldenRatioFraction(i);
    const Chart::Choice choice = even.Draw(vec2(u, v), VTKI_WARP_APART, 99);
    worst = std::max({ worst, std::abs((choice.Cell.x + choice.Place.x) / 32.0 - u),
      std::abs((choice.Cell.y + choice.Place.y) / 32.0 - v) });
  }
  CheckAtMost("how far an even chart moves places", worst, 1e-6, "rounding");
  // A single cell is drawn from every place, also from the corners of the square, with probability
  // one; for the smallest and the largest numbers.
  for (const double size : { 1e-30, 1e-9, 1.0, 1e6, 1e30 })
  {
    for (int cell = 0; cell < 16; ++cell)
    {
      const Chart alone(2, [=](int x, int y) { return 4 * y + x == cell ? size : 0.0; });
      for (const float x : { 0.0f, 0.5f, VTKI_BELOW_ONE })
      {
        for (const float y : { 0.0f, 0.5f, VTKI_BELOW_ONE })
        {
          const Chart::Choice choice = alone.Draw(vec2(x, y), VTKI_WARP_APART, 99);
          if (4 * choice.Cell.y + choice.Cell.x != cell || choice.Probability != 1.0)
          {
            Check(
              "a cell alone is drawn from " + std::to_string(x) + ", " + std::to_string(y), false);
          }
        }
      }
    }
  }
  Check("one cell alone is drawn from everywhere", true);
  // A small change of importance moves places by as little.
  const Chart before(4, [](int x, int y) { return 1.0 + 0.5 * std::sin(x + 2.0 * y); });
  const Chart after(4, [](int x, int y) { return 1.0 + 0.501 * std::sin(x + 2.0 * y); });
  double farthest = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    const vec2 place((i + 0.5) / 1000, vtkIndirectSamplePattern::GoldenRatioFraction(i));
    const Chart::Choice a = before.Draw(place, VTKI_WARP_APART, 99);
    const Chart::Choice b = after.Draw(place, VTKI_WARP_APART, 99);
    // Across a border between halves columns belong to other rows: only rows are continuous.
    farthest = std::max<double>(farthest,
      std::abs(
        (static_cast<float>(a.Cell.y) + a.Place.y) - (static_cast<float>(b.Cell.y) + b.Place.y)) /
        16.0);
  }
  CheckAtMost("how far a change of a thousandth moves places", farthest, 3e-3,
    "the warp is monotonous along rows, with slopes of at most 2.3");
}

VTK_INDIRECT_TEST(ImportanceCharts)
{
  // The map preserves areas: the mean of a place's direction is that of the cone's.
  for (const double angle : { 61.0, 89.0, 180.0 })
  {
    const double cosCone = std::cos(angle * vtkMath::Pi() / 180.0);
    glm::dvec3 sum(0.0);
    double worst = 0.0;
    constexpr int edge = 200;
    for (int i = 0; i < edge * edge; ++i)
    {
      const vec2 place((i % edge + 0.5) / edge, (i / edge + 0.5) / edge);
      const vec3 direction = vtkiChartDirection(place, static_cast<float>(cosCone));
      worst = std::max(worst, std::abs(static_cast<double>(length(direction)) - 1.0));
      sum += glm::dvec3(direction) / static_cast<double>(edge * edge);
    }
    const std::string what = std::to_string(static_cast<int>(angle)) + " degrees: ";
    CheckAtMost(what + "length less one", worst, 1e-6, "rounding");
    CheckAbsolute(what + "mean along the axis", -sum.z, 0.5 * (1.0 + cosCone), 1e-6, "closed form");
    CheckAbsolute(what + "mean across", std::hypot(sum.x, sum.y), 0.0, 1e-6, "symmetry");
  }
  // The direction of the low-discrepancy pattern's place is that of the lattice over directions.
  for (int i = 0; i < 10; ++i)
  {
    const glm::dvec3 expected = vtkIndirectSamplePattern::DirectionInCone(i, 10, -1.0);
    const vec3 direction = vtkiChartDirection(
      vec2((i + 0.5) / 10, vtkIndirectSamplePattern::GoldenRatioFraction(i)), -1.0f);
    CheckAtMost("direction " + std::to_string(i), glm::length(glm::dvec3(direction) - expected),
      2e-6, "rounding");
  }
  // Levels of a chart of 1024 cells, four of them side by side.
  int begin[2] = { 0, 0 };
  int wrong = 0;
  for (int level = 0; level < 10; ++level)
  {
    wrong += vtkiNodesBegin(4 * 512, level) == begin[level % 2] ? 0 : 1;
    begin[level % 2] += 4 * (512 >> level);
  }
  CheckEqual("levels that do not lie side by side", wrong, 0);
}
