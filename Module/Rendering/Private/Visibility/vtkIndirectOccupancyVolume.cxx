// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Visibility/vtkIndirectOccupancyVolume.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectPolygons.h"
#include "Scene/vtkIndirectPropKind.h"
#include "Scene/vtkIndirectSurfaces.h"
#include "Visibility/vtkIndirectDistanceField.h"
#include "vtkProp.h"

#include <algorithm>
#include <cmath>

namespace
{
// Tests the separating axes of a triangle and the cube of half edge `half` about the origin, except
// the cube's own faces and the triangle's plane, which the caller has tested.
bool EdgesOverlap(const glm::dvec3 v[3], double half)
{
  for (int e = 0; e < 3; ++e)
  {
    const glm::dvec3 edge = v[(e + 1) % 3] - v[e];
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 unit(0.0);
      unit[axis] = 1.0;
      const glm::dvec3 a = glm::cross(unit, edge);
      const double p0 = glm::dot(a, v[e]);
      const double p1 = glm::dot(a, v[(e + 2) % 3]);
      const double radius = half * (std::abs(a.x) + std::abs(a.y) + std::abs(a.z));
      if (std::min(p0, p1) > radius || std::max(p0, p1) < -radius)
      {
        return false;
      }
    }
  }
  return true;
}
}

vtkIndirectOccupancyVolume::vtkIndirectOccupancyVolume(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , DistanceField(new vtkIndirectDistanceField(this))
{
}

vtkIndirectOccupancyVolume::~vtkIndirectOccupancyVolume() = default;

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::Clear(
  const glm::dvec3& lower, const glm::dvec3& upper, int resolution)
{
  const glm::dvec3 extent = glm::max(upper - lower, glm::dvec3(0.0));
  const double longest = std::max({ extent.x, extent.y, extent.z });
  // The grid has two voxels more than the scene, split unevenly between both ends. Otherwise a wall
  // on the scene's bounds would lie on a face between voxels and set the voxels on both sides.
  const double border = 0.87;
  this->VoxelSize = longest > 0.0 ? longest / (resolution - 2.0) : 1.0 / resolution;
  this->Origin = lower - border * this->VoxelSize;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Size[axis] =
      std::min(resolution, static_cast<int>(std::ceil(extent[axis] / this->VoxelSize)) + 2);
  }
  this->Columns.assign(static_cast<size_t>(this->Size.x) * this->Size.y, glm::uvec4(0u));
  this->Planes.Clear(this->Size);
  this->Area = 0.0;
  this->MeanAlbedo = glm::dvec3(0.0);
  this->NumberOfTriangles = 0;
  this->LeftOut.clear();
  this->Texture.Clear();
  this->DistanceFieldIsCurrent = false;
}

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::Mark(const glm::ivec3& voxel)
{
  if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) ||
    glm::any(glm::greaterThanEqual(voxel, this->Size)))
  {
    return;
  }
  this->Columns[voxel.x + static_cast<size_t>(this->Size.x) * voxel.y][voxel.z / 32] |= 1u
    << (voxel.z % 32);
  this->Touched.push_back(voxel);
}

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::AddTriangle(const glm::dvec3 corners[3], const glm::dvec3& albedo)
{
  glm::dvec3 v[3];
  for (int i = 0; i < 3; ++i)
  {
    v[i] = this->ToVoxels(corners[i]);
    if (!std::isfinite(v[i].x + v[i].y + v[i].z))
    {
      return;
    }
  }
  ++this->NumberOfTriangles;
  const glm::dvec3 doubled = glm::cross(v[1] - v[0], v[2] - v[0]);
  const glm::dvec3 size = glm::abs(doubled);
  const int w = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const int u = (w + 1) % 3;
  const int t = (w + 2) % 3;
  const glm::dvec3 lower = glm::min(v[0], glm::min(v[1], v[2]));
  const glm::dvec3 upper = glm::max(v[0], glm::max(v[1], v[2]));
  const glm::ivec3 first = glm::max(glm::ivec3(glm::floor(lower)), glm::ivec3(0));
  const glm::ivec3 last = glm::min(glm::ivec3(glm::floor(upper)), this->Size - 1);
  this->Touched.clear();
  // Along the normal's largest part the plane meets each column in a short range only.
  const bool flat = size[w] > 0.0;
  const double su = flat ? -doubled[u] / doubled[w] : 0.0;
  const double st = flat ? -doubled[t] / doubled[w] : 0.0;
  const double spread = 0.5 * (std::abs(su) + std::abs(st));
  glm::ivec3 voxel;
  for (voxel[u] = first[u]; voxel[u] <= last[u]; ++voxel[u])
  {
    for (voxel[t] = first[t]; voxel[t] <= last[t]; ++voxel[t])
    {
      double low = lower[w];
      double high = upper[w];
      if (flat)
      {
        const double height =
          v[0][w] + su * (voxel[u] + 0.5 - v[0][u]) + st * (voxel[t] + 0.5 - v[0][t]);
        low = std::max(low, height - spread);
        high = std::min(high, height + spread);
      }
      const int begin = std::max(static_cast<int>(std::floor(low)), 0);
      const int end = std::min(static_cast<int>(std::floor(high)), this->Size[w] - 1);
      for (voxel[w] = begin; voxel[w] <= end; ++voxel[w])
      {
        const glm::dvec3 center = glm::dvec3(voxel) + 0.5;
        const glm::dvec3 relative[3] = { v[0] - center, v[1] - center, v[2] - center };
        if (EdgesOverlap(relative, 0.5))
        {
          this->Mark(voxel);
        }
      }
    }
  }
  const double area = 0.5 * glm::length(doubled);
  if (this->Touched.empty() || !(area > 0.0))
  {
    return;
  }
  this->Area += area;
  this->MeanAlbedo += area * albedo;
  if (this->SurfacesAreKept)
  {
    this->Planes.Add(v, this->Touched);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::KeepSurfaces(bool glyphs)
{
  if (!this->SurfacesAreKept || this->GlyphsAreTaken != glyphs)
  {
    this->SurfacesAreKept = true;
    this->GlyphsAreTaken = glyphs;
    this->Forget();
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectOccupancyVolume::Update(
  const vtkIndirectFrame& frame, const vtkIndirectSurfaces& surfaces, int resolution)
{
  vtkIndirectKey key;
  key.Add("bounds of the scene", frame.SceneBounds, 6).Add("resolution", resolution);
  key.Add("other receivers", frame.NumberOfOtherReceivers);
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    caster.AppendTo(key);
  }
  if (!this->Key.Take(std::move(key)))
  {
    return false;
  }
  const glm::dvec3 lower = frame.ToScene(vtkIndirectFrame::GetCorner(frame.SceneBounds, 0));
  const glm::dvec3 upper = frame.ToScene(vtkIndirectFrame::GetCorner(frame.SceneBounds, 7));
  this->Clear(lower, upper, resolution);
  this->AddPolygons(frame, surfaces);
  this->Finish();
  return true;
}

//------------------------------------------------------------------------------
const vtkIndirectDistanceField& vtkIndirectOccupancyVolume::GetDistanceField() const
{
  if (!this->DistanceFieldIsCurrent)
  {
    this->DistanceField->Build(*this);
    this->DistanceFieldIsCurrent = true;
  }
  return *this->DistanceField;
}

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::AddPolygons(
  const vtkIndirectFrame& frame, const vtkIndirectSurfaces& surfaces)
{
  std::vector<bool> there(frame.Casters.size(), false);
  const std::vector<bool> held = surfaces.ReadPolygons(frame,
    [&](size_t caster, const vtkIndirectPolygons& piece)
    {
      if (piece.IsOfGlyphs && !this->GlyphsAreTaken)
      {
        return;
      }
      const size_t before = this->NumberOfTriangles;
      for (const vtkIndirectPolygons::Triangle& triangle : piece.Triangles)
      {
        const glm::dvec3 corners[3] = { piece.Positions[triangle.Points[0]],
          piece.Positions[triangle.Points[1]], piece.Positions[triangle.Points[2]] };
        this->AddTriangle(
          corners, this->SurfacesAreKept ? piece.FindMeanAlbedo(triangle) : glm::dvec3(0.0));
      }
      there[caster] = there[caster] || this->NumberOfTriangles > before;
    });
  this->AllIsHeld =
    frame.NumberOfOtherReceivers == 0 && std::find(held.begin(), held.end(), false) == held.end();
  for (size_t i = 0; i < there.size(); ++i)
  {
    if (!there[i])
    {
      vtkProp* const prop = frame.Casters[i].Prop;
      this->LeftOut.push_back({ prop, vtkIndirectPropKind::GetFullName(prop),
        "its mapper has no polygons that the processor can read; it blocks no indirect light" });
    }
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectOccupancyVolume::IsOccupied(const glm::ivec3& voxel) const
{
  if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) ||
    glm::any(glm::greaterThanEqual(voxel, this->Size)))
  {
    return false;
  }
  const glm::uvec4& column = this->Columns[voxel.x + static_cast<size_t>(this->Size.x) * voxel.y];
  return (column[voxel.z / 32] >> (voxel.z % 32) & 1u) != 0u;
}

//------------------------------------------------------------------------------
bool vtkIndirectOccupancyVolume::IsAnyOccupied(
  const glm::ivec3& lower, const glm::ivec3& upper) const
{
  const glm::ivec3 first = glm::max(lower, glm::ivec3(0));
  const glm::ivec3 last = glm::min(upper, this->Size - 1);
  const glm::uvec4 range = vtkIndirectKernels::vtkiBitRange(first.z, last.z);
  for (int y = first.y; y <= last.y && first.z <= last.z; ++y)
  {
    for (int x = first.x; x <= last.x; ++x)
    {
      if (vtkIndirectKernels::vtkiAnyBit(
            this->Columns[x + static_cast<size_t>(this->Size.x) * y], range))
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool vtkIndirectOccupancyVolume::IsFree(const glm::vec3& start, const glm::vec3& end) const
{
  vtkIndirectKernels::vtkiWalk walk = vtkIndirectKernels::vtkiBeginWalk(start, end);
  const int count = walk.remaining;
  for (int i = 0; i <= count; ++i)
  {
    const glm::ivec2 at = walk.column;
    if (at.x >= 0 && at.y >= 0 && at.x < this->Size.x && at.y < this->Size.y &&
      vtkIndirectKernels::vtkiAnyBit(this->Columns[at.x + static_cast<size_t>(this->Size.x) * at.y],
        vtkIndirectKernels::vtkiWalkBits(walk)))
    {
      return false;
    }
    vtkIndirectKernels::vtkiAdvance(walk);
  }
  return true;
}

//------------------------------------------------------------------------------
size_t vtkIndirectOccupancyVolume::GetNumberOfOccupiedVoxels() const
{
  size_t count = 0;
  for (const glm::uvec4& column : this->Columns)
  {
    for (int word = 0; word < 4; ++word)
    {
      for (glm::uint bits = column[word]; bits; bits &= bits - 1u)
      {
        ++count;
      }
    }
  }
  return count;
}

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::Activate(
  vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program) const
{
  if (this->Texture.IsEmpty())
  {
    this->Texture.Set(window, vtkIndirectDataTexture::INTEGERS, 4,
      { this->Size.x, this->Size.y, 0 }, this->Columns.data());
  }
  this->Texture.Activate(program, "vtkiOccupancy");
  vtkIndirectSetUniform(
    program, "vtkiOccupancyOrigin", glm::vec4(glm::dvec4(this->Origin, 1.0 / this->VoxelSize)));
  vtkIndirectSetUniform(program, "vtkiOccupancySize", glm::vec3(this->Size));
}

//------------------------------------------------------------------------------
size_t vtkIndirectOccupancyVolume::GetMainMemoryBytes() const
{
  return this->Columns.size() * sizeof(glm::uvec4) + this->Planes.GetBytes() +
    this->DistanceField->GetMainMemoryBytes();
}
