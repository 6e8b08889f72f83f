// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualLights/vtkIndirectAreaClusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

namespace
{
// Each pixel of an image with fewer pixels along an edge is cut into cells; in an image with more
// pixels than MostEntries, several pixels share an entry of the table.
constexpr int LeastCells = 64;
constexpr int MostEntries = 512;

// Sums over cells: of radiance by colour, of its strength (the sum over the colours), of strength
// times place and times the place's square, and of the strength's square.
enum Quantity
{
  Red,
  Green,
  Blue,
  Strength,
  StrengthX,
  StrengthY,
  StrengthXX,
  StrengthYY,
  StrengthSquared,
  NumberOfQuantities
};
using Sums = std::array<double, NumberOfQuantities>;

// An image in cells. Four entries give the sums over any rectangle of entries (summed-area table,
// Crow 1984).
class Table
{
public:
  explicit Table(const vtkIndirectAreaClusters::Image& image)
    : Image(image)
    , Repeat{ (LeastCells + image.Columns - 1) / image.Columns,
      (LeastCells + image.Rows - 1) / image.Rows }
    , Cells{ image.Columns * Repeat[0], image.Rows * Repeat[1] }
    , Size{ std::min(Cells[0], MostEntries), std::min(Cells[1], MostEntries) }
    , Entries(static_cast<size_t>(Size[0] + 1) * (Size[1] + 1), Sums{})
  {
    for (int y = 0; y < this->Cells[1]; ++y)
    {
      for (int x = 0; x < this->Cells[0]; ++x)
      {
        this->Add(
          this->Entries[this->GetIndex(this->FindEntry(x, 0) + 1, this->FindEntry(y, 1) + 1)], x,
          y);
      }
    }
    for (int y = 1; y <= this->Size[1]; ++y)
    {
      Sums row{};
      for (int x = 1; x <= this->Size[0]; ++x)
      {
        Sums& entry = this->Entries[this->GetIndex(x, y)];
        const Sums& below = this->Entries[this->GetIndex(x, y - 1)];
        for (int q = 0; q < NumberOfQuantities; ++q)
        {
          row[q] += entry[q];
          entry[q] = below[q] + row[q];
        }
      }
    }
  }

  Sums Sum(const int lower[2], const int upper[2]) const
  {
    const Sums& a = this->Entries[this->GetIndex(lower[0], lower[1])];
    const Sums& b = this->Entries[this->GetIndex(upper[0], lower[1])];
    const Sums& c = this->Entries[this->GetIndex(lower[0], upper[1])];
    const Sums& d = this->Entries[this->GetIndex(upper[0], upper[1])];
    Sums sums;
    for (int q = 0; q < NumberOfQuantities; ++q)
    {
      sums[q] = (d[q] - b[q]) - (c[q] - a[q]);
    }
    // A dark piece may have a rest from rounding, which is no light.
    if (!(sums[Strength] > 1e-12 * this->Entries.back()[Strength]))
    {
      sums.fill(0.0);
    }
    return sums;
  }

  vtkIndirectAreaClusters::Image Image;
  int Repeat[2]; // cells of a pixel
  int Cells[2];
  int Size[2]; // in entries

private:
  size_t GetIndex(int x, int y) const { return static_cast<size_t>(y) * (this->Size[0] + 1) + x; }
  int FindEntry(int cell, int axis) const
  {
    return static_cast<int>(static_cast<long long>(cell) * this->Size[axis] / this->Cells[axis]);
  }
  // Places are from -1/2 to 1/2, which preserves digits.
  double GetPlace(int cell, int axis) const { return (cell + 0.5) / this->Cells[axis] - 0.5; }

  void Add(Sums& sums, int x, int y) const
  {
    const size_t pixel =
      static_cast<size_t>(y / this->Repeat[1]) * this->Image.Columns + x / this->Repeat[0];
    const float* const radiance = this->Image.Radiances + 3 * pixel;
    const double light = double(radiance[0]) + radiance[1] + radiance[2];
    const double u = this->GetPlace(x, 0);
    const double v = this->GetPlace(y, 1);
    const Sums one = { radiance[0], radiance[1], radiance[2], light, light * u, light * v,
      light * u * u, light * v * v, light * light };
    for (int q = 0; q < NumberOfQuantities; ++q)
    {
      sums[q] += one[q];
    }
  }

  std::vector<Sums> Entries;
};

struct Piece
{
  const Table* Whole;
  int Lower[2];
  int Upper[2];
  Sums Sum;
  glm::dvec2 Mean;   // mean place of its light
  glm::dvec2 Spread; // mean squared distance from Mean along the edges, scene units squared
  double Width;      // light times the sum of Spread
  int Axis;          // axis along which it can be cut; -1: it cannot be cut

  Piece(const Table& whole, const int lower[2], const int upper[2])
    : Whole(&whole)
    , Lower{ lower[0], lower[1] }
    , Upper{ upper[0], upper[1] }
    , Sum(whole.Sum(lower, upper))
  {
    const vtkIndirectAreaClusters::Image& image = whole.Image;
    const double light = this->Sum[Strength];
    if (!(light > 0.0))
    {
      this->Width = 0.0;
      this->Axis = -1;
      return;
    }
    this->Mean = glm::dvec2(this->Sum[StrengthX], this->Sum[StrengthY]) / light;
    const glm::dvec2 square = glm::dvec2(this->Sum[StrengthXX], this->Sum[StrengthYY]) / light;
    const glm::dvec2 cell(1.0 / whole.Cells[0], 1.0 / whole.Cells[1]);
    const glm::dvec2 edges(glm::dot(image.Edge1, image.Edge1), glm::dot(image.Edge2, image.Edge2));
    this->Spread =
      edges * (glm::max(square - this->Mean * this->Mean, glm::dvec2(0.0)) + cell * cell / 12.0);
    this->Width = light * cell.x * cell.y * image.GetArea() * (this->Spread.x + this->Spread.y);
    this->Axis = this->Spread.x >= this->Spread.y ? 0 : 1;
    this->Axis = upper[this->Axis] - lower[this->Axis] > 1 ? this->Axis : 1 - this->Axis;
    this->Axis = upper[this->Axis] - lower[this->Axis] > 1 ? this->Axis : -1;
  }

  // Returns the entry of the table before which the piece is cut.
  int FindCut() const
  {
    const int cut =
      static_cast<int>(std::lround((this->Mean[this->Axis] + 0.5) * this->Whole->Size[this->Axis]));
    return std::min(std::max(cut, this->Lower[this->Axis] + 1), this->Upper[this->Axis] - 1);
  }

  vtkIndirectAreaClusters::Light MakeLight() const
  {
    const vtkIndirectAreaClusters::Image& image = this->Whole->Image;
    const glm::dvec3 span = glm::cross(image.Edge1, image.Edge2);
    const double cell =
      glm::length(span) / (static_cast<double>(this->Whole->Cells[0]) * this->Whole->Cells[1]);
    vtkIndirectAreaClusters::Light light;
    light.Position = image.GetPlace(this->Mean + 0.5);
    light.Normal = glm::normalize(span);
    light.RadianceArea = cell * glm::dvec3(this->Sum[Red], this->Sum[Green], this->Sum[Blue]);
    light.Area = cell * this->Sum[Strength] * this->Sum[Strength] / this->Sum[StrengthSquared];
    return light;
  }
};

// Orders the queue so that the widest piece comes first, and among equal ones the earlier.
struct Narrower
{
  bool operator()(const std::pair<double, size_t>& a, const std::pair<double, size_t>& b) const
  {
    return a.first != b.first ? a.first < b.first : a.second > b.second;
  }
};
}

//------------------------------------------------------------------------------
std::vector<vtkIndirectAreaClusters::Light> vtkIndirectAreaClusters::MakeLights(
  const std::vector<Image>& images, int count)
{
  std::vector<Table> tables;
  tables.reserve(images.size());
  std::vector<Piece> pieces;
  std::priority_queue<std::pair<double, size_t>, std::vector<std::pair<double, size_t>>, Narrower>
    queue;
  int lights = 0;
  auto sides = [](const Piece& piece) { return piece.Whole->Image.TwoSided ? 2 : 1; };
  auto add = [&](const Piece& piece)
  {
    if (!(piece.Sum[Strength] > 0.0))
    {
      return;
    }
    lights += sides(piece);
    if (piece.Axis >= 0)
    {
      queue.emplace(piece.Width, pieces.size());
    }
    pieces.push_back(piece);
  };
  for (const Image& image : images)
  {
    if (!(image.GetArea() > 0.0))
    {
      continue;
    }
    tables.emplace_back(image);
    const int lower[2] = { 0, 0 };
    add(Piece(tables.back(), lower, tables.back().Size));
  }
  while (!queue.empty())
  {
    const size_t widest = queue.top().second;
    const Piece piece = pieces[widest];
    if (lights + sides(piece) > count)
    {
      break;
    }
    queue.pop();
    lights -= sides(piece);
    int middle[2] = { piece.Upper[0], piece.Upper[1] };
    middle[piece.Axis] = piece.FindCut();
    const Piece first(*piece.Whole, piece.Lower, middle);
    middle[0] = piece.Lower[0];
    middle[1] = piece.Lower[1];
    middle[piece.Axis] = piece.FindCut();
    const Piece second(*piece.Whole, middle, piece.Upper);
    // One half replaces the whole piece; the other half may be dark.
    const bool firstIsLit = first.Sum[Strength] > 0.0;
    pieces[widest] = firstIsLit ? first : second;
    lights += sides(piece);
    if (pieces[widest].Axis >= 0)
    {
      queue.emplace(pieces[widest].Width, widest);
    }
    if (firstIsLit)
    {
      add(second);
    }
  }
  std::vector<vtkIndirectAreaClusters::Light> result;
  result.reserve(static_cast<size_t>(lights));
  for (const Piece& piece : pieces)
  {
    result.push_back(piece.MakeLight());
    if (piece.Whole->Image.TwoSided)
    {
      result.push_back(result.back());
      result.back().Normal = -result.back().Normal;
    }
  }
  return result;
}
