// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Visibility/vtkIndirectSphereGrid.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Senders/vtkIndirectSamplePattern.h"

#include <algorithm>
#include <cmath>

namespace
{
// Cells for each sphere, over the bounds of all spheres.
constexpr double CellsOfSphere = 4.0;
// Finer cells divide lists longer than this.
constexpr std::uint32_t LongList = 64;
// Largest number of finer cells in all (16 MB).
constexpr double MostCells = 2097152.0;
// Largest number of entries for each sphere: where spheres lie inside each other finer cells help
// little.
constexpr size_t MostEntriesOfSphere = 64;
// Segments are followed in single precision, and may lie a little beside their cell.
constexpr float Slack = 1e-3f;
}

//------------------------------------------------------------------------------
void vtkIndirectSphereGrid::Clear()
{
  this->Size = glm::ivec3(1);
  this->Scale = 1.0;
  this->NumberOfSpheres = 0;
  this->NumberOfSteps = 0.0;
  this->Cells = std::vector<glm::uvec2>();
  this->Lists = std::vector<glm::vec4>();
  this->CellTexture.Clear();
  this->ListTexture.Clear();
}

//------------------------------------------------------------------------------
// Makes cubes, about this many and none smaller than the longest extent allows; makes one cube if
// only one is wanted.
void vtkIndirectSphereGrid::SetSize(const glm::dvec3& extent, double cells)
{
  const double longest = std::max({ extent.x, extent.y, extent.z });
  const double edge = cells <= 1.0
    ? longest
    : std::max(std::cbrt(extent.x * extent.y * extent.z / cells), longest / MaximumSize);
  this->Scale = 1.0 / edge;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Size[axis] = cells <= 1.0
      ? 1
      : std::clamp(static_cast<int>(std::ceil(extent[axis] * this->Scale)), 1, MaximumSize);
  }
}

//------------------------------------------------------------------------------
template <typename F>
void vtkIndirectSphereGrid::ForEachTouched(const glm::vec4& sphere, const F& call) const
{
  const glm::vec3 center(sphere);
  const float outer = sphere.w + Slack;
  const float inner = std::max(sphere.w - Slack, 0.0f);
  // Clamping keeps spheres within the border cells despite rounding.
  const glm::ivec3 most = this->Size - 1;
  const glm::ivec3 first = glm::clamp(glm::ivec3(glm::floor(center - outer)), glm::ivec3(0), most);
  const glm::ivec3 last = glm::clamp(glm::ivec3(glm::floor(center + outer)), glm::ivec3(0), most);
  for (int z = first.z; z <= last.z; ++z)
  {
    for (int y = first.y; y <= last.y; ++y)
    {
      for (int x = first.x; x <= last.x; ++x)
      {
        const glm::vec3 corner(x, y, z);
        const glm::vec3 nearest = center - glm::clamp(center, corner, corner + 1.0f);
        const glm::vec3 farthest =
          glm::max(glm::abs(center - corner), glm::abs(center - corner - 1.0f));
        if (glm::dot(nearest, nearest) <= outer * outer &&
          glm::dot(farthest, farthest) >= inner * inner)
        {
          call(this->Fold(x, y, z));
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// Returns the number of entries.
size_t vtkIndirectSphereGrid::Count(
  const std::vector<glm::dvec4>& spheres, std::vector<std::uint32_t>& counts) const
{
  counts.assign(static_cast<size_t>(this->Size.x) * this->Size.y * this->Size.z, 0u);
  size_t entries = 0;
  for (const glm::dvec4& sphere : spheres)
  {
    this->ForEachTouched(this->ToCells(sphere),
      [&](size_t cell)
      {
        ++counts[cell];
        ++entries;
      });
  }
  return entries;
}

//------------------------------------------------------------------------------
void vtkIndirectSphereGrid::Fill(
  const std::vector<glm::dvec4>& spheres, const std::vector<std::uint32_t>& counts)
{
  this->Cells.resize(counts.size());
  std::uint32_t first = 0;
  for (size_t i = 0; i < counts.size(); ++i)
  {
    this->Cells[i] = glm::uvec2(first, 0u);
    first += counts[i];
  }
  this->Lists.resize(first);
  for (const glm::dvec4& sphere : spheres)
  {
    const glm::vec4 inCells = this->ToCells(sphere);
    this->ForEachTouched(inCells,
      [&](size_t cell)
      {
        glm::uvec2& list = this->Cells[cell];
        this->Lists[list.x + list.y++] = inCells;
      });
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectSphereGrid::Build(const std::vector<glm::dvec4>& spheres, size_t entries)
{
  return this->Build(spheres, 0.0, entries);
}

//------------------------------------------------------------------------------
bool vtkIndirectSphereGrid::Build(
  const std::vector<glm::dvec4>& spheres, double cellsOfSphere, size_t entries)
{
  this->Clear();
  if (spheres.empty() || spheres.size() > entries)
  {
    return spheres.empty();
  }
  glm::dvec3 lower(spheres.front());
  glm::dvec3 upper(spheres.front());
  for (const glm::dvec4& sphere : spheres)
  {
    lower = glm::min(lower, glm::dvec3(sphere) - sphere.w);
    upper = glm::max(upper, glm::dvec3(sphere) + sphere.w);
  }
  const bool chooses = cellsOfSphere <= 0.0;
  double cells = static_cast<double>(spheres.size()) * (chooses ? CellsOfSphere : cellsOfSphere);
  this->Origin = lower;
  this->SetSize(upper - lower, cells);
  std::vector<std::uint32_t> counts;
  // In a single cell each sphere has one entry, so the loop ends.
  while (this->Count(spheres, counts) > entries)
  {
    cells = std::min(cells, static_cast<double>(counts.size())) / 8.0;
    this->SetSize(upper - lower, cells);
  }
  std::vector<std::uint32_t> finer;
  while (chooses && 8.0 * static_cast<double>(counts.size()) <= MostCells &&
    *std::max_element(counts.begin(), counts.end()) > LongList)
  {
    const glm::ivec3 size = this->Size;
    const double scale = this->Scale;
    this->SetSize(upper - lower, 8.0 * static_cast<double>(counts.size()));
    if (this->Size == size ||
      this->Count(spheres, finer) > std::min(entries, MostEntriesOfSphere * spheres.size()))
    {
      this->Size = size;
      this->Scale = scale;
      break;
    }
    counts.swap(finer);
  }
  this->NumberOfSpheres = spheres.size();
  this->Fill(spheres, counts);
  this->FindNumberOfSteps(spheres, lower, upper);
  return true;
}

//------------------------------------------------------------------------------
size_t vtkIndirectSphereGrid::GetLongestList() const
{
  std::uint32_t longest = 0;
  for (const glm::uvec2& cell : this->Cells)
  {
    longest = std::max(longest, cell.y);
  }
  return longest;
}

//------------------------------------------------------------------------------
bool vtkIndirectSphereGrid::IsFree(const glm::dvec3& start, const glm::dvec3& end, int* steps) const
{
  using namespace vtkIndirectKernels;
  const glm::vec3 from(this->ToCells(start));
  const glm::vec3 along((end - start) * this->Scale);
  const float inverse = vtkiInverseSquare(along);
  int count = 0;
  bool free = true;
  if (!this->IsEmpty())
  {
    vtkiCells walk = vtkiBeginCells(from, along, this->Size);
    for (bool more = walk.inside; more && free; more = vtkiNextCell(walk))
    {
      ++count;
      const glm::uvec2& list = this->Cells[this->Fold(walk.cell.x, walk.cell.y, walk.cell.z)];
      for (std::uint32_t i = list.x; i < list.x + list.y && free; ++i)
      {
        ++count;
        free = !vtkiSphereBlocks(from, along, inverse, this->Lists[i]);
      }
    }
  }
  if (steps)
  {
    *steps = count;
  }
  return free;
}

//------------------------------------------------------------------------------
void vtkIndirectSphereGrid::FindNumberOfSteps(
  const std::vector<glm::dvec4>& spheres, const glm::dvec3& lower, const glm::dvec3& upper)
{
  vtkIndirectSamplePattern::Random random(1u);
  auto vector = [&random]()
  {
    const double x = random.Next();
    const double y = random.Next();
    return glm::dvec3(x, y, random.Next());
  };
  auto pick = [&](const glm::dvec3& other, bool onSphere)
  {
    if (!onSphere)
    {
      glm::dvec3 place = lower + vector() * (upper - lower);
      const int axis = static_cast<int>(3.0 * random.Next());
      place[axis] = random.Next() < 0.5 ? upper[axis] : lower[axis];
      return place;
    }
    // The end lies on the sphere's side towards the other end.
    const glm::dvec4& sphere =
      spheres[static_cast<size_t>(random.Next() * static_cast<double>(spheres.size()))];
    const glm::dvec3 way = other - glm::dvec3(sphere);
    const glm::dvec3 out = way + glm::length(way) * (vector() - 0.5);
    return glm::dvec3(sphere) + sphere.w * out / std::max(glm::length(out), 1e-12);
  };
  constexpr int count = 128;
  this->NumberOfSteps = 0.0;
  for (int kind = 0; kind < 3; ++kind)
  {
    double sum = 0.0;
    for (int i = 0; i < count; ++i)
    {
      const glm::dvec3 start = pick(0.5 * (lower + upper), kind == 2);
      int steps = 0;
      this->IsFree(start, pick(start, kind > 0), &steps);
      sum += steps;
    }
    this->NumberOfSteps = std::max(this->NumberOfSteps, sum / count);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectSphereGrid::Upload(vtkOpenGLRenderWindow* window) const
{
  this->CellTexture.Set(
    window, vtkIndirectDataTexture::INTEGERS, 2, this->Size, this->Cells.data());
  const size_t rows = (this->Lists.size() + RowLength - 1) / RowLength;
  std::vector<glm::vec4> table(this->Lists);
  table.resize(RowLength * rows, glm::vec4(0.0f));
  this->ListTexture.Set(window, vtkIndirectDataTexture::FLOATS, 4,
    { RowLength, static_cast<int>(rows), 0 }, table.data());
}

//------------------------------------------------------------------------------
void vtkIndirectSphereGrid::Activate(
  vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program) const
{
  if (this->CellTexture.IsEmpty())
  {
    this->Upload(window);
  }
  this->CellTexture.Activate(program, "vtkiSphereCells");
  this->ListTexture.Activate(program, "vtkiSphereLists");
  vtkIndirectSetUniform(
    program, "vtkiSphereOrigin", glm::vec4(glm::dvec4(this->Origin, this->Scale)));
}

//------------------------------------------------------------------------------
size_t vtkIndirectSphereGrid::GetMainMemoryBytes() const
{
  return this->Cells.size() * sizeof(glm::uvec2) + this->Lists.size() * sizeof(glm::vec4);
}
