// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/vtkIndirectMeshParts.h"

#include "Scene/vtkIndirectRevision.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/gtc/type_ptr.hpp>
#include <limits>

namespace
{
using Triangle = vtkIndirectMeshParts::Triangle;

// A part has about as many triangles. With more and smaller parts a view chooses levels and what it
// sees more finely, and has more points at borders, which no level joins.
constexpr double TrianglesOfPart = 4000.0;
constexpr int MostPartsAlongAxis = 6;

// A piece has about as many triangles: with fewer, views spend more time on finding what they see.
constexpr double TrianglesOfPiece = 128.0;
constexpr int MostPiecesAlongAxis = 4;

// Cells of the first level hold the points of about four triangles; those of each further level
// have twice the width.
constexpr double FirstWidth = 2.0;
constexpr int MostLevels = 6;
// A level with more than this share of the triangles of the finer one is not worth its memory.
constexpr double WorthShare = 0.7;

// The error of a level, over the root of the mean square of its distances.
constexpr double ErrorInDeviations = 2.0;

constexpr std::uint32_t MostCells = 1u << 20; // along an axis, so that keys fit 64 bits

// A mesh whose points are farther apart than this times an edge has outliers.
constexpr double MostExtent = 1.0e5;

//------------------------------------------------------------------------------
// Removes triangles without area by their points, or with a point that is no number, which OpenGL
// does not draw either.
void RemoveUndrawn(const std::vector<glm::dvec3>& points, std::vector<Triangle>& triangles)
{
  const auto undrawn = [&points](const Triangle& triangle)
  {
    return triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0] ||
      std::any_of(triangle.begin(), triangle.end(),
        [&points](unsigned int i)
        {
          const glm::dvec3& p = points[i];
          return !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z);
        });
  };
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(), undrawn), triangles.end());
}

//------------------------------------------------------------------------------
double FindMedianEdge(const std::vector<glm::dvec3>& points, const std::vector<Triangle>& triangles)
{
  std::vector<double> edges;
  edges.reserve(triangles.size());
  for (const Triangle& triangle : triangles)
  {
    edges.push_back(glm::length(points[triangle[1]] - points[triangle[0]]));
  }
  const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
  std::nth_element(edges.begin(), middle, edges.end());
  return *middle;
}

//------------------------------------------------------------------------------
// Makes the parts of a mesh and its levels, one after the other.
class Maker
{
public:
  Maker(std::vector<glm::dvec3> points, std::vector<Triangle> triangles)
    : Points(std::move(points))
    , Triangles(std::move(triangles))
  {
    for (const Triangle& triangle : this->Triangles)
    {
      for (const unsigned int i : triangle)
      {
        this->Low = glm::min(this->Low, this->Points[i]);
        this->High = glm::max(this->High, this->Points[i]);
      }
    }
  }

  std::unique_ptr<vtkIndirectMeshParts> Make()
  {
    const double edge = FindMedianEdge(this->Points, this->Triangles);
    const glm::dvec3 extent = this->High - this->Low;
    const double longest = std::max({ extent.x, extent.y, extent.z });
    if (!(edge > 0.0) || !(longest < MostExtent * edge))
    {
      return nullptr;
    }
    this->Made = std::make_unique<vtkIndirectMeshParts>();
    this->Made->Middle = 0.5 * (this->Low + this->High);
    this->Made->HasInsets = true;
    for (const glm::dvec3& p : this->Points)
    {
      this->Made->AddPoint(p);
    }
    this->Divide(longest);
    this->AddMesh();
    this->KeepBorders();
    this->FindNormals();
    size_t finer = this->Triangles.size();
    for (int level = 0; level < MostLevels; ++level)
    {
      const size_t count = this->AddLevel(std::ldexp(FirstWidth * edge, level));
      if (static_cast<double>(count) > WorthShare * static_cast<double>(finer))
      {
        this->RemoveLevel();
        break;
      }
      finer = count;
    }
    for (vtkIndirectMeshParts::Part& part : this->Made->Parts)
    {
      std::reverse(part.Levels.begin(), part.Levels.end());
    }
    this->Made->NumberOfLevels = this->Made->Parts.front().Levels.size();
    if (this->Made->NumberOfLevels > 1)
    {
      this->DivideLevels();
    }
    return this->Made->NumberOfLevels > 1 ? std::move(this->Made) : nullptr;
  }

private:
  std::vector<glm::dvec3> Points;
  std::vector<Triangle> Triangles;
  glm::dvec3 Low{ std::numeric_limits<double>::max() };
  glm::dvec3 High{ -std::numeric_limits<double>::max() };
  std::vector<size_t> Firsts;      // first triangle of each part, and one past the last
  std::vector<char> Stays;         // one entry a point: 1 for a point that no level joins
  std::vector<glm::dvec3> Normals; // of the triangles
  std::unique_ptr<vtkIndirectMeshParts> Made;

  // Returns the number of the cell of a grid that holds a place.
  std::uint64_t FindCell(const glm::dvec3& p, double width) const
  {
    const glm::dvec3 at = glm::max((p - this->Low) / width, glm::dvec3(0.0));
    std::uint64_t cell = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      cell = cell * MostCells + std::min(static_cast<std::uint32_t>(at[axis]), MostCells - 1);
    }
    return cell;
  }

  // Sorts triangles by cells of a coarse grid. Points that parts share stay.
  void Divide(double longest)
  {
    const double number =
      std::sqrt(static_cast<double>(this->Triangles.size()) / TrianglesOfPart / 3.0);
    const double width =
      longest / std::min(std::max(std::round(number), 1.0), 1.0 * MostPartsAlongAxis);
    std::vector<std::pair<std::uint64_t, size_t>> cells;
    cells.reserve(this->Triangles.size());
    for (size_t i = 0; i < this->Triangles.size(); ++i)
    {
      const Triangle& t = this->Triangles[i];
      cells.emplace_back(
        this->FindCell((this->Points[t[0]] + this->Points[t[1]] + this->Points[t[2]]) / 3.0, width),
        i);
    }
    std::sort(cells.begin(), cells.end());
    std::vector<Triangle> sorted;
    sorted.reserve(cells.size());
    std::vector<size_t> partOf(this->Points.size(), 0); // 0: of none so far
    this->Stays.assign(this->Points.size(), 0);
    for (size_t i = 0; i < cells.size(); ++i)
    {
      if (i == 0 || cells[i].first != cells[i - 1].first)
      {
        this->Firsts.push_back(i);
        this->Made->Parts.emplace_back();
      }
      const Triangle& triangle = this->Triangles[cells[i].second];
      sorted.push_back(triangle);
      for (const unsigned int point : triangle)
      {
        const size_t part = this->Firsts.size();
        this->Stays[point] = partOf[point] != 0 && partOf[point] != part ? 1 : this->Stays[point];
        partOf[point] = part;
      }
    }
    this->Firsts.push_back(cells.size());
    this->Triangles = std::move(sorted);
  }

  // Keeps the points of edges that do not have two triangles of the same orientation. Where each
  // edge of a point has them, the triangles' next corners are their last corners in another order:
  // sums of both, by random numbers of the points, agree.
  void KeepBorders()
  {
    std::vector<std::uint64_t> sums(this->Points.size(), 0);
    for (const Triangle& t : this->Triangles)
    {
      for (size_t i = 0; i < 3; ++i)
      {
        sums[t[i]] += vtkIndirectRevision::Join(0, t[(i + 1) % 3]) -
          vtkIndirectRevision::Join(0, t[(i + 2) % 3]);
      }
    }
    for (size_t i = 0; i < sums.size(); ++i)
    {
      this->Stays[i] = sums[i] != 0 ? 1 : this->Stays[i];
    }
  }

  void FindNormals()
  {
    for (const Triangle& t : this->Triangles)
    {
      const glm::dvec3& a = this->Points[t[0]];
      const glm::dvec3 normal = glm::cross(this->Points[t[1]] - a, this->Points[t[2]] - a);
      const double length = glm::length(normal);
      this->Normals.push_back(length > 0.0 ? normal / length : glm::dvec3(0.0));
    }
  }

  void AddMesh()
  {
    for (size_t k = 0; k < this->Made->Parts.size(); ++k)
    {
      vtkIndirectMeshParts::Part& part = this->Made->Parts[k];
      glm::dvec3 low(std::numeric_limits<double>::max());
      glm::dvec3 high = -low;
      const size_t first = this->Made->Indices.size();
      for (size_t i = this->Firsts[k]; i < this->Firsts[k + 1]; ++i)
      {
        for (const unsigned int point : this->Triangles[i])
        {
          low = glm::min(low, this->Points[point]);
          high = glm::max(high, this->Points[point]);
          this->Made->Indices.push_back(point);
        }
      }
      part.Bounds = { low.x, high.x, low.y, high.y, low.z, high.z };
      part.Levels.push_back({ first, this->Made->Indices.size() - first, 0.0 });
    }
  }

  // Returns the first of the points that are in a point's cell and connected with the point within
  // that cell, so that no cell joins two sheets.
  static unsigned int FindFirst(std::vector<unsigned int>& firsts, unsigned int point)
  {
    while (firsts[point] != point)
    {
      firsts[point] = firsts[firsts[point]];
      point = firsts[point];
    }
    return point;
  }

  // Joins the points in each cell that are connected, but for those that stay. Returns the new
  // point of each. moves: the way of each point.
  std::vector<unsigned int> JoinPoints(double width, std::vector<glm::dvec3>& moves)
  {
    const size_t count = this->Points.size();
    std::vector<std::uint64_t> cells(count);
    std::vector<unsigned int> firsts(count);
    for (size_t i = 0; i < count; ++i)
    {
      cells[i] = this->Stays[i] ? 0 : this->FindCell(this->Points[i], width);
      firsts[i] = static_cast<unsigned int>(i);
    }
    for (const Triangle& t : this->Triangles)
    {
      for (size_t i = 0; i < 3; ++i)
      {
        const unsigned int a = t[i];
        const unsigned int b = t[(i + 1) % 3];
        if (cells[a] == cells[b] && !this->Stays[a] && !this->Stays[b])
        {
          const unsigned int x = FindFirst(firsts, a);
          const unsigned int y = FindFirst(firsts, b);
          firsts[std::max(x, y)] = std::min(x, y);
        }
      }
    }
    std::vector<glm::dvec3> sums(count, glm::dvec3(0.0));
    std::vector<unsigned int> numbers(count, 0);
    for (unsigned int i = 0; i < count; ++i)
    {
      const unsigned int first = FindFirst(firsts, i);
      sums[first] += this->Points[i];
      ++numbers[first];
    }
    std::vector<unsigned int> joined(count);
    moves.assign(count, glm::dvec3(0.0));
    for (unsigned int i = 0; i < count; ++i)
    {
      const unsigned int first = FindFirst(firsts, i);
      joined[i] = i;
      if (numbers[first] > 1)
      {
        const glm::dvec3 mean = sums[first] / static_cast<double>(numbers[first]);
        // The first of the points has the lowest number.
        joined[i] = first == i ? this->Made->AddPoint(mean) : joined[first];
        moves[i] = mean - this->Points[i];
      }
    }
    return joined;
  }

  // Sets the insets of joined points, from the sums of the normals around them and their greatest
  // distances from the planes there.
  void SetInsets(const std::vector<glm::dvec3>& normals, const std::vector<double>& distances)
  {
    for (size_t i = 0; i < normals.size(); ++i)
    {
      const double length = glm::length(normals[i]);
      if (distances[i] > 0.0 && length > 0.0)
      {
        const glm::vec3 inset(normals[i] * (distances[i] / length));
        std::copy(&inset[0], &inset[0] + 3,
          &this->Made->Points[vtkIndirectMeshParts::FloatsOfPoint * i + 3]);
      }
    }
  }

  // Adds the level of a width. Returns its number of triangles.
  size_t AddLevel(double width)
  {
    std::vector<glm::dvec3> moves;
    const std::vector<unsigned int> joined = this->JoinPoints(width, moves);
    const size_t points = this->Made->CountPoints();
    std::vector<glm::dvec3> normals(points, glm::dvec3(0.0));
    std::vector<double> distances(points, 0.0);
    size_t count = 0;
    std::vector<Triangle> kept;
    for (size_t k = 0; k < this->Made->Parts.size(); ++k)
    {
      kept.clear();
      double squares = 0.0;
      for (size_t i = this->Firsts[k]; i < this->Firsts[k + 1]; ++i)
      {
        const Triangle& t = this->Triangles[i];
        for (const unsigned int point : t)
        {
          const double distance = glm::dot(this->Normals[i], moves[point]);
          squares += distance * distance;
          normals[joined[point]] += this->Normals[i];
          distances[joined[point]] = std::max(distances[joined[point]], std::abs(distance));
        }
        Triangle made = { joined[t[0]], joined[t[1]], joined[t[2]] };
        if (made[0] != made[1] && made[1] != made[2] && made[2] != made[0])
        {
          // Depth has no front and back: triangles of the same points are the same.
          std::sort(made.begin(), made.end());
          kept.push_back(made);
        }
      }
      std::sort(kept.begin(), kept.end());
      kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
      const double corners = 3.0 * static_cast<double>(this->Firsts[k + 1] - this->Firsts[k]);
      const double error = ErrorInDeviations * std::sqrt(squares / corners);
      const size_t first = this->Made->Indices.size();
      for (const Triangle& triangle : kept)
      {
        this->Made->Indices.insert(this->Made->Indices.end(), triangle.begin(), triangle.end());
      }
      this->Made->Parts[k].Levels.push_back({ first, 3 * kept.size(), error });
      count += kept.size();
    }
    this->SetInsets(normals, distances);
    return count;
  }

  void DivideLevels()
  {
    for (vtkIndirectMeshParts::Part& part : this->Made->Parts)
    {
      for (vtkIndirectMeshParts::Level& level : part.Levels)
      {
        this->Made->Divide(level);
      }
    }
  }

  // Removes the level that was added last.
  void RemoveLevel()
  {
    this->Made->Indices.resize(this->Made->Parts.front().Levels.back().First);
    for (vtkIndirectMeshParts::Part& part : this->Made->Parts)
    {
      part.Levels.pop_back();
    }
  }
};
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkIndirectMeshParts> vtkIndirectMeshParts::Make(
  vtkPolyData* mesh, std::vector<Triangle> triangles)
{
  const auto count = static_cast<size_t>(mesh->GetNumberOfPoints());
  std::vector<glm::dvec3> points(count);
  for (size_t i = 0; i < count; ++i)
  {
    mesh->GetPoint(static_cast<vtkIdType>(i), &points[i][0]);
  }
  RemoveUndrawn(points, triangles);
  if (triangles.size() < FewestTriangles || count > std::numeric_limits<unsigned int>::max() / 2)
  {
    return nullptr;
  }
  return Maker(std::move(points), std::move(triangles)).Make();
}

//------------------------------------------------------------------------------
// The pieces are the cells of a grid over the level. Within a piece the triangles keep their order,
// in which neighbours follow each other, so that OpenGL transforms few points twice.
void vtkIndirectMeshParts::Divide(Level& level)
{
  const auto place = [this](size_t i)
  { return glm::dvec3(glm::make_vec3(&this->Points[FloatsOfPoint * this->Indices[i]])); };
  const auto inset = [this](size_t i)
  { return glm::dvec3(glm::make_vec3(&this->Points[FloatsOfPoint * this->Indices[i] + 3])); };
  const double number = std::sqrt(static_cast<double>(level.Count) / 3.0 / TrianglesOfPiece / 3.0);
  const double along = std::min(std::max(std::round(number), 1.0), 1.0 * MostPiecesAlongAxis);
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high = -low;
  for (size_t i = level.First; i < level.First + level.Count; ++i)
  {
    low = glm::min(low, place(i));
    high = glm::max(high, place(i));
  }
  const glm::dvec3 extent = high - low;
  const double width = std::max({ extent.x, extent.y, extent.z }) / along;
  std::vector<std::pair<int, Triangle>> sorted;
  sorted.reserve(level.Count / 3);
  for (size_t i = level.First; i < level.First + level.Count; i += 3)
  {
    const glm::dvec3 middle = (place(i) + place(i + 1) + place(i + 2)) / 3.0;
    const glm::ivec3 cell(width > 0.0 ? (middle - low) / width : glm::dvec3(0.0));
    sorted.emplace_back(
      (cell.z * (MostPiecesAlongAxis + 1) + cell.y) * (MostPiecesAlongAxis + 1) + cell.x,
      Triangle{ this->Indices[i], this->Indices[i + 1], this->Indices[i + 2] });
  }
  std::stable_sort(
    sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  level.FirstPiece = this->Pieces.size();
  for (size_t k = 0; k < sorted.size(); ++k)
  {
    const size_t first = level.First + 3 * k;
    if (k == 0 || sorted[k].first != sorted[k - 1].first)
    {
      const double most = std::numeric_limits<double>::max();
      this->Pieces.push_back({ first, 0, { most, -most, most, -most, most, -most } });
    }
    Piece& piece = this->Pieces.back();
    std::copy(sorted[k].second.begin(), sorted[k].second.end(),
      this->Indices.begin() + static_cast<std::ptrdiff_t>(first));
    piece.Count += 3;
    for (size_t i = first; i < first + 3; ++i)
    {
      const glm::dvec3 p = this->Middle + place(i);
      const glm::dvec3 away = glm::abs(inset(i));
      for (int axis = 0; axis < 3; ++axis)
      {
        double* bounds = &piece.Bounds[static_cast<size_t>(2 * axis)];
        bounds[0] = std::min(bounds[0], p[axis] - away[axis]);
        bounds[1] = std::max(bounds[1], p[axis] + away[axis]);
      }
    }
  }
  level.NumberOfPieces = this->Pieces.size() - level.FirstPiece;
}

//------------------------------------------------------------------------------
void vtkIndirectMeshParts::GatherPieces()
{
  if (!this->PieceIndices.empty())
  {
    return;
  }
  this->PieceIndices.resize(this->Indices.size());
  std::vector<std::pair<size_t, unsigned int>> numbers(this->CountPoints()); // piece + 1, number
  for (size_t k = 0; k < this->Pieces.size(); ++k)
  {
    Piece& piece = this->Pieces[k];
    piece.FirstPoint = this->PiecePoints.size() / FloatsOfPoint;
    piece.NumberOfPoints = 0;
    for (size_t i = piece.First; i < piece.First + piece.Count; ++i)
    {
      auto& [owner, number] = numbers[this->Indices[i]];
      if (owner != k + 1)
      {
        owner = k + 1;
        number = static_cast<unsigned int>(piece.NumberOfPoints++);
        const auto point =
          this->Points.begin() + static_cast<std::ptrdiff_t>(FloatsOfPoint * this->Indices[i]);
        this->PiecePoints.insert(this->PiecePoints.end(), point, point + FloatsOfPoint);
      }
      this->PieceIndices[i] = number;
    }
  }
}

//------------------------------------------------------------------------------
unsigned int vtkIndirectMeshParts::AddPoint(const glm::dvec3& p)
{
  const glm::vec3 relative(p - this->Middle);
  this->Points.insert(this->Points.end(), { relative.x, relative.y, relative.z, 0.0f, 0.0f, 0.0f });
  return static_cast<unsigned int>(this->CountPoints() - 1);
}

//------------------------------------------------------------------------------
int vtkIndirectMeshParts::Part::FindLevel(double mostError) const
{
  const auto found = std::find_if(this->Levels.begin(), this->Levels.end(),
    [mostError](const Level& level) { return level.Error <= mostError; });
  return found != this->Levels.end() ? static_cast<int>(found - this->Levels.begin()) : -1;
}
