// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectCasterBounds.h"

#include "Scene/vtkIndirectFrame.h"
#include "vtkBoundingBox.h"

#include <algorithm>

namespace
{
constexpr double ShareOfMotion = 1.0 / 8.0;
constexpr double LeastFilled = 0.5;

bool Contains(const std::array<double, 6>& box, const double bounds[6])
{
  return box[0] <= bounds[0] && box[1] >= bounds[1] && box[2] <= bounds[2] && box[3] >= bounds[3] &&
    box[4] <= bounds[4] && box[5] >= bounds[5];
}
}

//------------------------------------------------------------------------------
void vtkIndirectCasterBounds::Give(std::vector<vtkIndirectCaster>& casters, bool interactive)
{
  if (!interactive)
  {
    this->Boxes.clear();
  }
  vtkBoundingBox exact;
  vtkBoundingBox before;
  for (const auto& entry : this->Boxes)
  {
    before.AddBounds(entry.second.data());
  }
  for (const vtkIndirectCaster& caster : casters)
  {
    exact.AddBounds(caster.Bounds);
  }
  double scene[6];
  vtkBoundingBox all = exact;
  all.AddBox(before);
  all.GetBounds(scene);
  const double margin = ShareOfMotion * vtkIndirectFrame::FindDiagonal(exact);
  std::unordered_map<vtkProp*, Box> boxes;
  vtkBoundingBox wide;
  for (const vtkIndirectCaster& caster : casters)
  {
    Box box;
    std::copy(caster.Bounds, caster.Bounds + 6, box.begin());
    const auto found = this->Boxes.find(caster.Prop);
    if (found != this->Boxes.end() && Contains(found->second, caster.Bounds))
    {
      box = found->second;
    }
    else if (found != this->Boxes.end())
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        // A caster that moves the scene's border outwards gets space beyond the border.
        double& lower = box[static_cast<size_t>(2 * axis)];
        double& upper = box[static_cast<size_t>(2 * axis + 1)];
        const bool leavesBelow = before.IsValid() && lower < before.GetBound(2 * axis);
        const bool leavesAbove = before.IsValid() && upper > before.GetBound(2 * axis + 1);
        lower = leavesBelow ? lower - margin : std::max(lower - margin, scene[2 * axis]);
        upper = leavesAbove ? upper + margin : std::min(upper + margin, scene[2 * axis + 1]);
      }
    }
    boxes[caster.Prop] = box;
    wide.AddBounds(box.data());
  }
  this->Boxes = std::move(boxes);
  const bool fills =
    vtkIndirectFrame::FindDiagonal(exact) >= LeastFilled * vtkIndirectFrame::FindDiagonal(wide);
  for (vtkIndirectCaster& caster : casters)
  {
    Box& box = this->Boxes[caster.Prop];
    if (!fills)
    {
      std::copy(caster.Bounds, caster.Bounds + 6, box.begin());
    }
    std::copy(box.begin(), box.end(), caster.WideBounds);
    caster.HasWideBounds = true;
  }
}
