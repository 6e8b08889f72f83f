// SPDX-License-Identifier: BSD-3-Clause
#include "Maps/vtkIndirectCasterWindow.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <algorithm>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <set>
#include <utility>

namespace
{
// Largest number of points of a mesh that is tested for convexity: a box has 24 points, and each
// cell is tested with all points.
constexpr vtkIdType MostPoints = 128;

// The sides of a cell's plane on which points lie, beyond a tolerance for rounding.
struct Sides
{
  bool Before = false;
  bool Behind = false;
};

Sides FindSides(vtkPoints* points, const vtkIdType* ids, vtkIdType size, double tolerance)
{
  const glm::dvec3 first = glm::make_vec3(points->GetPoint(ids[0]));
  glm::dvec3 normal(0.0);
  for (vtkIdType i = 1; i + 1 < size; ++i)
  {
    const glm::dvec3 a = glm::make_vec3(points->GetPoint(ids[i])) - first;
    const glm::dvec3 b = glm::make_vec3(points->GetPoint(ids[i + 1])) - first;
    normal += glm::cross(a, b);
  }
  const double length = glm::length(normal);
  Sides sides;
  for (vtkIdType i = 0; length > 0.0 && i < points->GetNumberOfPoints(); ++i)
  {
    const double height = glm::dot(glm::make_vec3(points->GetPoint(i)) - first, normal) / length;
    sides.Before = sides.Before || height > tolerance;
    sides.Behind = sides.Behind || height < -tolerance;
  }
  return sides;
}

// Adds each edge of a cell that is not in the set, and removes each edge that is. A closed surface
// leaves none.
void FlipEdges(vtkPoints* points, const vtkIdType* ids, vtkIdType size,
  std::set<std::pair<std::array<double, 3>, std::array<double, 3>>>& edges)
{
  for (vtkIdType i = 0; i < size; ++i)
  {
    std::array<double, 3> a;
    std::array<double, 3> b;
    points->GetPoint(ids[i], a.data());
    points->GetPoint(ids[(i + 1) % size], b.data());
    const auto edge = std::minmax(a, b);
    if (!edges.insert(edge).second)
    {
      edges.erase(edge);
    }
  }
}

std::array<glm::dvec3, 8> ToBox(const vtkIndirectFrame& frame, const double bounds[6])
{
  std::array<glm::dvec3, 8> box;
  for (int i = 0; i < 8; ++i)
  {
    box[i] = frame.ToScene(vtkIndirectFrame::GetCorner(bounds, i));
  }
  return box;
}

bool IsNamed(vtkObjectBase* object, const char* name)
{
  return object && std::strcmp(object->GetClassName(), name) == 0;
}

// The two smallest places at which casters' bounds begin, along an axis or against it.
struct Least
{
  double First = std::numeric_limits<double>::infinity();
  double Second = std::numeric_limits<double>::infinity();

  void Add(double place)
  {
    this->Second = std::min(this->Second, std::max(this->First, place));
    this->First = std::min(this->First, place);
  }
  double GetOfOthers(double own) const { return own == this->First ? this->Second : this->First; }
};

// FindBegin returns where bounds begin along the inward axis of a face of a box, FindEnd where they
// end.
double FindBegin(const double bounds[6], int face)
{
  return face % 2 == 0 ? bounds[face] : -bounds[face];
}
double FindEnd(const double bounds[6], int face)
{
  return face % 2 == 0 ? bounds[face + 1] : -bounds[face - 1];
}
}

//------------------------------------------------------------------------------
bool vtkIndirectCasterWindow::IsConvex(vtkProp* prop)
{
  // Other classes may draw something else than their input.
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* mapper = actor ? vtkPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  vtkPolyData* mesh = IsNamed(actor, "vtkOpenGLActor") && IsNamed(mapper, "vtkOpenGLPolyDataMapper")
    ? mapper->GetInput()
    : nullptr;
  if (!mesh || !mesh->GetPoints() || mesh->GetNumberOfPoints() > MostPoints ||
    mesh->GetNumberOfPolys() == 0 || mesh->GetNumberOfPolys() != mesh->GetNumberOfCells())
  {
    return false;
  }
  const double tolerance = 1e-5 * mesh->GetLength();
  vtkCellArray* cells = mesh->GetPolys();
  vtkNew<vtkIdList> ids;
  std::set<std::pair<std::array<double, 3>, std::array<double, 3>>> edges;
  bool flat = true;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, ids);
    const vtkIdType size = ids->GetNumberOfIds();
    if (size < 3)
    {
      return false;
    }
    const Sides sides = FindSides(mesh->GetPoints(), ids->GetPointer(0), size, tolerance);
    if (sides.Before && sides.Behind)
    {
      return false;
    }
    flat = flat && !sides.Before && !sides.Behind;
    FlipEdges(mesh->GetPoints(), ids->GetPointer(0), size, edges);
  }
  return flat || edges.empty();
}

//------------------------------------------------------------------------------
bool vtkIndirectCasterWindow::Update(
  const vtkIndirectFrame& frame, const std::vector<glm::dvec3>& corners)
{
  std::array<Least, 6> least;        // of casters
  std::array<double, 6> cornerBegin; // where the polygon begins
  for (int face = 0; face < 6; ++face)
  {
    for (const vtkIndirectCaster& caster : frame.Casters)
    {
      least[face].Add(FindBegin(caster.GetFit(), face));
    }
    cornerBegin[face] = std::numeric_limits<double>::infinity();
    for (const glm::dvec3& corner : corners)
    {
      const double place = frame.ToWorld(corner)[face / 2];
      cornerBegin[face] = std::min(cornerBegin[face], face % 2 == 0 ? place : -place);
    }
  }
  const double tolerance = 1e-6 / frame.SceneScale;
  std::vector<Box> boxes;
  for (size_t k = 0; k < frame.Casters.size(); ++k)
  {
    const double* const fit = frame.Casters[k].GetFit();
    bool apart = false;
    for (int face = 0; face < 6 && !apart; ++face)
    {
      const double end = FindEnd(fit, face) - tolerance;
      apart = cornerBegin[face] >= end && least[face].GetOfOthers(FindBegin(fit, face)) >= end;
    }
    if (apart && IsConvex(frame.Casters[k].Prop))
    {
      continue;
    }
    boxes.push_back(ToBox(frame, fit));
  }
  const Box all = ToBox(frame, frame.SceneBounds);
  const bool same = boxes == this->Boxes && all == this->All;
  this->Boxes = std::move(boxes);
  this->All = all;
  return !same;
}

//------------------------------------------------------------------------------
// Finds the part of a view within tangents `least` to `most` that boxes cover; the part is empty
// where no box is in view.
vtkIndirectCasterWindow::Part vtkIndirectCasterWindow::FindPart(
  const vtkIndirectDepthTile& view, const glm::dvec2& least, const glm::dvec2& most) const
{
  const double nearPlane = vtkIndirectKernels::VTKI_WINDOW_NEAR;
  Part all;
  for (const Box& box : this->Boxes)
  {
    Part part;
    Box seen;
    std::transform(box.begin(), box.end(), seen.begin(),
      [&view](const glm::dvec3& corner) { return view.ToView(corner); });
    auto add = [&](const glm::dvec3& p)
    {
      const glm::dvec2 tangents = glm::dvec2(p) / p.z;
      part.Lower = glm::min(part.Lower, tangents);
      part.Upper = glm::max(part.Upper, tangents);
      part.Nearest = std::min(part.Nearest, p.z);
    };
    for (size_t i = 0; i < 8; ++i)
    {
      if (seen[i].z >= nearPlane)
      {
        add(seen[i]);
      }
      // Adds the points at which edges cross the near plane.
      for (const size_t bit : { size_t(1), size_t(2), size_t(4) })
      {
        const glm::dvec3& a = seen[i];
        const glm::dvec3& b = seen[i ^ bit];
        if (a.z < nearPlane && b.z > nearPlane)
        {
          add(glm::mix(a, b, (nearPlane - a.z) / (b.z - a.z)));
        }
      }
    }
    // A box that only touches the view's border, such as the wall that a light is set into, is not
    // in view.
    constexpr double touch = 1e-6;
    const bool held = part.Lower.x < most.x - touch && part.Lower.y < most.y - touch &&
      part.Upper.x > least.x + touch && part.Upper.y > least.y + touch && !part.IsEmpty();
    if (held)
    {
      all.Add(part);
    }
  }
  return all;
}

//------------------------------------------------------------------------------
vtkIndirectDepthTile::Strip vtkIndirectCasterWindow::ToWindow(
  const Part& part, const glm::dvec2& least, const glm::dvec2& most)
{
  // A margin keeps the outermost points off the edge, and a thin part gets an extent, too.
  constexpr double margin = 0.005;
  const glm::dvec2 room = glm::max(margin * (part.Upper - part.Lower), glm::dvec2(1e-3));
  const glm::dvec2 lower = glm::max(part.Lower - room, least);
  const glm::dvec2 upper = glm::min(part.Upper + room, most);
  return { 0.5 * (upper - lower), 0.5 * (lower + upper) };
}

//------------------------------------------------------------------------------
void vtkIndirectCasterWindow::Fit(const std::vector<vtkIndirectDepthTile*>& tiles) const
{
  const double limit = vtkIndirectKernels::VTKI_WINDOW_TANGENT;
  const double nearPlane = vtkIndirectKernels::VTKI_WINDOW_NEAR;
  constexpr double none = std::numeric_limits<double>::infinity();
  const glm::dvec2 most(limit);
  const glm::dvec2 leastOfStrip(-1.0, 0.0);
  const glm::dvec2 mostOfStrip(1.0, 1.0 / limit);
  double nearest = none;
  double farthest = 2.0 * nearPlane;
  double nearestOfStrips = none;
  double farthestOfStrips = 2.0 * nearPlane;
  std::array<Part, 4> parts;
  for (vtkIndirectDepthTile* tile : tiles)
  {
    Part ahead = this->FindPart(tile->GetView(0), -most, most);
    nearest = std::min(nearest, ahead.Nearest);
    if (ahead.IsEmpty())
    {
      // No caster hides anything ahead: any view will do.
      ahead.Lower = ahead.Upper = glm::dvec2(0.0);
    }
    const vtkIndirectDepthTile::Strip window = ToWindow(ahead, -most, most);
    tile->HalfWidth = window.HalfWidth;
    tile->Middle = window.Middle;
    for (const glm::dvec3& corner : this->All)
    {
      farthest = std::max(farthest, tile->ToView(corner).z);
      farthestOfStrips = std::max(farthestOfStrips, glm::length(corner - tile->Place));
    }
    for (size_t k = 0; k < parts.size(); ++k)
    {
      const Part part =
        this->FindPart(tile->GetView(static_cast<int>(k) + 1), leastOfStrip, mostOfStrip);
      parts[k].Add(part);
      nearestOfStrips = std::min(nearestOfStrips, part.Nearest);
    }
  }
  // Half of the distance leaves room for rounding.
  auto begin = [nearPlane](double place, double end)
  { return std::max(std::min(0.5 * place, 0.5 * end), nearPlane); };
  for (vtkIndirectDepthTile* tile : tiles)
  {
    tile->Far = 1.01 * farthest;
    tile->Near = begin(nearest, tile->Far);
    tile->StripFar = 1.01 * farthestOfStrips;
    tile->StripNear = begin(nearestOfStrips, tile->StripFar);
    for (size_t k = 0; k < parts.size(); ++k)
    {
      tile->Strips[k] = parts[k].IsEmpty() ? vtkIndirectDepthTile::Strip()
                                           : ToWindow(parts[k], leastOfStrip, mostOfStrip);
    }
  }
}
