// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualLights/vtkIndirectRefraction.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkGenericCell.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkProperty.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>

namespace
{
// Faces on a way at most: light that is mirrored so often inside has lost most of itself.
constexpr int MostFaces = 8;
}

vtkIndirectRefraction::vtkIndirectRefraction() = default;
vtkIndirectRefraction::~vtkIndirectRefraction() = default;

//------------------------------------------------------------------------------
void vtkIndirectRefraction::SetBody(vtkActor* actor)
{
  auto* polygons = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  this->Surface->ShallowCopy(polygons);
  vtkMatrix4x4* matrix = actor->GetMatrix();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(polygons->GetNumberOfPoints());
  vtkDataArray* given = polygons->GetPointData()->GetNormals();
  // One that is too short, or of other vectors, says nothing.
  const bool whole = given && given->GetNumberOfComponents() == 3 &&
    given->GetNumberOfTuples() >= polygons->GetNumberOfPoints();
  given = whole ? given : nullptr;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  glm::dmat3 turn(1.0);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      turn[j][i] = matrix->GetElement(i, j);
    }
  }
  const glm::dmat3 turnNormals = glm::transpose(glm::inverse(turn));
  for (vtkIdType i = 0; i < polygons->GetNumberOfPoints(); ++i)
  {
    double p[4] = { 0.0, 0.0, 0.0, 1.0 };
    polygons->GetPoint(i, p);
    matrix->MultiplyPoint(p, p);
    points->SetPoint(i, p);
    if (given)
    {
      double n[3];
      given->GetTuple(i, n);
      const glm::dvec3 turned = turnNormals * glm::dvec3(n[0], n[1], n[2]);
      normals->InsertNextTuple3(turned.x, turned.y, turned.z);
    }
  }
  this->Surface->SetPoints(points);
  // Others would cost a copy each; a flat surface has none.
  this->Surface->GetPointData()->Initialize();
  this->Surface->GetCellData()->Initialize();
  if (given)
  {
    this->Surface->GetPointData()->SetNormals(normals);
  }
  this->Surface->Modified();
  this->Size = this->Surface->GetLength();
  this->Locator->SetDataSet(this->Surface);
  this->Locator->CacheCellBoundsOn();
  this->Locator->BuildLocator();
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
bool vtkIndirectRefraction::Meet(const glm::dvec3& from, const glm::dvec3& direction, double length,
  glm::dvec3& place, glm::dvec3& normal) const
{
  const glm::dvec3 to = from + length * direction;
  double t = 0.0;
  double x[3];
  double parametric[3];
  int subId = 0;
  vtkIdType cell = -1;
  if (!this->Locator->IntersectWithLine(
        &from[0], &to[0], 1e-9 * this->Size, t, x, parametric, subId, cell, this->Cell) ||
    cell < 0)
  {
    return false;
  }
  place = glm::dvec3(x[0], x[1], x[2]);
  double facet[3];
  vtkPolygon::ComputeNormal(this->Cell->GetPoints(), facet);
  normal = glm::dvec3(facet[0], facet[1], facet[2]);
  normal = glm::dot(normal, direction) > 0.0 ? -normal : normal;
  if (vtkDataArray* given = this->Surface->GetPointData()->GetNormals())
  {
    double weights[64];
    double closest[3];
    double distance = 0.0;
    const vtkIdType count = this->Cell->GetNumberOfPoints();
    if (count <= 64 &&
      this->Cell->EvaluatePosition(x, closest, subId, parametric, distance, weights) >= 0)
    {
      glm::dvec3 mean(0.0);
      for (vtkIdType i = 0; i < count; ++i)
      {
        double n[3];
        given->GetTuple(this->Cell->GetPointId(static_cast<int>(i)), n);
        mean += weights[i] * glm::dvec3(n[0], n[1], n[2]);
      }
      mean = glm::dot(mean, normal) < 0.0 ? -mean : mean;
      // A normal that is turned away from the way cannot be refracted at.
      if (glm::length(mean) > 1e-6 && glm::dot(mean, direction) < -1e-6 * glm::length(mean))
      {
        normal = glm::normalize(mean);
      }
    }
  }
  return glm::dot(normal, normal) > 0.5;
}

//------------------------------------------------------------------------------
vtkIndirectRefraction::Path vtkIndirectRefraction::Trace(
  const glm::dvec3& origin, const glm::dvec3& direction, double length) const
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
    if (!this->Meet(from, way, inside ? 2.0 * this->Size : length, place, normal))
    {
      return path; // past the body, or out of one that is not closed
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
    // Off the face, by more than what rounding moves places by.
    from = place + 1e-6 * this->Size * way;
  }
  return path;
}
