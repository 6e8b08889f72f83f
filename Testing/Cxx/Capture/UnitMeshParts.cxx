// SPDX-License-Identifier: BSD-3-Clause
// Parts of dense meshes and their coarse levels.
#include "Capture/vtkIndirectMeshParts.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <map>

using namespace vtkIndirectTest;

namespace
{
using Triangles = std::vector<vtkIndirectMeshParts::Triangle>;

// A closed ring of a round tube: every edge has two triangles.
struct Ring
{
  static constexpr double Radius = 1.0;
  vtkNew<vtkPolyData> Mesh;
  Triangles List;

  /** around, along: points around the tube and along the ring. */
  Ring(unsigned int around, unsigned int along, double tube)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    const double turn = 2.0 * 3.14159265358979323846;
    for (unsigned int i = 0; i < along; ++i)
    {
      for (unsigned int j = 0; j < around; ++j)
      {
        const double u = turn * i / along;
        const double v = turn * j / around;
        const double r = Radius + tube * std::cos(v);
        points->InsertNextPoint(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
        const unsigned int next = (i + 1) % along * around;
        const unsigned int here = i * around;
        const unsigned int k = (j + 1) % around;
        this->List.push_back({ here + j, next + j, next + k });
        this->List.push_back({ here + j, next + k, here + k });
      }
    }
    this->Mesh->SetPoints(points);
  }
};

glm::dvec3 GetPoint(const vtkIndirectMeshParts& parts, unsigned int index)
{
  const float* const p = &parts.Points[6 * static_cast<size_t>(index)];
  return parts.Middle + glm::dvec3(p[0], p[1], p[2]);
}

double GetInset(const vtkIndirectMeshParts& parts, unsigned int index)
{
  const float* const p = &parts.Points[6 * static_cast<size_t>(index)];
  return glm::length(glm::dvec3(p[3], p[4], p[5]));
}

// Counts the edges that other than two triangles have, where each part draws this level, or part by
// part the finest and the coarsest one in turn (-1).
int CountOpenEdges(const vtkIndirectMeshParts& parts, int level)
{
  std::map<std::pair<unsigned int, unsigned int>, int> edges;
  for (size_t k = 0; k < parts.Parts.size(); ++k)
  {
    const size_t finest = parts.NumberOfLevels - 1;
    const size_t number = level >= 0 ? static_cast<size_t>(level) : k % 2 == 0 ? finest : 0;
    const vtkIndirectMeshParts::Level& drawn = parts.Parts[k].Levels[number];
    for (size_t i = 0; i < drawn.Count; i += 3)
    {
      for (size_t e = 0; e < 3; ++e)
      {
        const unsigned int a = parts.Indices[drawn.First + i + e];
        const unsigned int b = parts.Indices[drawn.First + i + (e + 1) % 3];
        ++edges[{ std::min(a, b), std::max(a, b) }];
      }
    }
  }
  return static_cast<int>(
    std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second != 2; }));
}

// Counts the levels whose pieces are not the whole level, and the points, with their insets, that
// lie outside of their piece.
int CountOutsidePieces(const vtkIndirectMeshParts& parts)
{
  int outside = 0;
  for (const vtkIndirectMeshParts::Part& part : parts.Parts)
  {
    for (const vtkIndirectMeshParts::Level& level : part.Levels)
    {
      size_t next = level.First;
      for (size_t k = level.FirstPiece; k < level.FirstPiece + level.NumberOfPieces; ++k)
      {
        const vtkIndirectMeshParts::Piece& piece = parts.Pieces[k];
        outside += piece.First == next ? 0 : 1;
        next = piece.First + piece.Count;
        for (size_t i = piece.First; i < next; ++i)
        {
          const float* p = &parts.Points[vtkIndirectMeshParts::FloatsOfPoint * parts.Indices[i]];
          for (size_t axis = 0; axis < 3; ++axis)
          {
            const double at = parts.Middle[static_cast<int>(axis)] + p[axis];
            const double inset = std::abs(p[3 + axis]);
            const double* bounds = &piece.Bounds[2 * axis];
            outside += at - inset < bounds[0] || at + inset > bounds[1] ? 1 : 0;
          }
        }
      }
      outside += next == level.First + level.Count ? 0 : 1;
    }
  }
  return outside;
}

// Counts the sets of triangles that share points.
int CountPieces(const vtkIndirectMeshParts& parts, size_t level)
{
  std::map<unsigned int, unsigned int> above;
  const auto top = [&above](unsigned int i)
  {
    while (above.emplace(i, i).first->second != i)
    {
      i = above[i];
    }
    return i;
  };
  for (const vtkIndirectMeshParts::Part& part : parts.Parts)
  {
    const vtkIndirectMeshParts::Level& drawn = part.Levels[level];
    for (size_t i = drawn.First; i < drawn.First + drawn.Count; ++i)
    {
      const unsigned int a = top(parts.Indices[i]);
      const unsigned int b = top(parts.Indices[drawn.First + (i - drawn.First) / 3 * 3]);
      above[std::max(a, b)] = std::min(a, b);
    }
  }
  return static_cast<int>(std::count_if(
    above.begin(), above.end(), [](const auto& entry) { return entry.first == entry.second; }));
}
}

VTK_INDIRECT_TEST(MeshPartsOfARing)
{
  const double tube = 0.4;
  const Ring ring(200, 500, tube);
  const auto parts = vtkIndirectMeshParts::Make(ring.Mesh, ring.List);
  if (!Check("a dense mesh has parts", parts != nullptr))
  {
    return;
  }
  // The mesh's own facets lie that far inside the tube.
  const double facets = tube * (1.0 - std::cos(3.14159265358979323846 / 200)) + 1e-6;
  const size_t finest = parts->NumberOfLevels - 1;
  std::vector<size_t> counts(parts->NumberOfLevels, 0);
  double mostOverError = 0.0;
  double mostOverInset = 0.0;
  int wrong = 0; // levels whose error, or choice by that error, is none
  for (const vtkIndirectMeshParts::Part& part : parts->Parts)
  {
    for (size_t level = 0; level < parts->NumberOfLevels; ++level)
    {
      const vtkIndirectMeshParts::Level& drawn = part.Levels[level];
      counts[level] += drawn.Count / 3;
      wrong += (level == finest) == (drawn.Error == 0.0) ? 0 : 1;
      wrong += part.FindLevel(drawn.Error) <= static_cast<int>(level) ? 0 : 1;
      for (size_t i = drawn.First; i < drawn.First + drawn.Count; ++i)
      {
        const glm::dvec3 p = GetPoint(*parts, parts->Indices[i]);
        const double distance =
          std::abs(std::hypot(std::hypot(p.x, p.y) - Ring::Radius, p.z) - tube) - facets;
        mostOverInset = std::max(mostOverInset, distance - GetInset(*parts, parts->Indices[i]));
        mostOverError = std::max(
          mostOverError, level < finest && distance > 0.0 ? distance / drawn.Error : distance);
      }
    }
  }
  CheckEqual("levels with a wrong error", wrong, 0);
  CheckEqual("levels or points outside of their pieces", CountOutsidePieces(*parts), 0);
  // 0.42 measured: means of curved pieces lie inside, by less than corners of facets.
  Check("points are as near as the error says", mostOverError < 1.0, std::to_string(mostOverError));
  Check("insets reach the surface", mostOverInset <= 0.0, std::to_string(mostOverInset));
  CheckEqual("triangles of the last level", counts[finest], ring.List.size());
  for (size_t level = 0; level < finest; ++level)
  {
    Check("a level has seven tenths of the finer one's triangles at most",
      10 * counts[level] <= 7 * counts[level + 1], std::to_string(counts[level]));
  }
  Check(
    "the coarsest level has an eighth", 8 * counts[0] < counts[finest], std::to_string(counts[0]));
  CheckEqual("open edges of the mesh", CountOpenEdges(*parts, static_cast<int>(finest)), 0);
  // No gap opens between parts of different levels.
  CheckEqual("open edges of levels in turn", CountOpenEdges(*parts, -1), 0);
}

VTK_INDIRECT_TEST(MeshPartsOfTwoSheets)
{
  // A ring in a ring, nearer to each other than the points of the coarsest level.
  Ring both(200, 500, 0.4);
  const Ring inner(200, 500, 0.399);
  const auto first = static_cast<unsigned int>(both.Mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < inner.Mesh->GetNumberOfPoints(); ++i)
  {
    both.Mesh->GetPoints()->InsertNextPoint(inner.Mesh->GetPoint(i));
  }
  for (const auto& t : inner.List)
  {
    both.List.push_back({ first + t[0], first + t[1], first + t[2] });
  }
  const auto parts = vtkIndirectMeshParts::Make(both.Mesh, both.List);
  if (!Check("a dense mesh has parts", parts != nullptr))
  {
    return;
  }
  CheckEqual("open edges of the coarsest level", CountOpenEdges(*parts, 0), 0);
  CheckEqual("pieces of the coarsest level", CountPieces(*parts, 0), 2);
}

VTK_INDIRECT_TEST(MeshPartsOfOtherMeshes)
{
  const Ring few(20, 90, 0.4);
  Check("few triangles have no parts", !vtkIndirectMeshParts::Make(few.Mesh, few.List));

  const Ring ring(200, 500, 0.4);
  vtkNew<vtkPolyData> apart;
  vtkNew<vtkPoints> points;
  Triangles list;
  for (const auto& triangle : ring.List)
  {
    for (const unsigned int i : triangle)
    {
      points->InsertNextPoint(ring.Mesh->GetPoint(i));
    }
    const auto last = static_cast<unsigned int>(points->GetNumberOfPoints());
    list.push_back({ last - 3, last - 2, last - 1 });
  }
  apart->SetPoints(points);
  Check("triangles of their own points have none", !vtkIndirectMeshParts::Make(apart, list));

  vtkNew<vtkPolyData> other;
  vtkNew<vtkPoints> outlying;
  outlying->DeepCopy(ring.Mesh->GetPoints());
  outlying->SetPoint(7, 1e20, 0.0, 0.0);
  other->SetPoints(outlying);
  Check("nor has a mesh with a point at 1e20", !vtkIndirectMeshParts::Make(other, ring.List));
  outlying->SetPoint(7, std::nan(""), 0.0, 0.0);
  const auto without = vtkIndirectMeshParts::Make(other, ring.List);
  Check("a point that is no number is left out",
    without &&
      std::none_of(
        without->Indices.begin(), without->Indices.end(), [](unsigned int i) { return i == 7; }));
}
