// SPDX-License-Identifier: BSD-3-Clause
// The voxels of the scene: walls are watertight, however thin, slanted or finely divided, and free
// space stays free.
#include "OpenGL/vtkIndirectKernels.h"
#include "Scene/vtkIndirectFrame.h"
#include "Scene/vtkIndirectSurfaces.h"
#include "Visibility/vtkIndirectDistanceField.h"
#include "Visibility/vtkIndirectOccupancyVolume.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkIndirectVoxelLines.h"
#include "vtkIndirectVoxelPatch.h"

#include "vtkActor.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace vtkIndirectTest;

namespace
{
// Number of segments that pass a wall in the plane z = f(x, y) over the whole volume, between
// random points on both sides of it, by either walk.
int CountLeaks(vtkIndirectOccupancyVolume& volume, const glm::dvec3& normal, double offset,
  int count, double clearance)
{
  Random random(7);
  int leaks = 0;
  int tested = 0;
  while (tested < count)
  {
    glm::dvec3 ends[2];
    for (glm::dvec3& end : ends)
    {
      end = { random.Next(0.02, 0.98), random.Next(0.02, 0.98), random.Next(0.02, 0.98) };
    }
    const double d0 = glm::dot(normal, ends[0]) - offset;
    const double d1 = glm::dot(normal, ends[1]) - offset;
    // Ends in the wall's own voxels are not hidden by them.
    if (d0 * d1 >= 0.0 || std::min(std::abs(d0), std::abs(d1)) < clearance)
    {
      continue;
    }
    ++tested;
    const glm::vec3 start(volume.ToVoxels(ends[0]));
    const glm::vec3 end(volume.ToVoxels(ends[1]));
    leaks += volume.IsFree(start, end) ||
      vtkIndirectVoxelLines(volume.GetDistanceField()).IsFree(start, end);
  }
  return leaks;
}
}

VTK_INDIRECT_TEST(OccupancyBits)
{
  using namespace vtkIndirectKernels;
  int wrong = 0;
  for (int first = -3; first < 131; ++first)
  {
    for (int last = first - 2; last < 131; ++last)
    {
      const glm::uvec4 range = vtkiBitRange(first, last);
      for (int bit = 0; bit < 128; ++bit)
      {
        const bool set = (range[bit / 32] >> (bit % 32) & 1u) != 0u;
        wrong += set != (bit >= first && bit <= last);
      }
    }
  }
  CheckEqual("bits of ranges that differ from their definition", wrong, 0);
  wrong = 0;
  for (int set = 0; set < 128; ++set)
  {
    const glm::uvec4 column = vtkiBitRange(set, set);
    for (int bit = -70; bit < 200; ++bit)
    {
      wrong += vtkiHasBit(column, bit) != (bit == set);
    }
  }
  CheckEqual("bits that are found where they are not, or not where they are", wrong, 0);
}

VTK_INDIRECT_TEST(OccupancyWatertight)
{
  // Planes through the cube at all slants, whole and divided into pieces smaller than a voxel, at
  // three resolutions: one to eight voxels of wall.
  Random random(3);
  for (int resolution : { 16, 64, 128 })
  {
    int leaks = 0;
    int walls = 0;
    for (int i = 0; i < 12; ++i)
    {
      glm::dvec3 normal = i < 3 ? glm::dvec3(i == 0, i == 1, i == 2) : random.NextDirection();
      const double offset = glm::dot(normal, glm::dvec3(0.5) + 0.1 * random.Next());
      glm::dvec3 helper = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
      const glm::dvec3 u = glm::normalize(glm::cross(normal, helper)) * 4.0;
      const glm::dvec3 v = glm::cross(normal, u);
      vtkIndirectOccupancyVolume volume;
      volume.Clear(glm::dvec3(0.0), glm::dvec3(1.0), resolution);
      AddPatch(volume, normal * offset - 0.5 * u - 0.5 * v, u, v, i % 2 ? 1 : 6 * resolution);
      volume.Finish();
      leaks += CountLeaks(volume, normal, offset, 500, 2.0 * volume.GetVoxelSize());
      ++walls;
      // Thin: twice a plane's area over a voxel's face bounds what it can touch.
      const double face = volume.GetVoxelSize() * volume.GetVoxelSize();
      if (i == 0)
      {
        CheckAtMost("occupied voxels of a plane over its own", // 1 plane of voxels
          volume.GetNumberOfOccupiedVoxels() * face,
          std::pow(resolution / (resolution - 2.0), 2.0) * (1.0 + 1e-9),
          "one voxel thick, over the scene and the border of two voxels");
      }
    }
    CheckEqual(
      std::to_string(resolution) + ": segments through " + std::to_string(walls) + " walls", leaks,
      0);
  }
}

VTK_INDIRECT_TEST(OccupancyThickWalls)
{
  // Two faces of a wall of one to five voxels, and a gap in it: closed it is opaque, open it
  // transmits just the segments through the gap.
  for (int thickness = 1; thickness <= 5; ++thickness)
  {
    vtkIndirectOccupancyVolume volume;
    volume.Clear(glm::dvec3(0.0), glm::dvec3(1.0), 64);
    const double size = volume.GetVoxelSize();
    const double x = 0.5;
    for (double at : { x, x + (thickness - 1) * size })
    {
      AddPatch(volume, { at, -0.2, -0.2 }, { 0, 1.4, 0 }, { 0, 0, 1.4 }, 1);
    }
    volume.Finish();
    const std::string what = "wall of " + std::to_string(thickness) + " voxels: ";
    CheckEqual(what + "leaks",
      CountLeaks(volume, { 1, 0, 0 }, x + 0.5 * (thickness - 1) * size, 2000,
        (0.5 * thickness + 1.5) * size),
      0);

    vtkIndirectOccupancyVolume open;
    open.Clear(glm::dvec3(0.0), glm::dvec3(1.0), 64);
    for (double at : { x, x + (thickness - 1) * size })
    {
      AddPatch(open, { at, -0.2, -0.2 }, { 0, 1.4, 0 }, { 0, 0, 0.6 }, 1);
      AddPatch(open, { at, -0.2, 0.6 }, { 0, 1.4, 0 }, { 0, 0, 0.6 }, 1);
    }
    open.Finish();
    auto free = [&](double z)
    {
      return open.IsFree(
        glm::vec3(open.ToVoxels({ 0.1, 0.4, z })), glm::vec3(open.ToVoxels({ 0.9, 0.6, z })));
    };
    Check(what + "open, through the gap", free(0.5));
    Check(what + "open, beside it", !free(0.3) && !free(0.7));
  }
}

VTK_INDIRECT_TEST(OccupancyFree)
{
  // A segment is blocked exactly if a dense march along it meets an occupied voxel: from column to
  // column, and by leaps.
  Random random(11);
  vtkIndirectOccupancyVolume volume;
  volume.Clear(glm::dvec3(0.0), glm::dvec3(1.0), 128);
  for (int i = 0; i < 40; ++i)
  {
    const glm::dvec3 at(random.Next(), random.Next(), random.Next());
    AddPatch(volume, at, 0.2 * random.NextDirection(), 0.2 * random.NextDirection(), 1);
  }
  volume.Finish();
  int blocked = 0;
  int missed[2] = {};
  int invented[2] = {};
  for (int i = 0; i < 4000; ++i)
  {
    const glm::dvec3 a = volume.ToVoxels({ random.Next(), random.Next(), random.Next() });
    const glm::dvec3 b = volume.ToVoxels({ random.Next(), random.Next(), random.Next() });
    const bool free[2] = { volume.IsFree(glm::vec3(a), glm::vec3(b)),
      vtkIndirectVoxelLines(volume.GetDistanceField()).IsFree(glm::vec3(a), glm::vec3(b)) };
    bool met = false;
    bool deep = false; // met by more than rounding
    bool near = false; // an occupied voxel is within rounding
    const glm::ivec3 first(glm::floor(a));
    const glm::ivec3 last(glm::floor(b));
    const int steps = static_cast<int>(50.0 * glm::length(b - a)) + 1;
    for (int s = 0; s <= steps; ++s)
    {
      const glm::dvec3 p = a + (b - a) * (static_cast<double>(s) / steps);
      const glm::ivec3 voxel(glm::floor(p));
      met = met || (voxel != first && voxel != last && volume.IsOccupied(voxel));
      bool around = met;
      for (int corner = 0; corner < 8; ++corner)
      {
        const glm::ivec3 beside(glm::floor(
          p + 0.03 * glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1)));
        const bool occupied = beside != first && beside != last && volume.IsOccupied(beside);
        near = near || occupied;
        around = around && occupied;
      }
      deep = deep || around;
    }
    blocked += !free[0];
    for (int walk = 0; walk < 2; ++walk)
    {
      // Columns count both sides of a voxel's face; leaps choose one of two voxels at an edge.
      missed[walk] += (walk == 0 ? met : deep) && free[walk];
      invented[walk] += !near && !free[walk];
    }
  }
  for (int walk = 0; walk < 2; ++walk)
  {
    const std::string what = walk == 0 ? "columns: " : "leaps: ";
    CheckEqual(what + "segments that pass an occupied voxel", missed[walk], 0);
    CheckEqual(what + "segments blocked by nothing", invented[walk], 0);
  }
  CheckAtLeast("blocked segments", blocked, 500, "the test's own power");
  CheckAtLeast("free segments", 4000 - blocked, 500, "the test's own power");
}

VTK_INDIRECT_TEST(OccupancyClearance)
{
  // Distances by their definition; the edges of the volume differ, and none is a power of two.
  Random random(23);
  vtkIndirectOccupancyVolume volume;
  volume.Clear(glm::dvec3(0.0), glm::dvec3(0.7, 1.0, 0.9), 45);
  for (int i = 0; i < 4; ++i)
  {
    AddPatch(volume, 0.6 * glm::dvec3(random.Next(), random.Next(), random.Next()),
      0.1 * random.NextDirection(), 0.1 * random.NextDirection(), 1);
  }
  volume.Finish();
  const glm::ivec3 size = volume.GetSize();
  std::vector<glm::ivec3> occupied;
  auto forEach = [&size](const std::function<void(const glm::ivec3&)>& f)
  {
    for (int z = 0; z < size.z; ++z)
    {
      for (int y = 0; y < size.y; ++y)
      {
        for (int x = 0; x < size.x; ++x)
        {
          f({ x, y, z });
        }
      }
    }
  };
  forEach(
    [&](const glm::ivec3& voxel)
    {
      if (volume.IsOccupied(voxel))
      {
        occupied.push_back(voxel);
      }
    });
  int wrong = 0;
  int farthest = 0;
  forEach(
    [&](const glm::ivec3& voxel)
    {
      int nearest = 255;
      for (const glm::ivec3& other : occupied)
      {
        const glm::ivec3 d = glm::abs(other - voxel);
        nearest = std::min(nearest, std::max({ d.x, d.y, d.z }));
      }
      wrong += nearest != volume.GetDistanceField().Get(voxel);
      farthest = std::max(farthest, nearest);
    });
  CheckEqual("distances that differ from their definition", wrong, 0);
  CheckAtLeast("farthest", farthest, 15, "the test's own power");
  // Made anew with the volume.
  volume.Clear(glm::dvec3(0.0), glm::dvec3(1.0), 16);
  CheckEqual("distance in an empty volume", volume.GetDistanceField().Get({ 3, 4, 5 }), 255);
  const glm::vec3 outside(-3.0f, 4.5f, 20.0f);
  Check("a segment from outside to outside ends",
    vtkIndirectVoxelLines(volume.GetDistanceField()).IsFree(outside, -outside));
}

VTK_INDIRECT_TEST(OccupancyAlbedo)
{
  vtkIndirectOccupancyVolume volume;
  volume.Clear(glm::dvec3(0.0), glm::dvec3(1.0), 64);
  AddPatch(volume, { 0.1, 0.2, 0.3 }, { 0.7, 0, 0 }, { 0, 0.6, 0 }, 5);
  const glm::dvec3 corners[3] = { { 0.1, 0.1, 0.8 }, { 0.9, 0.1, 0.8 }, { 0.9, 0.6, 0.8 } };
  volume.AddTriangle(corners, { 0.9, 0.3, 0.1 });
  volume.Finish();
  CheckRelative("mean albedo, red", volume.GetMeanAlbedo().x, (0.42 * 0.5 + 0.2 * 0.9) / 0.62, 1e-9,
    "weighed by area");
  CheckEqual("bytes of planes that no one asked for", volume.GetPlanes().GetBytes(), size_t(0));
}

// Voxels have the reflectance of surfaces under light of others: coefficients of both kinds of
// shading count.
VTK_INDIRECT_TEST(OccupancyMaterials)
{
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  mapper->Update();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.8, 0.6, 0.4);
  actor->GetProperty()->SetDiffuse(0.5);
  actor->GetProperty()->SetMetallic(0.25);
  vtkIndirectFrame frame;
  vtkIndirectCaster caster;
  caster.Prop = actor;
  frame.Casters.push_back(caster);
  const double bounds[6] = { -0.5, 0.5, -0.5, 0.5, -0.5, 0.5 };
  std::copy(bounds, bounds + 6, frame.SceneBounds);
  auto red = [&](int interpolation)
  {
    actor->GetProperty()->SetInterpolation(interpolation);
    vtkIndirectOccupancyVolume volume;
    volume.KeepSurfaces();
    volume.Update(frame, vtkIndirectSurfaces(), 16);
    return volume.GetMeanAlbedo().x;
  };
  CheckRelative("Phong's diffuse colour", red(VTK_PHONG), 0.5 * 0.8, 1e-9, "rounding of the means");
  CheckRelative("what is not metal: VTK's PBR divides light of vtkLights alone by pi", red(VTK_PBR),
    0.75 * 0.5 * 0.8, 1e-9, "same");
}
