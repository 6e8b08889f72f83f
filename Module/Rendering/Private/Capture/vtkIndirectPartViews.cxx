// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/vtkIndirectPartViews.h"

#include "Capture/vtkIndirectDepthTile.h"
#include "Frame/vtkIndirectFrame.h"
#include "vtkProp.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
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
  , Scale(FindScale(prop))
  , Seen(parts.Parts.size(), 0)
  , Levels(parts.NumberOfLevels)
{
  const glm::dmat4 toWorld = vtkIndirectFrame::ToGLM(prop->GetMatrix());
  for (const vtkIndirectMeshParts::Part& part : parts.Parts)
  {
    glm::dvec3 low(std::numeric_limits<double>::max());
    glm::dvec3 high = -low;
    for (int i = 0; i < 8; ++i)
    {
      const glm::dvec3 corner(
        toWorld * glm::dvec4(vtkIndirectFrame::GetCorner(part.Bounds.data(), i), 1.0));
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
    this->Bounds.push_back({ low.x, high.x, low.y, high.y, low.z, high.z });
  }
}

//------------------------------------------------------------------------------
void vtkIndirectPartViews::SetTile(
  const vtkIndirectFrame& frame, const vtkIndirectDepthTile& tile, int texels)
{
  for (size_t i = 0; i < this->Seen.size(); ++i)
  {
    this->Seen[i] = tile.FindViews(frame, this->Bounds[i].data(), texels);
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
        this->Levels[static_cast<size_t>(level)].push_back(
          this->Parts.Parts[i].Levels[static_cast<size_t>(level)]);
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
