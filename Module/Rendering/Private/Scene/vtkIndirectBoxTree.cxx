// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectBoxTree.h"

#include <algorithm>
#include <cstddef>

namespace
{
constexpr uint32_t MostBins = 16;
// Below this depth boxes are halved by their count: 31 levels of halves hold 2^31 boxes.
constexpr int DeepestByArea = 32;
// A node of more boxes is split even if the heuristic finds no gain.
constexpr uint32_t LargestLeaf = 8;

// Returns the median of the boxes' centres on each axis.
glm::dvec3 FindMiddle(const std::vector<vtkIndirectBoxTree::Box>& boxes)
{
  glm::dvec3 middle(0.0);
  std::vector<double> places(boxes.size());
  for (int axis = 0; axis < 3 && !places.empty(); ++axis)
  {
    std::transform(boxes.begin(), boxes.end(), places.begin(),
      [axis](const auto& box) { return 0.5 * (box.Lower[axis] + box.Upper[axis]); });
    const auto half = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
    std::nth_element(places.begin(), half, places.end());
    middle[axis] = *half;
  }
  return middle;
}
}

//------------------------------------------------------------------------------
vtkIndirectBoxTree::Range::Range()
{
  std::fill(this->Lower, this->Lower + 4, std::numeric_limits<float>::infinity());
  std::fill(this->Upper, this->Upper + 4, -std::numeric_limits<float>::infinity());
}

//------------------------------------------------------------------------------
void vtkIndirectBoxTree::Range::Add(const Range& other)
{
  for (int i = 0; i < 4; ++i)
  {
    this->Lower[i] = other.Lower[i] < this->Lower[i] ? other.Lower[i] : this->Lower[i];
    this->Upper[i] = other.Upper[i] > this->Upper[i] ? other.Upper[i] : this->Upper[i];
  }
}

//------------------------------------------------------------------------------
float vtkIndirectBoxTree::Range::HalfArea() const
{
  const float x = this->Upper[0] - this->Lower[0];
  const float y = this->Upper[1] - this->Lower[1];
  const float z = this->Upper[2] - this->Lower[2];
  return x >= 0.0f ? x * y + y * z + z * x : 0.0f;
}

//------------------------------------------------------------------------------
struct vtkIndirectBoxTree::Split
{
  int Axis = -1;
  int Bin = 0;                                         // the first one of the second child
  float Cost = std::numeric_limits<float>::infinity(); // half area times boxes
  float CostOfLeaf = 0.0f;
  int NumberOfBins = 0;
  float Lower[3];
  float Scale[3]; // bins per length

  int FindBin(const Range& centre, int axis) const
  {
    return std::min(static_cast<int>((centre.Lower[axis] - this->Lower[axis]) * this->Scale[axis]),
      this->NumberOfBins - 1);
  }
};

//------------------------------------------------------------------------------
vtkIndirectBoxTree::vtkIndirectBoxTree(const std::vector<Box>& boxes)
  : Middle(FindMiddle(boxes))
{
  for (const Box& box : boxes)
  {
    this->All.Add(box);
  }
  const glm::dvec3 edges = this->All.Upper - this->All.Lower;
  const double longest = std::max({ edges.x, edges.y, edges.z });
  const double scale = longest > 0.0 ? 1.0 / longest : 1.0;
  this->Items.resize(boxes.size());
  for (size_t i = 0; i < boxes.size(); ++i)
  {
    Item& item = this->Items[i];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double middle = this->Middle[axis];
      item.Bounds.Lower[axis] = static_cast<float>(scale * (boxes[i].Lower[axis] - middle));
      item.Bounds.Upper[axis] = static_cast<float>(scale * (boxes[i].Upper[axis] - middle));
    }
    item.Bounds.Lower[3] = item.Bounds.Upper[3] = 0.0f;
    item.Number = static_cast<uint32_t>(i);
  }
  this->MakeParts();
  this->Order.reserve(boxes.size());
  for (const Item& item : this->Items)
  {
    this->Order.push_back(item.Number);
  }
  this->Items = {};
  this->FindBounds(boxes);
}

//------------------------------------------------------------------------------
// Finds the bounds of all nodes without rounding. Children come after their parent.
void vtkIndirectBoxTree::FindBounds(const std::vector<Box>& boxes)
{
  for (auto part = this->Parts.rbegin(); part != this->Parts.rend(); ++part)
  {
    for (uint32_t i = part->First; i < part->First + part->Count; ++i)
    {
      part->Bounds.Add(boxes[this->Order[i]]);
    }
    if (part->Count == 0 && part->First > 0)
    {
      part->Bounds.Add(this->Parts[part->First].Bounds);
      part->Bounds.Add(this->Parts[part->First + 1].Bounds);
    }
  }
}

//------------------------------------------------------------------------------
vtkIndirectBoxTree::Range vtkIndirectBoxTree::FindCentre(const Item& item)
{
  Range centre;
  for (int i = 0; i < 4; ++i)
  {
    centre.Lower[i] = centre.Upper[i] = 0.5f * (item.Bounds.Lower[i] + item.Bounds.Upper[i]);
  }
  return centre;
}

//------------------------------------------------------------------------------
// Few boxes need few bins: most nodes are small.
vtkIndirectBoxTree::Split vtkIndirectBoxTree::FindSplit(
  uint32_t begin, uint32_t end, const Range& centres) const
{
  const uint32_t all = end - begin;
  Split best;
  best.NumberOfBins = static_cast<int>(std::min(MostBins, 2 * all));
  for (int axis = 0; axis < 3; ++axis)
  {
    const float edge = centres.Upper[axis] - centres.Lower[axis];
    best.Lower[axis] = centres.Lower[axis];
    best.Scale[axis] = edge > 0.0f ? static_cast<float>(best.NumberOfBins) / edge : 0.0f;
  }
  Range ranges[3][MostBins];
  uint32_t counts[3][MostBins] = {};
  for (uint32_t i = begin; i < end; ++i)
  {
    const Range centre = FindCentre(this->Items[i]);
    for (int axis = 0; axis < 3; ++axis)
    {
      const int bin = best.FindBin(centre, axis);
      ranges[axis][bin].Add(this->Items[i].Bounds);
      ++counts[axis][bin];
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    float below[MostBins]; // costs of the bins up to this one
    Range range;
    uint32_t count = 0;
    for (int bin = 0; bin < best.NumberOfBins; ++bin)
    {
      range.Add(ranges[axis][bin]);
      count += counts[axis][bin];
      below[bin] = static_cast<float>(count) * range.HalfArea();
    }
    best.CostOfLeaf = below[best.NumberOfBins - 1] - range.HalfArea();
    range = Range();
    count = 0;
    for (int bin = best.NumberOfBins - 1; bin > 0; --bin)
    {
      range.Add(ranges[axis][bin]);
      count += counts[axis][bin];
      const float cost = below[bin - 1] + static_cast<float>(count) * range.HalfArea();
      if (count > 0 && count < all && cost < best.Cost)
      {
        best.Cost = cost;
        best.Axis = axis;
        best.Bin = bin;
      }
    }
  }
  return best;
}

//------------------------------------------------------------------------------
// Returns the place in the order at which the boxes of a node are split; `begin` for a leaf.
uint32_t vtkIndirectBoxTree::Divide(const Job& job)
{
  const uint32_t count = job.End - job.Begin;
  if (count <= 1 || job.Depth >= Deepest - 2)
  {
    return job.Begin;
  }
  Range centres;
  for (uint32_t i = job.Begin; i < job.End; ++i)
  {
    centres.Add(FindCentre(this->Items[i]));
  }
  const Split split = this->FindSplit(job.Begin, job.End, centres);
  // A step down the tree costs about as much as the test of one box's content.
  const bool gains = split.Axis >= 0 && split.Cost < split.CostOfLeaf;
  if (!gains && count <= LargestLeaf)
  {
    return job.Begin;
  }
  if (split.Axis < 0 || job.Depth >= DeepestByArea)
  {
    return job.Begin + count / 2;
  }
  const auto first = this->Items.begin();
  return static_cast<uint32_t>(
    std::partition(first + job.Begin, first + job.End,
      [&](const Item& one) { return split.FindBin(FindCentre(one), split.Axis) < split.Bin; }) -
    first);
}

//------------------------------------------------------------------------------
void vtkIndirectBoxTree::MakeParts()
{
  std::vector<Part>& parts = this->Parts;
  parts.resize(1);
  std::vector<Job> jobs = { { 0, 0, static_cast<uint32_t>(this->Items.size()), 0 } };
  while (!jobs.empty())
  {
    const Job job = jobs.back();
    jobs.pop_back();
    const uint32_t middle = this->Divide(job);
    const bool leaf = middle == job.Begin;
    Part& part = parts[job.Node];
    part.First = leaf ? job.Begin : static_cast<uint32_t>(parts.size());
    part.Count = leaf ? job.End - job.Begin : 0;
    if (!leaf)
    {
      jobs.push_back({ part.First, job.Begin, middle, job.Depth + 1 });
      jobs.push_back({ part.First + 1, middle, job.End, job.Depth + 1 });
      parts.resize(parts.size() + 2);
    }
  }
}
