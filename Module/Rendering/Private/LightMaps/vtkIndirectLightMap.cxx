// SPDX-License-Identifier: BSD-3-Clause
#include "LightMaps/vtkIndirectLightMap.h"
#include "Frame/vtkIndirectKey.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// A face aimed at the scene replaces a light's own faces if it is at most this share as wide: then
// the scene gets twice the texels, or more.
constexpr double AimedShare = 0.5;

// Surfaces nearer to a light than this fraction of its farthest surface are not in its map. The
// depth buffer's steps grow with far/near: 2.4e-7 * 1024 * far is below a tenth of a texel of 512.
constexpr double NearestFraction = 1.0 / 1024.0;

// Makes a frame whose -z axis is the direction; the smallest component makes the most robust cross
// product.
glm::dmat3 FrameAlong(const glm::dvec3& direction)
{
  const glm::dvec3 a = glm::abs(direction);
  glm::dvec3 helper(0.0, 0.0, 1.0);
  if (a.y <= a.x && a.y <= a.z)
  {
    helper = glm::dvec3(0.0, 1.0, 0.0);
  }
  else if (a.x <= a.y && a.x <= a.z)
  {
    helper = glm::dvec3(1.0, 0.0, 0.0);
  }
  const glm::dvec3 right = glm::normalize(glm::cross(direction, helper));
  return { right, glm::cross(right, direction), -direction };
}
}

//------------------------------------------------------------------------------
void vtkIndirectLightMap::Fit(const vtkIndirectFrame& frame, const vtkIndirectLight& light)
{
  using namespace vtkIndirectKernels;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  this->Light = light;
  this->SceneScale = frame.SceneScale;
  const bool omnidirectional = light.Positional && light.ConeAngle >= 90.0;
  const bool narrow = light.FindMapProjection() == VTKI_MAP_SINGLE;
  const double cone = narrow ? std::tan(light.ConeAngle * vtkMath::Pi() / 180.0) : 1.0;
  glm::dvec3 place = light.Positional ? frame.ToScene(light.PositionWC) : glm::dvec3(0.0);
  // From outside of the sphere around all casters a light may aim at them. A margin keeps surfaces
  // that touch the sphere, whose diameter is one, off the map's edge.
  constexpr double radius = 0.505;
  const double distance = glm::length(place);
  const double tangent = distance > radius && !frame.Casters.empty()
    ? radius / std::sqrt((distance - radius) * (distance + radius))
    : infinity;
  const bool aimed = tangent <= AimedShare * cone;

  // A point light's faces stay along the world's axes, so that they never turn.
  const glm::dmat3 axes = aimed ? FrameAlong(-place / distance)
    : omnidirectional           ? glm::dmat3(1.0)
                                : FrameAlong(light.DirectionWC);
  glm::dvec3 lower(infinity);
  glm::dvec3 upper(-infinity);
  for (const glm::dvec3& p : frame.FindCorners(axes, place))
  {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  if (!light.Positional)
  {
    this->Projection = VTKI_MAP_PARALLEL;
    this->NumberOfFaces = 1;
    // Centres the map on the casters; a margin keeps the outermost off its edge.
    const glm::dvec3 half = 0.5 * (upper - lower);
    constexpr double margin = 1.01;
    this->HalfWidth = margin * std::max({ half.x, half.y, 1e-3 * half.z });
    const double depth = std::max(half.z, 1e-3 * this->HalfWidth);
    this->Near = 0.0;
    this->Far = 2.0 * margin * depth;
    place = axes * (0.5 * (lower + upper) + glm::dvec3(0.0, 0.0, margin * depth));
  }
  else
  {
    const bool single = narrow || aimed;
    this->Projection = single ? VTKI_MAP_SINGLE : VTKI_MAP_FACES;
    // A spot of less than 90 degrees has no face that looks backward.
    this->NumberOfFaces = single ? 1 : (omnidirectional ? 6 : 5);
    this->HalfWidth = aimed ? tangent : cone;
    FitDepths(*this, lower, upper);
  }

  const glm::dvec3 eye = light.Positional ? light.PositionWC : frame.ToWorld(place);
  this->WorldToLight = glm::dmat4(glm::transpose(axes));
  this->WorldToLight[3] = glm::dvec4(-(glm::transpose(axes) * eye), 1.0);
  for (int face = 0; face < this->NumberOfFaces; ++face)
  {
    this->Faces[face] = MakeFace(*this, axes, place, face);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectLightMap::FitDepths(
  vtkIndirectShadowMap& map, const glm::dvec3& lower, const glm::dvec3& upper, double radius)
{
  if (map.Projection == vtkIndirectKernels::VTKI_MAP_SINGLE)
  {
    map.Far = -lower.z + radius;
    map.Near = -upper.z - radius;
  }
  else
  {
    const glm::dvec3 most = glm::max(-lower, upper);
    map.Far = std::max({ most.x, most.y, most.z }) + radius;
    // The nearest depth at which any face may find a caster along its own axis.
    const glm::dvec3 outside = glm::max(glm::max(lower, -upper), glm::dvec3(0.0));
    map.Near = std::max({ outside.x, outside.y, outside.z }) - radius;
  }
  // If all casters lie behind a spot its map is empty, and any range will do.
  map.Far = map.Far > 0.0 ? 1.001 * map.Far : 1.0;
  map.Near = std::min(std::max(0.999 * map.Near, NearestFraction * map.Far), 0.5 * map.Far);
}

//------------------------------------------------------------------------------
vtkIndirectDepthTile vtkIndirectLightMap::MakeFace(
  const vtkIndirectShadowMap& map, const glm::dmat3& axes, const glm::dvec3& place, int face)
{
  using namespace vtkIndirectKernels;
  glm::dmat3 toFace;
  for (int i = 0; i < 3; ++i)
  {
    glm::vec3 axis(0.0f);
    axis[i] = 1.0f;
    toFace[i] = glm::dvec3(vtkiToFace(axis, face));
  }
  const glm::dmat3 turned = axes * glm::transpose(toFace);
  vtkIndirectDepthTile view;
  view.Parallel = map.Projection == VTKI_MAP_PARALLEL;
  view.Place = place;
  view.Right = turned[0];
  view.Up = turned[1];
  view.Forward = -turned[2];
  view.HalfWidth = glm::dvec2(map.HalfWidth);
  view.Near = map.Near;
  view.Far = map.Far;
  return view;
}

//------------------------------------------------------------------------------
double vtkIndirectLightMap::FindTexelAt(const glm::dvec3& place, int texels) const
{
  return 2.0 * this->HalfWidth / texels *
    (this->Light.Positional ? glm::distance(place, this->Light.PositionWC)
                            : 1.0 / this->SceneScale);
}

//------------------------------------------------------------------------------
void vtkIndirectLightMap::AppendTo(vtkIndirectKey& key) const
{
  key.Add("projection", this->Projection).Add("layer", this->FirstLayer);
  key.Add("projection", this->HalfWidth).Add("projection", this->Near);
  key.Add("projection", this->Far).Add("scene units", this->SceneScale);
  key.Add("placement", this->WorldToLight);
}
