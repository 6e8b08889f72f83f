// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of hints: colours, areas and planes in their cells.
#include "OpenGL/vtkIndirectKernels.h"
#include "RadianceHints/vtkIndirectHintGrid.h"
#include "Scene/vtkIndirectSurfaces.h"
#include "Visibility/vtkIndirectOccupancyVolume.h"
#include "vtkIndirectSurfaceFrame.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkIndirectVoxelPatch.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
vtkIndirectHintGrid::Settings HintsInUnitCube(int edge)
{
  vtkIndirectHintGrid::Region region;
  region.Upper = glm::dvec3(1.0);
  region.Size = glm::ivec3(edge);
  vtkIndirectHintGrid::Settings settings;
  settings.Regions.push_back(region);
  return settings;
}
}

VTK_INDIRECT_TEST(HintSurfaces)
{
  // A wall thinner than a voxel with different colours on its sides, and a bar thinner than a
  // voxel: hints see the colour of the side that faces them, and the bar's true size.
  SurfaceFrame scene;
  const double wall = 0.52;
  auto quad = [&](const glm::dvec3& a, const glm::dvec3& u, const glm::dvec3& v, double albedo) {
    scene.Add({ { a, a + u, a + u + v }, { a, a + u + v, a + v } }, albedo);
  };
  quad({ wall, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, 0.9);
  quad({ wall + 0.004, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, 0.1);
  const double bar = 0.008;
  const double place = 0.3;
  quad({ place, 0, 0.5 }, { 0, 1, 0 }, { 0, 0, bar }, 0.5);
  vtkIndirectSurfaces surfaces;
  surfaces.Update(scene.Frame);
  vtkIndirectOccupancyVolume volume;
  volume.Update(scene.Frame, surfaces, 32);
  vtkIndirectHintGrid::Settings settings = HintsInUnitCube(8);
  settings.NumberOfRays = 4096;
  vtkIndirectHintGrid grid;
  grid.Build(settings, &volume, &surfaces);
  int wrong = 0;
  int seen[3] = { 0, 0, 0 };
  double share = 0.0;
  double expected = 0.0;
  for (int hint = 0; hint < grid.GetNumberOfHints(); ++hint)
  {
    const glm::dvec3 at(grid.GetHints()[hint]);
    const bool left = at.x < wall;
    for (int ray = 0; ray < grid.GetNumberOfRays(); ++ray)
    {
      const int surfel = grid.GetHit(hint, ray);
      if (surfel < 0)
      {
        continue;
      }
      const auto& surface = grid.GetSurfels()[surfel];
      const glm::dvec4 direction = vtkIndirectHintGrid::GetDirection(ray, 64);
      const bool isBar = std::abs(surface.Position.x - place) < 1e-3;
      wrong += glm::dot(glm::dvec3(surface.Normal), glm::dvec3(direction)) > 0.0;
      wrong += std::abs(surface.Albedo.x - (isBar ? 0.5 : (left ? 0.9 : 0.1))) > 1e-6;
      ++seen[isBar ? 2 : (left ? 0 : 1)];
      share += isBar ? direction.w : 0.0;
    }
    if (left)
    {
      // Solid angle of the bar: a rectangle's, from four corner terms.
      auto corner = [&](double y, double z)
      {
        const double d = std::abs(place - at.x);
        return std::atan(y * z / (d * std::sqrt(d * d + y * y + z * z)));
      };
      const double y0 = -at.y;
      const double y1 = 1.0 - at.y;
      const double z0 = 0.5 - at.z;
      const double z1 = z0 + bar;
      expected += corner(y1, z1) - corner(y0, z1) - corner(y1, z0) + corner(y0, z0);
    }
  }
  CheckEqual("surfaces of another colour, or turned away", wrong, 0);
  for (int count : seen)
  {
    CheckAtLeast("rays on each", count, 1000, "the test's own power");
  }
  CheckRelative("solid angle of a bar a quarter of a voxel wide", share, expected, 0.1,
    "4096 rays from each of 256 hints, 3 degrees apart; a voxel's width would be four times as "
    "much");
}

VTK_INDIRECT_TEST(HintMasks)
{
  // A wall between two rows of hints: a voxel sees only the hints of its own side.
  vtkIndirectOccupancyVolume volume;
  volume.Clear(glm::dvec3(0.0), glm::dvec3(1.0), 64);
  const double wall = 0.52;
  AddPatch(volume, { wall, -0.1, -0.1 }, { 0, 1.2, 0 }, { 0, 0, 1.2 }, 1);
  volume.Finish();
  vtkIndirectHintGrid::Settings settings = HintsInUnitCube(8);
  settings.Masks = true;
  vtkIndirectHintGrid grid;
  grid.Build(settings, &volume, nullptr);
  int wrong = 0;
  int seen = 0;
  for (int x = 2; x < volume.GetSize().x - 2; ++x)
  {
    const glm::ivec3 voxel(x, 20, 31);
    const double center = volume.ToScene(glm::dvec3(voxel) + 0.5).x;
    const double inGrid = center * 8.0 - 0.5;
    if (volume.IsOccupied(voxel))
    {
      continue;
    }
    const int mask = grid.GetMask(0, voxel);
    for (int corner = 0; corner < 8; ++corner)
    {
      const int column = std::clamp(static_cast<int>(std::floor(inGrid)) + (corner & 1), 0, 7);
      const bool same = (center < wall) == ((column + 0.5) / 8.0 < wall);
      wrong += same != ((mask >> corner & 1) != 0);
      seen += mask >> corner & 1;
    }
  }
  CheckEqual("hints seen through the wall or hidden by nothing", wrong, 0);
  CheckAtLeast("hints seen", seen, 300, "the test's own power");
}

VTK_INDIRECT_TEST(HintPlanes)
{
  // A wall at any slant: from positions in its own voxels one step leads to a free voxel on the
  // same side.
  Random random(11);
  int wrong = 0;
  int stuck = 0;
  int tested = 0;
  for (int i = 0; i < 12; ++i)
  {
    const glm::dvec3 normal = i < 3 ? glm::dvec3(i == 0, i == 1, i == 2) : random.NextDirection();
    const glm::dvec3 u = glm::normalize(glm::cross(normal, glm::dvec3(0.36, 0.48, 0.8)));
    const glm::dvec3 v = glm::cross(normal, u);
    const glm::dvec3 middle(0.5 + random.Next(-0.05, 0.05));
    vtkIndirectOccupancyVolume volume;
    volume.KeepSurfaces();
    volume.Clear(glm::dvec3(0.0), glm::dvec3(1.0), 64);
    AddPatch(volume, middle - u - v, 2.0 * u, 2.0 * v, i % 2 ? 1 : 9);
    volume.Finish();
    vtkIndirectHintGrid::Settings settings = HintsInUnitCube(4);
    settings.Masks = true;
    vtkIndirectHintGrid grid;
    grid.Build(settings, &volume, nullptr);
    const double voxel = volume.GetVoxelSize();
    for (int k = 0; k < 2000; ++k)
    {
      const glm::dvec3 place = middle + random.Next(-0.3, 0.3) * u + random.Next(-0.3, 0.3) * v +
        random.Next(-1.0, 1.0) * voxel * normal;
      const glm::dvec3 at = volume.ToVoxels(place);
      const glm::ivec3 home(glm::floor(at));
      const double side = glm::dot(normal, place - middle) / voxel;
      // Five bits a coordinate have an error of a sixtieth of a right angle and more over half a
      // diagonal.
      if (!volume.IsOccupied(home) || std::abs(side) < 0.1)
      {
        continue;
      }
      ++tested;
      const glm::vec4 plane =
        vtkIndirectKernels::vtkiUnpackPlane(grid.GetMask(0, home) | (grid.GetMask(1, home) << 8));
      const glm::dvec3 left(vtkIndirectKernels::vtkiLeavePlane(glm::vec3(at), plane));
      stuck += volume.IsOccupied(glm::ivec3(glm::floor(left)));
      wrong += glm::dot(normal, volume.ToScene(left) - middle) * side <= 0.0;
    }
  }
  CheckAtLeast("places in walls", tested, 5000, "the test's own power");
  CheckEqual("places led to the wall's other side", wrong, 0);
  CheckEqual("places led to occupied voxels", stuck, 0);
}
