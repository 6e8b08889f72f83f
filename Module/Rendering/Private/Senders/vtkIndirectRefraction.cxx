// SPDX-License-Identifier: BSD-3-Clause
#include "Senders/vtkIndirectRefraction.h"

#include "Scene/vtkIndirectFrame.h"
#include "Scene/vtkIndirectRevision.h"
#include "vtkActor.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
// Largest number of faces on a path: light that is mirrored so often inside has lost most of its
// flux.
constexpr int MostFaces = 8;
}

//------------------------------------------------------------------------------
void vtkIndirectRefraction::SetBody(const vtkIndirectFrame& frame, vtkActor* actor)
{
  // The scene holds the body alone: light passes through everything else.
  vtkIndirectFrame body;
  std::copy(frame.SceneBounds, frame.SceneBounds + 6, body.SceneBounds);
  body.SceneCenter = frame.SceneCenter;
  body.SceneScale = frame.SceneScale;
  vtkIndirectCaster caster;
  caster.Prop = actor;
  caster.Revision = vtkIndirectRevision::Find(actor);
  body.Casters.push_back(caster);
  this->Surfaces.Update(body);
  double bounds[6];
  actor->GetBounds(bounds);
  this->Size = frame.SceneScale *
    glm::length(glm::dvec3(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]));
  this->Index = actor->GetProperty()->GetBaseIOR();
  this->Transmission = 1.0 - actor->GetProperty()->GetOpacity();
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectRefraction::Refract(
  const glm::dvec3& direction, const glm::dvec3& normal, double indexBefore, double indexBehind)
{
  const double ratio = indexBefore / indexBehind;
  const double cosine = -glm::dot(direction, normal);
  const double square = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
  return square > 0.0
    ? glm::normalize(ratio * direction + (ratio * cosine - std::sqrt(square)) * normal)
    : glm::dvec3(0.0);
}

//------------------------------------------------------------------------------
double vtkIndirectRefraction::Reflectance(double cosine, double indexBefore, double indexBehind)
{
  const double ratio = indexBefore / indexBehind;
  const double square = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
  if (!(square > 0.0))
  {
    return 1.0;
  }
  const double behind = std::sqrt(square);
  const double s =
    (indexBefore * cosine - indexBehind * behind) / (indexBefore * cosine + indexBehind * behind);
  const double p =
    (indexBehind * cosine - indexBefore * behind) / (indexBehind * cosine + indexBefore * behind);
  return 0.5 * (s * s + p * p);
}

//------------------------------------------------------------------------------
bool vtkIndirectRefraction::Meet(
  const glm::dvec3& from, const glm::dvec3& direction, glm::dvec3& place, glm::dvec3& normal) const
{
  vtkIndirectSurfaces::Meeting meeting;
  if (!this->Surfaces.Meet(from, direction, vtkIndirectTriangleTree::None, meeting, true))
  {
    return false;
  }
  place = meeting.Position;
  const glm::dvec3& facet = meeting.FacetNormal;
  const glm::dvec3 shading =
    glm::dot(meeting.Normal, facet) < 0.0 ? -meeting.Normal : meeting.Normal;
  // Light cannot be refracted at a normal that faces away from its origin.
  normal = glm::dot(shading, direction) < -1e-6 ? shading : facet;
  return true;
}

//------------------------------------------------------------------------------
vtkIndirectRefraction::Path vtkIndirectRefraction::Trace(
  const glm::dvec3& origin, const glm::dvec3& direction) const
{
  Path path;
  glm::dvec3 from = origin;
  glm::dvec3 way = direction;
  glm::dvec3 place;
  glm::dvec3 normal;
  double share = 1.0;
  bool inside = false;
  for (int face = 0; face < MostFaces; ++face)
  {
    if (!this->Meet(from, way, place, normal))
    {
      return path; // past the body, or out of a body that is not closed
    }
    const double before = inside ? this->Index : 1.0;
    const double behind = inside ? 1.0 : this->Index;
    const glm::dvec3 refracted = Refract(way, normal, before, behind);
    if (glm::dot(refracted, refracted) > 0.5)
    {
      share *= (1.0 - Reflectance(-glm::dot(way, normal), before, behind)) * this->Transmission;
      way = refracted;
      if (inside)
      {
        path.Position = place;
        path.Normal = -normal;
        path.Direction = way;
        path.Share = share;
        return path;
      }
      inside = true;
    }
    else
    {
      way = glm::normalize(way - 2.0 * glm::dot(way, normal) * normal);
    }
    // The path goes on off the face, by more than the rounding of places.
    from = place + 1e-6 * this->Size * way;
  }
  return path;
}
