// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectSightLines.h"

#include "Visibility/vtkIndirectTriangleTree.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
vtkIndirectSightLines::End vtkIndirectSightLines::FindEnd(
  const glm::dvec3& position, const glm::dvec3& normal) const
{
  End end;
  vtkIndirectTriangleTree::Facet facet;
  end.OnSurface = this->Tree.FindFacet(position, normal, Reach, facet);
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
