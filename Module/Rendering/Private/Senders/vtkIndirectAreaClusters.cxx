// SPDX-License-Identifier: BSD-3-Clause
#include "Senders/vtkIndirectAreaClusters.h"

#include "OpenGL/vtkIndirectKernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

namespace
{
using Light = vtkIndirectAreaClusters::Light;

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

  Light MakeLight() const
  {
    const vtkIndirectAreaClusters::Image& image = this->Whole->Image;
    const glm::dvec3 span = glm::cross(image.Edge1, image.Edge2);
    const double cell =
      glm::length(span) / (static_cast<double>(this->Whole->Cells[0]) * this->Whole->Cells[1]);
    Light light;
    light.Position = image.GetPlace(this->Mean + 0.5);
    light.Normal = glm::normalize(span);
    light.DensityArea = cell * glm::dvec3(this->Sum[Red], this->Sum[Green], this->Sum[Blue]);
    light.Area = cell * this->Sum[Strength] * this->Sum[Strength] / this->Sum[StrengthSquared];
    return light;
  }

  // Returns the lights of the piece's sides.
  int GetSides() const { return this->Whole->Image.TwoSided ? 2 : 1; }
};

// Orders the queue so that the widest piece comes first, and among equal ones the earlier.
struct Narrower
{
  bool operator()(const std::pair<double, size_t>& a, const std::pair<double, size_t>& b) const
  {
    return a.first != b.first ? a.first < b.first : a.second > b.second;
  }
};

// Halves the widest piece again and again, until there are as many lights, sides counted, as asked
// for. One half replaces the whole piece; the other half may be dark.
void Halve(std::vector<Piece>& pieces, int count)
{
  std::priority_queue<std::pair<double, size_t>, std::vector<std::pair<double, size_t>>, Narrower>
    queue;
  int lights = 0;
  auto enqueue = [&](size_t i)
  {
    lights += pieces[i].GetSides();
    if (pieces[i].Axis >= 0)
    {
      queue.emplace(pieces[i].Width, i);
    }
  };
  for (size_t i = 0; i < pieces.size(); ++i)
  {
    enqueue(i);
  }
  while (!queue.empty())
  {
    const size_t widest = queue.top().second;
    const Piece piece = pieces[widest];
    if (lights + piece.GetSides() > count)
    {
      break;
    }
    queue.pop();
    lights -= piece.GetSides();
    int middle[2] = { piece.Upper[0], piece.Upper[1] };
    middle[piece.Axis] = piece.FindCut();
    const Piece first(*piece.Whole, piece.Lower, middle);
    middle[0] = piece.Lower[0];
    middle[1] = piece.Lower[1];
    middle[piece.Axis] = piece.FindCut();
    const Piece second(*piece.Whole, middle, piece.Upper);
    const bool firstIsLit = first.Sum[Strength] > 0.0;
    pieces[widest] = firstIsLit ? first : second;
    enqueue(widest);
    if (firstIsLit && second.Sum[Strength] > 0.0)
    {
      pieces.push_back(second);
      enqueue(pieces.size() - 1);
    }
  }
}

// Returns the light of a piece, or of a piece of a piece, which receives divide near it if the
// error of the whole exceeds the limit.
Light MakeNode(const Piece& piece, double limit)
{
  Light light = piece.MakeLight();
  light.ContactSoftening = light.Area;
  if (limit > 0.0 && piece.Axis >= 0)
  {
    const double strength = (light.DensityArea.x + light.DensityArea.y + light.DensityArea.z) / 3.0;
    light.ChildDistance = vtkIndirectSenderClusters::FindChildDistance(
      strength, piece.Spread.x + piece.Spread.y, limit);
  }
  return light;
}

// Adds the lights of a piece's sides. Branches are places for two generations below a light: each
// child is followed by its own children. Both sides are divided the same way.
void AddLights(const Piece& piece, double limit, vtkIndirectAreaClusters::LightTree& tree)
{
  constexpr int perNode = vtkIndirectKernels::VTKI_BRANCHES_PER_NODE;
  Light nothing;
  nothing.ChildDistance = -1.0;
  std::vector<Light> branches(limit > 0.0 ? vtkIndirectKernels::VTKI_BRANCHES : 0, nothing);
  const Light light = MakeNode(piece, limit);
  if (light.ChildDistance > 0.0)
  {
    std::vector<Piece> children = { piece };
    Halve(children, perNode * piece.GetSides());
    for (size_t i = 0; i < children.size(); ++i)
    {
      Light* const family = &branches[i * (perNode + 1)];
      family[0] = MakeNode(children[i], limit);
      if (family[0].ChildDistance > 0.0)
      {
        std::vector<Piece> leaves = { children[i] };
        Halve(leaves, perNode * piece.GetSides());
        double softening = 0.0;
        for (size_t k = 0; k < leaves.size(); ++k)
        {
          family[k + 1] = MakeNode(leaves[k], 0.0);
          softening = std::max(softening, family[k + 1].Area);
        }
        family[0].ContactSoftening = softening;
      }
    }
  }
  for (int side = 0; side < piece.GetSides(); ++side)
  {
    tree.Lights.push_back(light);
    tree.Branches.insert(tree.Branches.end(), branches.begin(), branches.end());
    if (side == 1)
    {
      tree.Lights.back().Normal *= -1.0;
      for (size_t i = tree.Branches.size() - branches.size(); i < tree.Branches.size(); ++i)
      {
        tree.Branches[i].Normal *= -1.0;
      }
    }
  }
}

// Squares of a picture at all sizes down to cells, with the least and the greatest radiance of each
// (the sum over the colours).
class MinMaxPyramid
{
public:
  // Squares along an edge of the finest level.
  static constexpr int Finest = 64;

  explicit MinMaxPyramid(const Table& table)
    : Whole(table)
  {
    for (int edge = Finest; edge > 0; edge /= 2)
    {
      this->Levels.emplace_back(static_cast<size_t>(edge) * edge);
      for (int y = 0; y < edge; ++y)
      {
        for (int x = 0; x < edge; ++x)
        {
          this->Levels.back()[static_cast<size_t>(y) * edge + x] =
            edge == Finest ? this->Measure(x, y) : this->Join(x, y, 2 * edge);
        }
      }
    }
  }

  double GetGreatestRange() const { return this->Levels.back()[0].y - this->Levels.back()[0].x; }

  // Appends pieces of at least 1 / coarsest of an edge: squares whose radiances differ by at most
  // this, and else their quarters.
  void AppendPieces(double difference, int coarsest, std::vector<Piece>& pieces) const
  {
    this->Append(0, 0, this->Levels.size() - 1, difference, coarsest, pieces);
  }

private:
  Piece MakePiece(int x, int y, int edge) const
  {
    auto place = [&](int i, int axis) { return i * this->Whole.Size[axis] / edge; };
    const int lower[2] = { place(x, 0), place(y, 1) };
    const int upper[2] = { place(x + 1, 0), place(y + 1, 1) };
    return Piece(this->Whole, lower, upper);
  }
  glm::dvec2 Measure(int x, int y) const
  {
    const Piece piece = this->MakePiece(x, y, Finest);
    const double entries = static_cast<double>(piece.Upper[0] - piece.Lower[0]) *
      static_cast<double>(piece.Upper[1] - piece.Lower[1]);
    return glm::dvec2(piece.Sum[Strength] / entries);
  }
  glm::dvec2 Join(int x, int y, int finer) const
  {
    const std::vector<glm::dvec2>& level = this->Levels[this->Levels.size() - 2];
    glm::dvec2 range = level[static_cast<size_t>(2 * y) * finer + 2 * x];
    for (int i = 1; i < 4; ++i)
    {
      const glm::dvec2& other = level[static_cast<size_t>(2 * y + i / 2) * finer + 2 * x + i % 2];
      range = { std::min(range.x, other.x), std::max(range.y, other.y) };
    }
    return range;
  }
  void Append(
    int x, int y, size_t level, double difference, int coarsest, std::vector<Piece>& pieces) const
  {
    const int edge = Finest >> level;
    const glm::dvec2& range = this->Levels[level][static_cast<size_t>(y) * edge + x];
    if (level == 0 || (edge >= coarsest && range.y - range.x <= difference))
    {
      const Piece piece = this->MakePiece(x, y, edge);
      if (piece.Sum[Strength] > 0.0)
      {
        pieces.push_back(piece);
      }
      return;
    }
    for (int i = 0; i < 4; ++i)
    {
      this->Append(2 * x + i % 2, 2 * y + i / 2, level - 1, difference, coarsest, pieces);
    }
  }

  const Table& Whole;
  std::vector<std::vector<glm::dvec2>> Levels; // the finest first
};

std::vector<Table> MakeTables(const std::vector<vtkIndirectAreaClusters::Image>& images)
{
  std::vector<Table> tables;
  tables.reserve(images.size());
  for (const vtkIndirectAreaClusters::Image& image : images)
  {
    if (image.GetArea() > 0.0)
    {
      tables.emplace_back(image);
    }
  }
  return tables;
}
}

//------------------------------------------------------------------------------
vtkIndirectAreaClusters::LightTree vtkIndirectAreaClusters::MakeLights(
  const std::vector<Image>& images, int count, double limit)
{
  const std::vector<Table> tables = MakeTables(images);
  std::vector<Piece> pieces;
  for (const Table& table : tables)
  {
    const int lower[2] = { 0, 0 };
    const Piece whole(table, lower, table.Size);
    if (whole.Sum[Strength] > 0.0)
    {
      pieces.push_back(whole);
    }
  }
  Halve(pieces, count);
  LightTree tree;
  tree.Lights.reserve(static_cast<size_t>(std::max(count, 0)));
  for (const Piece& piece : pieces)
  {
    AddLights(piece, limit, tree);
  }
  return tree;
}

//------------------------------------------------------------------------------
std::vector<vtkIndirectAreaClusters::Light> vtkIndirectAreaClusters::MakeMinMaxLights(
  const std::vector<Image>& images, int count)
{
  const std::vector<Table> tables = MakeTables(images);
  int sides = 0;
  double most = 0.0;
  std::vector<MinMaxPyramid> pyramids;
  for (const Table& table : tables)
  {
    sides += table.Image.TwoSided ? 2 : 1;
    pyramids.emplace_back(table);
    most = std::max(most, pyramids.back().GetGreatestRange());
  }
  int coarsest = MinMaxPyramid::Finest;
  while (coarsest > 1 && sides * 4 * coarsest * coarsest > count)
  {
    coarsest /= 2;
  }
  std::vector<Piece> pieces;
  auto divide = [&](double difference)
  {
    pieces.clear();
    int lights = 0;
    for (const MinMaxPyramid& pyramid : pyramids)
    {
      const size_t before = pieces.size();
      pyramid.AppendPieces(difference, coarsest, pieces);
      lights += before < pieces.size()
        ? static_cast<int>(pieces.size() - before) * pieces.back().GetSides()
        : 0;
    }
    return lights <= count;
  };
  // Fewer lights come of a greater difference. The greatest gives no more than asked for, or one
  // for each side.
  if (!divide(0.0))
  {
    double enough = most;
    double tooSmall = 0.0;
    for (int i = 0; i < 20; ++i)
    {
      const double middle = 0.5 * (tooSmall + enough);
      (divide(middle) ? enough : tooSmall) = middle;
    }
    divide(enough);
  }
  LightTree tree;
  for (const Piece& piece : pieces)
  {
    AddLights(piece, 0.0, tree);
  }
  return tree.Lights;
}
