// SPDX-License-Identifier: BSD-3-Clause
#include "RadianceHints/vtkIndirectHintGrid.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "RadianceHints/vtkIndirectHintSurfaces.h"
#include "Scene/vtkIndirectSurfaces.h"
#include "Visibility/vtkIndirectOccupancyVolume.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
// Hints whose rays are traced before their hits are collected.
constexpr int RayBatch = 256;

glm::ivec3 Unfold(int index, const glm::ivec3& size)
{
  return { index % size.x, index / size.x % size.y, index / size.x / size.y };
}

int Fold(const glm::ivec3& at, const glm::ivec3& size)
{
  return at.x + size.x * (at.y + size.y * at.z);
}
}

vtkIndirectHintGrid::vtkIndirectHintGrid(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
{
}

vtkIndirectHintGrid::~vtkIndirectHintGrid() = default;

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectHintGrid::GetCell(int grid) const
{
  return this->Current.Regions[grid].GetCell();
}

//------------------------------------------------------------------------------
glm::dvec4 vtkIndirectHintGrid::GetDirection(int ray, int edge)
{
  // Solid angle of a bin: corners are directions v / |v| with |v|_1 = 1, so that
  // dw = 4 du dv / (|v|^3 2) over the square [-1,1]^2 of area 4; eight by eight points a bin.
  constexpr int points = 8;
  glm::dvec3 sum(0.0);
  double angle = 0.0;
  for (int i = 0; i < points * points; ++i)
  {
    const double u = 2.0 * (ray % edge + (i % points + 0.5) / points) / edge - 1.0;
    const double v = 2.0 * (ray / edge + (i / points + 0.5) / points) / edge - 1.0;
    // |v|^2 at the octahedron's point for the square's point.
    const double z = 1.0 - std::abs(u) - std::abs(v);
    const double fold = std::max(-z, 0.0);
    const double x = std::abs(u) - fold;
    const double y = std::abs(v) - fold;
    const double r2 = x * x + y * y + z * z;
    const double share = 4.0 / (edge * edge * points * points) / (r2 * std::sqrt(r2));
    angle += share;
    sum += share *
      glm::dvec3(vtkIndirectKernels::vtkiOctahedralDecode(
        glm::vec2(static_cast<float>(u), static_cast<float>(v))));
  }
  return glm::dvec4(glm::normalize(sum), angle);
}

//------------------------------------------------------------------------------
int vtkIndirectHintGrid::FindRayEdge(int rays)
{
  return static_cast<int>(std::ceil(0.5 * std::sqrt(rays) - 1e-9)) * 2;
}

//------------------------------------------------------------------------------
std::string vtkIndirectHintGrid::FindObstacle(const Settings& settings, int longestEdge)
{
  double hints = 0.0;
  for (const Region& region : settings.Regions)
  {
    hints += static_cast<double>(region.Size.x) * region.Size.y * region.Size.z;
  }
  const double edge = FindRayEdge(settings.NumberOfRays);
  const double rays = edge * edge;
  const double most =
    std::min(MaximumNumberOfHits, 4.0 * static_cast<double>(longestEdge) * longestEdge);
  if (hints > static_cast<double>(RowLength) * longestEdge || hints * rays > most)
  {
    return std::to_string(static_cast<int>(hints)) + " hints of " +
      std::to_string(static_cast<int>(rays)) + " rays need a larger table than the " +
      std::to_string(static_cast<int>(most)) + " entries that there may be.";
  }
  return {};
}

//------------------------------------------------------------------------------
std::string vtkIndirectHintGrid::FindObstacle(int longestEdge) const
{
  return this->GetNumberOfSurfelRows() <= longestEdge ? std::string()
                                                      : "The hints' rays meet " +
      std::to_string(this->Surfels.size()) + " surfaces, more than a texture can hold.";
}

//------------------------------------------------------------------------------
void vtkIndirectHintGrid::Clear()
{
  this->Hints.clear();
  this->First.clear();
  this->Masks.clear();
  std::vector<float>().swap(this->Hits); // the largest table: frees its memory
  this->Surfels.clear();
  this->Directions.clear();
  this->Albedo.clear();
  this->MaskSize = glm::ivec3(0);
  this->NumberOfActive = 0;
  for (vtkIndirectDataTexture& texture : this->Textures)
  {
    texture.Clear();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectHintGrid::Build(const Settings& settings, const vtkIndirectOccupancyVolume* volume,
  const vtkIndirectSurfaces* surfaces)
{
  this->Clear();
  this->Current = settings;
  this->Volume = volume && !volume->IsEmpty() ? volume : nullptr;
  this->RayEdge = FindRayEdge(settings.NumberOfRays);
  this->Current.NumberOfRays = this->Volume ? this->RayEdge * this->RayEdge : 0;
  const int grids = static_cast<int>(settings.Regions.size());
  for (int grid = 0; grid < grids; ++grid)
  {
    this->Place(grid);
  }
  this->NumberOfActive = static_cast<int>(std::count_if(
    this->Hints.begin(), this->Hints.end(), [](const glm::vec4& hint) { return hint.w > 0.0f; }));
  if (this->Volume && settings.Masks)
  {
    this->MaskSize = this->Volume->GetSize();
    this->Masks.assign(
      2 * static_cast<size_t>(this->MaskSize.x) * this->MaskSize.y * this->MaskSize.z, 0);
    for (int grid = 0; grid < grids; ++grid)
    {
      this->FindMasks(grid);
    }
    this->FindPlanes();
  }
  if (this->Current.NumberOfRays > 0)
  {
    this->FindHits(*surfaces);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectHintGrid::Place(int grid)
{
  const Region& region = this->Current.Regions[grid];
  const glm::dvec3 cell = this->GetCell(grid);
  const int count = region.Size.x * region.Size.y * region.Size.z;
  const int first = this->GetNumberOfHints();
  this->First.push_back(first);
  this->Hints.resize(static_cast<size_t>(first) + count);
  const vtkIndirectOccupancyVolume* volume = this->Volume;
  const bool move = volume && this->Current.Masks;
  const double voxel = volume ? volume->GetVoxelSize() : 1.0;
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const glm::ivec3 at = Unfold(static_cast<int>(i), region.Size);
        glm::dvec3 position = region.Lower + (glm::dvec3(at) + 0.5) * cell;
        bool active = true;
        // Only if the voxels hold all visible surfaces: others have no known position.
        if (volume && this->Current.SkipEmpty && volume->HoldsAll())
        {
          const glm::dvec3 reach = (this->Current.Reach + 1.0) * cell;
          active = volume->IsAnyOccupied(glm::ivec3(glm::floor(volume->ToVoxels(position - reach))),
            glm::ivec3(glm::floor(volume->ToVoxels(position + reach))));
        }
        const glm::ivec3 home =
          glm::ivec3(glm::floor(volume ? volume->ToVoxels(position) : position));
        if (active && move && volume->IsOccupied(home))
        {
          // Nearest free voxel, less than half a cell away; without one the hint is in a solid.
          const glm::ivec3 range = glm::ivec3(glm::floor(0.5 * cell / voxel));
          double nearest = INFINITY;
          glm::ivec3 best = home;
          for (int z = -range.z; z <= range.z; ++z)
          {
            for (int y = -range.y; y <= range.y; ++y)
            {
              for (int x = -range.x; x <= range.x; ++x)
              {
                const glm::ivec3 to = home + glm::ivec3(x, y, z);
                const double distance = x * x + y * y + z * z;
                if (distance < nearest && !volume->IsOccupied(to))
                {
                  nearest = distance;
                  best = to;
                }
              }
            }
          }
          active = std::isfinite(nearest);
          position = volume->ToScene(glm::dvec3(best) + 0.5);
        }
        this->Hints[first + i] = glm::vec4(glm::vec3(position), active ? 1.0f : 0.0f);
      }
    });
}

//------------------------------------------------------------------------------
namespace
{
// Offsets from a voxel, near ones first, each with the list index of the previous offset on the way
// to it. Two successive offsets differ by at most one voxel along each axis: a surface between
// their centres touches one of the two voxels.
struct Way
{
  glm::ivec3 Offset;
  int Before;
};

std::vector<Way> MakeWays(const glm::ivec3& reach)
{
  const glm::ivec3 size = 2 * reach + 1;
  const int longest = std::max({ reach.x, reach.y, reach.z });
  std::vector<int> place(static_cast<size_t>(size.x) * size.y * size.z, -1);
  std::vector<Way> ways;
  ways.reserve(place.size());
  std::vector<std::vector<glm::ivec3>> shells(longest + 1);
  for (int i = 0; i < static_cast<int>(place.size()); ++i)
  {
    const glm::ivec3 d = Unfold(i, size) - reach;
    shells[std::max({ std::abs(d.x), std::abs(d.y), std::abs(d.z) })].push_back(d);
  }
  for (int m = 0; m <= longest; ++m)
  {
    for (const glm::ivec3& d : shells[m])
    {
      Way way = { d, -1 };
      if (m > 0)
      {
        const glm::ivec3 before(glm::round(glm::dvec3(d) * ((m - 1.0) / m)));
        way.Before = place[Fold(before + reach, size)];
      }
      place[Fold(d + reach, size)] = static_cast<int>(ways.size());
      ways.push_back(way);
    }
  }
  return ways;
}
}

//------------------------------------------------------------------------------
// Spreads visibility from each hint over the voxels of the cells around it: a voxel is visible if
// it is free and its predecessor is visible.
void vtkIndirectHintGrid::FindMasks(int grid)
{
  const Region& region = this->Current.Regions[grid];
  const glm::dvec3 cell = this->GetCell(grid);
  const vtkIndirectOccupancyVolume* volume = this->Volume;
  const glm::ivec3 size = this->MaskSize;
  const double voxel = volume->GetVoxelSize();
  // A cell to each side, and half a cell that a hint may have been moved; beyond the outermost
  // hints there is half a cell up to the volume's border.
  const glm::ivec3 reach = glm::ivec3(glm::ceil(1.5 * cell / voxel)) + 2;
  const std::vector<Way> ways = MakeWays(reach);
  // For each voxel and axis, the lower of the two hints around it.
  std::vector<int> bases[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < size[axis]; ++i)
    {
      const double center = volume->ToScene(glm::dvec3(i + 0.5))[axis];
      bases[axis].push_back(
        static_cast<int>(std::floor((center - region.Lower[axis]) / cell[axis] - 0.5)));
    }
  }
  // Corners (0: lower, 1: upper, as bits) at which a hint lies around a voxel, along one axis.
  auto corners = [&](int axis, int hint, int at)
  {
    const int last = region.Size[axis] - 1;
    const int base = bases[axis][at];
    return (std::clamp(base, 0, last) == hint ? 1 : 0) |
      (std::clamp(base + 1, 0, last) == hint ? 2 : 0);
  };

  // Hints of one parity share no voxel.
  for (int parity = 0; parity < 8; ++parity)
  {
    const glm::ivec3 odd(parity & 1, parity >> 1 & 1, parity >> 2);
    const glm::ivec3 count = (region.Size - odd + 1) / 2;
    vtkSMPTools::For(0, count.x * count.y * count.z,
      [&](vtkIdType begin, vtkIdType end)
      {
        std::vector<char> seen(ways.size());
        for (vtkIdType i = begin; i < end; ++i)
        {
          const glm::ivec3 at = 2 * Unfold(static_cast<int>(i), count) + odd;
          const glm::vec4& hint = this->Hints[this->First[grid] + Fold(at, region.Size)];
          if (!(hint.w > 0.0f))
          {
            continue;
          }
          const glm::ivec3 home(glm::floor(volume->ToVoxels(glm::dvec3(hint))));
          // The voxels that may lie between this hint and its neighbours.
          const glm::dvec3 middle = region.Lower + (glm::dvec3(at) + 0.5) * cell;
          glm::ivec3 lower =
            glm::max(glm::ivec3(glm::floor(volume->ToVoxels(middle - cell))), glm::ivec3(0));
          glm::ivec3 upper =
            glm::min(glm::ivec3(glm::floor(volume->ToVoxels(middle + cell))), size - 1);
          for (int axis = 0; axis < 3; ++axis)
          {
            // Beyond the outermost hints these represent all others.
            lower[axis] = at[axis] == 0 ? 0 : lower[axis];
            upper[axis] = at[axis] == region.Size[axis] - 1 ? size[axis] - 1 : upper[axis];
            lower[axis] = std::max(lower[axis], home[axis] - reach[axis]);
            upper[axis] = std::min(upper[axis], home[axis] + reach[axis]);
          }
          const bool empty = !volume->IsAnyOccupied(lower, upper);
          const glm::ivec3 far = glm::max(home - lower, upper - home);
          const int farthest = std::max({ far.x, far.y, far.z });
          for (size_t k = 0; k < ways.size(); ++k)
          {
            const glm::ivec3& offset = ways[k].Offset;
            if (std::max({ std::abs(offset.x), std::abs(offset.y), std::abs(offset.z) }) > farthest)
            {
              break;
            }
            const glm::ivec3 there = home + offset;
            if (glm::any(glm::lessThan(there, glm::ivec3(0))) ||
              glm::any(glm::greaterThanEqual(there, size)))
            {
              // Voxels outside the range do not count as visible, although a path might leave it
              // and return.
              seen[k] = 0;
              continue;
            }
            seen[k] =
              empty || ((ways[k].Before < 0 || seen[ways[k].Before]) && !volume->IsOccupied(there));
            if (!seen[k])
            {
              continue;
            }
            const int x = corners(0, at.x, there.x);
            const int y = corners(1, at.y, there.y);
            const int z = corners(2, at.z, there.z);
            if (x && y && z)
            {
              unsigned char mask = 0;
              for (int corner = 0; corner < 8; ++corner)
              {
                mask |= (x >> (corner & 1) & y >> (corner >> 1 & 1) & z >> (corner >> 2) & 1)
                  << corner;
              }
              this->Masks[2 * static_cast<size_t>(Fold(there, size)) + grid] |= mask;
            }
          }
        }
      });
  }
}

//------------------------------------------------------------------------------
// Positions in a wall's own voxels see no hint: they need the plane that tells their side of the
// wall.
void vtkIndirectHintGrid::FindPlanes()
{
  const vtkIndirectVoxelPlanes& planes = this->Volume->GetPlanes();
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Masks.size() / 2),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        glm::dvec3 normal;
        double height;
        if (planes.Find(Unfold(static_cast<int>(i), this->MaskSize), normal, height))
        {
          const int code =
            vtkIndirectKernels::vtkiPackPlane(glm::vec3(normal), static_cast<float>(height));
          this->Masks[2 * i] = static_cast<unsigned char>(code & 255);
          this->Masks[2 * i + 1] = static_cast<unsigned char>(code >> 8);
        }
      }
    });
}

//------------------------------------------------------------------------------
unsigned char vtkIndirectHintGrid::GetMask(int grid, const glm::ivec3& voxel) const
{
  return this->Masks[2 * static_cast<size_t>(Fold(voxel, this->MaskSize)) + grid];
}

//------------------------------------------------------------------------------
void vtkIndirectHintGrid::FindHits(const vtkIndirectSurfaces& surfaces)
{
  const int rays = this->Current.NumberOfRays;
  std::vector<glm::dvec3> directions;
  for (int i = 0; i < rays; ++i)
  {
    const glm::dvec4 direction = GetDirection(i, this->RayEdge);
    directions.emplace_back(direction);
    this->Directions.emplace_back(direction);
  }
  this->Hits.assign(this->Hints.size() * rays, -1.0f);
  this->Albedo.assign(this->Hints.size(), glm::vec4(0.0f));
  vtkIndirectHintSurfaces sides(this->Volume->GetSize());
  struct Met
  {
    vtkIndirectHintSurfaces::Hit Hit;
    bool There;
  };
  std::vector<Met> met(static_cast<size_t>(RayBatch) * rays);
  for (int begin = 0; begin < this->GetNumberOfHints(); begin += RayBatch)
  {
    const int count = std::min(RayBatch, this->GetNumberOfHints() - begin);
    vtkSMPTools::For(0, count,
      [&](vtkIdType from, vtkIdType to)
      {
        for (vtkIdType i = from; i < to; ++i)
        {
          const glm::vec4& hint = this->Hints[begin + i];
          for (int ray = 0; ray < rays; ++ray)
          {
            Met& one = met[i * rays + ray];
            vtkIndirectSurfaces::Meeting meeting;
            one.There = hint.w > 0.0f &&
              surfaces.Meet(
                glm::dvec3(hint), directions[ray], vtkIndirectTriangleTree::None, meeting);
            one.Hit = { this->Volume->ToVoxels(meeting.Position), meeting.FacetNormal,
              meeting.Sends ? meeting.Albedo : glm::dvec3(0.0) };
          }
        }
      });
    // In the order of hints, so that the surfaces do not depend on the threads.
    for (int i = 0; i < count; ++i)
    {
      glm::vec4& albedo = this->Albedo[begin + i];
      for (int ray = 0; ray < rays; ++ray)
      {
        const Met& one = met[static_cast<size_t>(i) * rays + ray];
        if (one.There)
        {
          this->Hits[static_cast<size_t>(begin + i) * rays + ray] =
            static_cast<float>(sides.Add(one.Hit));
          albedo += glm::vec4(glm::vec3(one.Hit.Albedo), 1.0f);
        }
      }
      albedo /= std::max(albedo.w, 1.0f);
    }
  }
  // Depth behind the plane at which a sender still lies on the surface: as for the surface's own
  // hits.
  const float depth =
    static_cast<float>(vtkIndirectHintSurfaces::PlaneDepth * this->Volume->GetVoxelSize());
  for (int i = 0; i < sides.GetNumberOfSurfaces(); ++i)
  {
    const vtkIndirectHintSurfaces::Hit mean = sides.GetMean(i);
    this->Surfels.push_back({ glm::vec3(this->Volume->ToScene(mean.Position)),
      glm::vec3(mean.Normal), glm::vec3(mean.Albedo), depth });
  }
}

//------------------------------------------------------------------------------
int vtkIndirectHintGrid::GetHit(int hint, int ray) const
{
  return static_cast<int>(this->Hits[static_cast<size_t>(hint) * this->Current.NumberOfRays + ray]);
}

//------------------------------------------------------------------------------
size_t vtkIndirectHintGrid::GetMainMemoryBytes() const
{
  return (this->Hints.size() + this->Directions.size() + this->Albedo.size()) * sizeof(glm::vec4) +
    this->Masks.size() + this->Hits.size() * sizeof(float) + this->Surfels.size() * sizeof(Surfel);
}

//------------------------------------------------------------------------------
int vtkIndirectHintGrid::GetNumberOfSurfelRows() const
{
  return std::max(1, (static_cast<int>(this->Surfels.size()) + RowLength - 1) / RowLength);
}
