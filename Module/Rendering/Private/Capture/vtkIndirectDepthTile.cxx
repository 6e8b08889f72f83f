// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/vtkIndirectDepthTile.h"

#include "Capture/vtkIndirectFootprint.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLCamera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <vector>

namespace
{
glm::dvec3 ToScene(const vtkIndirectFrame& frame, const double bounds[6], int corner)
{
  return frame.ToScene(vtkIndirectFrame::GetCorner(bounds, corner));
}

// Makes two axes across a unit vector, with the same rounding as in shaders.
void FrameAlong(const glm::dvec3& n, glm::dvec3& x, glm::dvec3& y)
{
  glm::vec3 first;
  glm::vec3 second;
  vtkIndirectKernels::vtkiFrameAlong(glm::vec3(n), first, second);
  x = first;
  y = second;
}

// Returns the matrix to clip coordinates, of lengths that are scene units over a scale.
glm::dmat4 MakeProjection(const vtkIndirectDepthTile& view, double scale)
{
  const double nearPlane = view.Near / scale;
  const double farPlane = view.Far / scale;
  const double depth = farPlane - nearPlane;
  const glm::dvec2 halfWidth = view.Parallel ? view.HalfWidth / scale : view.HalfWidth;
  glm::dmat4 projection(0.0);
  projection[0][0] = 1.0 / halfWidth.x;
  projection[1][1] = 1.0 / halfWidth.y;
  projection[2][0] = view.Parallel ? 0.0 : view.Middle.x / halfWidth.x;
  projection[2][1] = view.Parallel ? 0.0 : view.Middle.y / halfWidth.y;
  projection[2][2] = -(view.Parallel ? 2.0 : farPlane + nearPlane) / depth;
  projection[3][2] = -(view.Parallel ? farPlane + nearPlane : 2.0 * farPlane * nearPlane) / depth;
  projection[2][3] = view.Parallel ? 0.0 : -1.0;
  projection[3][3] = view.Parallel ? 1.0 : 0.0;
  return projection;
}

// A caster that lies in a plane across an axis: it hides nothing of itself.
struct FlatCaster
{
  size_t Number;
  int Axis;
  double Area; // world units squared
};

// Finds the largest flat casters; further ones are not worth the tests of all pairs.
std::vector<FlatCaster> FindFlat(const vtkIndirectFrame& frame)
{
  constexpr size_t most = 16;
  const double flat = 1e-6 / frame.SceneScale;
  std::vector<FlatCaster> found;
  for (size_t i = 0; i < frame.Casters.size(); ++i)
  {
    const double* const b = frame.Casters[i].Bounds;
    const double size[3] = { b[1] - b[0], b[3] - b[2], b[5] - b[4] };
    const int axis = static_cast<int>(std::min_element(size, size + 3) - size);
    if (size[axis] <= flat)
    {
      found.push_back({ i, axis, size[(axis + 1) % 3] * size[(axis + 2) % 3] });
    }
  }
  std::stable_sort(found.begin(), found.end(),
    [](const FlatCaster& a, const FlatCaster& b) { return a.Area > b.Area; });
  // resize() could grow the list, which GCC 16 warns of.
  found.erase(found.begin() + std::min(found.size(), most), found.end());
  return found;
}

// Returns true if a flat caster keeps none of this light from another caster: the other one lies on
// the lit side of its plane.
bool LeavesLit(
  const vtkIndirectFrame& frame, const FlatCaster& flat, size_t other, const glm::dvec3& toLight)
{
  const int axis = flat.Axis;
  const double* const plane = frame.Casters[flat.Number].Bounds + 2 * axis;
  const double* const bounds = frame.Casters[other].Bounds + 2 * axis;
  const double along = toLight[axis];
  return along == 0.0 || (along > 0.0 ? bounds[0] >= plane[0] : bounds[1] <= plane[1]);
}

// Marks the casters that may reach beyond the tile.
std::vector<char> FindOutlying(const vtkIndirectFrame& frame, const glm::dvec3& toLight)
{
  std::vector<char> outlying(frame.Casters.size(), 0);
  std::vector<FlatCaster> chosen;
  for (const FlatCaster& flat : FindFlat(frame))
  {
    const bool fits = std::all_of(chosen.begin(), chosen.end(),
      [&](const FlatCaster& other)
      {
        return LeavesLit(frame, flat, other.Number, toLight) &&
          LeavesLit(frame, other, flat.Number, toLight);
      });
    if (fits)
    {
      chosen.push_back(flat);
      outlying[flat.Number] = 1;
    }
  }
  // The tile must be fitted to at least one caster.
  if (chosen.size() == frame.Casters.size())
  {
    std::fill(outlying.begin(), outlying.end(), char{ 0 });
  }
  return outlying;
}
}

//------------------------------------------------------------------------------
vtkIndirectDepthTile vtkIndirectDepthTile::FromPlace(
  const glm::dvec3& place, const glm::dvec3& normal)
{
  using namespace vtkIndirectKernels;
  vtkIndirectDepthTile tile;
  tile.Place = place;
  tile.Forward = normal;
  // Seen along the normal, the second axis is to the right of the first one.
  FrameAlong(normal, tile.Up, tile.Right);
  tile.HalfWidth = glm::dvec2(VTKI_TILE_TANGENT);
  tile.Near = tile.StripNear = VTKI_TILE_NEAR;
  tile.Far = tile.StripFar = VTKI_TILE_FAR;
  const double height = 1.0 / VTKI_TILE_TANGENT;
  tile.Strips.fill({ glm::dvec2(1.0, 0.5 * height), glm::dvec2(0.0, 0.5 * height) });
  return tile;
}

//------------------------------------------------------------------------------
vtkIndirectDepthTile vtkIndirectDepthTile::GetView(int view) const
{
  vtkIndirectDepthTile tile = *this;
  tile.Strips.fill({});
  if (view > 0)
  {
    const Strip& strip = this->Strips[static_cast<size_t>(view - 1)];
    const glm::dvec3 axis = view < 3 ? this->Right : this->Up;
    tile.Forward = view % 2 == 1 ? axis : -axis;
    tile.Up = this->Forward;
    tile.Right = glm::cross(tile.Forward, tile.Up);
    tile.HalfWidth = strip.HalfWidth;
    tile.Middle = strip.Middle;
    tile.Near = this->StripNear;
    tile.Far = this->StripFar;
  }
  return tile;
}

//------------------------------------------------------------------------------
glm::ivec2 vtkIndirectDepthTile::GetSizeOfView(int view, int texels)
{
  const glm::vec2 half = vtkIndirectKernels::vtkiHalfOfView(view - 1, static_cast<float>(texels));
  return glm::ivec2(2.0f * half);
}

//------------------------------------------------------------------------------
glm::ivec2 vtkIndirectDepthTile::GetPlaceOfView(int view, int texels, bool strips)
{
  using namespace vtkIndirectKernels;
  const float edge = static_cast<float>(texels);
  const glm::vec2 middle(0.5f * edge, (strips ? 0.5f + VTKI_TILE_STRIPS : 0.5f) * edge);
  return glm::ivec2(middle + vtkiPlaceOfView(view - 1, edge) - vtkiHalfOfView(view - 1, edge));
}

//------------------------------------------------------------------------------
vtkIndirectDepthTile vtkIndirectDepthTile::FromDirection(
  const vtkIndirectFrame& frame, const glm::dvec3& toLight, const vtkIndirectSeenBox& receivers)
{
  vtkIndirectDepthTile tile;
  tile.Parallel = true;
  tile.Forward = -toLight;
  FrameAlong(toLight, tile.Right, tile.Up);
  const glm::dmat3 axes(tile.GetToScene());
  const std::vector<glm::dvec3> corners = frame.FindCorners(axes, tile.Place);
  glm::dvec3 lower(std::numeric_limits<double>::infinity());
  glm::dvec3 upper = -lower;
  const std::vector<char> outlying = FindOutlying(frame, toLight);
  for (size_t i = 0; i < corners.size(); ++i)
  {
    // Depths cover all casters: an outlying one is drawn within the tile.
    for (int axis = outlying[i / 8] ? 2 : 0; axis < 3; ++axis)
    {
      lower[axis] = std::min(lower[axis], corners[i][axis]);
      upper[axis] = std::max(upper[axis], corners[i][axis]);
    }
  }
  for (int axis = 0; receivers.IsPart() && axis < 2; ++axis)
  {
    const double middle = glm::dot(axes[axis], receivers.Middle - tile.Place);
    const double reach = receivers.FindReach(axes[axis]);
    lower[axis] = glm::clamp(lower[axis], middle - reach, middle + reach);
    upper[axis] = glm::clamp(upper[axis], middle - reach, middle + reach);
  }
  // A margin keeps the outermost points off the edge, and a flat scene gets an extent, too.
  constexpr double margin = 1.01;
  const glm::dvec3 half = glm::max(0.5 * margin * (upper - lower), glm::dvec3(1e-3));
  const glm::dvec3 middle = 0.5 * (lower + upper);
  tile.HalfWidth = glm::dvec2(half);
  tile.Far = 2.0 * half.z;
  tile.Place = axes * (middle + glm::dvec3(0.0, 0.0, half.z));
  return tile;
}

//------------------------------------------------------------------------------
vtkIndirectDepthTile vtkIndirectDepthTile::FromUnits(
  double scale, const glm::dvec3& center, const vtkIndirectFrame& frame) const
{
  vtkIndirectDepthTile tile = *this;
  const double ratio = frame.SceneScale / scale;
  tile.Place = (this->Place / scale + (center - frame.SceneCenter)) * frame.SceneScale;
  tile.HalfWidth *= ratio;
  tile.Near *= ratio;
  tile.Far *= ratio;
  return tile;
}

//------------------------------------------------------------------------------
unsigned int vtkIndirectDepthTile::FindViews(
  const vtkIndirectFrame& frame, const double bounds[6], int texels) const
{
  std::array<glm::dvec3, 8> corners;
  vtkIndirectFootprint footprint;
  bool within = true; // the widest view ahead holds the bounds
  bool behind = true;
  const double limit = vtkIndirectKernels::VTKI_TILE_TANGENT;
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec3 p = this->ToView(ToScene(frame, bounds, i));
    corners[static_cast<size_t>(i)] = p;
    footprint.Add(glm::dvec2(p) - this->Middle * p.z,
      this->HalfWidth * (this->Parallel ? 1.0 : p.z), p.z < this->Near);
    within = within && std::max(std::abs(p.x), std::abs(p.y)) < limit * p.z;
    behind = behind && p.z <= 0.0;
  }
  unsigned int views = footprint.IsHeld(glm::dvec2(texels)) ? 1u : 0u;
  for (int view = 1; view < NumberOfViews && !within && !behind; ++view)
  {
    const Strip& strip = this->Strips[static_cast<size_t>(view - 1)];
    if (strip.HalfWidth.x <= 0.0)
    {
      continue;
    }
    // The axes are those of GetView.
    const int to = view < 3 ? 0 : 1;
    const double sign = view % 2 == 1 ? 1.0 : -1.0;
    vtkIndirectFootprint beside;
    for (const glm::dvec3& p : corners)
    {
      const double depth = sign * p[to];
      const glm::dvec2 place((to == 0 ? sign : -sign) * p[1 - to], p.z);
      beside.Add(place - strip.Middle * depth, strip.HalfWidth * depth, depth < this->StripNear);
    }
    views |= beside.IsHeld(glm::dvec2(GetSizeOfView(view, texels))) ? 1u << view : 0u;
  }
  return views;
}

//------------------------------------------------------------------------------
double vtkIndirectDepthTile::FindTexelAt(
  const vtkIndirectFrame& frame, const double bounds[6], const glm::dvec2& texels) const
{
  const glm::dvec2 widths = 2.0 * this->HalfWidth / texels;
  const double width = std::min(widths.x, widths.y);
  if (this->Parallel)
  {
    return width / frame.SceneScale;
  }
  // The part of the bounds that the tile sees is no nearer along its axis than the nearest corner,
  // and no nearer than `least`, which follows from the distance to the bounds.
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 8; ++i)
  {
    nearest = std::min(nearest, this->ToView(ToScene(frame, bounds, i)).z);
  }
  const glm::dvec3 lower = ToScene(frame, bounds, 0);
  const glm::dvec3 upper = ToScene(frame, bounds, 7);
  const double away = glm::length(glm::clamp(this->Place, lower, upper) - this->Place);
  const glm::dvec2 widest = glm::abs(this->Middle) + this->HalfWidth;
  const double least = away / std::sqrt(1.0 + glm::dot(widest, widest));
  return width * std::max({ nearest, least, this->Near }) / frame.SceneScale;
}

//------------------------------------------------------------------------------
glm::dmat4 vtkIndirectDepthTile::GetWorldToClip(const vtkIndirectFrame& frame) const
{
  const glm::dmat3 rotation = glm::transpose(glm::dmat3(this->GetToScene())) * frame.SceneScale;
  glm::dmat4 view(rotation);
  view[3] = glm::dvec4(-(rotation * frame.ToWorld(this->Place)), 1.0);
  return MakeProjection(*this, 1.0) * view;
}

//------------------------------------------------------------------------------
void vtkIndirectDepthTile::SetUp(vtkOpenGLCamera* camera, const vtkIndirectFrame& frame) const
{
  const double n = this->Near / frame.SceneScale;
  const double f = this->Far / frame.SceneScale;
  const glm::dvec3 position = frame.ToWorld(this->Place);
  // VTK stores the direction as a difference of points: far from the origin it needs a long one.
  const glm::dvec3 focal = position + this->Forward * f;
  camera->SetPosition(position.x, position.y, position.z);
  camera->SetFocalPoint(focal.x, focal.y, focal.z);
  camera->SetViewUp(this->Up.x, this->Up.y, this->Up.z);
  // Mappers put this flag into the key of their shader source: a map that changed it would rebuild
  // every actor's source twice a frame. The projection itself is set below.
  camera->SetParallelProjection(frame.Parallel ? 1 : 0);
  camera->SetClippingRange(std::max(n, 1e-6 * f), f);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(glm::value_ptr(glm::transpose(MakeProjection(*this, frame.SceneScale))));
  camera->SetExplicitProjectionTransformMatrix(matrix);
  camera->UseExplicitProjectionTransformMatrixOn();
  camera->Modified();
}

//------------------------------------------------------------------------------
bool vtkIndirectDepthTile::operator==(const vtkIndirectDepthTile& other) const
{
  return this->Parallel == other.Parallel && this->Place == other.Place &&
    this->Forward == other.Forward && this->HalfWidth == other.HalfWidth &&
    this->Middle == other.Middle && this->Near == other.Near && this->Far == other.Far &&
    this->Strips == other.Strips && this->StripNear == other.StripNear &&
    this->StripFar == other.StripFar;
}
