// SPDX-License-Identifier: BSD-3-Clause
// Segments against all triangles of a scene: the tree agrees with a loop over them, edges and
// corners are watertight, and surfaces do not hide their own light.
#include "Scene/vtkIndirectTriangleTree.h"
#include "vtkIndirectSightLines.h"
#include "vtkIndirectTestUtilities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <iostream>
#include <vector>

using namespace vtkIndirectTest;

namespace
{
using Corners = std::array<glm::dvec3, 3>;

void Fill(vtkIndirectTriangleTree& tree, const std::vector<Corners>& triangles)
{
  tree.Clear();
  for (const Corners& triangle : triangles)
  {
    tree.Add(triangle.data());
  }
  tree.Finish();
}

glm::dvec3 NextInCube(Random& random)
{
  const double x = random.Next();
  const double y = random.Next();
  return { x, y, random.Next() };
}

// Small ones, long ones, slivers, and some in planes along the axes.
std::vector<Corners> MakeTriangles(Random& random, int count)
{
  std::vector<Corners> triangles;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 at = NextInCube(random);
    const double size = i % 5 == 0 ? 0.5 : random.NextMagnitude(0.003, 0.1);
    const glm::dvec3 u = size * random.NextDirection();
    const glm::dvec3 v = (i % 7 == 0 ? 0.01 : 1.0) * size * random.NextDirection();
    Corners triangle = { at, at + u, at + v };
    if (i % 4 == 0)
    {
      for (glm::dvec3& corner : triangle)
      {
        corner[i / 4 % 3] = at[i / 4 % 3];
      }
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

enum Answer
{
  FREE,
  BLOCKED,
  UNDECIDED // within `margin` of an edge, or of an end
};

// A loop over all triangles with an independent formula: the crossing of the plane, and its
// distance inside each edge.
Answer LoopOverAll(const std::vector<Corners>& triangles, const glm::dvec3& start,
  const glm::dvec3& end, double margin)
{
  Answer answer = FREE;
  for (const Corners& v : triangles)
  {
    const glm::dvec3 cross = glm::cross(v[1] - v[0], v[2] - v[0]);
    const glm::dvec3 normal = cross / std::sqrt(glm::dot(cross, cross));
    const double h0 = glm::dot(normal, start - v[0]);
    const double h1 = glm::dot(normal, end - v[0]);
    if (h0 * h1 > 0.0 && std::min(std::abs(h0), std::abs(h1)) > margin)
    {
      continue;
    }
    const glm::dvec3 p = start + h0 / (h0 - h1) * (end - start);
    double inside = std::min(std::abs(h0), std::abs(h1));
    for (int e = 0; e < 3; ++e)
    {
      const glm::dvec3 edge = glm::normalize(v[(e + 1) % 3] - v[e]);
      inside = std::min(inside, glm::dot(glm::cross(edge, p - v[e]), normal));
    }
    if (inside > margin && h0 * h1 < 0.0)
    {
      return BLOCKED;
    }
    // NaN, for a segment in the plane, is undecided too.
    answer = inside < -margin ? answer : UNDECIDED;
  }
  return answer;
}

// The surface of a ball as triangles, with poles.
std::vector<Corners> MakeBall(int rings)
{
  const double pi = 3.14159265358979323846;
  auto at = [&](int i, int j)
  {
    const double theta = pi * i / rings;
    const double phi = pi * (j % (2 * rings)) / rings;
    return i == 0 || i == rings ? glm::dvec3(0.0, 0.0, i == 0 ? 1.0 : -1.0)
                                : glm::dvec3(std::sin(theta) * std::cos(phi),
                                    std::sin(theta) * std::sin(phi), std::cos(theta));
  };
  std::vector<Corners> triangles;
  for (int i = 0; i < rings; ++i)
  {
    for (int j = 0; j < 2 * rings; ++j)
    {
      triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return triangles;
}

// The cube from -1 to 1, its faces in n x n pieces of two triangles; odd n have none at zero.
std::vector<Corners> MakeCube(int n)
{
  std::vector<Corners> triangles;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (double side : { -1.0, 1.0 })
    {
      auto at = [&](int i, int j)
      {
        glm::dvec3 p;
        p[axis] = side;
        p[(axis + 1) % 3] = 2.0 * i / n - 1.0;
        p[(axis + 2) % 3] = 2.0 * j / n - 1.0;
        return p;
      };
      for (int i = 0; i < n; ++i)
      {
        for (int j = 0; j < n; ++j)
        {
          triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
          triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
        }
      }
    }
  }
  return triangles;
}
}

VTK_INDIRECT_TEST(TreeSameAsLoop)
{
  // Rounding of positions of order one, in double precision, with room.
  constexpr double margin = 1e-12;
  Random random(29);
  const std::vector<Corners> triangles = MakeTriangles(random, 900);
  vtkIndirectTriangleTree tree;
  Fill(tree, triangles);
  CheckEqual("triangles", static_cast<double>(tree.GetNumberOfTriangles()), 900);
  int wrong = 0;
  int counts[3] = {};
  for (int i = 0; i < 120000; ++i)
  {
    // Short ones and long ones, some from outside, some along an axis.
    glm::dvec3 start = NextInCube(random);
    glm::dvec3 end = i % 3 == 0 ? start + 0.1 * random.NextDirection() : NextInCube(random);
    if (i % 8 == 0)
    {
      start = 5.0 * start - 2.0;
    }
    if (i % 5 == 0)
    {
      const int axis = i / 5 % 3;
      end[axis] = start[axis];
      end[(axis + 1) % 3] = i % 2 == 0 ? start[(axis + 1) % 3] : end[(axis + 1) % 3];
    }
    const Answer expected = LoopOverAll(triangles, start, end, margin);
    ++counts[expected];
    wrong += expected != UNDECIDED && tree.IsBlocked(start, end) != (expected == BLOCKED);
    wrong += tree.IsBlocked(start, end) != tree.IsBlocked(end, start) && expected != UNDECIDED;
  }
  CheckEqual("segments that a loop over all triangles answers otherwise", wrong, 0);
  CheckAtLeast("blocked segments", counts[BLOCKED], 30000, "the test's own power");
  CheckAtLeast("free segments", counts[FREE], 30000, "the test's own power");
  CheckAtMost("segments within 1e-12 of an edge or an end", counts[UNDECIDED], 10,
    "the measure of such strips is 1e-9 of all");
}

VTK_INDIRECT_TEST(TreeWatertight)
{
  // From inside to outside of closed surfaces: through corners, through edges, and anywhere. None
  // of a cube's numbers is rounded, all of a rotated ball's are.
  Random random(31);
  for (int kind = 0; kind < 4; ++kind)
  {
    std::vector<Corners> triangles = kind < 2 ? MakeCube(kind == 0 ? 6 : 7) : MakeBall(24);
    if (kind == 3)
    {
      const glm::dvec3 axis = random.NextDirection();
      for (Corners& triangle : triangles)
      {
        for (glm::dvec3& v : triangle)
        {
          v = 2.0 * glm::dot(axis, v) * axis - v + glm::dvec3(0.1, 0.2, -0.3);
        }
      }
    }
    const glm::dvec3 center = kind == 3 ? glm::dvec3(0.1, 0.2, -0.3) : glm::dvec3(0.0);
    vtkIndirectTriangleTree tree;
    Fill(tree, triangles);
    int leaks = 0;
    int count = 0;
    auto test = [&](const glm::dvec3& start, const glm::dvec3& target)
    {
      // The target lies on the segment but for rounding, or exactly, in its middle.
      leaks += !tree.IsBlocked(start, start + 2.0 * (target - start));
      leaks += !tree.IsBlocked(start + 2.0 * (target - start), start);
      count += 2;
    };
    for (const Corners& v : triangles)
    {
      for (int k = 0; k < 4; ++k)
      {
        const glm::dvec3 start =
          k == 0 ? center : center + random.Next(0.0, 0.5) * random.NextDirection();
        for (int e = 0; e < 3; ++e)
        {
          test(start, v[e]);
          test(start, 0.5 * (v[e] + v[(e + 1) % 3]));
          const double t = random.Next();
          test(start, v[e] + t * (v[(e + 1) % 3] - v[e]));
        }
        test(start, start + 2.0 * random.NextDirection());
      }
    }
    CheckEqual("surface " + std::to_string(kind) + ", leaks of " + std::to_string(count), leaks, 0);
  }
}

VTK_INDIRECT_TEST(TreeScales)
{
  // The same answers at any scale, and at any place with enough digits for positions.
  Random random(37);
  const std::vector<Corners> triangles = MakeTriangles(random, 300);
  std::vector<std::array<glm::dvec3, 2>> segments;
  std::vector<Answer> expected;
  for (int i = 0; i < 5000; ++i)
  {
    const glm::dvec3 start = NextInCube(random);
    segments.push_back({ start, NextInCube(random) });
    // Margin of rounding at a distance of 1e6 edges: 1e6 times 2^-52, and more.
    expected.push_back(LoopOverAll(triangles, start, segments.back()[1], 1e-8));
  }
  for (const auto& [scale, place] :
    { std::pair(1.0, glm::dvec3(0.0)), std::pair(1e-9, glm::dvec3(0.0)),
      std::pair(1e6, glm::dvec3(0.0)), std::pair(1e-30, glm::dvec3(0.0)),
      std::pair(1.0, glm::dvec3(1e6, -3e5, 2e6)), std::pair(1e-9, glm::dvec3(1e-4, 1e-3, -2e-3)) })
  {
    auto move = [scale = scale, place = place](const glm::dvec3& p) { return place + scale * p; };
    std::vector<Corners> moved = triangles;
    for (Corners& v : moved)
    {
      v = { move(v[0]), move(v[1]), move(v[2]) };
    }
    vtkIndirectTriangleTree tree;
    Fill(tree, moved);
    int wrong = 0;
    for (size_t i = 0; i < segments.size(); ++i)
    {
      wrong += expected[i] != UNDECIDED &&
        tree.IsBlocked(move(segments[i][0]), move(segments[i][1])) != (expected[i] == BLOCKED);
    }
    CheckEqual("scale " + std::to_string(std::log10(scale)) + " decades, " +
        std::to_string(glm::length(place) / scale) + " edges away: other answers",
      wrong, 0);
  }
  CheckAtLeast("blocked segments",
    static_cast<double>(std::count(expected.begin(), expected.end(), BLOCKED)), 1000,
    "the test's own power");
}

// Boxes grow by their own coordinates, not by those of a triangle far away: a box that did would
// hold each point of the room, so that each ray met all triangles.
VTK_INDIRECT_TEST(TreeBesideAFarTriangle)
{
  Random random(53);
  std::vector<Corners> triangles;
  for (int i = 0; i < 2000; ++i)
  {
    const glm::dvec3 at = NextInCube(random);
    triangles.push_back(
      { at, at + 0.02 * random.NextDirection(), at + 0.02 * random.NextDirection() });
  }
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 2000; ++i)
  {
    points.push_back(NextInCube(random));
  }
  const auto count = [&](const std::vector<Corners>& given)
  {
    vtkIndirectTriangleTree tree;
    Fill(tree, given);
    double near = 0.0;
    for (const glm::dvec3& point : points)
    {
      tree.ForEachNear(point, 1e-3, [&near](const glm::dvec3*) { near += 1.0; });
    }
    return near;
  };
  const double alone = count(triangles);
  CheckAtLeast("triangles near to the points", alone, 10.0, "the test's own power");
  triangles.push_back({ glm::dvec3(2, 2, 2), glm::dvec3(1e9, 2, 2), glm::dvec3(2, 1e9, 2) });
  CheckAtMost("beside a triangle of 1e9", count(triangles),
    1.2 * alone + static_cast<double>(points.size()),
    "its own box is wide by rounding; were all boxes as wide, four million were near");
}

VTK_INDIRECT_TEST(TreeOddTriangles)
{
  vtkIndirectTriangleTree tree;
  tree.Finish();
  Check("an empty tree blocks nothing", !tree.IsBlocked({ 0, 0, 0 }, { 1, 1, 1 }));
  vtkIndirectSightLines::Facet facet;
  Check("and has no facets",
    !vtkIndirectSightLines::FindFacet(tree, { 0, 0, 0 }, { 0, 0, 1 }, 1e300, facet));

  const Corners odd[] = { { glm::dvec3(0.5), glm::dvec3(0.5), glm::dvec3(0.5) },
    { glm::dvec3(0, 0, 0.5), glm::dvec3(1, 1, 0.5), glm::dvec3(0.25, 0.25, 0.5) },
    { glm::dvec3(NAN, 0, 0.5), glm::dvec3(1, 0, 0.5), glm::dvec3(0, 1, 0.5) },
    { glm::dvec3(0, 0, 0.5), glm::dvec3(INFINITY, 0, 0.5), glm::dvec3(0, 1, 0.5) } };
  for (const Corners& triangle : odd)
  {
    tree.Add(triangle.data());
  }
  tree.Finish();
  CheckEqual("triangles without area, or that are nowhere",
    static_cast<double>(tree.GetNumberOfTriangles()), 0);
  const Corners one = { glm::dvec3(0, 0, 0.5), glm::dvec3(1, 0, 0.5), glm::dvec3(0, 1, 0.5) };
  tree.Add(one.data());
  tree.Finish();
  Check("one triangle blocks", tree.IsBlocked({ 0.2, 0.2, 0 }, { 0.2, 0.2, 1 }));
  Check("from its other side too", tree.IsBlocked({ 0.2, 0.2, 1 }, { 0.2, 0.2, 0 }));
  Check("not beside it", !tree.IsBlocked({ 0.7, 0.7, 1 }, { 0.7, 0.7, 0 }));
  Check("not before it", !tree.IsBlocked({ 0.2, 0.2, 0 }, { 0.2, 0.2, 0.4 }));
  Check("not where the segment ends on it", !tree.IsBlocked({ 0.2, 0.2, 0 }, { 0.2, 0.2, 0.5 }));
  Check("not a segment without length", !tree.IsBlocked({ 0.2, 0.2, 0.5 }, { 0.2, 0.2, 0.5 }));

  // Thousands at one place, which no plane separates, and sizes over 600 decades, which bins cannot
  // separate.
  tree.Clear();
  for (int i = 0; i < 5000; ++i)
  {
    tree.Add(one.data());
  }
  for (int i = 0; i < 500; ++i)
  {
    const double s = std::pow(10.0, -0.6 * (i % 250));
    const Corners small = { glm::dvec3(s, 0, 2), glm::dvec3(2 * s, 0, 2), glm::dvec3(s, s, 2) };
    tree.Add(small.data());
  }
  tree.Finish();
  Check("thousands at one place block", tree.IsBlocked({ 0.2, 0.2, 0 }, { 0.2, 0.2, 1 }));
  Check("not beside them", !tree.IsBlocked({ 0.7, 0.7, 1 }, { 0.7, 0.7, 0 }));
  int found = 0;
  for (int i = 0; i < 60; ++i)
  {
    const double s = std::pow(10.0, -0.6 * i);
    found += tree.IsBlocked({ 1.25 * s, 0.25 * s, 1.5 }, { 1.25 * s, 0.25 * s, 2.5 });
  }
  CheckEqual("triangles of 1 to 1e-36 that block", found, 60);
}

VTK_INDIRECT_TEST(TreeFacets)
{
  // Finds for points beside a bumpy sheet the triangle that they come from.
  Random random(41);
  const std::vector<Corners> triangles = MakeBall(40);
  vtkIndirectTriangleTree tree;
  Fill(tree, triangles);
  int wrong = 0;
  int tested = 0;
  for (const Corners& v : triangles)
  {
    const glm::dvec3 doubled = glm::cross(v[1] - v[0], v[2] - v[0]);
    if (glm::length(doubled) < 1e-6)
    {
      continue; // at a pole
    }
    const glm::dvec3 normal = glm::normalize(doubled);
    for (double side : { -1.0, 1.0 })
    {
      const double height = random.Next(-1e-4, 1e-4);
      const double a = random.Next(0.2, 0.4);
      const double b = random.Next(0.2, 0.4);
      const glm::dvec3 point =
        v[0] + a * (v[1] - v[0]) + b * (v[2] - v[0]) + height * side * normal;
      vtkIndirectSightLines::Facet facet;
      // The shading normal is the ball's own.
      const bool found =
        vtkIndirectSightLines::FindFacet(tree, point, side * glm::normalize(point), 2e-4, facet);
      const double outwards = glm::dot(normal, v[0]) > 0.0 ? 1.0 : -1.0;
      wrong += !found || glm::length(facet.Normal - side * outwards * normal) > 1e-9 ||
        std::abs(facet.Height - outwards * height) > 1e-12 ||
        std::abs(facet.Distance - std::abs(height)) > 1e-12;
      ++tested;
    }
  }
  CheckEqual("points led to another plane, of " + std::to_string(tested), wrong, 0);
  vtkIndirectSightLines::Facet facet;
  Check("out of reach there is none",
    !vtkIndirectSightLines::FindFacet(tree, { 0, 0, 0.99 }, { 0, 0, 1 }, 2e-4, facet));
  // At an edge of walls the normal decides.
  Fill(tree, MakeCube(1));
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 normal(0.0);
    normal[axis] = 1.0;
    Check("at a corner, wall " + std::to_string(axis),
      vtkIndirectSightLines::FindFacet(tree, glm::dvec3(-1.0 + 1e-7), normal, 2e-4, facet) &&
        facet.Normal == normal);
  }
}

VTK_INDIRECT_TEST(SightOwnSurfaces)
{
  // Inside of convex bodies every point sees every other, at any rounding of buffers, up to walls'
  // edges; and no point outside sees another through its own triangle.
  Random random(43);
  for (const bool ball : { false, true })
  {
    std::vector<Corners> triangles = ball ? MakeBall(32) : MakeCube(9);
    for (Corners& v : triangles)
    {
      // A body of diagonal one.
      v = { v[0] / std::sqrt(12.0), v[1] / std::sqrt(12.0), v[2] / std::sqrt(12.0) };
    }
    vtkIndirectTriangleTree tree;
    Fill(tree, triangles);
    const vtkIndirectSightLines lines(tree);
    auto next = [&](double side)
    {
      const Corners& v = triangles[random.NextBits() % triangles.size()];
      double a = random.Next();
      double b = random.Next();
      if (a + b > 1.0)
      {
        a = 1.0 - a;
        b = 1.0 - b;
      }
      const glm::dvec3 point = v[0] + a * (v[1] - v[0]) + b * (v[2] - v[0]);
      const glm::dvec3 cross = glm::cross(v[1] - v[0], v[2] - v[0]);
      // Avoids a pole's degenerate triangles.
      const glm::dvec3 outward =
        glm::length(cross) > 1e-9 ? glm::normalize(cross) : glm::normalize(point);
      const glm::dvec3 normal = side * (glm::dot(outward, point) > 0.0 ? outward : -outward);
      return lines.FindEnd(point + random.Next(-1e-4, 1e-4) * normal, normal);
    };
    int hidden = 0;
    int seen = 0;
    int pairs = 0;
    for (int i = 0; i < 40000; ++i)
    {
      const auto a = next(-1.0);
      const auto b = next(-1.0);
      // Points on one facet are not in front of each other, but for rounding.
      if (glm::dot(a.Normal, b.Normal) < 1.0 - 1e-9)
      {
        hidden += !lines.IsVisible(a, b);
        ++pairs;
      }
      const auto c = next(1.0);
      const auto d = next(1.0);
      seen += lines.IsVisible(c, a);
      // Neighbours see each other if both are nearer to their edge than the lift over their angle.
      seen += glm::dot(c.Normal, d.Normal) < 0.98 && lines.IsVisible(c, d);
    }
    const std::string what = ball ? "ball: " : "cube: ";
    CheckAtMost(what + "pairs inside that do not see each other, of " + std::to_string(pairs),
      hidden, ball ? 8 : 0, "points at edges that are led to the neighbour's plane");
    CheckEqual(what + "pairs that see each other through it, or about its outside", seen, 0);
  }
}

VTK_INDIRECT_TEST(SightContact)
{
  // Triangles nearer than the lift do not occlude, those farther do.
  const double lift = vtkIndirectSightLines::Lift;
  for (const double gap : { 0.5, 2.0 })
  {
    std::vector<Corners> triangles;
    for (const double z : { 0.0, gap * lift })
    {
      triangles.push_back({ glm::dvec3(-1, -1, z), glm::dvec3(1, -1, z), glm::dvec3(1, 1, z) });
      triangles.push_back({ glm::dvec3(-1, -1, z), glm::dvec3(1, 1, z), glm::dvec3(-1, 1, z) });
    }
    vtkIndirectTriangleTree tree;
    Fill(tree, triangles);
    const vtkIndirectSightLines lines(tree);
    const auto floor = lines.FindEnd({ 0.3, 0.1, -0.1 * lift }, { 0, 0, 1 });
    const auto above = lines.FindEnd({ 0.1, 0.2, 0.5 }, { 0, 0, -1 });
    Check("the floor is a surface", floor.OnSurface);
    Check("a point in mid-air is none", !above.OnSurface);
    Check("a sheet over it at " + std::to_string(gap) + " lifts",
      lines.IsVisible(floor, above) == (gap < 1.0));
  }
}

VTK_INDIRECT_TEST(TreeSpeed)
{
  // Printed without a limit: segments between points of 100 000 triangles that fill a room, and of
  // as many that are one surface.
  for (const bool ball : { false, true })
  {
    Random random(47);
    std::vector<Corners> triangles = ball ? MakeBall(158) : std::vector<Corners>();
    while (triangles.size() < 99500)
    {
      const glm::dvec3 at = NextInCube(random);
      triangles.push_back(
        { at, at + 0.02 * random.NextDirection(), at + 0.02 * random.NextDirection() });
    }
    const std::clock_t begun = std::clock();
    vtkIndirectTriangleTree tree;
    Fill(tree, triangles);
    const double built = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
    std::vector<glm::dvec3> ends;
    for (int i = 0; i < 400001; ++i)
    {
      ends.push_back(ball ? 0.99 * random.NextDirection() : NextInCube(random));
    }
    int blocked = 0;
    const std::clock_t start = std::clock();
    for (size_t i = 1; i < ends.size(); ++i)
    {
      blocked += tree.IsBlocked(ends[i - 1], ends[i]);
    }
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    std::cout << "  " << (ball ? "inside a ball: " : "in a cloud: ") << triangles.size()
              << " triangles, tree made in " << built << " s, " << 400000.0 / seconds / 1e6
              << " million segments a second and core, " << blocked / 4000.0 << " % blocked\n";
    CheckEqual("answers", std::min(blocked, 1), ball ? std::min(blocked, 1) : 1);
  }
}
