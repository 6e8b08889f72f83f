// SPDX-License-Identifier: BSD-3-Clause
#include "Senders/vtkIndirectSenderClusters.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace
{
// The distance from a cluster's mean to the place in front of it where its middle is sought, in
// standard deviations of its places: about the higher one of two random places. Receivers see the
// front parts of folds, organs and atoms; lights at their mean, in a furrow, would light the furrow
// alone.
constexpr double Forward = 0.5;

// Least length of a mean normal, so that it has a direction.
constexpr double LeastNormal = 0.01;

// The length, in scene units, that a factor e of radiosity counts as. A cluster that reached from a
// bright place into a dim one, such as along a wall behind a baffle, would have its place in the
// bright part; then receivers that see the dim part alone would see no light at all.
constexpr double BrightnessLength = 0.05;

// Range of the logarithm of radiosity over the mean. A walk's vertex whose area is too small by
// chance would be a bright spot as a cluster of its own: brighter places count as the upper end.
constexpr double MostDimness = 4.0;
constexpr double MostBrightness = 0.5;

// The growth of the clusters' number from one question whether they are narrow to the next.
constexpr double GrowthOfNumber = 1.4;

// A lobe counts the turn of normals so much more than diffuse light does.
constexpr double LobeTurn = 3.0;

double Sum(const glm::dvec3& light)
{
  return light.x + light.y + light.z;
}

// Returns a cluster's mean place, as far as it lies beside its middle texel or in front of it,
// where a bowl's mean is. It moves smoothly with a light; a place at texels would jump. A mean
// behind the texel would lie in the body, so that part is dropped.
glm::dvec3 FindPlace(const vtkIndirectSenderClusters::Sender& middle, const glm::dvec3& mean)
{
  const glm::dvec3 place(middle.Position);
  const glm::dvec3 normal(middle.Normal);
  const double height = glm::dot(mean - place, normal);
  const glm::dvec3 step = mean - place - std::min(height, 0.0) * normal;
  const double pitch = std::sqrt(static_cast<double>(middle.Area));
  const double length = glm::length(step);
  return length > pitch ? place + (pitch / length) * step : place + step;
}

// Makes the patch of a node for vtkiFindPatchLight. Folded surfaces have more area than the
// variance of their light suggests. A surface whose light has more than twice the variance of its
// area is scattered, not stretched. A lobe of a patch wider than its surface would be visible. A
// node may move forward, away from its surface; behind the surface its depth map would be drawn
// within the body, and it would light the other side of a sheet.
void MakePatch(vtkIndirectSenderClusters::Light& light)
{
  const double most = Sum(light.LobeDensityArea) > 0.0 ? 1.0 : 2.0;
  light.Area = std::min(most * light.Area, light.Stretched);
  light.Position += std::max(light.Shift, 0.0) * light.Normal;
  light.Shift = 0.0;
}

// Returns each map's light over the mean of the maps with light, rounded to powers of four.
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
void vtkIndirectSenderClusters::SetSenders(std::vector<Sender> senders)
{
  this->Senders = std::move(senders);
  glm::vec3 least(std::numeric_limits<float>::max());
  glm::vec3 largest(std::numeric_limits<float>::lowest());
  for (const Sender& sender : this->Senders)
  {
    least = glm::min(least, sender.Position);
    largest = glm::max(largest, sender.Position);
  }
  const glm::dvec3 edges = largest - least;
  this->Sides =
    this->Senders.empty() ? 0.0 : 2.0 * (edges.x * edges.y + edges.y * edges.z + edges.z * edges.x);
  this->Weights.clear();
  this->Entries.clear();
  this->Clusters.clear();
  this->Wanted = {};
}

//------------------------------------------------------------------------------
void vtkIndirectSenderClusters::SetSeen(const vtkIndirectSeenBox& seen)
{
  if (!(seen == this->Seen))
  {
    this->Seen = seen;
    this->Weights.clear(); // divides again
  }
}

//------------------------------------------------------------------------------
size_t vtkIndirectSenderClusters::GetBytes() const
{
  return this->Senders.size() * sizeof(Sender) + this->Entries.size() * sizeof(Entry) +
    this->Clusters.size() * sizeof(Cluster);
}

//------------------------------------------------------------------------------
uint32_t vtkIndirectSenderClusters::FindMiddle(const Cluster& cluster) const
{
  const glm::dvec3 normal(cluster.Mean[3], cluster.Mean[4], cluster.Mean[5]);
  const double length = glm::length(normal);
  const double forward = length > 0.0 ? Forward * std::sqrt(cluster.Spread) / length : 0.0;
  double wanted[NumberOfAxes];
  for (int axis = 0; axis < NumberOfAxes; ++axis)
  {
    wanted[axis] = cluster.Mean[axis] + (axis < 3 ? forward * normal[axis] : 0.0);
  }
  uint32_t middle = this->Entries[cluster.Begin].Sender;
  double nearest = -1.0;
  for (size_t i = cluster.Begin; i < cluster.End; ++i)
  {
    double distance = 0.0;
    for (int axis = 0; axis < NumberOfAxes; ++axis)
    {
      const double x = this->Entries[i].Coordinates[axis] - wanted[axis];
      distance += x * x;
    }
    if (nearest < 0.0 || distance < nearest)
    {
      nearest = distance / (1.0 + Margin);
      middle = this->Entries[i].Sender;
    }
  }
  return middle;
}

//------------------------------------------------------------------------------
// Divides some of the entries into clusters, in their order. Makes no more than the least number
// once these are near and narrow enough.
std::vector<vtkIndirectSenderClusters::Cluster> vtkIndirectSenderClusters::Divide(
  size_t begin, size_t end, Numbers numbers)
{
  std::vector<Cluster> clusters;
  const size_t most = std::max(numbers.Near, numbers.Narrow);
  if (end - begin <= most)
  {
    for (size_t i = begin; i < end; ++i)
    {
      clusters.push_back(this->Measure(i, i + 1));
      clusters.back().Middle = this->Entries[i].Sender;
    }
    return clusters;
  }
  // The widest cluster comes first, and among nearly equal ones the first in order.
  auto narrower = [&clusters](size_t a, size_t b) {
    return clusters[a].Order != clusters[b].Order ? clusters[a].Order < clusters[b].Order : a > b;
  };
  std::priority_queue<size_t, std::vector<size_t>, decltype(narrower)> queue(narrower);
  clusters.push_back(this->Measure(begin, end));
  queue.push(0);
  double total = 0.0;
  for (size_t i = begin; i < end; ++i)
  {
    const Entry& entry = this->Entries[i];
    const glm::dvec3 place(entry.Coordinates[0], entry.Coordinates[1], entry.Coordinates[2]);
    total += entry.Weight * this->Seen.FindImportance(place);
  }
  // The part that is seen counts as a scene of its own.
  const double nearness =
    this->Nearness * (this->Seen.IsPart() ? 2.0 * glm::length(this->Seen.Half) : 1.0);
  const double enough = nearness * nearness * total;
  double width = clusters.front().Width;
  const std::vector<size_t> asked =
    numbers.Narrow > numbers.Least ? this->FindAsked() : std::vector<size_t>();
  while (!queue.empty() && clusters.size() < most)
  {
    if (clusters.size() >= numbers.Least && (width <= enough || clusters.size() >= numbers.Near))
    {
      if (clusters.size() >= numbers.Narrow || this->AreNarrow(clusters, asked))
      {
        break;
      }
      numbers.Least =
        static_cast<size_t>(std::ceil(GrowthOfNumber * static_cast<double>(clusters.size())));
    }
    const size_t top = queue.top();
    queue.pop();
    const Cluster cluster = clusters[top];
    const auto first = this->Entries.begin();
    const auto middle = std::partition(first + static_cast<std::ptrdiff_t>(cluster.Begin),
      first + static_cast<std::ptrdiff_t>(cluster.End),
      [&](const Entry& entry) { return entry.Coordinates[cluster.Axis] < cluster.Border; });
    const size_t border = static_cast<size_t>(middle - first);
    if (border == cluster.Begin || border == cluster.End)
    {
      continue; // all texels are at one place, except for rounding: the cluster stays whole
    }
    clusters[top] = this->Measure(cluster.Begin, border);
    clusters.push_back(this->Measure(border, cluster.End));
    width += clusters[top].Width + clusters.back().Width - cluster.Width;
    queue.push(top);
    queue.push(clusters.size() - 1);
  }
  for (Cluster& cluster : clusters)
  {
    cluster.Middle = this->FindMiddle(cluster);
  }
  return clusters;
}

//------------------------------------------------------------------------------
void vtkIndirectSenderClusters::DivideAll(
  const std::vector<double>& weights, const Numbers& numbers, bool divides)
{
  this->Weights = weights;
  this->Wanted = numbers;
  this->Divides = divides;
  this->Entries.clear();
  this->Clusters.clear();
  // All light over all area is the mean radiosity.
  double area = 0.0;
  double sum = 0.0;
  auto findSent = [](const Sender& s)
  { return Sum(glm::dvec3(s.Reflected)) + Sum(glm::dvec3(s.LobeReflected)); };
  for (const Sender& s : this->Senders)
  {
    area += static_cast<double>(s.Area);
    sum += findSent(s) * weights[static_cast<size_t>(s.Map)];
  }
  for (size_t i = 0; i < this->Senders.size(); ++i)
  {
    const Sender& s = this->Senders[i];
    const double lobe = Sum(glm::dvec3(s.LobeReflected));
    const double sent = findSent(s);
    const double weight = sent * weights[static_cast<size_t>(s.Map)];
    if (weight > 0.0)
    {
      // A mirrored direction turns twice as much as the normal.
      const auto turn = static_cast<float>(NormalLength * (1.0 + LobeTurn * lobe / sent));
      const double share = weight * area / (sum * static_cast<double>(s.Area));
      const double brightness =
        share > 0.0 ? std::clamp(std::log(share), -MostDimness, MostBrightness) : 0.0;
      this->Entries.push_back(
        { { s.Position.x, s.Position.y, s.Position.z, turn * s.Normal.x, turn * s.Normal.y,
            turn * s.Normal.z, static_cast<float>(BrightnessLength * brightness) },
          static_cast<float>(weight), static_cast<uint32_t>(i) });
    }
  }
  this->Clusters = this->Divide(0, this->Entries.size(), numbers);
}

//------------------------------------------------------------------------------
std::vector<std::vector<size_t>> vtkIndirectSenderClusters::FindGroups(int count)
{
  const size_t number = static_cast<size_t>(std::max(count, 1));
  this->DivideAll({ 1.0 }, { number, number, number }, false);
  std::vector<std::vector<size_t>> groups;
  for (const Cluster& cluster : this->Clusters)
  {
    std::vector<size_t>& group = groups.emplace_back(1, cluster.Middle);
    for (size_t i = cluster.Begin; i < cluster.End; ++i)
    {
      if (this->Entries[i].Sender != cluster.Middle)
      {
        group.push_back(this->Entries[i].Sender);
      }
    }
  }
  return groups;
}

//------------------------------------------------------------------------------
vtkIndirectSenderClusters::Light vtkIndirectSenderClusters::MakeLight(
  const Cluster& cluster, const std::vector<glm::dvec3>& strengths, double overlap) const
{
  Light light;
  light.Begin = cluster.Begin;
  light.End = cluster.End;
  light.Spread = cluster.Spread;
  // The first covers are those of the maps, and one more may be that of all further senders.
  const size_t covers = strengths.size() + 1;
  std::vector<double> areas(covers, 0.0);
  std::vector<double> sums(covers, 0.0);
  glm::dvec3 normal(0.0);
  const glm::dvec3 place(cluster.Mean[0], cluster.Mean[1], cluster.Mean[2]);
  // Sums of sent light, times the following quantities.
  double turned = 0.0;     // normals by places
  double within = 0.0;     // areas of senders
  double withinMaps = 0.0; // areas of senders that are the maps' texels
  double smoothing = 0.0;  // contact softening of senders
  for (size_t i = cluster.Begin; i < cluster.End; ++i)
  {
    const Sender& sender = this->Senders[this->Entries[i].Sender];
    const size_t map = static_cast<size_t>(sender.Map);
    const glm::dvec3 sent = strengths[map] * glm::dvec3(sender.Reflected);
    light.DensityArea += sent;
    const double all = Sum(sent) + Sum(strengths[map] * glm::dvec3(sender.LobeReflected));
    normal += all * glm::dvec3(sender.Normal);
    turned += all * glm::dot(glm::dvec3(sender.Normal), glm::dvec3(sender.Position) - place);
    within += all * static_cast<double>(sender.Area);
    withinMaps += sender.Cover < 0 ? all * static_cast<double>(sender.Area) : 0.0;
    smoothing += all * static_cast<double>(sender.Smoothing);
    const size_t cover = sender.Cover < 0 ? map : static_cast<size_t>(sender.Cover);
    areas[cover] += sender.Area;
    sums[cover] += all;
  }
  // Each map's texels cover the surface once. A map may see only a part of the surface: maps that
  // light most of it count most.
  double total = 0.0;
  double area = 0.0;
  for (size_t cover = 0; cover < covers; ++cover)
  {
    total += sums[cover];
    area += sums[cover] * areas[cover];
  }
  const double ofMaps = std::accumulate(areas.begin(), areas.end() - 1, 0.0);
  const double sentByMaps = std::accumulate(sums.begin(), sums.end() - 1, 0.0);
  area = std::min(area, sentByMaps * ofMaps / overlap + sums.back() * areas.back());
  within -= (1.0 - 1.0 / overlap) * withinMaps;
  const Sender& middle = this->Senders[cluster.Middle];
  light.Position = FindPlace(middle, place);
  // Normals that cancel out are replaced by that of the middle.
  const glm::dvec3 mean = total > 0.0 ? normal / total : glm::dvec3(middle.Normal);
  light.Normal = glm::length(mean) > LeastNormal ? mean : LeastNormal * glm::dvec3(middle.Normal);
  light.Area = static_cast<double>(middle.Area);
  if (total > 0.0)
  {
    light.Area = area / total;
    light.Stretched = 6.0 * cluster.Spread + within / total;
    light.ContactSoftening = std::min(light.Area, light.Stretched) * smoothing / total;
    // The covariance of normals and places adds to the mean of the weights: a patch on a bowl
    // appears as if its mean place lay twice as far before the surface, a patch on a ball as if it
    // lay twice as far behind it.
    const double bend = -0.5 * turned / total;
    this->CloseBowl(cluster, strengths, light);
    const double length = glm::length(light.Normal);
    const glm::dvec3 unit = light.Normal / length;
    light.Shift = (glm::dot(unit, place - light.Position) + bend) / length;
  }
  this->AddLobe(cluster, strengths, light);
  return light;
}

//------------------------------------------------------------------------------
// Corrects the light of a bowl. In a bowl no place sees another from behind: the spread of its
// normals sends no light behind its mean plane, and the bowl sends the light of its opening. So, as
// far as normals turn towards each other, the mean normal is lengthened to one and the light is
// reduced by the same factor. A ball stays as it is, as do surfaces whose places and normals are
// unrelated, and bowls of more than half a sphere, which are seen from within.
void vtkIndirectSenderClusters::CloseBowl(
  const Cluster& cluster, const std::vector<glm::dvec3>& strengths, Light& light) const
{
  const glm::dvec3 place(cluster.Mean[0], cluster.Mean[1], cluster.Mean[2]);
  // Sums of sent light, times the following quantities.
  double turned = 0.0; // turn of normals from their mean, times places along that turn
  double turns = 0.0;  // squares of the turns
  double places = 0.0;
  for (size_t i = cluster.Begin; i < cluster.End; ++i)
  {
    const Sender& sender = this->Senders[this->Entries[i].Sender];
    const glm::dvec3& strength = strengths[static_cast<size_t>(sender.Map)];
    const double all = Sum(strength * glm::dvec3(sender.Reflected)) +
      Sum(strength * glm::dvec3(sender.LobeReflected));
    const glm::dvec3 turn = glm::dvec3(sender.Normal) - light.Normal;
    const double turn2 = glm::dot(turn, turn);
    if (turn2 > 0.0)
    {
      const double along = glm::dot(turn, glm::dvec3(sender.Position) - place);
      turned += all * along;
      turns += all * turn2;
      places += all * along * along / turn2;
    }
  }
  const double both = std::sqrt(turns * places);
  const double square = glm::dot(light.Normal, light.Normal);
  const double open = std::min(std::max(4.0 * std::sqrt(square) - 1.0, 0.0), 1.0);
  const double closed = both > 0.0 ? open * std::min(std::max(-turned / both, 0.0), 1.0) : 0.0;
  const double length = std::sqrt((1.0 - closed) * square + closed);
  const double share = std::sqrt(square) / length;
  light.Normal /= share;
  light.DensityArea *= share;
  light.Share = share;
}

//------------------------------------------------------------------------------
// Adds a lobe of the mean direction, with an exponent from the variance about it: the variance of
// the directions, plus that of each lobe, 1 / exponent along either axis.
void vtkIndirectSenderClusters::AddLobe(
  const Cluster& cluster, const std::vector<glm::dvec3>& strengths, Light& light) const
{
  glm::dvec3 direction(0.0);
  double total = 0.0;
  double width = 0.0;
  double strongest = 0.0;
  glm::dvec3 fallback(0.0, 0.0, 1.0);
  for (size_t i = cluster.Begin; i < cluster.End; ++i)
  {
    const Sender& sender = this->Senders[this->Entries[i].Sender];
    const glm::dvec3 sent =
      strengths[static_cast<size_t>(sender.Map)] * glm::dvec3(sender.LobeReflected);
    const double sum = Sum(sent);
    if (!(sum > 0.0))
    {
      continue;
    }
    light.LobeDensityArea += sent;
    total += sum;
    direction += sum * glm::dvec3(sender.LobeDirection);
    width += sum / (static_cast<double>(sender.LobeExponent) + 1.0);
    if (sum > strongest)
    {
      strongest = sum;
      fallback = glm::dvec3(sender.LobeDirection);
    }
  }
  if (!(total > 0.0))
  {
    return;
  }
  const double length = glm::length(direction) / total;
  light.LobeDirection = length > LeastNormal ? glm::normalize(direction) : fallback;
  // The variance of the directions counts along one axis, as where a mirror is curved along one
  // axis.
  const double variance = width / total + std::max(1.0 - length * length, 0.0);
  light.LobeExponent = std::max(1.0 / variance - 1.0, 0.0);
}

//------------------------------------------------------------------------------
void vtkIndirectSenderClusters::MakeBranches(size_t top, const std::vector<glm::dvec3>& strengths,
  double limit, double overlap, std::vector<Light>& all)
{
  constexpr size_t perNode = vtkIndirectKernels::VTKI_BRANCHES_PER_NODE;
  const size_t first = top * vtkIndirectKernels::VTKI_BRANCHES;
  const Cluster& cluster = this->Clusters[top];
  const std::vector<Cluster> children =
    this->Divide(cluster.Begin, cluster.End, { perNode, perNode, perNode });
  for (size_t i = 0; i < children.size(); ++i)
  {
    Light child = this->MakeLight(children[i], strengths, overlap);
    child.ChildDistance = FindChildDistance(child, limit);
    MakePatch(child);
    const size_t family = first + i * (perNode + 1);
    all[family] = child;
    if (child.ChildDistance > 0.0)
    {
      const std::vector<Cluster> leaves =
        this->Divide(children[i].Begin, children[i].End, { perNode, perNode, perNode });
      double softening = 0.0;
      for (size_t k = 0; k < leaves.size(); ++k)
      {
        Light leaf = this->MakeLight(leaves[k], strengths, overlap);
        MakePatch(leaf);
        softening += Sum(leaf.DensityArea) * leaf.ContactSoftening;
        all[family + 1 + k] = leaf;
      }
      const double sent = Sum(child.DensityArea);
      all[family].ContactSoftening = sent > 0.0 ? softening / sent : child.ContactSoftening;
    }
  }
}

//------------------------------------------------------------------------------
vtkIndirectSenderClusters::LightTree vtkIndirectSenderClusters::MakeLights(
  const std::vector<glm::dvec3>& strengths, int count, double error, double nearness, int least,
  int narrow)
{
  const std::vector<double> weights = FindWeights(strengths);
  const bool divides = error > 0.0;
  Numbers numbers;
  numbers.Near = static_cast<size_t>(std::max(count, 1));
  numbers.Narrow = static_cast<size_t>(divides ? std::max(narrow, 0) : 0);
  numbers.Least = !divides ? numbers.Near
    : least > 0            ? static_cast<size_t>(least)
                           : (numbers.Near + 1) / 2;
  if (weights != this->Weights || divides != this->Divides || nearness != this->Nearness ||
    !(numbers == this->Wanted))
  {
    this->Nearness = nearness;
    this->DivideAll(weights, numbers, divides);
  }
  LightTree lights;
  lights.Lights.reserve(this->Clusters.size());
  bool divided = false;
  double flux = 0.0;
  const std::vector<double> overlaps = this->FindOverlaps(strengths);
  for (const Cluster& cluster : this->Clusters)
  {
    lights.Lights.push_back(this->MakeLight(cluster, strengths, overlaps[lights.Lights.size()]));
    flux += Sum(lights.Lights.back().DensityArea) / 3.0;
    divided = divided || cluster.End - cluster.Begin > 1;
  }
  const double limit = divided ? error * this->FindMeanIrradiance(flux) : 0.0;
  for (size_t i = 0; i < lights.Lights.size(); ++i)
  {
    Light& light = lights.Lights[i];
    const Cluster& cluster = this->Clusters[i];
    light.ChildDistance = FindChildDistance(light, limit);
    if (limit > 0.0)
    {
      MakePatch(light);
    }
    light.Normal = limit > 0.0 ? light.Normal : glm::dvec3(this->Senders[cluster.Middle].Normal);
  }
  if (limit > 0.0)
  {
    Light nothing;
    nothing.ChildDistance = -1.0;
    lights.Branches.assign(lights.Lights.size() * vtkIndirectKernels::VTKI_BRANCHES, nothing);
    vtkSMPTools::For(0, static_cast<vtkIdType>(lights.Lights.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          if (lights.Lights[static_cast<size_t>(i)].ChildDistance > 0.0)
          {
            this->MakeBranches(static_cast<size_t>(i), strengths, limit,
              overlaps[static_cast<size_t>(i)], lights.Branches);
          }
        }
      });
  }
  return lights;
}
