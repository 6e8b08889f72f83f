// SPDX-License-Identifier: BSD-3-Clause
#include "vtkProxySolid.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int Border = 2; // voxels around the bounds that are outside for certain
const glm::ivec3 Faces[6] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
  { 0, 0, -1 } };
}

//------------------------------------------------------------------------------
void vtkProxySolid::Build(const vtkProxySurface& surface, int resolution, double opening)
{
  this->Surface = &surface;
  const glm::dvec3 extent = surface.GetHigh() - surface.GetLow();
  this->Size = std::max(extent.x, std::max(extent.y, extent.z)) / resolution;
  this->Counts = glm::ivec3(glm::ceil(extent / this->Size)) + 2 * Border + 1;
  const glm::dvec3 middle = 0.5 * (surface.GetLow() + surface.GetHigh());
  this->Origin = middle - 0.5 * this->Size * glm::dvec3(this->Counts);
  this->Labels.assign(
    static_cast<size_t>(this->Counts.x) * this->Counts.y * this->Counts.z, Unknown);
  this->MarkWalls();
  this->FindRegions();
  this->Wound.clear();
  if (surface.HasOpenParts() && opening > 0.0)
  {
    this->FindWoundRegions(opening);
  }
  this->Voxels.clear();
  this->VoxelIndices.assign(this->Labels.size(), -1);
  for (int i = 0; i < static_cast<int>(this->Labels.size()); ++i)
  {
    if (this->Labels[static_cast<size_t>(i)] == Solid)
    {
      const glm::ivec3 v = this->Place(i);
      const glm::dvec3 p = this->Middle(v.x, v.y, v.z);
      this->VoxelIndices[static_cast<size_t>(i)] = static_cast<int>(this->Voxels.size());
      this->Voxels.push_back({ p, surface.FindNearest(p).Distance });
    }
  }
}

//------------------------------------------------------------------------------
void vtkProxySolid::MarkWalls()
{
  // Half a voxel's diagonal around the surface: no leak through edges or corners of voxels.
  const double reach = 0.5 * std::sqrt(3.0) * this->Size;
  const auto& points = this->Surface->GetPoints();
  for (const vtkProxySurface::Triangle& t : this->Surface->GetTriangles())
  {
    const glm::dvec3& a = points[static_cast<size_t>(t[0])];
    const glm::dvec3& b = points[static_cast<size_t>(t[1])];
    const glm::dvec3& c = points[static_cast<size_t>(t[2])];
    const glm::dvec3 low = glm::min(a, glm::min(b, c)) - reach - this->Origin;
    const glm::dvec3 high = glm::max(a, glm::max(b, c)) + reach - this->Origin;
    const glm::ivec3 first = glm::max(glm::ivec3(glm::floor(low / this->Size)), glm::ivec3(0));
    const glm::ivec3 last = glm::min(glm::ivec3(glm::floor(high / this->Size)), this->Counts - 1);
    for (int z = first.z; z <= last.z; ++z)
    {
      for (int y = first.y; y <= last.y; ++y)
      {
        for (int x = first.x; x <= last.x; ++x)
        {
          std::uint8_t& label = this->Labels[static_cast<size_t>(this->Index(x, y, z))];
          const glm::dvec3 p = this->Middle(x, y, z);
          if (label != Wall)
          {
            const glm::dvec3 way = vtkProxySurface::NearestOfTriangle(p, a, b, c) - p;
            if (glm::dot(way, way) <= reach * reach)
            {
              label = Wall;
            }
          }
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
std::vector<int> vtkProxySolid::Flood(
  int seed, std::vector<std::uint8_t>& values, std::uint8_t made) const
{
  const std::uint8_t old = values[static_cast<size_t>(seed)];
  std::vector<int> found{ seed };
  values[static_cast<size_t>(seed)] = made;
  for (size_t i = 0; i < found.size(); ++i)
  {
    const glm::ivec3 v = this->Place(found[i]);
    for (const glm::ivec3& face : Faces)
    {
      const glm::ivec3 w = v + face;
      if (glm::any(glm::lessThan(w, glm::ivec3(0))) ||
        glm::any(glm::greaterThanEqual(w, this->Counts)))
      {
        continue;
      }
      const int index = this->Index(w.x, w.y, w.z);
      if (values[static_cast<size_t>(index)] == old)
      {
        values[static_cast<size_t>(index)] = made;
        found.push_back(index);
      }
    }
  }
  return found;
}

//------------------------------------------------------------------------------
void vtkProxySolid::FindRegions()
{
  this->Flood(0, this->Labels, Outside);
  for (int i = 0; i < static_cast<int>(this->Labels.size()); ++i)
  {
    if (this->Labels[static_cast<size_t>(i)] == Unknown)
    {
      // If all parts are closed, a region with winding number zero is the hollow of a shell.
      const glm::ivec3 v = this->Place(i);
      const bool solid =
        this->Surface->HasOpenParts() || this->IsInClosedPart(this->Middle(v.x, v.y, v.z));
      this->Flood(i, this->Labels, solid ? Solid : Outside);
    }
  }
}

//------------------------------------------------------------------------------
void vtkProxySolid::FindWoundRegions(double opening)
{
  // Includes walls, so that regions thinner than a voxel are connected.
  std::vector<std::uint8_t> wound(this->Labels.size(), 0);
  for (size_t i = 0; i < wound.size(); ++i)
  {
    const glm::ivec3 v = this->Place(static_cast<int>(i));
    const glm::dvec3 p = this->Middle(v.x, v.y, v.z);
    if (glm::all(glm::greaterThan(p, this->Surface->GetLow())) &&
      glm::all(glm::lessThan(p, this->Surface->GetHigh())))
    {
      wound[i] = std::abs(this->Surface->GetWinding(p).Open) > 0.5 ? 1 : 0;
    }
  }
  this->Wound.assign(this->Labels.size(), 0);
  for (int i = 0; i < static_cast<int>(wound.size()); ++i)
  {
    if (wound[static_cast<size_t>(i)] != 1)
    {
      continue;
    }
    const std::vector<int> region = this->Flood(i, wound, 2);
    long long walls = 0;
    long long open = 0;
    for (int j : region)
    {
      const glm::ivec3 v = this->Place(j);
      for (const glm::ivec3& face : Faces)
      {
        const glm::ivec3 w = v + face;
        const int other = this->Index(w.x, w.y, w.z);
        if (wound[static_cast<size_t>(other)] == 0)
        {
          const bool wall = this->Labels[static_cast<size_t>(j)] == Wall ||
            this->Labels[static_cast<size_t>(other)] == Wall;
          walls += wall ? 1 : 0;
          open += wall ? 0 : 1;
        }
      }
    }
    if (static_cast<double>(open) > opening * static_cast<double>(open + walls))
    {
      continue;
    }
    for (int j : region)
    {
      if (this->Labels[static_cast<size_t>(j)] == Outside)
      {
        this->Labels[static_cast<size_t>(j)] = Solid;
      }
      const glm::ivec3 v = this->Place(j);
      for (int n = 0; n < 27; ++n)
      {
        const glm::ivec3 w = v + glm::ivec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
        this->Wound[static_cast<size_t>(this->Index(w.x, w.y, w.z))] = 2;
      }
    }
  }
}

//------------------------------------------------------------------------------
bool vtkProxySolid::IsInClosedPart(const glm::dvec3& p) const
{
  return std::abs(this->Surface->GetWinding(p).Closed) > 0.5;
}

//------------------------------------------------------------------------------
int vtkProxySolid::VoxelOf(const glm::dvec3& p) const
{
  const glm::ivec3 v(glm::floor((p - this->Origin) / this->Size));
  const bool in =
    glm::all(glm::greaterThanEqual(v, glm::ivec3(0))) && glm::all(glm::lessThan(v, this->Counts));
  return in ? this->Index(v.x, v.y, v.z) : -1;
}

//------------------------------------------------------------------------------
bool vtkProxySolid::IsSolid(const glm::dvec3& p) const
{
  const int voxel = this->VoxelOf(p);
  if (voxel < 0)
  {
    return false;
  }
  std::uint8_t label = this->Labels[static_cast<size_t>(voxel)];
  if (label != Wall)
  {
    return label == Solid;
  }
  const vtkProxySurface::Winding winding = this->Surface->GetWinding(p);
  if (std::abs(winding.Closed) > 0.5)
  {
    return true;
  }
  if (!this->Surface->HasOpenParts())
  {
    return false;
  }
  if (!this->Wound.empty() && this->Wound[static_cast<size_t>(voxel)] == 2)
  {
    return std::abs(winding.Open) > 0.5;
  }
  // The triangles do not agree on a side: moves away from the nearest point of the surface until no
  // wall is near.
  const glm::dvec3 way = p - this->Surface->FindNearest(p).Point;
  const double length = glm::length(way);
  if (!(length > 0.0))
  {
    return false;
  }
  for (int i = 1; i <= 8 && label == Wall; ++i)
  {
    const int next = this->VoxelOf(p + 0.5 * i * this->Size / length * way);
    label = next < 0 ? static_cast<std::uint8_t>(Outside) : this->Labels[static_cast<size_t>(next)];
  }
  return label == Solid;
}

//------------------------------------------------------------------------------
double vtkProxySolid::GetDepth(const glm::dvec3& p) const
{
  const double distance = this->Surface->FindNearest(p).Distance;
  return this->IsSolid(p) ? distance : -distance;
}

//------------------------------------------------------------------------------
std::vector<vtkProxySolid::Voxel> vtkProxySolid::GetMedialVoxels() const
{
  std::vector<Voxel> found;
  for (size_t i = 0; i < this->Labels.size(); ++i)
  {
    if (this->VoxelIndices[i] < 0)
    {
      continue;
    }
    const Voxel& voxel = this->Voxels[static_cast<size_t>(this->VoxelIndices[i])];
    const glm::ivec3 v = this->Place(static_cast<int>(i));
    bool contained = false;
    for (int n = 0; n < 27 && !contained; ++n)
    {
      const glm::ivec3 step(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      const glm::ivec3 w = v + step;
      const int other = this->VoxelIndices[static_cast<size_t>(this->Index(w.x, w.y, w.z))];
      if (n != 13 && other >= 0)
      {
        // Along a flat wall's normal distances grow by the step itself.
        const double grown = this->Voxels[static_cast<size_t>(other)].Depth - voxel.Depth;
        contained = grown > 0.85 * this->Size * glm::length(glm::dvec3(step));
      }
    }
    if (!contained)
    {
      found.push_back(voxel);
    }
  }
  return found;
}
