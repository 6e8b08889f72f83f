// SPDX-License-Identifier: BSD-3-Clause
#include "Proxies/vtkIndirectProxyTree.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "Proxies/vtkIndirectProxySilhouette.h"

#include <algorithm>
#include <cmath>

namespace
{
// Up to this many spheres each have light of their own. If there are more, about SpheresTogether
// share a sender, or more where there would otherwise be too many senders: as groups have four
// parts, a sender covers two to eight spheres.
constexpr size_t FewSpheres = 2048;
constexpr size_t SpheresTogether = 8;
constexpr size_t MostSenders = 4096;
// A reach that covers everything, in scene units, whose square and cube are finite floats.
constexpr double Everywhere = 1e8;
// Sums of r^2, r^2 center, r^2 (center^2 + 3/5 r^2), r^2 albedo.
constexpr int NumberOfMoments = 8;
}

//------------------------------------------------------------------------------
void vtkIndirectProxyTree::Build(
  const std::vector<vtkIndirectProxySphere>& spheres, double angle, double reach)
{
  this->Entries.clear();
  this->Blocks.clear();
  this->Senders.clear();
  this->Means.clear();
  this->Nodes.clear();
  if (spheres.empty())
  {
    return;
  }
  if (angle <= 0.0)
  {
    for (const vtkIndirectProxySphere& sphere : spheres)
    {
      const glm::vec3 center(sphere.Center);
      const double outer = reach > 0.0 ? std::min(reach * sphere.Radius, Everywhere) : Everywhere;
      this->Entries.push_back({ center, static_cast<float>(sphere.Radius), center,
        static_cast<float>(outer), sphere.Albedo, 1.0f, sphere.Exact ? -1.0f : 0.0f,
        static_cast<int>(this->Senders.size()), 0, static_cast<float>(sphere.Radius) });
      this->Senders.push_back({ center, static_cast<float>(sphere.Radius) });
    }
    for (size_t i = 0; i < this->Entries.size(); ++i)
    {
      this->Entries[i].Next = i + 1 < this->Entries.size() ? static_cast<int>(i) + 1 : -1;
    }
    this->MakeBlocks();
    return;
  }
  this->Order.resize(spheres.size());
  for (size_t i = 0; i < spheres.size(); ++i)
  {
    this->Order[i] = i;
  }
  this->Nodes.reserve(spheres.size() * 3 / 2 + 4);
  double moments[NumberOfMoments];
  const size_t root = this->MakeNode(spheres, 0, spheres.size(), angle, moments);
  this->Entries.reserve(this->Nodes.size());
  this->SpheresOfSender =
    spheres.size() <= FewSpheres ? 1 : std::max(SpheresTogether, spheres.size() / MostSenders);
  this->AddSenders(root, -1);
  for (Node& node : this->Nodes)
  {
    // Means come after all senders.
    node.Sender =
      node.Sender < 0 ? static_cast<int>(this->Senders.size()) - 1 - node.Sender : node.Sender;
  }
  this->AddEntries(root, nullptr);
  for (Entry& entry : this->Entries)
  {
    entry.Next = entry.Next < static_cast<int>(this->Entries.size()) ? entry.Next : -1;
  }
  this->MakeBlocks();
}

//------------------------------------------------------------------------------
// Splits the spheres into halves along the longest axis of their centres' box.
void vtkIndirectProxyTree::Split(
  const std::vector<vtkIndirectProxySphere>& spheres, size_t first, size_t end)
{
  glm::dvec3 lower(1e300);
  glm::dvec3 upper(-1e300);
  for (size_t i = first; i < end; ++i)
  {
    lower = glm::min(lower, spheres[this->Order[i]].Center);
    upper = glm::max(upper, spheres[this->Order[i]].Center);
  }
  const glm::dvec3 size = upper - lower;
  const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
  const auto begin = this->Order.begin();
  std::nth_element(begin + static_cast<std::ptrdiff_t>(first),
    begin + static_cast<std::ptrdiff_t>(first + (end - first) / 2),
    begin + static_cast<std::ptrdiff_t>(end),
    [&spheres, axis](size_t a, size_t b)
    {
      const double x = spheres[a].Center[axis];
      const double y = spheres[b].Center[axis];
      return x < y || (x == y && a < b);
    });
}

//------------------------------------------------------------------------------
// Returns the sphere that contains all others of a group; `end` if there is none.
size_t vtkIndirectProxyTree::FindHolding(
  const std::vector<vtkIndirectProxySphere>& spheres, size_t first, size_t end) const
{
  size_t largest = first;
  for (size_t i = first; i < end; ++i)
  {
    largest = spheres[this->Order[i]].Radius > spheres[this->Order[largest]].Radius ? i : largest;
  }
  const vtkIndirectProxySphere& whole = spheres[this->Order[largest]];
  for (size_t i = first; i < end; ++i)
  {
    const vtkIndirectProxySphere& other = spheres[this->Order[i]];
    if (glm::length(other.Center - whole.Center) + other.Radius > (1.0 + 1e-3) * whole.Radius)
    {
      return end;
    }
  }
  return largest;
}

//------------------------------------------------------------------------------
size_t vtkIndirectProxyTree::MakeNode(const std::vector<vtkIndirectProxySphere>& spheres,
  size_t first, size_t end, double angle, double* moments)
{
  const size_t number = this->Nodes.size();
  this->Nodes.emplace_back();
  Node node;
  node.NumberOfChildren = 0;
  node.NumberOfSpheres = end - first;
  node.Exact = false;
  if (end - first == 1)
  {
    const vtkIndirectProxySphere& sphere = spheres[this->Order[first]];
    const double r2 = sphere.Radius * sphere.Radius;
    moments[0] = r2;
    for (int i = 0; i < 3; ++i)
    {
      moments[1 + i] = r2 * sphere.Center[i];
      moments[5 + i] = r2 * sphere.Albedo[i];
    }
    moments[4] = r2 * (glm::dot(sphere.Center, sphere.Center) + 0.6 * r2);
    node.Center = sphere.Center;
    node.Radius = sphere.Radius;
    node.Bound = sphere.Radius;
    node.Albedo = sphere.Albedo;
    node.Share = 1.0;
    node.Inner = 0.0;
    node.Exact = sphere.Exact;
    this->Nodes[number] = node;
    return number;
  }
  const size_t holds = this->FindHolding(spheres, first, end);
  if (holds < end)
  {
    // The others are inside of it and invisible.
    std::swap(this->Order[first], this->Order[holds]);
    this->Nodes.pop_back();
    return this->MakeNode(spheres, first, first + 1, angle, moments);
  }
  size_t bounds[5] = { first, first, first, first, end };
  const size_t middle = first + (end - first) / 2;
  this->Split(spheres, first, end);
  bounds[2] = middle;
  bounds[1] = first + (middle - first) / 2;
  bounds[3] = middle + (end - middle) / 2;
  if (middle - first > 1)
  {
    this->Split(spheres, first, middle);
  }
  if (end - middle > 1)
  {
    this->Split(spheres, middle, end);
  }
  std::fill(moments, moments + NumberOfMoments, 0.0);
  for (int i = 0; i < 4; ++i)
  {
    if (bounds[i] == bounds[i + 1])
    {
      continue;
    }
    double own[NumberOfMoments];
    node.Children[node.NumberOfChildren++] =
      this->MakeNode(spheres, bounds[i], bounds[i + 1], angle, own);
    for (int k = 0; k < NumberOfMoments; ++k)
    {
      moments[k] += own[k];
    }
  }
  const double s = moments[0]; // may underflow for radii of 1e-200
  node.Center = s > 0.0 ? glm::dvec3(moments[1], moments[2], moments[3]) / s
                        : this->Nodes[node.Children[0]].Center;
  node.Albedo = s > 0.0 ? glm::dvec3(moments[5], moments[6], moments[7]) / s : glm::dvec3(0.0);
  double largest = 0.0;
  for (int i = 0; i < node.NumberOfChildren; ++i)
  {
    const Node& child = this->Nodes[node.Children[i]];
    largest = std::max(largest, glm::length(child.Center - node.Center) + child.Radius);
  }
  const double spread = s > 0.0 ? (moments[4] / s - glm::dot(node.Center, node.Center)) / 0.6 : 0.0;
  // The cancellation error is small against the squared distance from the origin, which is of order
  // one.
  node.Radius = std::min(std::sqrt(std::max(spread, 1e-4 * largest * largest)), largest);
  // At least as large as the disk that it hides.
  vtkIndirectProxySilhouette::Ball balls[4];
  for (int i = 0; i < node.NumberOfChildren; ++i)
  {
    const Node& child = this->Nodes[node.Children[i]];
    balls[i] = { child.Center, child.Radius, child.Share };
  }
  const double area = vtkIndirectProxySilhouette::FindArea(balls, node.NumberOfChildren);
  node.Radius = std::max(node.Radius, std::sqrt(area));
  node.Bound = node.Radius;
  node.Share = area > 0.0 ? std::min(area / (node.Radius * node.Radius), 1.0) : 0.0;
  // At its inner limit the children count in full.
  node.Inner = node.Radius / angle;
  for (int i = 0; i < node.NumberOfChildren; ++i)
  {
    const Node& child = this->Nodes[node.Children[i]];
    const double distance = glm::length(child.Center - node.Center);
    node.Inner =
      std::max(node.Inner, (child.Inner + distance) / vtkIndirectKernels::VTKI_PROXY_BAND);
    node.Bound = std::max(node.Bound, distance + child.Bound);
  }
  // Rounded as in texels: the children begin where it ends.
  node.Inner =
    vtkIndirectKernels::vtkiPairedAbove(static_cast<float>(std::min(node.Inner, Everywhere)));
  this->Nodes[number] = node;
  return number;
}

//------------------------------------------------------------------------------
// own: the sender of the group; negative: none. Means are numbered from -1 down.
void vtkIndirectProxyTree::AddSenders(size_t number, int own)
{
  Node& node = this->Nodes[number];
  if (own < 0 && node.NumberOfSpheres <= this->SpheresOfSender)
  {
    own = static_cast<int>(this->Senders.size());
    // Placed on one of its spheres, because the group's centre may be empty.
    size_t inside = number;
    while (this->Nodes[inside].NumberOfChildren > 0)
    {
      inside = this->Nodes[inside].Children[this->Nodes[inside].NumberOfChildren / 2];
    }
    const Node& sphere = this->Nodes[inside];
    this->Senders.push_back({ glm::vec3(sphere.Center), static_cast<float>(sphere.Radius) });
  }
  node.Sender = own;
  const int first = static_cast<int>(this->Senders.size());
  const size_t mean = this->Means.size();
  if (own < 0)
  {
    node.Sender = -1 - static_cast<int>(mean);
    this->Means.push_back({ first, 0 });
  }
  for (int i = 0; i < node.NumberOfChildren; ++i)
  {
    this->AddSenders(node.Children[i], own);
  }
  if (own < 0)
  {
    this->Means[mean].Count = static_cast<int>(this->Senders.size()) - first;
  }
}

//------------------------------------------------------------------------------
void vtkIndirectProxyTree::AddEntries(size_t number, const Node* parent)
{
  const Node& node = this->Nodes[number];
  const glm::vec3 center(node.Center);
  const size_t entry = this->Entries.size();
  this->Entries.push_back(
    { center, static_cast<float>(node.Radius), parent ? glm::vec3(parent->Center) : center,
      static_cast<float>(parent ? std::min(parent->Inner, Everywhere) : Everywhere),
      glm::vec3(node.Albedo), static_cast<float>(node.Share),
      node.Exact ? -1.0f : static_cast<float>(std::min(node.Inner, Everywhere)), node.Sender, -1,
      vtkIndirectKernels::vtkiPairedAbove(static_cast<float>(std::min(node.Bound, Everywhere))) });
  for (int i = 0; i < node.NumberOfChildren; ++i)
  {
    this->AddEntries(node.Children[i], &node);
  }
  this->Entries[entry].Next = static_cast<int>(this->Entries.size());
}

//------------------------------------------------------------------------------
void vtkIndirectProxyTree::MakeBlocks()
{
  const size_t length = static_cast<size_t>(vtkIndirectKernels::VTKI_ROW_LENGTH);
  for (size_t first = 0; first < this->Entries.size(); first += length)
  {
    Block block = { glm::vec3(1e30f), glm::vec3(-1e30f) };
    for (size_t i = first; i < std::min(first + length, this->Entries.size()); ++i)
    {
      const Entry& entry = this->Entries[i];
      block.Lower = glm::min(block.Lower, entry.OuterCenter - entry.Outer);
      block.Upper = glm::max(block.Upper, entry.OuterCenter + entry.Outer);
    }
    this->Blocks.push_back(block);
  }
}
