// SPDX-License-Identifier: BSD-3-Clause
#include "vtkProxyCover.h"

#include "vtkProxyCells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace
{
// Distance of the test of a surface's two sides from the surface; the diagonal is 1.
constexpr double Beside = 1e-5;
// Weight of all interior samples together over that of the surface.
constexpr double InteriorShare = 0.25;
constexpr int InteriorSamples = 6000;
// Share of the error allowed at samples, so that the surface between them is within the error.
constexpr double BetweenSamples = 0.93;
// Extra weight of squared distance beyond the error.
constexpr double Uncovered = 10.0;
// Candidates in the same cell, a quarter of this wide, are merged: a 512th of the diagonal.
constexpr double SamePlace = 4.0 / 512.0;
// Number of the skin's samples whose inner balls are candidates.
constexpr size_t Balls = 12000;
// Share of an inner ball that is searched for the surface. In the whole ball all facets of a round
// body would be near enough to be tested.
constexpr double Tight = 0.9;
// Number of balls that all others are compared with.
constexpr size_t Largest = 100;

// Gaussian elimination with pivots; false if the matrix is singular.
bool Solve(double a[4][5], double x[4])
{
  for (int i = 0; i < 4; ++i)
  {
    int pivot = i;
    for (int j = i + 1; j < 4; ++j)
    {
      pivot = std::abs(a[j][i]) > std::abs(a[pivot][i]) ? j : pivot;
    }
    if (!(std::abs(a[pivot][i]) > 1e-14))
    {
      return false;
    }
    std::swap(a[i], a[pivot]);
    for (int j = i + 1; j < 4; ++j)
    {
      const double f = a[j][i] / a[i][i];
      for (int k = i; k < 5; ++k)
      {
        a[j][k] -= f * a[i][k];
      }
    }
  }
  for (int i = 3; i >= 0; --i)
  {
    x[i] = a[i][4];
    for (int k = i + 1; k < 4; ++k)
    {
      x[i] -= a[i][k] * x[k];
    }
    x[i] /= a[i][i];
  }
  return true;
}
}

//------------------------------------------------------------------------------
vtkProxyCover::vtkProxyCover(
  const vtkProxySurface& surface, const vtkProxySolid& solid, int samples)
  : Surface(surface)
  , Solid(solid)
{
  this->Samples = this->MakeSamples(samples);
  // Sheets have no other candidates; solids have voxels as well.
  const size_t stride = this->Samples.size() / Balls + 1;
  for (size_t i = 0; i < this->Samples.size(); ++i)
  {
    if (i % stride == 0 || this->Samples[i].Kind == Sample::Sheet)
    {
      this->Candidates.push_back(this->MakeCandidate(this->Samples[i]));
    }
  }
  this->Candidates = this->FindDepths(this->Candidates);
  for (const vtkProxySolid::Voxel& voxel : solid.GetMedialVoxels())
  {
    this->Candidates.push_back({ voxel.Middle, voxel.Depth, false });
  }
  const std::vector<vtkProxySolid::Voxel>& voxels = solid.GetVoxels();
  const size_t step = voxels.size() / InteriorSamples + 1;
  const double weight = InteriorShare * surface.GetArea() / (voxels.size() / step + 1.0);
  // A step coprime to the lengths of rows would only give other, equally good positions.
  for (size_t i = step / 2; i < voxels.size(); i += step)
  {
    Sample sample;
    sample.Point = voxels[i].Middle;
    sample.Weight = weight;
    sample.Kind = Sample::Interior;
    sample.Depth = voxels[i].Depth;
    this->Samples.push_back(sample);
  }
}

//------------------------------------------------------------------------------
std::vector<vtkProxyCover::Sample> vtkProxyCover::MakeSamples(int count) const
{
  std::vector<Sample> samples;
  for (const vtkProxySurface::Sample& made : this->Surface.MakeSamples(count))
  {
    const bool front = this->Solid.IsSolid(made.Point + Beside * made.Normal);
    const bool back = this->Solid.IsSolid(made.Point - Beside * made.Normal);
    if (front && back)
    {
      continue; // no light reaches it
    }
    Sample sample;
    sample.Point = made.Point;
    sample.Weight = this->Surface.GetArea() / count;
    sample.Kind = front || back ? Sample::Skin : Sample::Sheet;
    sample.Inward = back ? -made.Normal : made.Normal;
    samples.push_back(sample);
  }
  return samples;
}

//------------------------------------------------------------------------------
vtkProxyCover::Candidate vtkProxyCover::MakeCandidate(const Sample& sample) const
{
  if (sample.Kind == Sample::Sheet)
  {
    return { sample.Point, 0.0, true };
  }
  // Finds the largest inner ball that touches the surface here, by shrinking a ball: Ma, Bae, Choi
  // 2012, "3D medial axis point approximation using nearest neighbors and the normal field".
  double radius = 0.5;
  for (int i = 0; i < 30; ++i)
  {
    const glm::dvec3 center = sample.Point + radius * sample.Inward;
    const vtkProxySurface::Nearest nearest = this->Surface.FindNearest(center, Tight * radius);
    if (nearest.Triangle < 0)
    {
      break;
    }
    const glm::dvec3 way = sample.Point - nearest.Point;
    const double length2 = glm::dot(way, way);
    const double cosine = -glm::dot(way, sample.Inward);
    const double smaller = cosine > 0.0 ? length2 / (2.0 * cosine) : 0.0;
    if (!(smaller < radius * (1.0 - 1e-9)) || smaller < Beside)
    {
      radius = std::max(std::min(smaller, radius), Beside);
      break;
    }
    radius = smaller;
  }
  const glm::dvec3 center = sample.Point + radius * sample.Inward;
  // The depth is computed later, for candidates without an equally good alternative.
  return this->Solid.IsSolid(center) ? Candidate{ center, radius, false }
                                     : Candidate{ sample.Point, 0.0, false };
}

//------------------------------------------------------------------------------
std::vector<vtkProxyCover::Candidate> vtkProxyCover::FindDepths(
  const std::vector<Candidate>& candidates) const
{
  std::vector<Candidate> found = Thin(candidates, SamePlace);
  for (Candidate& candidate : found)
  {
    if (!candidate.Sheet && candidate.Depth > 0.0)
    {
      candidate.Depth = this->Surface.FindNearest(candidate.Center).Distance;
    }
  }
  return found;
}

//------------------------------------------------------------------------------
std::vector<vtkProxyCover::Candidate> vtkProxyCover::Thin(
  const std::vector<Candidate>& candidates, double error)
{
  // Depths of neighbours differ at most by their distance, so that positions decide.
  const double size = 0.25 * error;
  struct Key
  {
    glm::tvec3<long long> Cell;
    int Index;
  };
  std::vector<Key> keys;
  keys.reserve(candidates.size());
  for (size_t i = 0; i < candidates.size(); ++i)
  {
    keys.push_back(
      { glm::tvec3<long long>(glm::floor(candidates[i].Center / size)), static_cast<int>(i) });
  }
  auto depth = [&](const Key& key) { return candidates[static_cast<size_t>(key.Index)].Depth; };
  std::sort(keys.begin(), keys.end(),
    [&](const Key& a, const Key& b)
    {
      for (int i = 0; i < 3; ++i)
      {
        if (a.Cell[i] != b.Cell[i])
        {
          return a.Cell[i] < b.Cell[i];
        }
      }
      return depth(a) != depth(b) ? depth(a) > depth(b) : a.Index < b.Index;
    });
  std::vector<Candidate> kept;
  for (size_t i = 0; i < keys.size(); ++i)
  {
    if (i == 0 || keys[i].Cell != keys[i - 1].Cell)
    {
      kept.push_back(candidates[static_cast<size_t>(keys[i].Index)]);
    }
  }
  // Removes balls inside of one of the largest: facets of a round body make many.
  std::stable_sort(kept.begin(), kept.end(),
    [](const Candidate& a, const Candidate& b) { return a.Depth > b.Depth; });
  std::vector<Candidate> left;
  for (const Candidate& candidate : kept)
  {
    bool inside = false;
    for (size_t i = 0; i < left.size() && i < Largest && !inside && !candidate.Sheet; ++i)
    {
      inside =
        glm::length(candidate.Center - left[i].Center) + candidate.Depth < left[i].Depth + size;
    }
    if (!inside)
    {
      left.push_back(candidate);
    }
  }
  return left;
}

//------------------------------------------------------------------------------
vtkProxySphere vtkProxyCover::MakeSphere(const Candidate& candidate, double error)
{
  return { candidate.Center, candidate.Depth + error, candidate.Sheet };
}

//------------------------------------------------------------------------------
bool vtkProxyCover::Covers(const vtkProxySphere& sphere, const Sample& sample, double error)
{
  // Sheets transmit no light: their spheres must contain all samples. Skin may be an error away.
  double reach = sphere.Radius;
  if (sample.Kind == Sample::Sheet)
  {
    reach *= BetweenSamples;
  }
  else if (sample.Kind == Sample::Skin && !sphere.Sheet)
  {
    reach += error;
  }
  const glm::dvec3 way = sample.Point - sphere.Center;
  return glm::dot(way, way) <= reach * reach;
}

//------------------------------------------------------------------------------
bool vtkProxyCover::Choose(const std::vector<Sample>& samples, const std::vector<Candidate>& all,
  double error, int most, std::vector<vtkProxySphere>& spheres) const
{
  const std::vector<Candidate> candidates = Thin(all, error);
  const vtkProxyCells cells(samples);
  std::vector<char> covered(samples.size(), 0);
  size_t left = samples.size();
  auto cover = [&](const vtkProxySphere& sphere)
  {
    cells.ForBall(sphere.Center, sphere.Radius + error,
      [&](int i)
      {
        const auto at = static_cast<size_t>(i);
        if (!covered[at] && Covers(sphere, samples[at], error))
        {
          covered[at] = 1;
          --left;
        }
      });
  };
  for (size_t i = 0; i < samples.size(); ++i)
  {
    // A sample this near to the skin is inside of any sphere that covers the skin there.
    if (samples[i].Kind == Sample::Interior && samples[i].Depth < 2.0 * error)
    {
      covered[i] = 1;
      --left;
    }
  }
  for (const vtkProxySphere& sphere : spheres)
  {
    cover(sphere);
  }
  auto gainOf = [&](int candidate)
  {
    const vtkProxySphere sphere = MakeSphere(candidates[static_cast<size_t>(candidate)], error);
    double gain = 0.0;
    cells.ForBall(sphere.Center, sphere.Radius + error,
      [&](int i)
      {
        const auto at = static_cast<size_t>(i);
        if (!covered[at] && Covers(sphere, samples[at], error))
        {
          gain += samples[at].Weight;
        }
      });
    return gain;
  };
  // Gains only decrease, so a recomputed gain that is still the largest is the maximum. Equal gains
  // are ordered by the candidates.
  using Entry = std::pair<double, int>;
  std::vector<Entry> gains;
  for (int i = 0; left > 0 && i < static_cast<int>(candidates.size()); ++i)
  {
    gains.emplace_back(gainOf(i), -i);
  }
  std::priority_queue<Entry> queue(std::less<Entry>(), std::move(gains));
  while (left > 0 && !queue.empty())
  {
    Entry top = queue.top();
    queue.pop();
    const double gain = gainOf(-top.second);
    if (!(gain > 0.0))
    {
      continue;
    }
    if (!queue.empty() && Entry(gain, top.second) < queue.top())
    {
      queue.emplace(gain, top.second);
      continue;
    }
    if (static_cast<int>(spheres.size()) >= most)
    {
      return false;
    }
    spheres.push_back(MakeSphere(candidates[static_cast<size_t>(-top.second)], error));
    cover(spheres.back());
  }
  return true;
}

//------------------------------------------------------------------------------
std::vector<vtkProxySphere> vtkProxyCover::CoverWithin(double error, int most) const
{
  std::vector<vtkProxySphere> spheres;
  if (!this->Choose(this->Samples, this->Candidates, error, most, spheres))
  {
    spheres.clear();
  }
  return spheres;
}

//------------------------------------------------------------------------------
double vtkProxyCover::CoverWith(int count, std::vector<vtkProxySphere>& spheres) const
{
  // With half the diagonal one sphere covers the surface.
  double low = 1e-4;
  double high = 0.5;
  spheres = this->CoverWithin(high, count);
  while (high > 1.01 * low)
  {
    const double middle = std::sqrt(low * high);
    std::vector<vtkProxySphere> tried = this->CoverWithin(middle, count);
    if (tried.empty())
    {
      low = middle;
    }
    else
    {
      high = middle;
      spheres = std::move(tried);
      if (static_cast<int>(spheres.size()) > count - 1 - count / 50)
      {
        break;
      }
    }
  }
  return high;
}

//------------------------------------------------------------------------------
void vtkProxyCover::Refine(std::vector<vtkProxySphere>& spheres, double error, int steps) const
{
  std::vector<int> owner(this->Samples.size());
  std::vector<double> off(this->Samples.size());
  // The energy of the spheres and the sphere of each sample.
  auto measure = [&](const std::vector<vtkProxySphere>& of)
  {
    struct Place
    {
      glm::dvec3 Point;
    };
    double energy = 0.0;
    double largest = 0.0;
    std::vector<Place> centers;
    for (const vtkProxySphere& sphere : of)
    {
      centers.push_back({ sphere.Center });
      largest = std::max(largest, sphere.Radius);
    }
    const vtkProxyCells cells(centers);
    for (size_t i = 0; i < this->Samples.size(); ++i)
    {
      const Sample& sample = this->Samples[i];
      owner[i] = -1;
      if (sample.Kind != Sample::Skin)
      {
        continue;
      }
      double least = std::numeric_limits<double>::max();
      cells.ForBall(sample.Point, largest + 2.0 * error,
        [&](int j)
        {
          const vtkProxySphere& sphere = of[static_cast<size_t>(j)];
          const double d = glm::length(sample.Point - sphere.Center) - sphere.Radius;
          if (d < least || (d == least && j < owner[i]))
          {
            least = d;
            owner[i] = j;
          }
        });
      if (owner[i] >= 0)
      {
        off[i] = least;
        // Uncovered distance counts more: it would require a further sphere.
        const double uncovered = std::max(least - error, 0.0);
        energy += sample.Weight * (least * least + Uncovered * uncovered * uncovered);
      }
    }
    return energy;
  };
  double energy = measure(spheres);
  for (int step = 0; step < steps; ++step)
  {
    // Gauss-Newton, one sphere at a time: distances from (center, radius) are nearly linear.
    struct Normal
    {
      double A[4][5] = {};
      double Count = 0.0;
    };
    std::vector<Normal> normals(spheres.size());
    for (size_t i = 0; i < this->Samples.size(); ++i)
    {
      if (owner[i] < 0)
      {
        continue;
      }
      const vtkProxySphere& sphere = spheres[static_cast<size_t>(owner[i])];
      const glm::dvec3 way = this->Samples[i].Point - sphere.Center;
      const double length = glm::length(way);
      if (!(length > 1e-9) || sphere.Sheet)
      {
        continue;
      }
      const double gradient[4] = { -way.x / length, -way.y / length, -way.z / length, -1.0 };
      Normal& n = normals[static_cast<size_t>(owner[i])];
      const double weight = off[i] > error ? 1.0 + Uncovered : 1.0;
      n.Count += weight;
      for (int r = 0; r < 4; ++r)
      {
        for (int c = 0; c < 4; ++c)
        {
          n.A[r][c] += weight * gradient[r] * gradient[c];
        }
        n.A[r][4] -= gradient[r] * (off[i] + (weight > 1.0 ? Uncovered * (off[i] - error) : 0.0));
      }
    }
    std::vector<glm::dvec4> moves(spheres.size(), glm::dvec4(0.0));
    for (size_t i = 0; i < spheres.size(); ++i)
    {
      Normal& n = normals[i];
      for (int r = 0; r < 4; ++r)
      {
        n.A[r][r] += 0.05 * n.Count;
      }
      double x[4];
      if (n.Count > 0.0 && Solve(n.A, x))
      {
        moves[i] = glm::dvec4(x[0], x[1], x[2], x[3]);
      }
    }
    const std::vector<vtkProxySphere> before = spheres;
    const double energyBefore = energy;
    bool better = false;
    for (double share = 1.0; share > 0.1 && !better; share *= 0.5)
    {
      for (size_t i = 0; i < spheres.size(); ++i)
      {
        if (before[i].Sheet)
        {
          continue;
        }
        vtkProxySphere& sphere = spheres[i];
        const glm::dvec3 move = share * glm::dvec3(moves[i]);
        sphere.Center = before[i].Center + move;
        const double depth = this->Solid.GetDepth(sphere.Center);
        sphere.Radius = std::min(before[i].Radius + share * moves[i].w, depth + error);
        // Rejects a step that makes a sphere much smaller or puts it outside.
        if (!(sphere.Radius > 0.5 * before[i].Radius) || !(depth > -error))
        {
          sphere = before[i];
        }
      }
      energy = measure(spheres);
      better = energy < energyBefore;
    }
    if (!better)
    {
      spheres = before;
      measure(spheres);
      break;
    }
  }
}

//------------------------------------------------------------------------------
void vtkProxyCover::Repair(std::vector<vtkProxySphere>& spheres, double error, int samples) const
{
  // Between samples the surface may be a little farther away.
  error *= BetweenSamples;
  const std::vector<Sample> all = this->MakeSamples(samples);
  const vtkProxyCells cells(all);
  std::vector<char> covered(all.size(), 0);
  for (const vtkProxySphere& sphere : spheres)
  {
    cells.ForBall(sphere.Center, sphere.Radius + error,
      [&](int i)
      {
        const auto at = static_cast<size_t>(i);
        covered[at] = covered[at] || Covers(sphere, all[at], error);
      });
  }
  std::vector<Sample> left;
  std::vector<Candidate> candidates;
  for (size_t i = 0; i < all.size(); ++i)
  {
    if (!covered[i])
    {
      left.push_back(all[i]);
      candidates.push_back(this->MakeCandidate(all[i]));
    }
  }
  if (!left.empty())
  {
    this->Choose(
      left, this->FindDepths(candidates), error, std::numeric_limits<int>::max(), spheres);
  }
}
