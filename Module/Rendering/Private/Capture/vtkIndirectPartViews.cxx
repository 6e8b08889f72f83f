// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/vtkIndirectPartViews.h"

#include "Capture/vtkIndirectDepthTile.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkProp.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr unsigned int NotAsked = ~0u;

// Returns a bound of the factor from lengths in a prop's mesh to world units, the factor itself for
// a matrix that shears nothing: by Gershgorin's circles of the squares of its singular values.
double FindScale(vtkProp* prop)
{
  const glm::dmat3 m(vtkIndirectFrame::ToGLM(prop->GetMatrix()));
  const glm::dmat3 squares = glm::transpose(m) * m;
  double most = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 row = glm::abs(squares[i]);
    most = std::max(most, row.x + row.y + row.z);
  }
  return std::sqrt(most);
}
}

//------------------------------------------------------------------------------
vtkIndirectPartViews::vtkIndirectPartViews(const vtkIndirectMeshParts& parts, vtkProp* prop)
  : Parts(parts)
  , ToWorld(vtkIndirectFrame::ToGLM(prop->GetMatrix()))
  , Scale(FindScale(prop))
  , Seen(parts.Parts.size(), 0)
  , Levels(parts.NumberOfLevels)
{
  for (const vtkIndirectMeshParts::Part& part : parts.Parts)
  {
    this->Bounds.push_back(this->ToWorldBounds(part.Bounds));
  }
}

//------------------------------------------------------------------------------
vtkIndirectPartViews::Bounds6 vtkIndirectPartViews::ToWorldBounds(const Bounds6& bounds) const
{
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high = -low;
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec3 corner(
      this->ToWorld * glm::dvec4(vtkIndirectFrame::GetCorner(bounds.data(), i), 1.0));
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  return { low.x, high.x, low.y, high.y, low.z, high.z };
}

//------------------------------------------------------------------------------
void vtkIndirectPartViews::SetTile(
  const vtkIndirectFrame& frame, const vtkIndirectDepthTile& tile, int texels)
{
  this->Tile = &tile;
  this->Texels = texels;
  this->SeenPieces.assign(this->Parts.Pieces.size(), NotAsked);
  for (size_t i = 0; i < this->Seen.size(); ++i)
  {
    this->Seen[i] = tile.FindViews(frame, this->Bounds[i].data(), texels);
  }
}

//------------------------------------------------------------------------------
// Adds the pieces of a part's level that a view sees.
void vtkIndirectPartViews::AddPieces(
  const vtkIndirectFrame& frame, const vtkIndirectMeshParts::Part& part, size_t level, int view)
{
  std::vector<vtkIndirectMeshParts::Level>& ranges = this->Levels[level];
  vtkIndirectMeshParts::Level range = part.Levels[level];
  range.Count = range.NumberOfPieces = 0;
  for (size_t k = 0; k < part.Levels[level].NumberOfPieces; ++k)
  {
    const size_t number = part.Levels[level].FirstPiece + k;
    const vtkIndirectMeshParts::Piece& piece = this->Parts.Pieces[number];
    unsigned int& seen = this->SeenPieces[number];
    if (seen == NotAsked)
    {
      seen = this->Tile->FindViews(frame, this->ToWorldBounds(piece.Bounds).data(), this->Texels);
    }
    if (((seen >> view) & 1u) == 0)
    {
      continue;
    }
    if (range.Count > 0 && range.First + range.Count != piece.First)
    {
      ranges.push_back(range);
      range.Count = range.NumberOfPieces = 0;
    }
    if (range.NumberOfPieces == 0)
    {
      range.First = piece.First;
      range.FirstPiece = number;
    }
    range.Count += piece.Count;
    ++range.NumberOfPieces;
  }
  if (range.Count > 0)
  {
    ranges.push_back(range);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectPartViews::Choose(const vtkIndirectFrame& frame, const vtkIndirectDepthTile& view,
  int number, int texels, double mostError)
{
  for (std::vector<vtkIndirectMeshParts::Level>& levels : this->Levels)
  {
    levels.clear();
  }
  bool whole = false;
  const glm::dvec2 size(vtkIndirectDepthTile::GetSizeOfView(number, texels));
  for (size_t i = 0; i < this->Seen.size(); ++i)
  {
    if ((this->Seen[i] >> number) & 1u)
    {
      const double texel = view.FindTexelAt(frame, this->Bounds[i].data(), size);
      const int level = this->Parts.Parts[i].FindLevel(mostError * texel / this->Scale);
      whole = whole || level < 0;
      if (level >= 0)
      {
        const auto chosen = static_cast<size_t>(level);
        const vtkIndirectMeshParts::Part& part = this->Parts.Parts[i];
        const bool several = (this->Seen[i] & (this->Seen[i] - 1u)) != 0;
        if (several && part.Levels[chosen].NumberOfPieces > 1)
        {
          this->AddPieces(frame, part, chosen, number);
        }
        else
        {
          this->Levels[chosen].push_back(part.Levels[chosen]);
        }
      }
    }
  }
  return whole;
}

//------------------------------------------------------------------------------
bool vtkIndirectPartViews::IsEmpty() const
{
  return std::all_of(
    this->Levels.begin(), this->Levels.end(), [](const auto& levels) { return levels.empty(); });
}

//------------------------------------------------------------------------------
double vtkIndirectPartViews::FindError(size_t number) const
{
  double error = 0.0;
  for (const vtkIndirectMeshParts::Level& level : this->Levels[number])
  {
    error = std::max(error, level.Error);
  }
  return error * this->Scale;
}
