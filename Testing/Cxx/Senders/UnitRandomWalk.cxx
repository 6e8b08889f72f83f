// SPDX-License-Identifier: BSD-3-Clause
// Rays and patterns of the random walk: the tree finds the same first hit as a loop over all
// triangles, and points are as even as their order promises.
#include "Scene/vtkIndirectTriangleTree.h"
#include "Senders/vtkIndirectSamplePattern.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStaticCellLocator.h"

#include <cmath>
#include <ctime>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace vtkIndirectTest;

VTK_INDIRECT_TEST(NearestTriangle)
{
  Random random(7);
  struct Corners
  {
    glm::dvec3 V[3];
  };
  std::vector<Corners> triangles;
  vtkIndirectTriangleTree tree;
  int leftOut = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const glm::dvec3 at(random.Next(), random.Next(), random.Next());
    const double size = random.NextMagnitude(0.01, 0.3);
    Corners triangle = { { at, at + size * random.NextDirection(),
      at + size * random.NextDirection() } };
    if (i % 10 == 3)
    {
      triangle.V[2] = triangle.V[1]; // no area
    }
    if (i % 10 == 5)
    {
      triangle.V[1].y = std::numeric_limits<double>::quiet_NaN();
    }
    // A triangle that is left out keeps its number; the loop below meets none of them.
    triangles.push_back(triangle);
    leftOut += tree.Add(triangle.V) ? 0 : 1;
  }
  CheckEqual("without area or no number", leftOut, 600);
  tree.Finish();
  int others = 0;
  int met = 0;
  double worst = 0.0;
  for (int i = 0; i < 3000; ++i)
  {
    const glm::dvec3 start = i % 3 == 0 ? 3.0 * random.NextDirection()
                                        : glm::dvec3(random.Next(), random.Next(), random.Next());
    glm::dvec3 direction = random.NextDirection();
    if (i % 7 == 0)
    {
      direction = glm::dvec3(0.0);
      direction[i / 7 % 3] = i % 2 ? 1.0 : -1.0;
    }
    // A loop with an independent formula: the plane's place, and the three edges' sides.
    double least = std::numeric_limits<double>::infinity();
    size_t first = triangles.size();
    for (size_t k = 0; k < triangles.size(); ++k)
    {
      const glm::dvec3* v = triangles[k].V;
      const glm::dvec3 n = glm::cross(v[1] - v[0], v[2] - v[0]);
      const double t = glm::dot(v[0] - start, n) / glm::dot(direction, n);
      const glm::dvec3 p = start + t * direction;
      const bool inside = glm::dot(glm::cross(v[1] - v[0], p - v[0]), n) >= 0.0 &&
        glm::dot(glm::cross(v[2] - v[1], p - v[1]), n) >= 0.0 &&
        glm::dot(glm::cross(v[0] - v[2], p - v[2]), n) >= 0.0;
      if (inside && t > 0.0 && t < least)
      {
        least = t;
        first = k;
      }
    }
    vtkIndirectTriangleTree::Hit hit;
    const bool found = tree.FindNearest(start, direction, vtkIndirectTriangleTree::None, hit);
    const bool same = found == (first < triangles.size()) && (!found || hit.Triangle == first);
    others += same ? 0 : 1;
    if (found && same)
    {
      ++met;
      const glm::dvec3* v = triangles[first].V;
      const glm::dvec3 place =
        hit.Weights[0] * v[0] + hit.Weights[1] * v[1] + hit.Weights[2] * v[2];
      worst = std::max(worst, glm::length(place - (start + least * direction)));
      vtkIndirectTriangleTree::Hit next;
      const bool behind = tree.FindNearest(start, direction, hit.Triangle, next);
      others += behind && next.Distance < hit.Distance ? 1 : 0;
    }
  }
  CheckEqual("other answers than the loop's", others, 0);
  Check("many meet something", met > 1000);
  CheckAtMost("place by weights", worst, 1e-10, "double precision");
  vtkIndirectTriangleTree empty;
  empty.Finish();
  vtkIndirectTriangleTree::Hit hit;
  Check("an empty tree", !empty.FindNearest({ 0, 0, 0 }, { 0, 0, 1 }, 0, hit));
}

// Compares with VTK's locator, an independent program: the same distances. The argument is the
// approximate number of triangles, for timing.
VTK_INDIRECT_TEST(NearestTriangleBesideVTK)
{
  const int asked = GetArguments().empty() ? 20000 : std::stoi(GetArguments().front());
  const int sides = std::max(8, static_cast<int>(std::sqrt(asked / 4.0)));
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(2 * sides);
  source->SetPhiResolution(sides);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkNew<vtkPolyData> data;
  data->ShallowCopy(source->GetOutput());
  // Waves on it, so that rays meet more than one sheet.
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 p;
    data->GetPoint(i, &p[0]);
    p *= 1.0 + 0.2 * std::sin(14.0 * p.x) * std::sin(17.0 * p.y + 1.0) * std::sin(15.0 * p.z);
    points->InsertNextPoint(&p[0]);
  }
  data->SetPoints(points);
  const auto seconds = [](std::clock_t since)
  { return static_cast<double>(std::clock() - since) / CLOCKS_PER_SEC; };
  std::clock_t begin = std::clock();
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(data);
  locator->BuildLocator();
  std::cout << data->GetNumberOfPolys() << " triangles: VTK's locator made in " << seconds(begin);
  begin = std::clock();
  vtkIndirectTriangleTree tree;
  vtkIdType count;
  const vtkIdType* ids;
  for (vtkIdType i = 0; i < data->GetNumberOfPolys(); ++i)
  {
    data->GetCellPoints(i, count, ids);
    glm::dvec3 corners[3];
    for (int k = 0; k < 3; ++k)
    {
      data->GetPoint(ids[k], &corners[k][0]);
    }
    tree.Add(corners);
  }
  tree.Finish();
  std::cout << " s, the tree in " << seconds(begin) << " s\n";
  Random random(11);
  std::vector<glm::dvec3> starts;
  std::vector<glm::dvec3> directions;
  constexpr size_t rays = 5000;
  for (size_t i = 0; i < rays; ++i)
  {
    starts.push_back((i % 2 ? 0.3 : 2.0) * random.NextDirection());
    directions.push_back(glm::normalize(0.5 * random.NextDirection() - starts.back()));
  }
  std::vector<double> expected(rays, -1.0);
  begin = std::clock();
  for (size_t i = 0; i < rays; ++i)
  {
    glm::dvec3 end = starts[i] + 4.0 * directions[i];
    double t;
    double x[3];
    double parametric[3];
    int part;
    vtkIdType cell;
    if (locator->IntersectWithLine(&starts[i][0], &end[0], 1e-12, t, x, parametric, part, cell))
    {
      expected[i] = 4.0 * t;
    }
  }
  const double vtks = seconds(begin);
  std::vector<double> found(rays, -1.0);
  begin = std::clock();
  for (size_t i = 0; i < rays; ++i)
  {
    vtkIndirectTriangleTree::Hit hit;
    if (tree.FindNearest(starts[i], directions[i], vtkIndirectTriangleTree::None, hit))
    {
      found[i] = hit.Distance;
    }
  }
  std::cout << "microseconds a ray: VTK " << 1e6 * vtks / rays << ", the tree "
            << 1e6 * seconds(begin) / rays << "\n";
  int different = 0;
  for (size_t i = 0; i < rays; ++i)
  {
    different += std::abs(found[i] - expected[i]) > 1e-9 ? 1 : 0;
  }
  CheckAtMost("rays with another distance", different, 5.0,
    "VTK's locator loses a ray in a thousand that passes an edge");
}

VTK_INDIRECT_TEST(ScrambledPoints)
{
  using vtkIndirectSamplePattern::ScrambledPoint;
  for (const std::uint32_t seed : { 0u, 17u, 4711u })
  {
    // Each box of area 1/256, of any shape, contains one of the first 256 points, and one of the
    // next.
    for (const std::uint32_t first : { 0u, 256u })
    {
      int wrong = 0;
      for (int columns = 0; columns <= 8; ++columns)
      {
        std::vector<int> counts(256, 0);
        for (std::uint32_t i = 0; i < 256; ++i)
        {
          const glm::dvec2 p = ScrambledPoint(first + i, seed);
          const int x = static_cast<int>(p.x * (1 << columns));
          const int y = static_cast<int>(p.y * (1 << (8 - columns)));
          ++counts[static_cast<size_t>(x + (y << columns))];
        }
        for (const int count : counts)
        {
          wrong += count == 1 ? 0 : 1;
        }
      }
      CheckEqual("boxes without one point", wrong, 0);
    }
  }
  // The two sequences are uncorrelated.
  double product = 0.0;
  for (std::uint32_t i = 0; i < 1024; ++i)
  {
    product += (ScrambledPoint(i, 1).x - 0.5) * (ScrambledPoint(i, 2).x - 0.5) / 1024.0;
  }
  CheckAtMost("correlation", std::abs(12.0 * product), 0.1, "three times 1 / sqrt(1024)");
}
