// SPDX-License-Identifier: BSD-3-Clause
#include "RadianceHints/vtkIndirectHintRegions.h"

#include "Plan/vtkIndirectPlan.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
std::vector<vtkIndirectHintGrid::Region> vtkIndirectHintRegions::Find(
  const vtkIndirectFrame& frame) const
{
  std::vector<vtkIndirectHintGrid::Region> regions = { this->FindCoarse(frame) };
  if (this->HasFine)
  {
    regions.push_back(this->FindFine(frame, regions.front()));
  }
  return regions;
}

//------------------------------------------------------------------------------
glm::ivec3 vtkIndirectHintRegions::FindSize(const glm::dvec3& extent) const
{
  const int along = vtkIndirectPlan::FindGridEdge(this->Tolerance);
  const double longest = std::max({ extent.x, extent.y, extent.z });
  glm::ivec3 size;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double share = longest > 0.0 ? extent[axis] / longest : 1.0;
    size[axis] = this->Resolution[axis] > 0
      ? this->Resolution[axis]
      : std::clamp(static_cast<int>(std::ceil(along * share - 1e-6)), 2, MaximumResolution);
  }
  return size;
}

//------------------------------------------------------------------------------
vtkIndirectHintGrid::Region vtkIndirectHintRegions::FindCoarse(const vtkIndirectFrame& frame) const
{
  glm::dvec3 lower = frame.ToScene(vtkIndirectFrame::GetCorner(frame.SceneBounds, 0));
  glm::dvec3 upper = frame.ToScene(vtkIndirectFrame::GetCorner(frame.SceneBounds, 7));
  if (this->OfView)
  {
    glm::dvec3 least(INFINITY);
    glm::dvec3 most(-INFINITY);
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec2 ndc(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0);
      const glm::dvec3 place = frame.FindPlace(ndc, corner & 4 ? frame.Far : frame.Near);
      least = glm::min(least, place);
      most = glm::max(most, place);
    }
    least = glm::max(least, lower);
    most = glm::min(most, upper);
    if (glm::all(glm::lessThan(least, most)))
    {
      lower = least;
      upper = most;
    }
  }
  // Gives a flat scene space in front of it.
  const double longest = glm::length(upper - lower);
  const glm::dvec3 room = glm::max(glm::dvec3(0.0), 0.02 * longest - 0.5 * (upper - lower));
  vtkIndirectHintGrid::Region region;
  region.Lower = lower - room;
  region.Upper = upper + room;
  region.Size = this->FindSize(region.Upper - region.Lower);
  return region;
}

//------------------------------------------------------------------------------
vtkIndirectHintGrid::Region vtkIndirectHintRegions::FindFine(
  const vtkIndirectFrame& frame, const vtkIndirectHintGrid::Region& coarse) const
{
  vtkIndirectHintGrid::Region fine;
  const glm::dvec3 edge = this->FineExtent * (coarse.Upper - coarse.Lower);
  fine.Size = coarse.Size;
  const glm::dvec3 cell = edge / glm::dvec3(fine.Size);
  double focal[3];
  frame.Renderer->GetActiveCamera()->GetFocalPoint(focal);
  const glm::dvec3 center = frame.ToScene({ focal[0], focal[1], focal[2] });
  const glm::dvec3 corner =
    glm::clamp(center - 0.5 * edge, coarse.Lower, coarse.Upper - edge) - coarse.Lower;
  // Moves by four cells at a time: steps of one would make new hints for every small movement.
  fine.Lower = coarse.Lower + glm::floor(corner / (4.0 * cell) + 0.5) * (4.0 * cell);
  fine.Upper = fine.Lower + edge;
  return fine;
}
