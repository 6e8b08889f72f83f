// SPDX-License-Identifier: BSD-3-Clause
#include "Visibility/vtkIndirectSightLines.h"

#include "Visibility/vtkIndirectTriangleTree.h"

//------------------------------------------------------------------------------
vtkIndirectSightLines::End vtkIndirectSightLines::FindEnd(
  const glm::dvec3& position, const glm::dvec3& normal) const
{
  End end;
  vtkIndirectTriangleTree::Facet facet;
  end.OnSurface = this->Tree.FindFacet(position, normal, Reach, facet);
  end.Normal = end.OnSurface ? facet.Normal : normal;
  end.Position = position + (end.OnSurface ? Lift - facet.Height : Lift) * end.Normal;
  return end;
}

//------------------------------------------------------------------------------
bool vtkIndirectSightLines::IsVisible(const End& a, const End& b) const
{
  // Heights of each end over the other's plane.
  const glm::dvec3 way = b.Position - a.Position;
  return glm::dot(a.Normal, way) > -Lift && glm::dot(b.Normal, way) < Lift &&
    !this->Tree.IsBlocked(a.Position, b.Position);
}
