// SPDX-License-Identifier: BSD-3-Clause
#include "RadianceHints/vtkIndirectHintSurfaces.h"

#include <algorithm>
#include <cmath>

namespace
{
// A block has so many voxels along its edge.
constexpr int BlockEdge = 2;
// Least cosine between normals of one slightly bent surface.
constexpr double LeastCosine = 0.95;

bool IsSame(const vtkIndirectHintSurfaces::Hit& a, const vtkIndirectHintSurfaces::Hit& b)
{
  const glm::dvec3 offset = b.Position - a.Position;
  return glm::dot(a.Normal, b.Normal) > LeastCosine &&
    std::max(std::abs(glm::dot(a.Normal, offset)), std::abs(glm::dot(b.Normal, offset))) <
    vtkIndirectHintSurfaces::PlaneDepth;
}
}

//------------------------------------------------------------------------------
vtkIndirectHintSurfaces::vtkIndirectHintSurfaces(const glm::ivec3& size)
  : Blocks((size + (BlockEdge - 1)) / BlockEdge)
  , Newest(static_cast<size_t>(this->Blocks.x) * this->Blocks.y * this->Blocks.z, -1)
{
}

//------------------------------------------------------------------------------
int vtkIndirectHintSurfaces::Add(const Hit& hit)
{
  const glm::ivec3 block = glm::clamp(glm::ivec3(glm::floor(hit.Position / (1.0 * BlockEdge))),
    glm::ivec3(0), this->Blocks - glm::ivec3(1));
  int& newest = this->Newest[block.x + this->Blocks.x * (block.y + this->Blocks.y * block.z)];
  int found = newest;
  while (found >= 0 && !IsSame(this->Surfaces[found].First, hit))
  {
    found = this->Surfaces[found].Before;
  }
  if (found < 0)
  {
    found = this->GetNumberOfSurfaces();
    this->Surfaces.push_back({ hit, {}, 0.0, newest });
    newest = found;
  }
  Surface& surface = this->Surfaces[found];
  surface.Sum.Position += hit.Position;
  surface.Sum.Normal += hit.Normal;
  surface.Sum.Albedo += hit.Albedo;
  surface.Count += 1.0;
  return found;
}

//------------------------------------------------------------------------------
vtkIndirectHintSurfaces::Hit vtkIndirectHintSurfaces::GetMean(int surface) const
{
  const Surface& from = this->Surfaces[surface];
  return { from.Sum.Position / from.Count, glm::normalize(from.Sum.Normal),
    from.Sum.Albedo / from.Count };
}
