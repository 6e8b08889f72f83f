// SPDX-License-Identifier: BSD-3-Clause
// Tests of segments against spheres in a grid agree with a loop over all spheres, and are more
// accurate than voxels.
#include "Scene/vtkIndirectTriangleTree.h"
#include "Visibility/vtkIndirectDistanceField.h"
#include "Visibility/vtkIndirectOccupancyVolume.h"
#include "Visibility/vtkIndirectSphereGrid.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkIndirectVoxelLines.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace vtkIndirectTest;

namespace
{
// In double precision, by the distance of the segment from the center. margin: distance, over a
// radius, to the opposite answer.
bool IsFreeByAll(const std::vector<glm::dvec4>& spheres, const glm::dvec3& start,
  const glm::dvec3& end, double& margin)
{
  bool free = true;
  margin = 1.0;
  for (const glm::dvec4& sphere : spheres)
  {
    const glm::dvec3 center(sphere);
    const double s = glm::length(start - center) / sphere.w - 1.0;
    const double e = glm::length(end - center) / sphere.w - 1.0;
    const glm::dvec3 along = end - start;
    const double t = glm::dot(center - start, along) / glm::dot(along, along);
    const double nearest = glm::length(start + glm::clamp(t, 0.0, 1.0) * along - center);
    const double inside = 1.0 - nearest / sphere.w;
    const bool blocks = s > 0.0 && e > 0.0 && inside > 0.0;
    // The decisive distance; an end that faces away decides nothing.
    margin = std::min({ margin, std::abs(inside), std::abs(s), std::abs(e) });
    free = free && !blocks;
  }
  return free;
}

std::vector<glm::dvec4> MakeSpheres(Random& random, int count, double radius)
{
  std::vector<glm::dvec4> spheres;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 place(random.Next(), random.Next(0.0, 0.7), random.Next(0.0, 0.4));
    spheres.emplace_back(place, radius * random.NextMagnitude(0.3, 3.0));
  }
  return spheres;
}

// A sphere's surface as 120 triangles, for voxels.
void AddSphere(vtkIndirectOccupancyVolume& volume, const glm::dvec4& sphere)
{
  auto at = [&sphere](int i, int j)
  {
    const double theta = vtkMath::Pi() * j / 6;
    const double phi = 2.0 * vtkMath::Pi() * i / 12;
    return glm::dvec3(sphere) +
      sphere.w *
      glm::dvec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
  };
  for (int j = 0; j < 6; ++j)
  {
    for (int i = 0; i < 12; ++i)
    {
      const glm::dvec3 upper[3] = { at(i, j), at(i + 1, j), at(i, j + 1) };
      const glm::dvec3 lower[3] = { at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) };
      if (j > 0)
      {
        volume.AddTriangle(upper, glm::dvec3(0.5));
      }
      if (j < 5)
      {
        volume.AddTriangle(lower, glm::dvec3(0.5));
      }
    }
  }
}
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(SphereBlockersAreAllSpheres)
{
  Random random(41);
  for (const double cells : { 0.01, 0.5, 4.0, 40.0 })
  {
    const std::vector<glm::dvec4> spheres = MakeSpheres(random, 300, 0.02);
    vtkIndirectSphereGrid grid;
    grid.Build(spheres, cells, vtkIndirectSphereGrid::MaximumNumberOfEntries);
    int wrong = 0;
    int blocked = 0;
    int near = 0;
    const int count = 4000;
    for (int i = 0; i < count; ++i)
    {
      // Ends inside the grid and outside of it; some along an axis.
      glm::dvec3 ends[2];
      for (glm::dvec3& end : ends)
      {
        end = { random.Next(-0.3, 1.3), random.Next(-0.3, 1.0), random.Next(-0.3, 0.7) };
      }
      if (i % 7 == 0)
      {
        const int axis = i % 3;
        const double to = ends[1][axis];
        ends[1] = ends[0];
        ends[1][axis] = to;
      }
      double margin = 0.0;
      const bool free = IsFreeByAll(spheres, ends[0], ends[1], margin);
      const bool found = grid.IsFree(ends[0], ends[1]);
      blocked += !free;
      // Single precision of positions in up to 60 cells, over radii of a tenth of a cell and more.
      const bool unsure = margin < 1e-4;
      near += unsure;
      wrong += !unsure && free != found;
    }
    CheckEqual("segments that a loop over all answers otherwise", wrong, 0);
    CheckAtMost("too near to tell", near, 0.05 * count, "the test's own power");
    CheckAtLeast("blocked", blocked, 0.1 * count, "the test's own power");
    CheckAtLeast("free", count - blocked, 0.1 * count, "the test's own power");
  }
}

//------------------------------------------------------------------------------
// Hundreds of spheres around one place, many more than 8 bits could count in any cell, rows of them
// that are longer than a grid's cells, and few entries: neither the grid nor the tree loses any.
VTK_INDIRECT_TEST(SphereBlockersAreNotDropped)
{
  struct Case
  {
    const char* Name;
    std::vector<glm::dvec4> Spheres;
    size_t Entries;
    size_t LongestList; // least length
  };
  Random random(61);
  std::vector<Case> cases;
  constexpr size_t many = vtkIndirectSphereGrid::MaximumNumberOfEntries;
  Case crowd{ "around one place", {}, many, 256 };
  for (int i = 0; i < 900; ++i)
  {
    crowd.Spheres.emplace_back(random.Next(-0.1, 0.1), random.Next(-0.1, 0.1),
      random.Next(-0.1, 0.1), random.Next(0.15, 0.2));
  }
  cases.push_back(crowd);
  Case far{ "a clump, and one far away", {}, many, 1 };
  for (int i = 0; i < 900; ++i)
  {
    far.Spheres.emplace_back(random.Next(0.0, 0.05), random.Next(0.0, 0.05), random.Next(0.0, 0.05),
      random.Next(0.001, 0.003));
  }
  far.Spheres.emplace_back(1.0, 1.0, 1.0, 0.01);
  cases.push_back(far);
  Case row{ "a row", {}, many, 1 };
  for (int i = 0; i < 5000; ++i)
  {
    row.Spheres.emplace_back(0.2 * i / 1000.0, 0.0, 0.0, 1e-4);
  }
  cases.push_back(row);
  Case few{ "few entries", MakeSpheres(random, 300, 0.02), 400, 1 };
  cases.push_back(few);
  Case giant{ "one that all others are around", MakeSpheres(random, 300, 0.01), many, 1 };
  giant.Spheres.emplace_back(0.5, 0.35, 0.2, 0.3);
  cases.push_back(giant);
  for (const Case& test : cases)
  {
    const std::string name = test.Name;
    vtkIndirectSphereGrid grid;
    Check(name + ": built", grid.Build(test.Spheres, test.Entries));
    CheckEqual(name + ": spheres", static_cast<double>(grid.GetNumberOfSpheres()),
      static_cast<double>(test.Spheres.size()));
    CheckAtMost(name + ": entries", static_cast<double>(grid.GetNumberOfEntries()),
      static_cast<double>(test.Entries), "as was asked for");
    CheckAtLeast(name + ": longest list", static_cast<double>(grid.GetLongestList()),
      static_cast<double>(test.LongestList), "the test's own power");
    vtkIndirectTriangleTree tree;
    for (const glm::dvec4& sphere : test.Spheres)
    {
      tree.AddSphere(glm::dvec3(sphere), sphere.w);
    }
    tree.Finish();
    CheckEqual(name + ": in the tree", tree.GetNumberOfSpheres(), test.Spheres.size());
    int wrong[2] = { 0, 0 };
    int blocked = 0;
    const int count = 1000;
    for (int i = 0; i < count; ++i)
    {
      // Closely past a sphere.
      const glm::dvec4& target = test.Spheres[random.NextBits() % test.Spheres.size()];
      const glm::dvec3 middle = glm::dvec3(target) + 1.3 * target.w * random.NextDirection();
      const glm::dvec3 way = random.NextDirection();
      const glm::dvec3 start = middle - random.Next(0.0, 0.5) * way;
      const glm::dvec3 end = middle + random.Next(0.0, 0.5) * way;
      double margin = 0.0;
      const bool free = IsFreeByAll(test.Spheres, start, end, margin);
      blocked += !free;
      // Single precision of positions in 256 cells, over radii of a fortieth of a cell and more.
      wrong[0] += margin > 2e-3 && grid.IsFree(start, end) != free;
      wrong[1] += margin > 1e-12 && tree.IsBlocked(start, end) == free;
    }
    CheckEqual(name + ": wrong, by the shaders' kernel", wrong[0], 0);
    CheckEqual(name + ": wrong, by the tree", wrong[1], 0);
    CheckAtLeast(name + ": blocked", blocked, 0.05 * count, "the test's own power");
    CheckAtLeast(name + ": free", count - blocked, 0.02 * count, "the test's own power");
  }
  vtkIndirectSphereGrid grid;
  Check("more spheres than entries", !grid.Build(crowd.Spheres, 899) && grid.IsEmpty());
  Check("as many", grid.Build(crowd.Spheres, 900) && grid.GetNumberOfEntries() == 900);
}

//------------------------------------------------------------------------------
// A sphere does not hide its own surface, at any scale, without offset or tolerance.
VTK_INDIRECT_TEST(SphereBlockersDoNotHideThemselves)
{
  Random random(43);
  for (const double radius : { 1e-3, 0.1, 10.0 })
  {
    const std::vector<glm::dvec4> spheres = { { 3.0, -2.0, 1.0, radius },
      { 3.0 + 100.0 * radius, -2.0, 1.0, radius } };
    vtkIndirectSphereGrid grid;
    grid.Build(spheres, 8.0, vtkIndirectSphereGrid::MaximumNumberOfEntries);
    int hidden = 0;
    int faced = 0;
    for (int i = 0; i < 3000; ++i)
    {
      const glm::dvec3 n = random.NextDirection();
      const glm::dvec3 m = random.NextDirection();
      const glm::dvec3 start = glm::dvec3(spheres[0]) + radius * n;
      const glm::dvec3 end = glm::dvec3(spheres[1]) + radius * m;
      const glm::dvec3 way = glm::normalize(end - start);
      // Rounding decides the side of cosines near zero.
      if (glm::dot(way, n) > 1e-3 && glm::dot(way, m) < -1e-3)
      {
        ++faced;
        hidden += !grid.IsFree(start, end);
      }
    }
    CheckEqual("segments that leave a sphere and are hidden by it", hidden, 0);
    CheckAtLeast("segments", faced, 500, "the test's own power");
  }
  vtkIndirectSphereGrid empty;
  empty.Build({});
  Check("nothing hides nothing", empty.IsFree(glm::dvec3(-1.0), glm::dvec3(2.0)));
}

//------------------------------------------------------------------------------
// Asks voxels and spheres about segments between places on spheres that face each other, as a
// gather does, and counts how often each is wrong.
VTK_INDIRECT_TEST(SphereBlockersBesideVoxels)
{
  Random random(47);
  const std::vector<glm::dvec4> spheres = MakeSpheres(random, 300, 0.02);
  vtkIndirectOccupancyVolume volume;
  volume.Clear(glm::dvec3(-0.06), glm::dvec3(1.06, 0.76, 0.46), 128);
  for (const glm::dvec4& sphere : spheres)
  {
    AddSphere(volume, sphere);
  }
  volume.Finish();
  const vtkIndirectVoxelLines field(volume.GetDistanceField());
  vtkIndirectSphereGrid grid;
  grid.Build(spheres);
  auto pick = [&](glm::dvec3& place, glm::dvec3& normal)
  {
    bool open = false;
    while (!open)
    {
      const glm::dvec4& sphere = spheres[random.NextBits() % spheres.size()];
      normal = random.NextDirection();
      place = glm::dvec3(sphere) + sphere.w * (1.0 + 1e-6) * normal;
      open = std::none_of(spheres.begin(), spheres.end(),
        [&place](const glm::dvec4& other)
        { return glm::length(place - glm::dvec3(other)) < other.w; });
    }
  };
  double wrong[2] = {};
  int hidden = 0;
  const int count = 3000;
  for (int i = 0; i < count;)
  {
    glm::dvec3 places[2];
    glm::dvec3 normals[2];
    pick(places[0], normals[0]);
    pick(places[1], normals[1]);
    const glm::dvec3 way = places[1] - places[0];
    if (glm::dot(way, normals[0]) <= 0.0 || glm::dot(way, normals[1]) >= 0.0)
    {
      continue;
    }
    ++i;
    double margin = 0.0;
    const bool free = IsFreeByAll(spheres, places[0], places[1], margin);
    hidden += !free;
    wrong[0] += free !=
      field.IsVisible(field.FindEnd(glm::vec3(places[0]), glm::vec3(normals[0])),
        field.FindEnd(glm::vec3(places[1]), glm::vec3(normals[1])));
    wrong[1] += free != grid.IsFree(places[0], places[1]);
  }
  CheckAtLeast("hidden", hidden, 0.2 * count, "the test's own power");
  CheckAtLeast("free", count - hidden, 0.2 * count, "the test's own power");
  CheckAtMost("spheres: share of wrong answers", wrong[1] / count, 2e-3,
    "single precision, where a segment touches a sphere or its end's own");
  CheckAtLeast("voxels: share of wrong answers", wrong[0] / count, 0.05,
    "voxels close the gaps between crowded spheres");
}
