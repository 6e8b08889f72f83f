// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectTriangleTree.h"

#include "Scene/vtkIndirectBoxTree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#if defined(__SSE__) || defined(_M_X64)
#include <xmmintrin.h>
#define VTK_INDIRECT_SSE
#endif

namespace
{
// Boxes are padded by this share of two coordinates about the tree's origin: the box's greatest and
// that of a segment's begin. Rounding to floats, of the box, the direction, its inverse and the two
// steps of the boxes' test, moves a face by less than 2^-21 of both. So small triangles have small
// boxes near the origin, however far other triangles reach.
constexpr double Padding = 1.0 / (1 << 20);

// Returns the place of the lowest bit that is set; one must be.
inline int FindLowestBit(unsigned int bits)
{
#ifdef __GNUC__
  return __builtin_ctz(bits);
#else
  int place = 0;
  for (; !(bits >> place & 1u); ++place)
  {
  }
  return place;
#endif
}
}

//------------------------------------------------------------------------------
void vtkIndirectTriangleTree::Clear()
{
  this->Triangles = {};
  this->Numbers = {};
  this->NumberOfGiven = 0;
  this->NumberOfSpheres = 0;
  this->Nodes = {};
}

//------------------------------------------------------------------------------
bool vtkIndirectTriangleTree::Add(const glm::dvec3 corners[3])
{
  const uint32_t number = this->NumberOfGiven++;
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double square = glm::dot(normal, normal);
  if (!(square > 0.0) || !std::isfinite(square))
  {
    return false;
  }
  this->Triangles.push_back({ { corners[0], corners[1], corners[2] } });
  this->Numbers.push_back(number);
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectTriangleTree::AddSphere(const glm::dvec3& center, double radius)
{
  const uint32_t number = this->NumberOfGiven++;
  if (!(radius > 0.0) || !std::isfinite(radius * radius + glm::dot(center, center)))
  {
    return false;
  }
  this->Triangles.push_back({ { center, glm::dvec3(radius), glm::dvec3(INFINITY) } });
  this->Numbers.push_back(number);
  ++this->NumberOfSpheres;
  return true;
}

//------------------------------------------------------------------------------
// A ray meets a sphere from outside only: impostors draw that side.
bool vtkIndirectTriangleTree::Triangle::MeetsSphere(
  const glm::dvec3& start, const glm::dvec3& direction, double& distance, double normal[3]) const
{
  const glm::dvec3 offset = start - this->Corners[0];
  const double radius = this->Corners[1].x;
  const double along = glm::dot(offset, direction);
  // `square` is the squared radius less the squared distance of the line from the center, without a
  // difference of large squares.
  const glm::dvec3 beside = offset - along * direction;
  const double square = radius * radius - glm::dot(beside, beside);
  if (!(square > 0.0))
  {
    return false;
  }
  distance = -along - std::sqrt(square);
  const glm::dvec3 outward = (offset + distance * direction) / radius;
  std::copy(&outward[0], &outward[0] + 3, normal);
  return distance > 0.0;
}

//------------------------------------------------------------------------------
// A sphere crosses a segment where the segment's place nearest to the center is inside, and both
// ends are outside.
bool vtkIndirectTriangleTree::Triangle::SphereCrosses(
  const glm::dvec3& start, const glm::dvec3& way) const
{
  const glm::dvec3 offset = this->Corners[0] - start;
  const double square = this->Corners[1].x * this->Corners[1].x;
  const double t = glm::dot(offset, way) / glm::dot(way, way);
  const glm::dvec3 beside = offset - t * way;
  const glm::dvec3 beyond = offset - way;
  return t > 0.0 && t < 1.0 && glm::dot(beside, beside) < square &&
    glm::dot(offset, offset) > square && glm::dot(beyond, beyond) > square;
}

//------------------------------------------------------------------------------
void vtkIndirectTriangleTree::Finish()
{
  this->Nodes.clear();
  if (this->Triangles.empty())
  {
    return;
  }
  std::vector<vtkIndirectBoxTree::Box> boxes(this->Triangles.size());
  for (size_t i = 0; i < boxes.size(); ++i)
  {
    const glm::dvec3* const v = this->Triangles[i].Corners;
    if (this->Triangles[i].IsSphere())
    {
      boxes[i].Add(v[0] - v[1].x);
      boxes[i].Add(v[0] + v[1].x);
      continue;
    }
    for (int corner = 0; corner < 3; ++corner)
    {
      boxes[i].Add(v[corner]);
    }
  }
  const vtkIndirectBoxTree builder(boxes);
  const std::vector<vtkIndirectBoxTree::Part>& parts = builder.GetParts();
  const glm::dvec3 edges = builder.GetAll().Upper - builder.GetAll().Lower;
  const glm::dvec3 padOfAll(Padding * std::max({ edges.x, edges.y, edges.z }));
  this->Lower = builder.GetAll().Lower - padOfAll;
  this->Upper = builder.GetAll().Upper + padOfAll;
  this->Origin = builder.GetMiddle();

  // The greatest child of each node is opened until the node has enough children.
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
        const vtkIndirectBoxTree::Part& part = parts[children[i]];
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
      const vtkIndirectBoxTree::Part part =
        i < count ? parts[children[i]] : vtkIndirectBoxTree::Part();
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
  std::vector<uint32_t> numbers(this->Triangles.size());
  for (size_t i = 0; i < sorted.size(); ++i)
  {
    sorted[i] = this->Triangles[builder.GetOrder()[i]];
    numbers[i] = this->Numbers[builder.GetOrder()[i]];
  }
  this->Triangles = std::move(sorted);
  this->Numbers = std::move(numbers);
}

//------------------------------------------------------------------------------
// A segment, in the form that the test of triangles needs.
struct vtkIndirectTriangleTree::Ray
{
  double Start[3]; // by the axes of K
  int K[3];        // axes; the last one is the direction's longest
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

  // True if the line of the segment meets the triangle behind its start, at t / determinant of its
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
// The segment about the tree's origin, in the form that the test of boxes needs.
struct vtkIndirectTriangleTree::Line
{
  glm::vec3 FromNear; // the begin, moved so that boxes begin sooner (here) and end later (FromFar)
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

  // Returns a bit for each child whose box the segment meets before the limit; near: where the
  // segment enters the box.
  unsigned int Meet(const Node& node, float limit, float near[Width]) const
  {
#ifdef VTK_INDIRECT_SSE
    __m128 enter = _mm_setzero_ps();
    __m128 leave = _mm_set1_ps(limit);
    for (int axis = 0; axis < 3; ++axis)
    {
      const __m128 fromNear = _mm_set1_ps(this->FromNear[axis]);
      const __m128 fromFar = _mm_set1_ps(this->FromFar[axis]);
      const __m128 inverse = _mm_set1_ps(this->Inverse[axis]);
      const float* const lower = node.Bounds[this->Sign[axis]][axis];
      const float* const upper = node.Bounds[1 - this->Sign[axis]][axis];
      // With a NaN and a number these instructions return their second argument.
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
      far[i] = limit;
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
// Finds the part of a segment that is in the box of all triangles. A direction along faces gives
// infinities, and NaNs, which comparisons reject.
bool vtkIndirectTriangleTree::Clip(
  const glm::dvec3& start, const glm::dvec3& way, double& enter, double& leave) const
{
  if (!std::isfinite(glm::dot(start + way, glm::dvec3(1.0))))
  {
    return false;
  }
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
// Calls for the number of each triangle and sphere whose box the line meets before the limit, which
// the call may lower, until a call returns false. The nearest boxes come first.
template <typename Call>
void vtkIndirectTriangleTree::Walk(const Line& line, float& limit, Call call) const
{
  struct Visit
  {
    uint32_t Node;
    float Near;
  };
  Visit waiting[(Width - 1) * vtkIndirectBoxTree::Deepest]; // without values: most stay unused
  int count = 0;
  for (uint32_t at = 0;;)
  {
    const Node& node = this->Nodes[at];
    float near[Width];
    const int first = count;
    for (unsigned int met = line.Meet(node, limit, near); met != 0; met &= met - 1)
    {
      const int i = FindLowestBit(met);
      if (node.Count[i] == 0)
      {
        // Children are sorted so that the nearest is taken first.
        int place = count++;
        for (; place > first && waiting[place - 1].Near < near[i]; --place)
        {
          waiting[place] = waiting[place - 1];
        }
        waiting[place] = { node.First[i], near[i] };
        continue;
      }
      if (near[i] > limit) // which a leaf before has lowered
      {
        continue;
      }
      for (uint32_t k = node.First[i]; k < node.First[i] + node.Count[i]; ++k)
      {
        if (!call(k))
        {
          return;
        }
      }
    }
    do
    {
      if (count == 0)
      {
        return;
      }
      --count;
    } while (waiting[count].Near > limit);
    at = waiting[count].Node;
  }
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
  bool blocked = false;
  float limit = 1.0f;
  this->Walk(line, limit,
    [&](uint32_t k)
    {
      const Triangle& triangle = this->Triangles[k];
      blocked = triangle.IsSphere() ? triangle.SphereCrosses(start, way) : ray.Crosses(triangle);
      return !blocked;
    });
  return blocked;
}

//------------------------------------------------------------------------------
bool vtkIndirectTriangleTree::FindNearest(
  const glm::dvec3& start, const glm::dvec3& direction, uint32_t except, Hit& hit) const
{
  hit.Triangle = None;
  double enter = 0.0;
  double leave = std::numeric_limits<double>::infinity();
  if (this->Nodes.empty() || !this->Clip(start, direction, enter, leave) || !std::isfinite(leave))
  {
    return false;
  }
  // Boxes are tested with a segment that ends where the ray leaves the box of all triangles.
  const double length = leave - enter;
  const Ray ray(start, direction);
  const Line line(start + enter * direction - this->Origin, glm::vec3(length * direction));
  double least = std::numeric_limits<double>::infinity();
  float limit = 1.0f;
  this->Walk(line, limit,
    [&](uint32_t k)
    {
      const Triangle& triangle = this->Triangles[k];
      double weights[3];
      double determinant = 1.0;
      double t;
      const bool meets = this->Numbers[k] != except &&
        (triangle.IsSphere() ? triangle.MeetsSphere(start, direction, t, weights)
                             : ray.Meets(triangle, weights, determinant, t));
      if (!meets || !(t / determinant < least))
      {
        return true;
      }
      least = t / determinant;
      hit.Triangle = this->Numbers[k];
      hit.Distance = least;
      for (int corner = 0; corner < 3; ++corner)
      {
        hit.Weights[corner] = weights[corner] / determinant;
      }
      // Boxes are wider than the rounding to floats; the limit gets the same margin.
      limit = static_cast<float>((least - enter) / length + 2.0 * Padding);
      return true;
    });
  return hit.Triangle != None;
}

//------------------------------------------------------------------------------
void vtkIndirectTriangleTree::ForEachNear(const glm::dvec3& point, double distance,
  const std::function<void(const glm::dvec3 corners[3])>& call) const
{
  const glm::dvec3 relative = point - this->Origin;
  uint32_t waiting[(Width - 1) * vtkIndirectBoxTree::Deepest] = { 0 };
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
      if (!(outside2 <= distance * distance))
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
        if (!this->Triangles[i].IsSphere())
        {
          call(this->Triangles[i].Corners);
        }
      }
    }
  }
}
