// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectSightLines.h"

#include "Scene/vtkIndirectTriangleTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Finds the point of a triangle that is nearest to p, by the regions of its corners, edges and
// inside.
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
bool vtkIndirectSightLines::FindFacet(const vtkIndirectTriangleTree& tree, const glm::dvec3& point,
  const glm::dvec3& normal, double reach, Facet& facet)
{
  double least = std::numeric_limits<double>::infinity();
  tree.ForEachNear(point, reach,
    [&](const glm::dvec3 v[3])
    {
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
    });
  return std::isfinite(least);
}

//------------------------------------------------------------------------------
vtkIndirectSightLines::End vtkIndirectSightLines::FindEnd(
  const glm::dvec3& position, const glm::dvec3& normal) const
{
  End end;
  Facet facet;
  end.OnSurface = FindFacet(this->Tree, position, normal, Reach, facet);
  end.Normal = end.OnSurface ? facet.Normal : normal;
  if (!end.OnSurface)
  {
    end.Position = position + Lift * normal;
    return end;
  }
  glm::dvec3 foot = position - facet.Height * facet.Normal;
  // A rasterizer moves corners, and thus edges, to a grid of its own: a point past the triangle's
  // edge may lie behind the wall that begins there. Such a point is moved onto the triangle and
  // away from that edge.
  if (facet.Distance > std::abs(facet.Height) + 1e-3 * Lift)
  {
    const glm::dvec3 inwards = facet.Centre - facet.Nearest;
    foot = facet.Nearest + std::min(1.0, 4.0 * Lift / glm::length(inwards)) * inwards;
  }
  end.Position = foot + Lift * facet.Normal;
  return end;
}

//------------------------------------------------------------------------------
bool vtkIndirectSightLines::IsVisible(const End& a, const End& b) const
{
  // The dot products are the heights of each end over the other end's plane.
  const glm::dvec3 way = b.Position - a.Position;
  return glm::dot(a.Normal, way) > -Lift && glm::dot(b.Normal, way) < Lift &&
    !this->Tree.IsBlocked(a.Position, b.Position);
}
