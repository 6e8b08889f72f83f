// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectBoxTree.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace
{
constexpr int Bins = 16;
// Below this depth boxes are halved by their count: 31 levels of halves hold 2^31 boxes.
constexpr int DeepestByArea = 32;
// A node of more boxes is split even if the heuristic finds no gain.
constexpr uint32_t LargestLeaf = 8;
}

//------------------------------------------------------------------------------
struct vtkIndirectBoxTree::Split
{
  int Axis = -1;
  int Bin = 0;
  double Cost = std::numeric_limits<double>::infinity(); // half area times boxes
  Box Centres;
};

//------------------------------------------------------------------------------
vtkIndirectBoxTree::vtkIndirectBoxTree(std::vector<Box> boxes)
  : Boxes(std::move(boxes))
  , Centres(Boxes.size())
  , Order(Boxes.size())
{
  std::iota(this->Order.begin(), this->Order.end(), 0u);
  for (size_t i = 0; i < this->Boxes.size(); ++i)
  {
    this->Centres[i] = 0.5 * (this->Boxes[i].Lower + this->Boxes[i].Upper);
    this->All.Add(this->Boxes[i]);
  }
  this->MakeParts();
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectBoxTree::FindMiddle() const
{
  glm::dvec3 middle(0.0);
  std::vector<double> places(this->Centres.size());
  for (int axis = 0; axis < 3 && !places.empty(); ++axis)
  {
    std::transform(this->Centres.begin(), this->Centres.end(), places.begin(),
      [axis](const glm::dvec3& centre) { return centre[axis]; });
    const auto half = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
    std::nth_element(places.begin(), half, places.end());
    middle[axis] = *half;
  }
  return middle;
}

//------------------------------------------------------------------------------
int vtkIndirectBoxTree::FindBin(const Split& split, int axis, uint32_t box) const
{
  const double lower = split.Centres.Lower[axis];
  const double edge = split.Centres.Upper[axis] - lower;
  return std::min(static_cast<int>((this->Centres[box][axis] - lower) / edge * Bins), Bins - 1);
}

//------------------------------------------------------------------------------
vtkIndirectBoxTree::Split vtkIndirectBoxTree::FindSplit(uint32_t begin, uint32_t end) const
{
  Split best;
  for (uint32_t i = begin; i < end; ++i)
  {
    best.Centres.Add(this->Centres[this->Order[i]]);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(best.Centres.Upper[axis] > best.Centres.Lower[axis]))
    {
      continue;
    }
    Box boxes[Bins];
    uint32_t counts[Bins] = {};
    for (uint32_t i = begin; i < end; ++i)
    {
      const int bin = this->FindBin(best, axis, this->Order[i]);
      boxes[bin].Add(this->Boxes[this->Order[i]]);
      ++counts[bin];
    }
    double below[Bins]; // sums over the bins up to this one
    Box box;
    uint32_t count = 0;
    for (int bin = 0; bin < Bins; ++bin)
    {
      box.Add(boxes[bin]);
      count += counts[bin];
      below[bin] = count ? count * box.HalfArea() : 0.0;
    }
    box = Box();
    count = 0;
    for (int bin = Bins - 1; bin > 0; --bin)
    {
      box.Add(boxes[bin]);
      count += counts[bin];
      const double cost = below[bin - 1] + (count ? count * box.HalfArea() : 0.0);
      if (count > 0 && count < end - begin && cost < best.Cost)
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
uint32_t vtkIndirectBoxTree::Divide(const Job& job, const Box& box)
{
  const uint32_t count = job.End - job.Begin;
  if (count <= 1 || job.Depth >= Deepest - 2)
  {
    return job.Begin;
  }
  const Split split = this->FindSplit(job.Begin, job.End);
  // A step down the tree costs about as much as the test of one box's content.
  const bool gains = split.Axis >= 0 && split.Cost + box.HalfArea() < count * box.HalfArea();
  if (!gains && count <= LargestLeaf)
  {
    return job.Begin;
  }
  if (split.Axis < 0 || job.Depth >= DeepestByArea)
  {
    return job.Begin + count / 2;
  }
  const auto first = this->Order.begin();
  return static_cast<uint32_t>(
    std::partition(first + job.Begin, first + job.End,
      [&](uint32_t one) { return this->FindBin(split, split.Axis, one) < split.Bin; }) -
    first);
}

//------------------------------------------------------------------------------
void vtkIndirectBoxTree::MakeParts()
{
  std::vector<Part>& parts = this->Parts;
  parts.resize(1);
  std::vector<Job> jobs = { { 0, 0, static_cast<uint32_t>(this->Order.size()), 0 } };
  while (!jobs.empty())
  {
    const Job job = jobs.back();
    jobs.pop_back();
    Part part;
    for (uint32_t i = job.Begin; i < job.End; ++i)
    {
      part.Bounds.Add(this->Boxes[this->Order[i]]);
    }
    const uint32_t middle = this->Divide(job, part.Bounds);
    const bool leaf = middle == job.Begin;
    part.First = leaf ? job.Begin : static_cast<uint32_t>(parts.size());
    part.Count = leaf ? job.End - job.Begin : 0;
    parts[job.Node] = part;
    if (!leaf)
    {
      jobs.push_back({ part.First, job.Begin, middle, job.Depth + 1 });
      jobs.push_back({ part.First + 1, middle, job.End, job.Depth + 1 });
      parts.resize(parts.size() + 2);
    }
  }
}
