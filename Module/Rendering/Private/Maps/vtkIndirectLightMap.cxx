// SPDX-License-Identifier: BSD-3-Clause
#include "Maps/vtkIndirectLightMap.h"
#include "OpenGL/vtkIndirectKey.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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

// Texels of a shadow are at most this many pixels wide where that is possible.
constexpr double WidestTexel = 1.5;
// A window is worth drawing if it halves the texels of half of the picture, or does as much.
constexpr double LeastGain = 0.5;
constexpr size_t FewestPlaces = 64;

// A place that the eye sees, in a map, and the width of a texel that suffices there.
struct SeenTexel
{
  glm::dvec2 At;
  double Width;
};

// Returns a window that holds the first places and is no finer than they need.
vtkIndirectShadowMap::WindowType FindWindow(
  const std::vector<SeenTexel>& seen, size_t count, double halfWidth, int texels, double share)
{
  glm::dvec2 lower = seen.front().At;
  glm::dvec2 upper = lower;
  for (size_t i = 0; i < count; ++i)
  {
    lower = glm::min(lower, seen[i].At);
    upper = glm::max(upper, seen[i].At);
  }
  const glm::dvec2 half = 0.5 * (upper - lower);
  // Half of the finest texels that any place needs.
  const double least = 0.25 * texels * seen.front().Width;
  vtkIndirectShadowMap::WindowType window;
  const double needed = std::max(half.x, half.y);
  for (int axis = 0; axis < 2; ++axis)
  {
    // Both axes have the longer one's length.
    const double middle = 0.5 * (lower[axis] + upper[axis]);
    const vtkIndirectInterval held =
      vtkIndirectInterval::Find(middle - needed, middle + needed, halfWidth, least, share);
    window.Middle[axis] = held.Middle;
    window.HalfWidth = held.Half;
  }
  return window;
}

// Returns by how many halvings of a texel's width a window helps, in sum over all places.
double FindGain(const std::vector<SeenTexel>& seen, const vtkIndirectShadowMap::WindowType& window,
  double halfWidth, int texels)
{
  double gain = 0.0;
  for (const SeenTexel& place : seen)
  {
    const glm::dvec2 beside = glm::abs(place.At - window.Middle);
    if (std::max(beside.x, beside.y) < window.HalfWidth)
    {
      gain += std::log2(std::max(2.0 * halfWidth / texels, place.Width) /
        std::max(2.0 * window.HalfWidth / texels, place.Width));
    }
  }
  return gain;
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
void vtkIndirectLightMap::FitWindow(const vtkIndirectFrame& frame, int texels, double share)
{
  this->Window = {};
  if (this->Projection == vtkIndirectKernels::VTKI_MAP_FACES)
  {
    return;
  }
  std::vector<SeenTexel> seen;
  for (const vtkIndirectSeen::Place& place : frame.Seen.Places)
  {
    const glm::dvec3 p = this->Faces[0].ToView(place.At);
    const double scale = this->Light.Positional ? p.z : 1.0;
    const glm::dvec2 at = glm::dvec2(p) / scale;
    if (scale > 0.0 && std::max(std::abs(at.x), std::abs(at.y)) <= this->HalfWidth)
    {
      seen.push_back({ at, WidestTexel * place.Pixel / scale });
    }
  }
  std::stable_sort(seen.begin(), seen.end(),
    [](const SeenTexel& a, const SeenTexel& b) { return a.Width < b.Width; });
  double most = LeastGain * static_cast<double>(seen.size());
  // A window of the places with the finest pixels is finer than a window of all places.
  for (size_t count = seen.size(); count >= FewestPlaces; count /= 2)
  {
    const WindowType window = FindWindow(seen, count, this->HalfWidth, texels, share);
    const double gain = FindGain(seen, window, this->HalfWidth, texels);
    if (gain > most)
    {
      most = gain;
      this->Window = window;
    }
  }
}

//------------------------------------------------------------------------------
vtkIndirectDepthTile vtkIndirectLightMap::GetView(int face) const
{
  if (face < this->NumberOfFaces)
  {
    return this->Faces[face];
  }
  vtkIndirectDepthTile view = this->Faces[0];
  const glm::dvec2& middle = this->Window.Middle;
  view.HalfWidth = glm::dvec2(this->Window.HalfWidth);
  if (view.Parallel)
  {
    view.Place += middle.x * view.Right + middle.y * view.Up;
  }
  else
  {
    view.Middle = middle;
  }
  return view;
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
  const glm::dvec3 p = glm::dvec3(this->WorldToLight * glm::dvec4(place, 1.0)) * this->SceneScale;
  const glm::dvec2 beside =
    glm::abs(glm::dvec2(p) / (this->Light.Positional ? -p.z : 1.0) - this->Window.Middle);
  const bool inWindow = std::max(beside.x, beside.y) < this->Window.HalfWidth;
  return 2.0 * (inWindow ? this->Window.HalfWidth : this->HalfWidth) / texels *
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
