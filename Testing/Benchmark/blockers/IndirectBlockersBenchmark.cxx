// SPDX-License-Identifier: BSD-3-Clause
// IndirectBlockersBenchmark NAME SPHERES [TRIANGLES | --shaders]
//
// Rows of a table: what stands between virtual lights and receivers by voxels, by depth maps and by
// spheres in a grid, against the true geometry. One thread, one process, processor's time. With
// --shaders rows of another one: what a picture costs in shaders.
#include "BlockersMaps.h"
#include "BlockersScene.h"
#include "BlockersShaders.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "Visibility/vtkIndirectDistanceField.h"
#include "Visibility/vtkIndirectOccupancyVolume.h"
#include "Visibility/vtkIndirectSphereGrid.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>

namespace
{
constexpr int NumberOfReceivers = 400;
constexpr int NumberOfLights = 256; // the samplers' default
constexpr int Resolution = 128;     // of voxels, the default
constexpr size_t MostEntries = vtkIndirectSphereGrid::MaximumNumberOfEntries;
// A frame of 512 x 512: a receiver at every fourth pixel either way, as the gather interpolates.
constexpr double ReceiversOfFrame = 512.0 * 512.0 / 16.0;

double GetSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// The least of five runs.
double MeasureSeconds(const std::function<void(int)>& run)
{
  double least = 1e300;
  for (int i = 0; i < 5; ++i)
  {
    const double start = GetSeconds();
    run(i);
    least = std::min(least, GetSeconds() - start);
  }
  return least;
}

// Voxels of the spheres' surfaces without any triangles: a bound of what voxels could cost.
void MarkSpheres(const vtkIndirectOccupancyVolume& volume, const std::vector<glm::dvec4>& spheres,
  std::vector<glm::uvec4>& columns)
{
  const glm::ivec3 size = volume.GetSize();
  columns.assign(static_cast<size_t>(size.x) * size.y, glm::uvec4(0u));
  for (const glm::dvec4& sphere : spheres)
  {
    const glm::vec3 c(volume.ToVoxels(glm::dvec3(sphere)));
    const float r = static_cast<float>(sphere.w / volume.GetVoxelSize());
    const int lowerY = std::max(0, static_cast<int>(std::floor(c.y - r)));
    const int upperY = std::min(size.y - 1, static_cast<int>(std::floor(c.y + r)));
    const int lowerX = std::max(0, static_cast<int>(std::floor(c.x - r)));
    const int upperX = std::min(size.x - 1, static_cast<int>(std::floor(c.x + r)));
    for (int y = lowerY; y <= upperY; ++y)
    {
      const float nearY = c.y - std::clamp(c.y, y + 0.0f, y + 1.0f);
      const float farY = std::max(std::abs(c.y - y), std::abs(y + 1.0f - c.y));
      for (int x = lowerX; x <= upperX; ++x)
      {
        const float nearX = c.x - std::clamp(c.x, x + 0.0f, x + 1.0f);
        const float farX = std::max(std::abs(c.x - x), std::abs(x + 1.0f - c.x));
        const float outer = r * r - nearX * nearX - nearY * nearY;
        if (outer < 0.0f)
        {
          continue;
        }
        const float high = std::sqrt(outer);
        const float low = std::sqrt(std::max(r * r - farX * farX - farY * farY, 0.0f));
        auto floorOf = [](float z) { return static_cast<int>(std::floor(z)); };
        columns[x + static_cast<size_t>(size.x) * y] |=
          vtkIndirectKernels::vtkiBitRange(floorOf(c.z - high), floorOf(c.z - low)) |
          vtkIndirectKernels::vtkiBitRange(floorOf(c.z + low), floorOf(c.z + high));
      }
    }
  }
}

using Answer = std::function<void(std::vector<char>&)>; // of all pairs

void PrintRow(const std::string& name, const std::string& by, const BlockersScene& scene,
  const Answer& answer, double buildMilliseconds)
{
  const std::vector<BlockersPair>& pairs = scene.Pairs;
  std::vector<char> seen(pairs.size(), 0);
  const double seconds = MeasureSeconds([&](int) { answer(seen); });
  double through = 0.0; // hidden ones that are said to be seen
  double lost = 0.0;
  std::vector<double> found(NumberOfReceivers, 0.0);
  std::vector<double> expected(NumberOfReceivers, 0.0);
  double change = 0.0;
  for (size_t i = 0; i < pairs.size(); ++i)
  {
    const BlockersPair& pair = pairs[i];
    through += seen[i] && !pair.Visible;
    lost += !seen[i] && pair.Visible;
    change += pair.Weight * (static_cast<bool>(seen[i]) != pair.Visible);
    found[static_cast<size_t>(pair.Receiver)] += seen[i] ? pair.Weight : 0.0;
    expected[static_cast<size_t>(pair.Receiver)] += pair.Visible ? pair.Weight : 0.0;
  }
  double sum = 0.0;
  double all = 0.0;
  double squares = 0.0;
  for (int r = 0; r < NumberOfReceivers; ++r)
  {
    const size_t i = static_cast<size_t>(r);
    sum += expected[i];
    all += found[i];
    squares += (found[i] - expected[i]) * (found[i] - expected[i]);
  }
  const double count = static_cast<double>(pairs.size());
  const double nanoseconds = 1e9 * seconds / count;
  const double facing = count / NumberOfReceivers / NumberOfLights;
  const double segments = ReceiversOfFrame * NumberOfLights * facing;
  std::printf("| %s | %s | %.1f%% | %.1f%% | %.3f | %+.1f%% | %.3f | %.0f | ", name.c_str(),
    by.c_str(), 100.0 * through / count, 100.0 * lost / count, change / sum,
    100.0 * (all / sum - 1.0), std::sqrt(squares / NumberOfReceivers) * NumberOfReceivers / sum,
    nanoseconds);
  if (buildMilliseconds < 0.0)
  {
    std::printf("| |\n");
    return;
  }
  std::printf(
    "%.1f | %.0f |\n", buildMilliseconds, 1e-6 * segments * nanoseconds + buildMilliseconds);
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  if (argc < 3 || argc > 4)
  {
    std::fprintf(stderr, "usage: %s NAME SPHERES [TRIANGLES | --shaders]\n", argv[0]);
    return 2;
  }
  const std::string name = argv[1];
  vtkSMPTools::Initialize(1);
  BlockersScene scene;
  const bool shaders = argc > 3 && std::string(argv[3]) == "--shaders";
  if (!scene.Read(argv[2], argc > 3 && !shaders ? argv[3] : ""))
  {
    std::fprintf(stderr, "%s: no spheres or no triangles in the files\n", name.c_str());
    return 1;
  }
  scene.MakePairs(NumberOfReceivers, NumberOfLights);
  const std::vector<BlockersPair>& pairs = scene.Pairs;
  double hidden = 0.0;
  for (const BlockersPair& pair : pairs)
  {
    hidden += !pair.Visible;
  }
  std::fprintf(stderr, "%s: %zu spheres, %zu triangles, %zu pairs, %.3f of them hidden\n",
    name.c_str(), scene.Spheres.size(), scene.Triangles.size(), pairs.size(),
    hidden / static_cast<double>(pairs.size()));

  if (shaders)
  {
    vtkIndirectOccupancyVolume volume;
    volume.Clear(scene.Lower, scene.Upper, Resolution);
    for (const BlockersScene::Triangle& triangle : scene.Triangles)
    {
      volume.AddTriangle(triangle.data(), glm::dvec3(0.5));
    }
    volume.Finish();
    BlockersMaps maps;
    maps.Draw(scene);
    vtkIndirectSphereGrid grid;
    grid.Build(scene.Spheres);
    MeasureShaders(name, scene, volume.GetDistanceField(), maps, grid);
    return 0;
  }

  PrintRow(
    name, "nothing", scene, [](std::vector<char>& seen) { std::fill(seen.begin(), seen.end(), 1); },
    -1.0);

  // Voxels
  // -----------------------------------------------------------------------------------------
  vtkIndirectOccupancyVolume volume;
  auto voxelize = [&](const std::vector<BlockersScene::Triangle>& triangles)
  {
    volume.Clear(scene.Lower, scene.Upper, Resolution);
    for (const BlockersScene::Triangle& triangle : triangles)
    {
      volume.AddTriangle(triangle.data(), glm::dvec3(0.5));
    }
    volume.Finish();
    volume.GetDistanceField();
  };
  std::vector<BlockersScene::Triangle> turned = scene.TurnTriangles(0.05);
  const double voxels = 1e3 * MeasureSeconds([&](int) { voxelize(turned); });
  turned.clear();
  voxelize(scene.Triangles);
  vtkIndirectDistanceField distances;
  const double field = 1e3 * MeasureSeconds([&](int) { distances.Build(volume); });
  std::vector<glm::uvec4> columns;
  const std::vector<glm::dvec4> spheres = scene.TurnSpheres(0.05);
  const double marks = 1e3 * MeasureSeconds([&](int) { MarkSpheres(volume, spheres, columns); });
  std::fprintf(stderr,
    "  voxels: %.1f ms by triangles, %.1f of them distances; spheres straight into bits %.1f ms\n",
    voxels, field, marks);
  std::vector<vtkIndirectDistanceField::End> receivers;
  std::vector<vtkIndirectDistanceField::End> lights;
  for (const BlockersPlace& place : scene.Receivers)
  {
    receivers.push_back(distances.FindEnd(glm::vec3(place.Position), glm::vec3(place.Normal)));
  }
  for (const BlockersPlace& place : scene.Lights)
  {
    lights.push_back(distances.FindEnd(glm::vec3(place.Position), glm::vec3(place.Normal)));
  }
  auto byVoxels = [&](std::vector<char>& seen)
  {
    for (size_t i = 0; i < pairs.size(); ++i)
    {
      seen[i] = distances.IsVisible(receivers[static_cast<size_t>(pairs[i].Receiver)],
        lights[static_cast<size_t>(pairs[i].Light)]);
    }
  };
  PrintRow(name, "voxels", scene, byVoxels, voxels);
  if (!scene.IsMesh())
  {
    PrintRow(name, "voxels, marked by spheres", scene, byVoxels, marks + field);
  }

  // Depth maps.
  BlockersMaps maps;
  const double start = GetSeconds();
  maps.Draw(scene);
  // Rays through a tree say nothing of what drawing triangles costs.
  const double drawing = scene.IsMesh() ? -1.0 : 1e3 * (GetSeconds() - start);
  PrintRow(
    name, "depth maps", scene,
    [&](std::vector<char>& seen)
    {
      for (size_t i = 0; i < pairs.size(); ++i)
      {
        const BlockersPlace& place = scene.Receivers[static_cast<size_t>(pairs[i].Receiver)];
        seen[i] = maps.IsSeen(
          static_cast<size_t>(pairs[i].Light), glm::vec3(place.Position), glm::vec3(place.Normal));
      }
    },
    drawing);

  // Spheres.
  vtkIndirectSphereGrid grid;
  // The library's own number of cells, and others.
  for (const double cells : { 1.0, 0.0, 16.0 })
  {
    const double build =
      1e3 * MeasureSeconds([&](int) { grid.Build(spheres, cells, MostEntries); });
    grid.Build(scene.Spheres, cells, MostEntries);
    const std::string by = cells > 0.0
      ? "spheres, " + std::to_string(static_cast<int>(cells)) + " cells each"
      : "spheres";
    PrintRow(
      name, by, scene,
      [&](std::vector<char>& seen)
      {
        for (size_t i = 0; i < pairs.size(); ++i)
        {
          seen[i] = grid.IsFree(scene.Receivers[static_cast<size_t>(pairs[i].Receiver)].Position,
            scene.Lights[static_cast<size_t>(pairs[i].Light)].Position);
        }
      },
      build);
    std::fprintf(stderr, "  %s: %zu bytes, longest list %zu, %.0f steps in the mean\n", by.c_str(),
      grid.GetMainMemoryBytes(), grid.GetLongestList(), grid.GetNumberOfSteps());
  }
  return 0;
}
