// SPDX-License-Identifier: BSD-3-Clause
// Kernels of antialiasing against their definitions: runs bit by bit, areas by quadrature.
#include "vtkIndirectTestUtilities.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

namespace
{
// Words in which runs of all lengths are likely.
uint MakeWord(Random& random)
{
  uint word = random.NextBits();
  for (double more = random.Next(0.0, 5.0); more >= 1.0; more -= 1.0)
  {
    word |= random.NextBits();
  }
  return word;
}

// Height of the outline over a run's border at a place.
double FindHeight(double place, double length, double firstEnd, double lastEnd)
{
  const double middle = 0.5 * length;
  return place < middle ? firstEnd * (1.0 - place / middle) : lastEnd * (place / middle - 1.0);
}
}

VTK_INDIRECT_TEST(AntialiasingBits)
{
  Random random(7);
  int wrong = 0;
  std::array<int, 32> lengths{};
  for (int i = 0; i < 100000; ++i)
  {
    const uint lower = MakeWord(random);
    const uint upper = MakeWord(random);
    const uint breaks = random.NextBits() & random.NextBits() & random.NextBits();
    const int first = static_cast<int>(random.NextBits() & 31u);
    const uint edges = vtkiBitWindow(lower, upper, first);
    for (int bit = 0; bit < 32; ++bit)
    {
      const int at = first + bit;
      const uint expected = at < 32 ? lower >> at : upper >> (at - 32);
      wrong += ((edges >> bit) & 1u) != (expected & 1u);
    }
    int forward = 0;
    while (forward < 31 && ((edges >> (forward + 1)) & 1u) && !((breaks >> (forward + 1)) & 1u))
    {
      ++forward;
    }
    int backward = 0;
    while (
      backward < 31 && ((edges >> (30 - backward)) & 1u) && !((breaks >> (31 - backward)) & 1u))
    {
      ++backward;
    }
    wrong += vtkiRunForward(edges | 1u, breaks) != forward;
    wrong += vtkiRunBackward(edges | 0x80000000u, breaks) != backward;
    ++lengths[static_cast<size_t>(forward)];
    const uint word = 1u << (random.NextBits() & 31u);
    wrong += (1u << vtkiLowestBit(word)) != word || (1u << vtkiHighestBit(word)) != word;
  }
  CheckEqual("bits and runs that are wrong", wrong, 0);
  wrong = vtkiHighestBit(0xffffffffu) != 31 || vtkiLowestBit(0xffffffffu) != 0;
  CheckEqual("a word of ones", wrong, 0);
  CheckEqual("a run beyond the reach", vtkiRunForward(0xffffffffu, 0u), VTKI_EDGE_REACH);
  CheckEqual("a run beyond the reach, before", vtkiRunBackward(0xffffffffu, 0u), VTKI_EDGE_REACH);
  CheckAtLeast("lengths of runs that occurred",
    static_cast<double>(std::count_if(lengths.begin(), lengths.end(), [](int n) { return n > 0; })),
    20, "the test's own power");
}

VTK_INDIRECT_TEST(AntialiasingEnds)
{
  // Bits: lines l - 2 to l + 1.
  CheckEqual("a step up", vtkiRunEnd(4u, 8u, 4u, true), 0.5);
  CheckEqual("a step down", vtkiRunEnd(2u, 2u, 4u, true), -0.5);
  CheckEqual("a step down at the other end", vtkiRunEnd(2u, 4u, 2u, false), -0.5);
  CheckEqual("no step", vtkiRunEnd(0u, 0u, 4u, true), 0.0);
  CheckEqual("a corner up stays sharp", vtkiRunEnd(12u, 0u, 4u, true), 0.0);
  CheckEqual("a corner down stays sharp", vtkiRunEnd(3u, 4u, 0u, false), 0.0);
  CheckEqual("the end of a thin line does", vtkiRunEnd(2u, 0u, 6u, true), 0.0);
  CheckEqual("a thin line's step does not", vtkiRunEnd(3u, 2u, 6u, true), -0.5);
  CheckEqual("an outline that ends at another", vtkiRunEnd(6u, 0u, 4u, true), 0.0);
  // A line of one pixel, lower before the end and higher behind it: its upper border (the run ends)
  // and its lower border (the run begins).
  CheckEqual("a thin line that rises", vtkiRunEnd(6u, 6u, 12u, false), 0.5);
  CheckEqual("and from below", vtkiRunEnd(6u, 6u, 12u, true), -0.5);
  CheckEqual("a thin line that falls", vtkiRunEnd(6u, 12u, 6u, false), -0.5);
  CheckEqual("and from below", vtkiRunEnd(6u, 12u, 6u, true), 0.5);
  CheckEqual("a board of squares", vtkiRunEnd(6u, 4u, 4u, true), 0.0);
  CheckEqual("a board of pixels", vtkiRunEnd(15u, 15u, 15u, true), 0.0);
  // A horizontal mirror image exchanges before and behind, a vertical one reverses the bits.
  int wrong = 0;
  auto turn = [](uint four)
  { return ((four & 1u) << 3u) | ((four & 2u) << 1u) | ((four & 4u) >> 1u) | ((four & 8u) >> 3u); };
  // Edges lie between lines: mirrored about the run's edge, bit 2.
  auto turnEdges = [](uint four)
  { return ((four & 2u) << 2u) | (four & 4u) | ((four & 8u) >> 2u); };
  for (uint i = 0; i < 16 * 16 * 16; ++i)
  {
    const uint across = i & 15u;
    const uint before = (i >> 4u) & 15u;
    const uint behind = i >> 8u;
    wrong += vtkiRunEnd(across, before, behind, true) != vtkiRunEnd(across, behind, before, false);
    wrong += vtkiRunEnd(turn(across), turnEdges(before), turnEdges(behind), true) !=
      -vtkiRunEnd(across, before, behind, true);
  }
  CheckEqual("ends that a mirror changes", wrong, 0);
}

VTK_INDIRECT_TEST(AntialiasingAreas)
{
  double worst = 0.0;
  double asymmetry = 0.0;
  for (int backward = 0; backward <= VTKI_EDGE_REACH; ++backward)
  {
    for (int forward = 0; forward <= VTKI_EDGE_REACH; ++forward)
    {
      for (float firstEnd : { -0.5f, 0.0f, 0.5f })
      {
        for (float lastEnd : { -0.5f, 0.0f, 0.5f })
        {
          const vec2 areas = vtkiRunAreas(backward, forward, firstEnd, lastEnd);
          const double length = backward + forward + 1;
          auto side = [&](double sign)
          {
            auto cut = [&](double place)
            { return std::max(sign * FindHeight(place, length, firstEnd, lastEnd), 0.0); };
            // Linear on either side of the middle, which is an end of a panel.
            return Integrate(backward, backward + 0.5, cut, 1) +
              Integrate(backward + 0.5, backward + 1, cut, 1);
          };
          worst =
            std::max({ worst, std::abs(areas.x - side(1.0)), std::abs(areas.y - side(-1.0)) });
          const vec2 mirrored = vtkiRunAreas(forward, backward, lastEnd, firstEnd);
          const vec2 turned = vtkiRunAreas(backward, forward, -firstEnd, -lastEnd);
          asymmetry = std::max<double>({ asymmetry, std::abs(areas.x - mirrored.x),
            std::abs(areas.y - mirrored.y), std::abs(areas.x - turned.y) });
        }
      }
    }
  }
  CheckAtMost("areas, worst", worst, 1e-6, "rounding of floats of order one");
  CheckEqual("areas that a mirror changes", asymmetry, 0.0);
  // A line of slope 1/8 through the middles of its steps has exact areas.
  const vec2 slope = vtkiRunAreas(0, 7, 0.5f, -0.5f);
  CheckAbsolute("the first pixel of eight", slope.x, 0.5 * (0.5 + 0.375), 1e-6, "rounding");
  const vec2 none = vtkiNeighborShares(0.0f, 0.0f);
  CheckEqual("no area, no share", none.x + none.y, 0.0);
  const vec2 both = vtkiNeighborShares(0.25f, 0.25f);
  CheckAbsolute("of two equal areas their mean", both.x + both.y, 0.25, 1e-7, "rounding");
  CheckEqual("a faint edge is left", vtkiEdgeStrength(VTKI_EDGE_CONTRAST), 0.0);
  CheckEqual("a clear one is blended in full", vtkiEdgeStrength(0.11f), 1.0);
}

VTK_INDIRECT_TEST(AntialiasingDiagonals)
{
  CheckEqual("two positions for a step, behind", vtkiDiagonalEnd(true, false, 1, false), -0.5);
  CheckEqual("two positions for a step, before", vtkiDiagonalEnd(true, false, 1, true), 0.5);
  CheckEqual("two lines for a step, behind", vtkiDiagonalEnd(false, true, 1, false), 0.5);
  CheckEqual("falling", vtkiDiagonalEnd(false, true, -1, false), -0.5);
  CheckEqual("no step", vtkiDiagonalEnd(false, false, 1, true), 0.0);
  CheckEqual("an outline that goes on both ways", vtkiDiagonalEnd(true, true, 1, true), 0.0);
  double worst = 0.0;
  double asymmetry = 0.0;
  for (int backward = 0; backward <= VTKI_DIAGONAL_REACH; ++backward)
  {
    for (int forward = 0; forward <= VTKI_DIAGONAL_REACH; ++forward)
    {
      for (float firstEnd : { -0.5f, 0.0f, 0.5f })
      {
        for (float lastEnd : { -0.5f, 0.0f, 0.5f })
        {
          if (backward + forward + 1 < VTKI_DIAGONAL_LENGTH ||
            (firstEnd == 0.0f && lastEnd == 0.0f))
          {
            continue;
          }
          for (int turn : { -1, 1 })
          {
            const vec2 areas = vtkiDiagonalAreas(backward, forward, firstEnd, lastEnd, turn);
            // Height of the line over the pixels' border, through the place's middle with its
            // slope.
            const double length = backward + forward + 1;
            const double place = backward + 0.5;
            const double height = FindHeight(place, length, firstEnd, lastEnd);
            const double step = 1e-3;
            const double slope = turn +
              (FindHeight(place + step, length, firstEnd, lastEnd) -
                FindHeight(place - step, length, firstEnd, lastEnd)) /
                (2.0 * step);
            auto below = [&](double from)
            {
              // Piecewise linear: panels are far finer than its bends.
              return Integrate(
                -0.5, 0.5,
                [&](double x) { return std::max(0.0, std::min(1.0, from * (height + slope * x))); },
                256);
            };
            worst =
              std::max({ worst, std::abs(areas.x - below(1.0)), std::abs(areas.y - below(-1.0)) });
            const vec2 mirrored = vtkiDiagonalAreas(forward, backward, lastEnd, firstEnd, -turn);
            const vec2 turned = vtkiDiagonalAreas(backward, forward, -firstEnd, -lastEnd, -turn);
            asymmetry = std::max<double>({ asymmetry, std::abs(areas.x - mirrored.x),
              std::abs(areas.y - mirrored.y), std::abs(areas.x - turned.y) });
          }
        }
      }
    }
  }
  CheckAtMost("areas, worst", worst, 1e-5, "rounding, and the quadrature at bends");
  CheckAtMost("areas that a mirror changes", asymmetry, 1e-6, "rounding");
  // Mean area over all lines at 45 degrees with the same pixels.
  const double mean = Integrate(-0.5, 0.5, [](double h) { return vtkiAreaBelow(float(h), 1.0f); });
  const vec2 unknown = vtkiDiagonalAreas(15, 15, 0.0f, 0.0f, 1);
  CheckAbsolute("a line that is anywhere", unknown.x, mean, 1e-6, "rounding");
}

VTK_INDIRECT_TEST(AntialiasingLeaps)
{
  // Depth buffer values for heights in a row.
  auto leaps = [](const std::array<double, 4>& heights)
  {
    vec4 depth(0.0f);
    for (int i = 0; i < 4; ++i)
    {
      depth[i] = static_cast<float>(heights[static_cast<size_t>(i)]);
    }
    return vtkiIsDepthLeap(depth);
  };
  Random random(11);
  int planes = 0;
  int steps = 0;
  int bends = 0;
  int waves = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const double slope = random.Next(-2e-3, 2e-3);
    const double first = random.Next(0.2, 0.9);
    auto noise = [&random] { return random.Next(-0.5, 0.5) * VTKI_DEPTH_ROUNDING; };
    std::array<double, 4> plane{};
    for (size_t k = 0; k < 4; ++k)
    {
      plane[k] = first + slope * static_cast<double>(k) + noise();
    }
    planes += leaps(plane);
    // Another surface, four times as far away as slope and rounding can reach.
    const double step = 4.0 * std::abs(slope) + 4e-6;
    steps += !leaps({ plane[0], plane[1], plane[2] + step, plane[3] + step });
    // A roof, seen from either side.
    const double other = random.Next(-2e-3, 2e-3);
    bends += leaps({ first - slope, first, first + slope, first + slope + other });
    const double length = random.Next(6.2, 40.0);
    const double phase = random.Next(0.0, 7.0);
    auto wave = [&](double x)
    { return 0.5 + 1e-3 * std::sin(phase + 2.0 * vtkMath::Pi() * x / length); };
    waves += leaps({ wave(0), wave(1), wave(2), wave(3) });
  }
  CheckEqual("planes with a leap", planes, 0);
  CheckEqual("steps without one", steps, 0);
  CheckEqual("bends with one", bends, 0);
  CheckEqual("waves of more than six pixels with one", waves, 0);
  CheckEqual("a thing of one pixel has sides", leaps({ 0.5, 0.4, 0.5, 0.5 }), true);
  CheckEqual("of two pixels beside nothing nothing is known", leaps({ 1.0, 0.4, 0.5, 1.0 }), false);
}

VTK_INDIRECT_TEST(AntialiasingCreases)
{
  auto encode = [](double angle)
  { return vtkiOctahedralEncode(vec3(float(std::sin(angle)), 0.0f, float(std::cos(angle)))); };
  int bent = 0;
  // Rows through the middle of a ball and across a tube, up to the outline.
  for (double radius = 5.0; radius < 200.0; radius *= 1.1)
  {
    for (double x = -radius + 0.5; x + 1.0 < radius; x += 0.5)
    {
      vec2 code[4];
      bool known[4];
      for (int k = 0; k < 4; ++k)
      {
        const double sine = (x + k - 1.0) / radius;
        known[k] = std::abs(sine) <= 1.0;
        code[k] = encode(std::asin(std::max(-1.0, std::min(1.0, sine))));
      }
      bent += known[2] && vtkiIsCrease(code[0], code[1], code[2], code[3], known[0], known[3]);
    }
  }
  CheckEqual("creases of what is round", bent, 0);
  CheckEqual("an edge of a cube",
    vtkiIsCrease(encode(-0.8), encode(-0.8), encode(0.8), encode(0.8), true, true), true);
  CheckEqual("one that light cannot show",
    vtkiIsCrease(encode(0.0), encode(0.0), encode(0.04), encode(0.04), true, true), false);
  CheckEqual("of two pixels alone nothing is known",
    vtkiIsCrease(encode(0.0), encode(-0.8), encode(0.8), encode(0.0), false, false), false);
}

VTK_INDIRECT_TEST(AntialiasingOutlines)
{
  const vec4 flat(0.5f);
  const vec3 ahead(0.0f, 0.0f, 1.0f);
  const vec4 lit = vtkiPackSurface(ahead, ahead, 1.0f, VTKI_SURFACE_LINEAR);
  const vec4 encoded = vtkiPackSurface(ahead, ahead, 1.0f, VTKI_SURFACE_ENCODED);
  const vec4 one = vtkiPackUnlit(1.0f, 7);
  const vec4 other = vtkiPackUnlit(1.0f, 8);
  const vec4 none(0.0f);
  CheckEqual("one surface", vtkiIsOutline(flat, lit, lit, lit, lit), false);
  CheckEqual("one prop", vtkiIsOutline(flat, one, one, one, one), false);
  CheckEqual("what has no surface", vtkiIsOutline(flat, none, none, none, none), false);
  CheckEqual("two props", vtkiIsOutline(flat, one, one, other, other), true);
  CheckEqual("two kinds", vtkiIsOutline(flat, lit, lit, encoded, encoded), true);
  CheckEqual("lit and not", vtkiIsOutline(flat, one, one, lit, lit), true);
  CheckEqual(
    "the background", vtkiIsOutline(vec4(0.5f, 0.5f, 1.0f, 1.0f), lit, lit, none, none), true);
  CheckEqual("nothing but background", vtkiIsOutline(vec4(1.0f), none, none, none, none), false);
  int wrong = 0;
  for (int number = 0; number < 32768; ++number)
  {
    const vec4 packed = vtkiPackUnlit(0.25f, number);
    wrong += vtkiSurfaceKind(packed) != VTKI_SURFACE_UNLIT || vtkiSurfaceIsLit(packed) ||
      !std::isfinite(packed.y) || vtkiSurfaceDepth(packed) != 0.25f ||
      vtkiSurfaceCode(packed) == vtkiSurfaceCode(vtkiPackUnlit(0.25f, number + 1));
  }
  CheckEqual("numbers that are not told apart", wrong, 0);
}
