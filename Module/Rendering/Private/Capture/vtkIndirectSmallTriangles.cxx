// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/vtkIndirectSmallTriangles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
// Corners are placed at whole numbers of 1/256 of a texel, as OpenGL on the processor does.
constexpr float StepsOfTexel = 256.0f;
constexpr float HalfStep = 0.5f / StepsOfTexel;
// This leaves room for OpenGL's own rounding of matrices and places.
constexpr float MarginOfChoice = 0.125f;

// Points nearer to the camera than this, in scene units, lie in front of every near plane.
constexpr float LeastDistance = 1e-5f;

// Longer triangles are drawn by OpenGL, in texels. Sums of products of their steps have 32 bits.
constexpr float LongestTriangle = 64.0f;

// Returns the nearest whole number: sums of this size have no fraction.
int Round(float x)
{
  constexpr float shift = 12582912.0f; // 1.5 * 2^23
  return static_cast<int>((x + shift) - shift);
}

// Returns the least whole number that is not smaller than a number that is not negative.
int RoundUp(float x)
{
  const int below = static_cast<int>(x);
  return below + (static_cast<float>(below) < x ? 1 : 0);
}

struct Corner
{
  int X; // in steps from the first centre
  int Y;
};

// One edge of a triangle as a sum that is positive inside.
struct Edge
{
  int AtFirst; // at the first centre
  int PerColumn;
  int PerRow;

  Edge(const Corner& from, const Corner& to)
  {
    const int x = to.X - from.X;
    const int y = to.Y - from.Y;
    // A centre on an edge counts to the triangle at one side of the edge.
    const int tie = y < 0 || (y == 0 && x > 0) ? 0 : -1;
    this->AtFirst = from.X * y - from.Y * x + tie;
    this->PerColumn = -static_cast<int>(StepsOfTexel) * y;
    this->PerRow = static_cast<int>(StepsOfTexel) * x;
  }
};
}

//------------------------------------------------------------------------------
void vtkIndirectSmallTriangles::SetView(
  const glm::mat4& toClip, const glm::ivec2& texels, const glm::vec4& emitter)
{
  this->ToClip = toClip;
  this->Emitter = emitter;
  this->Half = 0.5f * glm::vec2(texels);
  this->Last = glm::vec2(texels - 1);
  this->Width = texels.x;
}

//------------------------------------------------------------------------------
inline vtkIndirectSmallTriangles::Place vtkIndirectSmallTriangles::Find(
  const glm::vec3& point) const
{
  const glm::mat4& m = this->ToClip;
  const glm::vec4 clip = m[0] * point.x + m[1] * point.y + m[2] * point.z + m[3];
  const float inverse = 1.0f / clip.w;
  return { this->Half.x * (clip.x * inverse + 1.0f) - 0.5f,
    this->Half.y * (clip.y * inverse + 1.0f) - 0.5f,
    clip.w > LeastDistance ? 0.5f * clip.z * inverse + 0.5f : -1.0f };
}

//------------------------------------------------------------------------------
void vtkIndirectSmallTriangles::Project(const std::vector<glm::vec3>& points)
{
  this->Places.resize(points.size());
  for (size_t i = 0; i < points.size(); ++i)
  {
    this->Places[i] = this->Find(points[i]);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectSmallTriangles::ProjectInsets(const float* points, size_t count)
{
  this->Places.resize(std::max(this->Places.size(), count));
  for (size_t i = 0; i < count; ++i)
  {
    const float* const p = points + 6 * i;
    const glm::vec3 place(p[0], p[1], p[2]);
    const glm::vec3 inset(p[3], p[4], p[5]);
    const glm::vec3 toEmitter = glm::vec3(this->Emitter) - this->Emitter.w * place;
    this->Places[i] = this->Find(place - std::copysign(1.0f, glm::dot(inset, toEmitter)) * inset);
  }
}

//------------------------------------------------------------------------------
// Returns false if the bounds of a triangle, wider by a margin, hold no centre.
inline bool vtkIndirectSmallTriangles::FindCenters(
  const Place& a, const Place& b, const Place& c, float margin, Centers& found) const
{
  const float left = std::max(std::min(std::min(a.X, b.X), c.X) - margin, 0.0f);
  const float right = std::min(std::max(std::max(a.X, b.X), c.X) + margin, this->Last.x);
  const float bottom = std::max(std::min(std::min(a.Y, b.Y), c.Y) - margin, 0.0f);
  const float top = std::min(std::max(std::max(a.Y, b.Y), c.Y) + margin, this->Last.y);
  // Places that are not negative are truncated to the centre below them.
  found.Right = static_cast<int>(right);
  found.Top = static_cast<int>(top);
  if (!(static_cast<float>(found.Right) >= left && static_cast<float>(found.Top) >= bottom &&
        right >= 0.0f && top >= 0.0f))
  {
    return false;
  }
  found.Left = RoundUp(left);
  found.Bottom = RoundUp(bottom);
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectSmallTriangles::Choose(
  const unsigned int* indices, size_t count, std::vector<unsigned int>& chosen) const
{
  for (size_t i = 0; i + 2 < count; i += 3)
  {
    const unsigned int* const t = indices + i;
    const Place& a = this->Places[t[0]];
    const Place& b = this->Places[t[1]];
    const Place& c = this->Places[t[2]];
    Centers centers;
    if (std::min(std::min(a.Z, b.Z), c.Z) < 0.0f
        ? std::max(std::max(a.Z, b.Z), c.Z) >= 0.0f
        : this->FindCenters(a, b, c, MarginOfChoice, centers))
    {
      chosen.insert(chosen.end(), t, t + 3);
    }
  }
}

//------------------------------------------------------------------------------
// Returns false if the triangle is too large.
inline bool vtkIndirectSmallTriangles::DrawTriangle(
  const Place& a, const Place& b, const Place& c, const Centers& centers, float* depths) const
{
  if (!(std::max(std::max(a.X, b.X), c.X) - std::min(std::min(a.X, b.X), c.X) <= LongestTriangle &&
        std::max(std::max(a.Y, b.Y), c.Y) - std::min(std::min(a.Y, b.Y), c.Y) <= LongestTriangle))
  {
    return false;
  }
  const auto snap = [&](const Place& p)
  {
    return Corner{ Round(p.X * StepsOfTexel) - static_cast<int>(StepsOfTexel) * centers.Left,
      Round(p.Y * StepsOfTexel) - static_cast<int>(StepsOfTexel) * centers.Bottom };
  };
  Corner p = snap(a);
  Corner q = snap(b);
  const Corner r = snap(c);
  const int area = (q.X - p.X) * (r.Y - p.Y) - (q.Y - p.Y) * (r.X - p.X);
  if (area == 0)
  {
    return true;
  }
  if (area < 0)
  {
    std::swap(p, q);
  }
  const Edge first(p, q);
  const Edge second(q, r);
  const Edge third(r, p);
  // Depth is linear in the view.
  const float x1 = b.X - a.X;
  const float y1 = b.Y - a.Y;
  const float z1 = b.Z - a.Z;
  const float x2 = c.X - a.X;
  const float y2 = c.Y - a.Y;
  const float z2 = c.Z - a.Z;
  const float inverse = 1.0f / (x1 * y2 - y1 * x2);
  const float perColumn = (z1 * y2 - y1 * z2) * inverse;
  const float perRow = (x1 * z2 - z1 * x2) * inverse;
  for (int y = centers.Bottom; y <= centers.Top; ++y)
  {
    const int row = y - centers.Bottom;
    float* const line = depths + static_cast<size_t>(y) * static_cast<size_t>(this->Width);
    for (int x = centers.Left; x <= centers.Right; ++x)
    {
      const int column = x - centers.Left;
      const int outside = (first.AtFirst + column * first.PerColumn + row * first.PerRow) |
        (second.AtFirst + column * second.PerColumn + row * second.PerRow) |
        (third.AtFirst + column * third.PerColumn + row * third.PerRow);
      if (outside >= 0)
      {
        const float z =
          a.Z + (static_cast<float>(x) - a.X) * perColumn + (static_cast<float>(y) - a.Y) * perRow;
        line[x] = std::min(line[x], z);
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectSmallTriangles::Draw(
  const unsigned int* indices, size_t count, float* depths, std::vector<size_t>& left) const
{
  for (size_t i = 0; i + 2 < count; i += 3)
  {
    const unsigned int* const t = indices + i;
    const Place& a = this->Places[t[0]];
    const Place& b = this->Places[t[1]];
    const Place& c = this->Places[t[2]];
    const float nearest = std::min(std::min(a.Z, b.Z), c.Z);
    const float farthest = std::max(std::max(a.Z, b.Z), c.Z);
    if (farthest < 0.0f)
    {
      continue;
    }
    Centers centers;
    if (nearest < 0.0f || farthest > 1.0f ? true
                                          : this->FindCenters(a, b, c, HalfStep, centers) &&
          !this->DrawTriangle(a, b, c, centers, depths))
    {
      left.push_back(i);
    }
  }
}
