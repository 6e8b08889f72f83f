// SPDX-License-Identifier: BSD-3-Clause
#include "Proxies/vtkIndirectProxyShapes.h"

#include "Scene/vtkIndirectTriangles.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataAlgorithm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace
{
// Largest deviation of a sphere's points from its surface over the radius, and their least number:
// 8 points of a cube would pass, too.
constexpr double Roundness = 1e-3;
constexpr vtkIdType LeastPoints = 14;
// Largest distance of a flat mesh's points from their plane, over its size.
constexpr double Flatness = 1e-4;
// Area that may be missing inside a flat mesh's outline; and its number of corners: from a rounder
// outline this many are chosen and moved outwards until the area matches.
constexpr double MissingArea = 1e-3;
constexpr size_t MostCorners = 8;
// Class that fits spheres to meshes, in an optional module: it registers itself by this name.
const char* const FilterName = "vtkSphereProxyFilter";

glm::dvec3 GetPoint(vtkPolyData* mesh, vtkIdType i)
{
  double p[3];
  mesh->GetPoint(i, p);
  return { p[0], p[1], p[2] };
}

// Returns twice the area of a triangle, along its normal.
glm::dvec3 FindCross(vtkPolyData* mesh, const vtkIndirectTriangles::Points& points)
{
  const glm::dvec3 a = GetPoint(mesh, points[0]);
  return glm::cross(GetPoint(mesh, points[1]) - a, GetPoint(mesh, points[2]) - a);
}

// Fits the least-squares sphere through points: |p|^2 = 2 p c + k about their mean.
bool FitSphere(
  vtkPolyData* mesh, const vtkIdType* points, size_t count, vtkIndirectProxySphere& sphere)
{
  glm::dvec3 mean(0.0);
  for (size_t i = 0; i < count; ++i)
  {
    mean += GetPoint(mesh, points[i]);
  }
  mean /= static_cast<double>(count);
  glm::dmat3 left(0.0);
  glm::dvec3 right(0.0);
  double squares = 0.0;
  for (size_t i = 0; i < count; ++i)
  {
    const glm::dvec3 p = GetPoint(mesh, points[i]) - mean;
    left += glm::outerProduct(p, p);
    right += glm::dot(p, p) * p;
    squares += glm::dot(p, p);
  }
  const double size = squares / static_cast<double>(count);
  if (!(size > 0.0) || !(glm::determinant(left / squares) > 1e-4)) // a sphere has 1/27
  {
    return false;
  }
  const glm::dvec3 offset = 0.5 * (glm::inverse(left) * right);
  const double radius = std::sqrt(size + glm::dot(offset, offset));
  for (size_t i = 0; i < count; ++i)
  {
    const double distance = glm::length(GetPoint(mesh, points[i]) - mean - offset);
    if (!(std::abs(distance - radius) <= Roundness * radius))
    {
      return false;
    }
  }
  sphere.Center = mean + offset;
  sphere.Radius = radius;
  return true;
}

double FindArea(const std::vector<glm::dvec2>& outline)
{
  double twice = 0.0;
  for (size_t i = 0; i < outline.size(); ++i)
  {
    const glm::dvec2& a = outline[i];
    const glm::dvec2& b = outline[(i + 1) % outline.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

// Returns the convex hull, counterclockwise (Andrew's monotone chain).
std::vector<glm::dvec2> FindHull(std::vector<glm::dvec2> points)
{
  std::sort(points.begin(), points.end(),
    [](const glm::dvec2& a, const glm::dvec2& b)
    { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<glm::dvec2> hull;
  for (int half = 0; half < 2; ++half)
  {
    const size_t start = hull.size();
    for (const glm::dvec2& p : points)
    {
      while (hull.size() >= start + 2)
      {
        const glm::dvec2 a = hull[hull.size() - 1] - hull[hull.size() - 2];
        const glm::dvec2 b = p - hull[hull.size() - 2];
        if (a.x * b.y - a.y * b.x > 1e-5 * glm::length(a) * glm::length(b)) // points are floats
        {
          break;
        }
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}
}

//------------------------------------------------------------------------------
// Finds connected pieces of the mesh, each a sphere.
bool vtkIndirectProxyShapes::FindSpheres(vtkPolyData* mesh, Shape& shape)
{
  const size_t count = static_cast<size_t>(mesh->GetNumberOfPoints());
  std::vector<vtkIdType> piece(count);
  for (size_t i = 0; i < count; ++i)
  {
    piece[i] = static_cast<vtkIdType>(i);
  }
  auto find = [&piece](vtkIdType i)
  {
    while (piece[static_cast<size_t>(i)] != i)
    {
      vtkIdType& parent = piece[static_cast<size_t>(i)];
      parent = piece[static_cast<size_t>(parent)];
      i = parent;
    }
    return i;
  };
  std::vector<vtkIdType> cellOf(count, -1); // any cell of each point
  vtkIndirectTriangles::ForEach(mesh,
    [&](vtkIdType cell, const vtkIndirectTriangles::Points& points)
    {
      for (const vtkIdType point : points)
      {
        cellOf[static_cast<size_t>(point)] = cell;
        piece[static_cast<size_t>(find(point))] = find(points[0]);
      }
    });
  std::vector<std::pair<vtkIdType, vtkIdType>> members; // piece and point
  for (size_t i = 0; i < count; ++i)
  {
    if (cellOf[i] >= 0)
    {
      members.emplace_back(find(static_cast<vtkIdType>(i)), static_cast<vtkIdType>(i));
    }
  }
  std::sort(members.begin(), members.end());
  std::vector<vtkIdType> points;
  for (size_t first = 0; first < members.size();)
  {
    size_t end = first;
    points.clear();
    while (end < members.size() && members[end].first == members[first].first)
    {
      points.push_back(members[end++].second);
    }
    vtkIndirectProxySphere sphere;
    if (points.size() < LeastPoints || !FitSphere(mesh, points.data(), points.size(), sphere))
    {
      shape.Spheres.clear();
      shape.Points.clear();
      shape.Cells.clear();
      return false;
    }
    shape.Spheres.push_back(sphere);
    shape.Points.push_back(points.front());
    shape.Cells.push_back(cellOf[static_cast<size_t>(points.front())]);
    first = end;
  }
  return !shape.Spheres.empty();
}

//------------------------------------------------------------------------------
bool vtkIndirectProxyShapes::FindPolygon(vtkPolyData* mesh, Shape& shape)
{
  glm::dvec3 normal(0.0);
  double area = 0.0;
  if (mesh->GetNumberOfStrips() > 0 || mesh->GetNumberOfPolys() == 0)
  {
    return false;
  }
  vtkIndirectTriangles::ForEach(mesh,
    [&](vtkIdType, const vtkIndirectTriangles::Points& points)
    {
      const glm::dvec3 cross = FindCross(mesh, points);
      normal += glm::dot(cross, normal) < 0.0 ? -cross : cross;
      area += 0.5 * glm::length(cross);
    });
  const double length = glm::length(normal);
  if (!(area > 0.0) || !std::isfinite(length) || !(length > (2.0 - 1e-3) * area))
  {
    return false;
  }
  normal /= length;
  const glm::dvec3 right = glm::normalize(
    glm::cross(normal, std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 up = glm::cross(normal, right);
  const glm::dvec3 origin = GetPoint(mesh, 0);
  const double size = std::sqrt(area);
  std::vector<glm::dvec2> flat;
  bool isFlat = true;
  vtkIndirectTriangles::ForEach(mesh,
    [&](vtkIdType, const vtkIndirectTriangles::Points& points)
    {
      for (const vtkIdType point : points)
      {
        const glm::dvec3 d = GetPoint(mesh, point) - origin;
        isFlat = isFlat && std::abs(glm::dot(d, normal)) <= Flatness * size;
        flat.emplace_back(glm::dot(d, right), glm::dot(d, up));
      }
    });
  if (!isFlat)
  {
    return false;
  }
  std::vector<glm::dvec2> hull = FindHull(std::move(flat));
  const double whole = FindArea(hull);
  if (hull.size() < 3 || !(area >= (1.0 - MissingArea) * whole) ||
    !(area <= (1.0 + MissingArea) * whole))
  {
    return false;
  }
  if (hull.size() > MostCorners)
  {
    // Chooses corners evenly along the outline, about its middle.
    std::vector<glm::dvec2> chosen;
    for (size_t i = 0; i < MostCorners; ++i)
    {
      chosen.push_back(hull[i * hull.size() / MostCorners]);
    }
    glm::dvec2 middle(0.0);
    for (const glm::dvec2& p : chosen)
    {
      middle += p / static_cast<double>(MostCorners);
    }
    const double scale = std::sqrt(whole / std::max(FindArea(chosen), 1e-6 * whole));
    for (glm::dvec2& p : chosen)
    {
      p = middle + scale * (p - middle);
    }
    hull = chosen;
  }
  vtkIndirectProxyPolygon polygon;
  for (const glm::dvec2& p : hull)
  {
    polygon.Corners.push_back(origin + p.x * right + p.y * up);
  }
  shape.Polygons = { polygon };
  return true;
}

//------------------------------------------------------------------------------
// Tests the length of the border, edges with one triangle: a flat sheet's is at least 3.5 times the
// root of its area (a disk), that of holes in a body and of cut ends far less.
bool vtkIndirectProxyShapes::IsSheet(vtkPolyData* mesh)
{
  // Merges points at the same position.
  std::map<std::array<double, 3>, vtkIdType> places;
  std::vector<vtkIdType> merged;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> place;
    mesh->GetPoint(i, place.data());
    merged.push_back(places.emplace(place, i).first->second);
  }
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  double area = 0.0;
  vtkIndirectTriangles::ForEach(mesh,
    [&](vtkIdType, const vtkIndirectTriangles::Points& points)
    {
      area += 0.5 * glm::length(FindCross(mesh, points));
      for (size_t i = 0; i < 3; ++i)
      {
        ++edges[std::minmax(merged[static_cast<size_t>(points[i])],
          merged[static_cast<size_t>(points[(i + 1) % 3])])];
      }
    });
  double border = 0.0;
  for (const auto& [ends, count] : edges)
  {
    border +=
      count == 1 ? glm::length(GetPoint(mesh, ends.first) - GetPoint(mesh, ends.second)) : 0.0;
  }
  return border * border > area;
}

//------------------------------------------------------------------------------
void vtkIndirectProxyShapes::Fit(Known& known, vtkPolyData* mesh, bool exact)
{
  known.Made = Shape();
  known.Filter = nullptr;
  if (mesh->GetNumberOfPoints() == 0 || mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0)
  {
    known.Made.LeftOut = "it has no surface";
    return;
  }
  if (FindSpheres(mesh, known.Made))
  {
    known.Made.Kind = SPHERES;
    return;
  }
  if (FindPolygon(mesh, known.Made))
  {
    known.Made.Kind = POLYGON;
    return;
  }
  if (exact)
  {
    return;
  }
  if (IsSheet(mesh))
  {
    known.Made.Kind = SHEET;
    known.Made.LeftOut =
      "it is an open sheet, and spheres along it would hide it from itself; it hides no light";
    return;
  }
  auto made = vtkSmartPointer<vtkObject>::Take(vtkObjectFactory::CreateInstance(FilterName));
  known.Filter = vtkPolyDataAlgorithm::SafeDownCast(made);
  if (!known.Filter)
  {
    known.Made.LeftOut = "the module IndirectProxies, which makes spheres of meshes, is not loaded";
    return;
  }
  // The filter gets its own copy: its input stays unchanged if the mesh moves.
  vtkNew<vtkPolyData> copy;
  copy->SetPoints(vtkSmartPointer<vtkPoints>::New());
  copy->GetPoints()->DeepCopy(mesh->GetPoints());
  copy->SetPolys(mesh->GetPolys());
  copy->SetStrips(mesh->GetStrips());
  known.Filter->SetInputDataObject(0, copy);
  known.Made.Kind = FITTED;
  Move(known, nullptr);
}

//------------------------------------------------------------------------------
// Takes the filter's spheres, moved with the points of the mesh, if there is one.
void vtkIndirectProxyShapes::Move(Known& known, vtkPolyData* mesh)
{
  if (mesh)
  {
    vtkNew<vtkPolyData> points;
    points->SetPoints(mesh->GetPoints());
    known.Filter->SetInputDataObject(1, points);
  }
  known.Filter->Update();
  vtkPolyData* output = known.Filter->GetOutput();
  vtkDataArray* radii = output->GetPointData()->GetArray("Radius");
  known.Made.Spheres.clear();
  for (vtkIdType i = 0; radii && i < output->GetNumberOfPoints(); ++i)
  {
    vtkIndirectProxySphere sphere;
    sphere.Center = GetPoint(output, i);
    sphere.Radius = radii->GetTuple1(i);
    known.Made.Spheres.push_back(sphere);
  }
  if (known.Made.Spheres.empty())
  {
    known.Made.LeftOut = "no spheres could be made of it";
  }
}

//------------------------------------------------------------------------------
const vtkIndirectProxyShapes::Shape& vtkIndirectProxyShapes::Find(vtkPolyData* mesh, bool exact)
{
  Known& known = this->All[{ mesh, exact }];
  known.Used = true;
  if (known.Mesh.Take({ "mesh", mesh }))
  {
    vtkIndirectKey cells("cells", mesh->GetPolys());
    cells.Add("cells", mesh->GetStrips()).Add("points", mesh->GetNumberOfPoints());
    if (known.Cells.Take(std::move(cells)) || !known.Filter)
    {
      Fit(known, mesh, exact);
    }
    else
    {
      Move(known, mesh);
    }
  }
  return known.Made;
}

//------------------------------------------------------------------------------
void vtkIndirectProxyShapes::Forget()
{
  for (auto it = this->All.begin(); it != this->All.end();)
  {
    it = it->second.Used ? std::next(it) : this->All.erase(it);
  }
  for (auto& known : this->All)
  {
    known.second.Used = false;
  }
}
