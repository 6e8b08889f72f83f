// SPDX-License-Identifier: BSD-3-Clause
#include "Visibility/vtkIndirectRayPiece.h"

#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectRevision.h"
#include "Visibility/vtkIndirectGlyphs.h"
#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <cmath>
#include <utility>

namespace
{
glm::dvec3 ReadTuple(vtkDataArray* array, vtkIdType at)
{
  double values[9] = {};
  if (at < array->GetNumberOfTuples() && array->GetNumberOfComponents() <= 9)
  {
    array->GetTuple(at, values);
  }
  return { values[0], values[1], values[2] };
}

glm::dmat3 FindNormalMatrix(const glm::dmat4& matrix)
{
  return glm::transpose(glm::inverse(glm::dmat3(matrix)));
}
}

//------------------------------------------------------------------------------
vtkIndirectRayPiece::vtkIndirectRayPiece(vtkIndirectPolygons&& polygons)
  : Polygons(std::move(polygons))
{
  vtkProperty* property = this->Polygons.Actor->GetProperty();
  vtkPolyData* data = this->Polygons.Data;
  if (property->GetInterpolation() != VTK_FLAT)
  {
    this->PointNormals = data->GetPointData()->GetNormals();
  }
  if (!this->PointNormals)
  {
    this->CellNormals = data->GetCellData()->GetNormals();
  }
  this->NormalsToWorld = FindNormalMatrix(this->Polygons.ToWorld);
  this->CullsFront = property->GetFrontfaceCulling() != 0;
  this->CullsBack = property->GetBackfaceCulling() != 0;
}

//------------------------------------------------------------------------------
bool vtkIndirectRayPiece::ReadGlyphs(const vtkIndirectFrame& frame, vtkActor* actor,
  const glm::dmat4& toWorld, size_t& mostTriangles, const Taker& take)
{
  auto* mapper = vtkGlyph3DMapper::SafeDownCast(actor->GetMapper());
  const std::vector<std::vector<vtkPolyData*>> sources = vtkIndirectGlyphs::FindSources(mapper);
  bool all = true;
  vtkIndirectGlyphs::ForEachDataSet(mapper,
    [&](vtkDataSet* data)
    {
      std::vector<std::vector<vtkIndirectGlyphs::Instance>> instances(sources.size());
      vtkIndirectGlyphs::ForEach(mapper, data, sources.size(),
        [&](const vtkIndirectGlyphs::Instance& instance)
        { instances[instance.Source].push_back(instance); });
      const vtkIndirectMaterial material(actor, mapper, data);
      for (size_t i = 0; i < sources.size(); ++i)
      {
        std::vector<glm::dmat4> places;
        std::vector<Glyph> glyphs;
        for (const vtkIndirectGlyphs::Instance& instance : instances[i])
        {
          places.push_back(instance.ToData);
          glyphs.push_back({ instance.Point, FindNormalMatrix(toWorld * instance.ToData) });
        }
        for (vtkPolyData* source : sources[i])
        {
          vtkIndirectPolygons polygons;
          polygons.Actor = actor;
          polygons.Mapper = mapper;
          polygons.Data = source;
          polygons.ToWorld = toWorld;
          if (!polygons.Repeat(frame, places, mostTriangles))
          {
            all = false;
            continue;
          }
          mostTriangles -= polygons.Triangles.size();
          polygons.Material = material;
          auto piece = std::make_unique<vtkIndirectRayPiece>(std::move(polygons));
          piece->PointsOfGlyph = source->GetNumberOfPoints();
          piece->Places = data;
          piece->Glyphs = glyphs;
          take(std::move(piece));
        }
      }
    });
  return all;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectRayPiece::FindAlbedo(const vtkIndirectMaterial::Place& place) const
{
  return this->Glyphs.empty()
    ? this->Polygons.Material.Find(place)
    : this->Polygons.Material.Get(
        this->Glyphs[static_cast<size_t>(place.Points[0] / this->PointsOfGlyph)].Point);
}

//------------------------------------------------------------------------------
bool vtkIndirectRayPiece::FindNormal(
  const vtkIndirectMaterial::Place& place, const glm::dvec3& facet, glm::dvec3& normal) const
{
  normal = facet;
  if (!this->PointNormals && !this->CellNormals)
  {
    return true;
  }
  glm::dvec3 sum(0.0);
  for (int i = 0; this->PointNormals && i < 3; ++i)
  {
    sum += place.Weights[i] *
      ReadTuple(this->PointNormals,
        this->Glyphs.empty() ? place.Points[i] : place.Points[i] % this->PointsOfGlyph);
  }
  const glm::dmat3& toWorld = this->Glyphs.empty()
    ? this->NormalsToWorld
    : this->Glyphs[static_cast<size_t>(place.Points[0] / this->PointsOfGlyph)].NormalsToWorld;
  const glm::dvec3 turned =
    toWorld * (this->PointNormals ? sum : ReadTuple(this->CellNormals, place.Cell));
  const double length = glm::length(turned);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return false;
  }
  normal = (place.Front ? 1.0 : -1.0) / length * turned;
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectRayPiece::AppendShape(std::vector<double>& key) const
{
  vtkIndirectRevision::AppendTo(key, this->Polygons.Data);
  vtkIndirectRevision::AppendTo(key, this->Places);
  key.push_back(static_cast<double>(this->Polygons.Triangles.size()));
  // A glyph mapper's settings place its glyphs.
  vtkIndirectRevision::AppendTo(key, this->Places ? this->Polygons.Mapper : nullptr);
  vtkPlaneCollection* planes = this->Polygons.Mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    vtkIndirectRevision::AppendTo(key, planes->GetItem(i));
  }
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 3; ++row)
    {
      key.push_back(this->Polygons.ToWorld[column][row]);
    }
  }
}

//------------------------------------------------------------------------------
size_t vtkIndirectRayPiece::GetBytes() const
{
  return this->Polygons.Positions.size() * sizeof(glm::dvec3) +
    this->Glyphs.size() * sizeof(Glyph) + this->Polygons.Material.GetBytes();
}
