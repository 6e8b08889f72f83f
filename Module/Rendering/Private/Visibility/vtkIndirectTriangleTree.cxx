// SPDX-License-Identifier: BSD-3-Clause
#include "Visibility/vtkIndirectTriangleTree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace
{
constexpr int Bins = 16;
// Where splits by area have led so deep, halves by count end it: 31 levels of them hold 2^31.
constexpr int DeepestByArea = 32;
constexpr int DeepestOfAll = 64;
// More triangles than these are split although the heuristic finds no gain.
constexpr uint32_t LargestLeaf = 8;
// Of the greatest coordinate of a box, and of that of a segment's begin, about the tree's origin:
// its rounding to floats, that of the direction, of its inverse and of the two steps of the boxes'
// test move a face by less than 2^-21 of both. So what is small has small boxes near the origin,
// however far something else reaches.
constexpr double Padding = 1.0 / (1 << 20);

struct Box
{
  glm::dvec3 Lower{ std::numeric_limits<double>::infinity() };
  glm::dvec3 Upper{ -std::numeric_limits<double>::infinity() };

  void Add(const glm::dvec3& point)
  {
    this->Lower = glm::min(this->Lower, point);
    this->Upper = glm::max(this->Upper, point);
  }
  void Add(const Box& other)
  {
    this->Lower = glm::min(this->Lower, other.Lower);
    this->Upper = glm::max(this->Upper, other.Upper);
  }
  double HalfArea() const
  {
    const glm::dvec3 e = glm::max(this->Upper - this->Lower, glm::dvec3(0.0));
    return e.x * e.y + e.y * e.z + e.z * e.x;
  }
};

// The point of a triangle that is nearest to p, by the regions of its corners, edges and inside.
glm::dvec3 FindNearestPoint(const glm::dvec3 v[3], const glm::dvec3& p)
{
  const glm::dvec3 normal = glm::cross(v[1] - v[0], v[2] - v[0]);
  glm::dvec3 nearest = v[0];
  double least = std::numeric_limits<double>::infinity();
  bool inside = true;
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 edge = v[(i + 1) % 3] - v[i];
    const glm::dvec3 offset = p - v[i];
    inside = inside && glm::dot(glm::cross(edge, offset), normal) >= 0.0;
    const double t = glm::clamp(glm::dot(offset, edge) / glm::dot(edge, edge), 0.0, 1.0);
    const glm::dvec3 q = v[i] + t * edge;
    const double distance2 = glm::dot(p - q, p - q);
    if (distance2 < least)
    {
      least = distance2;
      nearest = q;
    }
  }
  return inside ? p - glm::dot(p - v[0], normal) / glm::dot(normal, normal) * normal : nearest;
}
}

//------------------------------------------------------------------------------
struct vtkIndirectTriangleTree::Builder
{
  struct Job
  {
    uint32_t Node;
    uint32_t Begin;
    uint32_t End;
    int Depth;
  };
  struct Split
  {
    int Axis = -1;
    int Bin = 0;
    double Cost = std::numeric_limits<double>::infinity(); // half area times triangles
    Box Centres;
  };

  std::vector<Box> Boxes;          // by triangle
  std::vector<glm::dvec3> Centres; // by triangle
  std::vector<uint32_t> Order;
  Box All;

  explicit Builder(const std::vector<Triangle>& triangles)
    : Boxes(triangles.size())
    , Centres(triangles.size())
    , Order(triangles.size())
  {
    std::iota(this->Order.begin(), this->Order.end(), 0u);
    for (size_t i = 0; i < triangles.size(); ++i)
    {
      for (const glm::dvec3& corner : triangles[i].Corners)
      {
        this->Boxes[i].Add(corner);
      }
      this->Centres[i] = 0.5 * (this->Boxes[i].Lower + this->Boxes[i].Upper);
      this->All.Add(this->Boxes[i]);
    }
  }

  int FindBin(const Split& split, int axis, uint32_t triangle) const
  {
    const double lower = split.Centres.Lower[axis];
    const double edge = split.Centres.Upper[axis] - lower;
    return std::min(
      static_cast<int>((this->Centres[triangle][axis] - lower) / edge * Bins), Bins - 1);
  }

  Split FindSplit(uint32_t begin, uint32_t end) const
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
      double below[Bins]; // of the bins up to this one
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

  // Where to part the triangles of a node; `begin` where they are a leaf.
  uint32_t Part(const Job& job, const Box& box)
  {
    const uint32_t count = job.End - job.Begin;
    if (count <= 1 || job.Depth >= DeepestOfAll - 2)
    {
      return job.Begin;
    }
    const Split split = this->FindSplit(job.Begin, job.End);
    // A step down costs about as much as the test of a triangle.
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
        [&](uint32_t triangle) { return this->FindBin(split, split.Axis, triangle) < split.Bin; }) -
      first);
  }

  // A tree of two children a node, which lie side by side.
  struct Part2
  {
    Box Bounds;
    uint32_t First = 0; // child, or triangle of a leaf
    uint32_t Count = 0; // of a leaf's triangles; 0: no leaf
  };

  std::vector<Part2> MakeParts()
  {
    std::vector<Part2> parts(1);
    std::vector<Job> jobs = { { 0, 0, static_cast<uint32_t>(this->Order.size()), 0 } };
    while (!jobs.empty())
    {
      const Job job = jobs.back();
      jobs.pop_back();
      Part2 part;
      for (uint32_t i = job.Begin; i < job.End; ++i)
      {
        part.Bounds.Add(this->Boxes[this->Order[i]]);
      }
      const uint32_t middle = this->Part(job, part.Bounds);
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
    return parts;
  }
};

//------------------------------------------------------------------------------
void vtkIndirectTriangleTree::Clear()
{
  this->Triangles = {};
  this->Numbers = {};
  this->Nodes = {};
}

//------------------------------------------------------------------------------
bool vtkIndirectTriangleTree::Add(const glm::dvec3 corners[3])
{
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double square = glm::dot(normal, normal);
  if (!(square > 0.0) || !std::isfinite(square))
  {
    return false;
  }
  this->Triangles.push_back({ { corners[0], corners[1], corners[2] } });
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectTriangleTree::Finish(bool numbered)
{
  this->Nodes.clear();
  this->Numbers.clear();
  if (this->Triangles.empty())
  {
    return;
  }
  Builder builder(this->Triangles);
  const std::vector<Builder::Part2> parts = builder.MakeParts();
  const glm::dvec3 edges = builder.All.Upper - builder.All.Lower;
  const glm::dvec3 padOfAll(Padding * std::max({ edges.x, edges.y, edges.z }));
  this->Lower = builder.All.Lower - padOfAll;
  this->Upper = builder.All.Upper + padOfAll;
  // Where most triangles are.
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> places;
    for (const glm::dvec3& place : builder.Centres)
    {
      places.push_back(place[axis]);
    }
    const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
    std::nth_element(places.begin(), middle, places.end());
    this->Origin[axis] = *middle;
  }

  // Of each node the greatest of its children is opened until there are enough of them.
  std::vector<std::pair<uint32_t, uint32_t>> jobs = { { 0, 0 } }; // node, part
  this->Nodes.emplace_back();
  while (!jobs.empty())
  {
    const auto [at, root] = jobs.back();
    jobs.pop_back();
    uint32_t children[Width] = { root };
    int count = 1;
    while (count < Width)
    {
      int greatest = -1;
      double area = -1.0;
      for (int i = 0; i < count; ++i)
      {
        const Builder::Part2& part = parts[children[i]];
        if (part.Count == 0 && part.Bounds.HalfArea() > area)
        {
          area = part.Bounds.HalfArea();
          greatest = i;
        }
      }
      if (greatest < 0)
      {
        break;
      }
      const uint32_t first = parts[children[greatest]].First;
      children[greatest] = first;
      children[count++] = first + 1;
    }
    Node node;
    for (int i = 0; i < Width; ++i)
    {
      const Builder::Part2 part = i < count ? parts[children[i]] : Builder::Part2();
      const glm::dvec3 farthest = glm::max(
        glm::abs(part.Bounds.Lower - this->Origin), glm::abs(part.Bounds.Upper - this->Origin));
      const glm::dvec3 pad(
        i < count ? Padding * std::max({ farthest.x, farthest.y, farthest.z }) : 0.0);
      const glm::dvec3 lower = part.Bounds.Lower - this->Origin - pad;
      const glm::dvec3 upper = part.Bounds.Upper - this->Origin + pad;
      for (int axis = 0; axis < 3; ++axis)
      {
        node.Bounds[0][axis][i] = static_cast<float>(lower[axis]);
        node.Bounds[1][axis][i] = static_cast<float>(upper[axis]);
      }
      const bool inner = i < count && part.Count == 0;
      node.First[i] = inner ? static_cast<uint32_t>(this->Nodes.size()) : part.First;
      node.Count[i] = part.Count;
      if (inner)
      {
        jobs.emplace_back(node.First[i], children[i]);
        this->Nodes.emplace_back();
      }
    }
    this->Nodes[at] = node;
  }
  this->Nodes.shrink_to_fit();
  std::vector<Triangle> sorted(this->Triangles.size());
  for (size_t i = 0; i < sorted.size(); ++i)
  {
    sorted[i] = this->Triangles[builder.Order[i]];
  }
  this->Triangles = std::move(sorted);
  if (numbered)
  {
    this->Numbers = std::move(builder.Order);
  }
}

//------------------------------------------------------------------------------
// A segment, and what the test of triangles needs of it.
struct vtkIndirectTriangleTree::Ray
{
  double Start[3]; // by the axes of K
  int K[3];        // axes; the last is the direction's longest
  double Shear[3];

  Ray(const glm::dvec3& start, const glm::dvec3& way)
  {
    const glm::dvec3 size = glm::abs(way);
    this->K[2] = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    this->K[0] = (this->K[2] + 1) % 3;
    this->K[1] = (this->K[2] + 2) % 3;
    for (int i = 0; i < 3; ++i)
    {
      this->Start[i] = start[this->K[i]];
    }
    this->Shear[0] = way[this->K[0]] / way[this->K[2]];
    this->Shear[1] = way[this->K[1]] / way[this->K[2]];
    this->Shear[2] = 1.0 / way[this->K[2]];
  }

  bool Crosses(const Triangle& triangle) const
  {
    double weights[3];
    double determinant;
    double t;
    return this->Meets(triangle, weights, determinant, t) &&
      (determinant > 0.0 ? t < determinant : t > determinant);
  }

  // Whether the line of the segment meets the triangle behind its start, at t / determinant of its
  // length, with the corners' weights times the determinant.
  bool Meets(const Triangle& triangle, double weights[3], double& determinant, double& t) const
  {
    double x[3];
    double y[3];
    double z[3];
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3& corner = triangle.Corners[i];
      z[i] = corner[this->K[2]] - this->Start[2];
      x[i] = corner[this->K[0]] - this->Start[0] - this->Shear[0] * z[i];
      y[i] = corner[this->K[1]] - this->Start[1] - this->Shear[1] * z[i];
    }
    const double u = x[2] * y[1] - y[2] * x[1];
    const double v = x[0] * y[2] - y[0] * x[2];
    const double w = x[1] * y[0] - y[1] * x[0];
    if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0))
    {
      return false;
    }
    weights[0] = u;
    weights[1] = v;
    weights[2] = w;
    determinant = u + v + w;
    t = (u * z[0] + v * z[1] + w * z[2]) * this->Shear[2];
    return determinant > 0.0 ? t > 0.0 : t < 0.0;
  }
};

//------------------------------------------------------------------------------
// The segment about the tree's origin, and what the test of boxes needs of it.
struct vtkIndirectTriangleTree::Line
{
  glm::vec3 FromNear; // the begin, moved to where boxes begin sooner, and end later
  glm::vec3 FromFar;
  glm::vec3 Inverse;
  int Sign[3];

  Line(const glm::dvec3& from, const glm::vec3& along)
    : Inverse(1.0f / along)
  {
    const glm::dvec3 size = glm::abs(from);
    const double slack = Padding * std::max({ size.x, size.y, size.z });
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Sign[axis] = std::signbit(this->Inverse[axis]);
      const double on = this->Sign[axis] ? -slack : slack;
      this->FromNear[axis] = static_cast<float>(from[axis] + on);
      this->FromFar[axis] = static_cast<float>(from[axis] - on);
    }
  }

  // Which children's boxes the segment meets, a bit each, and where it enters them.
  unsigned int Meet(const Node& node, float near[Width]) const
  {
#ifdef VTK_INDIRECT_SSE
    __m128 enter = _mm_setzero_ps();
    __m128 leave = _mm_set1_ps(1.0f);
    for (int axis = 0; axis < 3; ++axis)
    {
      const __m128 fromNear = _mm_set1_ps(this->FromNear[axis]);
      const __m128 fromFar = _mm_set1_ps(this->FromFar[axis]);
      const __m128 inverse = _mm_set1_ps(this->Inverse[axis]);
      const float* const lower = node.Bounds[this->Sign[axis]][axis];
      const float* const upper = node.Bounds[1 - this->Sign[axis]][axis];
      // Of a NaN and a number these take their second argument.
      enter = _mm_max_ps(_mm_mul_ps(_mm_sub_ps(_mm_load_ps(lower), fromNear), inverse), enter);
      leave = _mm_min_ps(_mm_mul_ps(_mm_sub_ps(_mm_load_ps(upper), fromFar), inverse), leave);
    }
    _mm_storeu_ps(near, enter);
    return static_cast<unsigned int>(_mm_movemask_ps(_mm_cmple_ps(enter, leave)));
#else
    float far[Width];
    for (int i = 0; i < Width; ++i)
    {
      near[i] = 0.0f;
      far[i] = 1.0f;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const float* const lower = node.Bounds[this->Sign[axis]][axis];
      const float* const upper = node.Bounds[1 - this->Sign[axis]][axis];
      for (int i = 0; i < Width; ++i)
      {
        const float a = (lower[i] - this->FromNear[axis]) * this->Inverse[axis];
        const float b = (upper[i] - this->FromFar[axis]) * this->Inverse[axis];
        near[i] = a > near[i] ? a : near[i];
        far[i] = b < far[i] ? b : far[i];
      }
    }
    unsigned int met = 0;
    for (int i = 0; i < Width; ++i)
    {
      met |= (near[i] <= far[i] ? 1u : 0u) << i;
    }
    return met;
#endif
  }
};

//------------------------------------------------------------------------------
// The part of a segment that is in the box of all. A direction along faces gives infinities, and
// NaNs, which no comparison takes.
bool vtkIndirectTriangleTree::Clip(
  const glm::dvec3& start, const glm::dvec3& way, double& enter, double& leave) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double inverse = 1.0 / way[axis];
    const double a = (this->Lower[axis] - start[axis]) * inverse;
    const double b = (this->Upper[axis] - start[axis]) * inverse;
    const double near = inverse < 0.0 ? b : a;
    const double far = inverse < 0.0 ? a : b;
    enter = near > enter ? near : enter;
    leave = far < leave ? far : leave;
  }
  return enter <= leave;
}

//------------------------------------------------------------------------------
bool vtkIndirectTriangleTree::IsBlocked(const glm::dvec3& start, const glm::dvec3& end) const
{
  const glm::dvec3 way = end - start;
  double enter = 0.0;
  double leave = 1.0;
  if (this->Nodes.empty() || way == glm::dvec3(0.0) || !this->Clip(start, way, enter, leave))
  {
    return false;
  }
  const Ray ray(start, way);
  const Line line(start + enter * way - this->Origin, glm::vec3((leave - enter) * way));
  uint32_t waiting[(Width - 1) * DeepestOfAll] = { 0 };
  int count = 1;
  while (count > 0)
  {
    const Node& node = this->Nodes[waiting[--count]];
    float near[Width];
    const unsigned int met = line.Meet(node, near);
    int nearest = -1;
    for (int i = 0; i < Width; ++i)
    {
      if (!(met >> i & 1u))
      {
        continue;
      }
      if (node.Count[i] == 0)
      {
        // The nearest comes last and is taken first.
        waiting[count] = node.First[i];
        if (nearest < 0 || near[i] < near[nearest])
        {
          nearest = i;
        }
        else
        {
          std::swap(waiting[count], waiting[count - 1]);
        }
        ++count;
        continue;
      }
      for (uint32_t k = node.First[i]; k < node.First[i] + node.Count[i]; ++k)
      {
        if (ray.Crosses(this->Triangles[k]))
        {
          return true;
        }
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool vtkIndirectTriangleTree::FindNearest(
  const glm::dvec3& start, const glm::dvec3& direction, uint32_t except, Hit& hit) const
{
  hit.Triangle = None;
  double enter = 0.0;
  double leave = std::numeric_limits<double>::infinity();
  if (this->Numbers.empty() || !this->Clip(start, direction, enter, leave) || !std::isfinite(leave))
  {
    return false;
  }
  // Boxes are asked with a segment that ends where the ray leaves that of all.
  const double length = leave - enter;
  const Ray ray(start, direction);
  const Line line(start + enter * direction - this->Origin, glm::vec3(length * direction));
  double least = std::numeric_limits<double>::infinity();
  float limit = 1.0f;
  struct Visit
  {
    uint32_t Node;
    float Near;
  };
  Visit waiting[(Width - 1) * DeepestOfAll] = { { 0, 0.0f } };
  int count = 1;
  while (count > 0)
  {
    const Visit visit = waiting[--count];
    if (visit.Near > limit)
    {
      continue;
    }
    const Node& node = this->Nodes[visit.Node];
    float near[Width];
    const unsigned int met = line.Meet(node, near);
    const int first = count;
    for (int i = 0; i < Width; ++i)
    {
      if (!(met >> i & 1u) || near[i] > limit)
      {
        continue;
      }
      if (node.Count[i] == 0)
      {
        // The nearest is taken first.
        int place = count++;
        for (; place > first && waiting[place - 1].Near < near[i]; --place)
        {
          waiting[place] = waiting[place - 1];
        }
        waiting[place] = { node.First[i], near[i] };
        continue;
      }
      for (uint32_t k = node.First[i]; k < node.First[i] + node.Count[i]; ++k)
      {
        double weights[3];
        double determinant;
        double t;
        if (this->Numbers[k] == except || !ray.Meets(this->Triangles[k], weights, determinant, t) ||
          !(t / determinant < least))
        {
          continue;
        }
        least = t / determinant;
        hit.Triangle = this->Numbers[k];
        hit.Distance = least;
        for (int corner = 0; corner < 3; ++corner)
        {
          hit.Weights[corner] = weights[corner] / determinant;
        }
        // Boxes are wider than what rounding to floats moves them by; so is what is beyond.
        limit = static_cast<float>((least - enter) / length + 2.0 * Padding);
      }
    }
  }
  return hit.Triangle != None;
}

//------------------------------------------------------------------------------
bool vtkIndirectTriangleTree::FindFacet(
  const glm::dvec3& point, const glm::dvec3& normal, double reach, Facet& facet) const
{
  double least = std::numeric_limits<double>::infinity();
  const glm::dvec3 relative = point - this->Origin;
  uint32_t waiting[(Width - 1) * DeepestOfAll] = { 0 };
  int count = this->Nodes.empty() ? 0 : 1;
  while (count > 0)
  {
    const Node& node = this->Nodes[waiting[--count]];
    for (int child = 0; child < Width; ++child)
    {
      double outside2 = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double outside = std::max({ node.Bounds[0][axis][child] - relative[axis],
          relative[axis] - node.Bounds[1][axis][child], 0.0 });
        outside2 += outside * outside;
      }
      if (!(outside2 <= reach * reach))
      {
        continue;
      }
      if (node.Count[child] == 0)
      {
        waiting[count++] = node.First[child];
        continue;
      }
      for (uint32_t i = node.First[child]; i < node.First[child] + node.Count[child]; ++i)
      {
        const glm::dvec3* v = this->Triangles[i].Corners;
        const glm::dvec3 nearest = FindNearestPoint(v, point);
        const double distance = glm::distance(point, nearest);
        const glm::dvec3 n = glm::normalize(glm::cross(v[1] - v[0], v[2] - v[0]));
        const double cosine = glm::dot(n, normal);
        const double penalty = distance + reach * (1.0 - std::abs(cosine));
        if (distance <= reach && penalty < least)
        {
          least = penalty;
          facet.Normal = cosine < 0.0 ? -n : n;
          facet.Height = glm::dot(point - v[0], facet.Normal);
          facet.Distance = distance;
          facet.Nearest = nearest;
          facet.Centre = (v[0] + v[1] + v[2]) / 3.0;
        }
      }
    }
  }
  return std::isfinite(least);
}
