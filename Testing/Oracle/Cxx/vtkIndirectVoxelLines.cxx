// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectVoxelLines.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "Visibility/vtkIndirectDistanceField.h"

#include <algorithm>

//------------------------------------------------------------------------------
bool vtkIndirectVoxelLines::IsFree(const glm::vec3& start, const glm::vec3& end) const
{
  vtkIndirectKernels::vtkiLeap leap = vtkIndirectKernels::vtkiBeginLeap(start, end);
  bool more = vtkIndirectKernels::vtkiLeapOn(leap, 1) && leap.voxel != leap.last;
  while (more)
  {
    const glm::ivec3 at = glm::clamp(leap.voxel, glm::ivec3(0), this->Field.GetSize() - 1);
    const int freeVoxels = this->Field.Get(at);
    if (freeVoxels == 0 && at == leap.voxel)
    {
      return false;
    }
    more = vtkIndirectKernels::vtkiLeapOn(leap, std::max(freeVoxels, 1)) && leap.voxel != leap.last;
  }
  return true;
}

//------------------------------------------------------------------------------
vtkIndirectVoxelLines::End vtkIndirectVoxelLines::FindEnd(
  const glm::dvec3& position, const glm::dvec3& direction) const
{
  const glm::vec3 normal(direction);
  auto isEmpty = [this](const glm::vec3& place)
  {
    const glm::ivec3 voxel(glm::floor(place));
    const glm::ivec3 at = glm::clamp(voxel, glm::ivec3(0), this->Field.GetSize() - 1);
    return this->Field.Get(at) > 0 || at != voxel;
  };
  const glm::vec3 voxels = this->Field.ToVoxels(glm::vec3(position));
  const glm::vec3 place = voxels + vtkIndirectKernels::vtkiClearHeight(normal) * normal;
  for (int i = 0; i < vtkIndirectKernels::VTKI_ASIDE && !isEmpty(place); ++i)
  {
    const glm::vec3 aside = place + vtkIndirectKernels::vtkiAside(i, normal);
    if (isEmpty(aside))
    {
      return { voxels, normal, aside };
    }
  }
  return { voxels, normal, place };
}

//------------------------------------------------------------------------------
bool vtkIndirectVoxelLines::IsVisible(const End& receiver, const End& sender) const
{
  using namespace vtkIndirectKernels;
  return this->IsFree(vtkiClearOf(receiver.Open, receiver.Normal, sender.Position, sender.Normal,
                        vtkiClearHeight(sender.Normal)),
    vtkiClearOf(sender.Open, sender.Normal, receiver.Position, receiver.Normal,
      vtkiClearHeight(receiver.Normal)));
}
