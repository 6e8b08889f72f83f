// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualLights/vtkIndirectSenderClusters.h"

#include "VirtualLights/vtkIndirectDirections.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace
{
// What a unit of normal counts in scene units: surfaces that face each other lie apart like the
// ends of half a scene.
constexpr double NormalLength = 0.25;

double Sum(const glm::dvec3& light)
{
  return light.x + light.y + light.z;
}

// How much light each map has, over the mean of those that have any, in powers of four.
std::vector<double> FindWeights(const std::vector<glm::dvec3>& strengths)
{
  double total = 0.0;
  double lit = 0.0;
  for (const glm::dvec3& strength : strengths)
  {
    total += Sum(strength);
    lit += Sum(strength) > 0.0 ? 1.0 : 0.0;
  }
  std::vector<double> weights;
  for (const glm::dvec3& strength : strengths)
  {
    const double share = total > 0.0 ? Sum(strength) * lit / total : 0.0;
    weights.push_back(share > 0.0 ? std::exp2(2.0 * std::round(0.5 * std::log2(share))) : 0.0);
  }
  return weights;
}
}

//------------------------------------------------------------------------------
void vtkIndirectSenderClusters::RemoveOutermost(
  std::vector<Sender>& senders, const std::vector<glm::vec3>& places)
{
  // The hull's corners as far as they are the farthest places in one of these directions; of what
  // is round between them little is lost, nothing of boxes.
  constexpr int directions = 128;
  std::vector<glm::vec3> corners;
  for (const glm::dvec3& exact : vtkIndirectDirections::MakeLattice(directions))
  {
    const glm::vec3 direction(exact);
    float farthest = 0.0f;
    const glm::vec3* corner = nullptr;
    for (const glm::vec3& place : places)
    {
      const float distance = glm::dot(place, direction);
      if (!corner || distance > farthest)
      {
        farthest = distance;
        corner = &place;
      }
    }
    if (corner)
    {
      corners.push_back(*corner);
    }
  }
  // Steps of packed normals, along a scene of length one.
  constexpr float rounding = 2.6e-4f;
  const auto outermost = std::remove_if(senders.begin(), senders.end(),
    [&](const Sender& sender)
    {
      const float height = glm::dot(sender.Normal, sender.Position) + rounding;
      return std::none_of(corners.begin(), corners.end(),
        [&](const glm::vec3& corner) { return glm::dot(sender.Normal, corner) > height; });
    });
  senders.erase(outermost, senders.end());
}

//------------------------------------------------------------------------------
void vtkIndirectSenderClusters::SetSenders(std::vector<Sender> senders)
{
  this->Senders = std::move(senders);
  this->Weights.clear();
  this->Order.clear();
  this->Clusters.clear();
  this->Count = 0;
}

//------------------------------------------------------------------------------
size_t vtkIndirectSenderClusters::GetBytes() const
{
  return this->Senders.size() * sizeof(Sender) + this->Order.size() * sizeof(size_t) +
    this->Clusters.size() * sizeof(Cluster);
}

//------------------------------------------------------------------------------
double vtkIndirectSenderClusters::GetCoordinate(size_t sender, int axis) const
{
  const Sender& s = this->Senders[sender];
  return axis < 3 ? double(s.Position[axis]) : NormalLength * double(s.Normal[axis - 3]);
}

//------------------------------------------------------------------------------
double vtkIndirectSenderClusters::GetWeight(size_t sender) const
{
  const Sender& s = this->Senders[sender];
  return Sum(glm::dvec3(s.Reflected)) * this->Weights[static_cast<size_t>(s.Map)];
}

//------------------------------------------------------------------------------
vtkIndirectSenderClusters::Cluster vtkIndirectSenderClusters::Measure(
  size_t begin, size_t end) const
{
  Cluster cluster;
  cluster.Begin = begin;
  cluster.End = end;
  double total = 0.0;
  double first[NumberOfAxes] = {};
  double second[NumberOfAxes] = {};
  for (size_t i = begin; i < end; ++i)
  {
    const double weight = this->GetWeight(this->Order[i]);
    total += weight;
    for (int axis = 0; axis < NumberOfAxes; ++axis)
    {
      const double x = this->GetCoordinate(this->Order[i], axis);
      first[axis] += weight * x;
      second[axis] += weight * x * x;
    }
  }
  double widest = 0.0;
  for (int axis = 0; axis < NumberOfAxes; ++axis)
  {
    cluster.Mean[axis] = first[axis] / total;
    const double width = second[axis] - first[axis] * cluster.Mean[axis];
    cluster.Width += std::max(width, 0.0);
    if (width > widest)
    {
      widest = width;
      cluster.Axis = axis;
    }
  }
  return cluster;
}

//------------------------------------------------------------------------------
size_t vtkIndirectSenderClusters::FindMiddle(const Cluster& cluster) const
{
  size_t middle = this->Order[cluster.Begin];
  double nearest = -1.0;
  for (size_t i = cluster.Begin; i < cluster.End; ++i)
  {
    double distance = 0.0;
    for (int axis = 0; axis < NumberOfAxes; ++axis)
    {
      const double x = this->GetCoordinate(this->Order[i], axis) - cluster.Mean[axis];
      distance += x * x;
    }
    if (nearest < 0.0 || distance < nearest)
    {
      nearest = distance;
      middle = this->Order[i];
    }
  }
  return middle;
}

//------------------------------------------------------------------------------
void vtkIndirectSenderClusters::Divide(const std::vector<double>& weights, int count)
{
  this->Weights = weights;
  this->Count = count;
  this->Order.clear();
  this->Clusters.clear();
  for (size_t i = 0; i < this->Senders.size(); ++i)
  {
    if (this->GetWeight(i) > 0.0)
    {
      this->Order.push_back(i);
    }
  }
  if (this->Order.empty())
  {
    return;
  }
  const size_t most = static_cast<size_t>(std::max(count, 1));
  if (this->Order.size() <= most)
  {
    for (size_t i = 0; i < this->Order.size(); ++i)
    {
      this->Clusters.push_back(this->Measure(i, i + 1));
    }
    return;
  }
  // The widest first; of equals the first in order.
  auto narrower = [this](size_t a, size_t b)
  {
    const double x = this->Clusters[a].Width;
    const double y = this->Clusters[b].Width;
    return x != y ? x < y : a > b;
  };
  std::priority_queue<size_t, std::vector<size_t>, decltype(narrower)> queue(narrower);
  this->Clusters.push_back(this->Measure(0, this->Order.size()));
  queue.push(0);
  while (!queue.empty() && this->Clusters.size() < most)
  {
    const size_t top = queue.top();
    queue.pop();
    const Cluster cluster = this->Clusters[top];
    const auto begin = this->Order.begin();
    const auto middle = std::partition(begin + static_cast<std::ptrdiff_t>(cluster.Begin),
      begin + static_cast<std::ptrdiff_t>(cluster.End),
      [&](size_t sender)
      { return this->GetCoordinate(sender, cluster.Axis) < cluster.Mean[cluster.Axis]; });
    const size_t border = static_cast<size_t>(middle - begin);
    if (border == cluster.Begin || border == cluster.End)
    {
      continue; // all at one place, but for rounding: it stays as it is
    }
    this->Clusters[top] = this->Measure(cluster.Begin, border);
    this->Clusters.push_back(this->Measure(border, cluster.End));
    queue.push(top);
    queue.push(this->Clusters.size() - 1);
  }
}

//------------------------------------------------------------------------------
std::vector<vtkIndirectSenderClusters::Light> vtkIndirectSenderClusters::MakeLights(
  const std::vector<glm::dvec3>& strengths, int count)
{
  const std::vector<double> weights = FindWeights(strengths);
  if (weights != this->Weights || count != this->Count)
  {
    this->Divide(weights, count);
    for (Cluster& cluster : this->Clusters)
    {
      cluster.Middle = this->FindMiddle(cluster);
    }
  }
  std::vector<Light> lights;
  lights.reserve(this->Clusters.size());
  std::vector<double> areas(strengths.size(), 0.0);
  std::vector<double> sums(strengths.size(), 0.0);
  std::vector<size_t> maps;
  for (const Cluster& cluster : this->Clusters)
  {
    Light light;
    maps.clear();
    for (size_t i = cluster.Begin; i < cluster.End; ++i)
    {
      const Sender& sender = this->Senders[this->Order[i]];
      const size_t map = static_cast<size_t>(sender.Map);
      const glm::dvec3 sent = strengths[map] * glm::dvec3(sender.Reflected);
      light.DensityArea += sent;
      if (areas[map] == 0.0)
      {
        maps.push_back(map);
      }
      areas[map] += sender.Area;
      sums[map] += Sum(sent);
    }
    // A map may see a part of the surface: those that light most of it count most.
    double total = 0.0;
    double area = 0.0;
    for (const size_t map : maps)
    {
      total += sums[map];
      area += sums[map] * areas[map];
      areas[map] = sums[map] = 0.0;
    }
    const Sender& middle = this->Senders[cluster.Middle];
    light.Position = glm::dvec3(middle.Position);
    light.Normal = glm::dvec3(middle.Normal);
    light.Area = total > 0.0 ? area / total : middle.Area;
    lights.push_back(light);
  }
  return lights;
}
