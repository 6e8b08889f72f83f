// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectPolygons.h"

#include "OpenGL/vtkIndirectKey.h"
#include "Scene/vtkIndirectActors.h"
#include "Scene/vtkIndirectFrame.h"
#include "Scene/vtkIndirectGlyphs.h"
#include "Scene/vtkIndirectTriangles.h"
#include "vtkActor.h"
#include "vtkAssemblyPath.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkDataSetMapper.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 90)
#include "vtkCompositePolyDataMapper.h"
using CompositeMapper = vtkCompositePolyDataMapper;
#else
#include "vtkCompositePolyDataMapper2.h"
using CompositeMapper = vtkCompositePolyDataMapper2;
#endif

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <string>

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

// Returns true if an actor draws nothing but its data's polygons and strips. Derived classes may
// draw anything. The caller looks for lines and vertices, which lie off the triangles.
bool DrawsPolygonsAlone(vtkActor* actor, vtkMapper* mapper)
{
  static const char* const mappers[] = { "vtkOpenGLPolyDataMapper", "vtkCompositePolyDataMapper",
    "vtkCompositePolyDataMapper2" };
  const std::string name = mapper->GetClassName();
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  return std::strcmp(actor->GetClassName(), "vtkOpenGLActor") == 0 &&
    std::find(std::begin(mappers), std::end(mappers), name) != std::end(mappers) &&
    shaders->GetNumberOfShaderReplacements() == 0 && !shaders->HasVertexShaderCode() &&
    !shaders->HasGeometryShaderCode();
}

// Returns true if a mapper draws the polygons of its data; other mappers draw glyphs, impostors or
// splats at the points of their data.
bool DrawsPolygons(vtkMapper* mapper)
{
  return (mapper->IsA("vtkPolyDataMapper") || mapper->IsA("vtkCompositePolyDataMapper") ||
           mapper->IsA("vtkDataSetMapper")) &&
    !mapper->IsA("vtkOpenGLSphereMapper") && !mapper->IsA("vtkOpenGLStickMapper") &&
    !mapper->IsA("vtkPointGaussianMapper");
}

// Returns true if a block shows scalars (VTK 9.3 and later) or a texture (9.6 and later) of its
// own.
bool HasOwnScalars([[maybe_unused]] vtkDataObject* object,
  [[maybe_unused]] vtkCompositeDataDisplayAttributes* attributes)
{
  bool any = false;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  any = attributes->HasBlockScalarMode(object) || attributes->HasBlockArrayAccessMode(object) ||
    attributes->HasBlockArrayName(object) || attributes->HasBlockArrayId(object) ||
    attributes->HasBlockArrayComponent(object) || attributes->HasBlockFieldDataTupleId(object) ||
    attributes->HasBlockColorMode(object) || attributes->HasBlockLookupTable(object) ||
    attributes->HasBlockScalarRange(object) ||
    attributes->HasBlockUseLookupTableScalarRange(object) ||
    attributes->HasBlockInterpolateScalarsBeforeMapping(object);
#endif
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  any = any || attributes->HasBlockTexture(object);
#endif
  return any;
}

// Calls `add` with each block that a composite mapper draws in the opaque pass, and with the
// attributes that the block inherits from its parents.
template <typename F>
void AddBlocks(vtkDataObject* object, vtkCompositeDataDisplayAttributes* attributes,
  vtkIndirectMaterial::Block block, const F& add)
{
  if (attributes && attributes->HasBlockVisibility(object))
  {
    block.Shown = attributes->GetBlockVisibility(object);
  }
  if (attributes && attributes->HasBlockOpacity(object))
  {
    block.Opaque = attributes->GetBlockOpacity(object) >= 1.0;
  }
  if (attributes && attributes->HasBlockColor(object))
  {
    block.HasColor = true;
    attributes->GetBlockColor(object, &block.Color[0]);
  }
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  if (attributes && attributes->HasBlockScalarVisibility(object))
  {
    block.ShowsScalars = attributes->GetBlockScalarVisibility(object);
  }
#endif
  block.HasOwnScalars = block.HasOwnScalars || (attributes && HasOwnScalars(object, attributes));
  if (auto* tree = vtkDataObjectTree::SafeDownCast(object))
  {
    for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::SkipEmptyNodes))
    {
      AddBlocks(child, attributes, block, add);
    }
  }
  else if (auto* data = vtkPolyData::SafeDownCast(object))
  {
    if (block.Shown && block.Opaque)
    {
      add(data, block);
    }
  }
}
}

//------------------------------------------------------------------------------
bool vtkIndirectPolygons::Read(const vtkIndirectFrame& frame, vtkProp* prop, const Taker& take)
{
  bool all = true;
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkAssemblyNode* node = path->GetLastNode();
    vtkActor* actor = vtkActor::SafeDownCast(node->GetViewProp());
    if (actor && !actor->GetVisibility())
    {
      continue;
    }
    if (!actor || !actor->GetMapper())
    {
      all = false;
      continue;
    }
    vtkMapper* mapper = actor->GetMapper();
    auto* dataSetMapper = vtkDataSetMapper::SafeDownCast(mapper);
    // VTK makes the inner mapper on its first draw.
    if (dataSetMapper && dataSetMapper->GetPolyDataMapper())
    {
      mapper = dataSetMapper->GetPolyDataMapper();
    }
    if (mapper->GetNumberOfInputPorts() < 1 || mapper->GetNumberOfInputConnections(0) < 1)
    {
      all = false;
      continue;
    }
    all = all && DrawsPolygonsAlone(actor, mapper);
    const glm::dmat4 toWorld =
      vtkIndirectFrame::ToGLM(node->GetMatrix() ? node->GetMatrix() : actor->GetMatrix());
    const auto add = [&](vtkPolyData* data, const vtkIndirectMaterial::Block& block)
    {
      if (!data->GetPoints() || data->GetPoints()->GetNumberOfPoints() == 0)
      {
        return;
      }
      vtkIndirectPolygons piece;
      piece.Begin(actor, mapper, data, toWorld);
      piece.Fill(frame, glm::dmat4(1.0));
      piece.Material = vtkIndirectMaterial(actor, mapper, data, block);
      all = all && data->GetNumberOfVerts() == 0 && data->GetNumberOfLines() == 0;
      take(piece);
    };
    vtkDataObject* input = DrawsPolygons(mapper) ? mapper->GetInputDataObject(0, 0) : nullptr;
    if (input)
    {
      auto* composite = CompositeMapper::SafeDownCast(mapper);
      AddBlocks(input, composite ? composite->GetCompositeDataDisplayAttributes() : nullptr,
        vtkIndirectMaterial::Block(), add);
    }
  }
  return all;
}

//------------------------------------------------------------------------------
bool vtkIndirectPolygons::ReadGlyphs(const vtkIndirectFrame& frame, vtkActor* actor,
  const glm::dmat4& toWorld, size_t& mostTriangles, const Taker& take)
{
  auto* mapper = vtkGlyph3DMapper::SafeDownCast(actor->GetMapper());
  const std::vector<std::vector<vtkPolyData*>> sources = vtkIndirectGlyphs::FindSources(mapper);
  bool all = true;
  vtkIndirectActors::ForEachBlock<vtkDataSet>(mapper->GetInputDataObject(0, 0),
    [&](vtkDataSet* data)
    {
      std::vector<std::vector<vtkIndirectGlyphs::Instance>> instances(sources.size());
      vtkIndirectGlyphs::ForEach(mapper, data, sources.size(),
        [&](const vtkIndirectGlyphs::Instance& instance)
        { instances[instance.Source].push_back(instance); });
      const vtkIndirectMaterial material(actor, mapper, data);
      for (size_t i = 0; i < sources.size(); ++i)
      {
        for (vtkPolyData* source : sources[i])
        {
          vtkIndirectPolygons piece;
          piece.Begin(actor, mapper, source, toWorld);
          piece.Material = material;
          piece.IsOfGlyphs = true;
          piece.PointsOfGlyph = source->GetNumberOfPoints();
          piece.GlyphPlaces = data;
          bool fits = true;
          for (size_t k = 0; k < instances[i].size() && fits && piece.PointsOfGlyph > 0; ++k)
          {
            const vtkIndirectGlyphs::Instance& instance = instances[i][k];
            piece.Glyphs.push_back({ instance.Point, FindNormalMatrix(toWorld * instance.ToData) });
            piece.Fill(frame, instance.ToData);
            fits = piece.Triangles.size() <= mostTriangles;
          }
          all = all && fits;
          if (fits)
          {
            mostTriangles -= piece.Triangles.size();
            take(piece);
          }
        }
      }
    });
  return all;
}

//------------------------------------------------------------------------------
void vtkIndirectPolygons::Begin(
  vtkActor* actor, vtkMapper* mapper, vtkPolyData* data, const glm::dmat4& toWorld)
{
  this->Mapper = mapper;
  this->Data = data;
  this->ToWorld = toWorld;
  this->NormalsToWorld = FindNormalMatrix(toWorld);
  vtkProperty* property = actor->GetProperty();
  if (property->GetInterpolation() != VTK_FLAT)
  {
    this->PointNormals = data->GetPointData()->GetNormals();
  }
  if (!this->PointNormals)
  {
    this->CellNormals = data->GetCellData()->GetNormals();
  }
  this->CullsFront = property->GetFrontfaceCulling() != 0;
  this->CullsBack = property->GetBackfaceCulling() != 0;
}

//------------------------------------------------------------------------------
void vtkIndirectPolygons::Fill(const vtkIndirectFrame& frame, const glm::dmat4& place)
{
  vtkPoints* points = this->Data->GetPoints();
  const glm::dmat4 toWorld = this->ToWorld * place;
  const size_t first = this->Positions.size();
  const size_t added = static_cast<size_t>(points->GetNumberOfPoints());
  this->Positions.resize(first + added);
  std::vector<char> shown(added, 1);
  std::vector<char> there(added, 1);
  vtkPlaneCollection* planes = this->Mapper->GetClippingPlanes();
  for (size_t i = 0; i < added; ++i)
  {
    double p[3];
    points->GetPoint(static_cast<vtkIdType>(i), p);
    const glm::dvec4 local(p[0], p[1], p[2], 1.0);
    glm::dvec4 world = toWorld * local;
    this->Positions[first + i] = frame.ToScene(glm::dvec3(world));
    // Casters lie in the scene's bounds, whose diagonal is one; points far beyond them are invalid.
    there[i] = glm::length(this->Positions[first + i]) <= 1e3;
    for (int k = 0; planes && k < planes->GetNumberOfItems(); ++k)
    {
      shown[i] = shown[i] && planes->GetItem(k)->EvaluateFunction(&world[0]) >= 0.0;
    }
  }

  vtkIndirectTriangles::ForEach(this->Data,
    [&](vtkIdType cell, const vtkIndirectTriangles::Points& ids)
    {
      Triangle triangle = { static_cast<uint32_t>(cell), {} };
      bool isShown = false;
      bool isThere = true;
      for (size_t i = 0; i < 3; ++i)
      {
        const auto id = static_cast<size_t>(ids[i]);
        isShown = isShown || shown[id];
        isThere = isThere && there[id];
        triangle.Points[i] = static_cast<uint32_t>(first + id);
      }
      // A triangle that a plane cuts counts as a whole: it blocks too much by at most its own
      // length.
      if (isShown && isThere)
      {
        this->Triangles.push_back(triangle);
      }
    });
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectPolygons::FindAlbedo(const vtkIndirectMaterial::Place& place) const
{
  return this->IsOfGlyphs ? this->Material.Get(this->GetGlyph(place.Points[0]).Point)
                          : this->Material.Find(place);
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectPolygons::FindMeanAlbedo(const Triangle& triangle) const
{
  const vtkIdType points[3] = { triangle.Points[0], triangle.Points[1], triangle.Points[2] };
  return this->IsOfGlyphs ? this->Material.Get(this->GetGlyph(points[0]).Point)
                          : this->Material.FindMean(triangle.Cell, points);
}

//------------------------------------------------------------------------------
bool vtkIndirectPolygons::FindNormal(
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
        this->IsOfGlyphs ? place.Points[i] % this->PointsOfGlyph : place.Points[i]);
  }
  const glm::dmat3& toWorld =
    this->IsOfGlyphs ? this->GetGlyph(place.Points[0]).NormalsToWorld : this->NormalsToWorld;
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
void vtkIndirectPolygons::AppendShape(vtkIndirectKey& key) const
{
  key.Add("mesh", this->Data).Add("glyphs", this->GlyphPlaces);
  key.Add("mesh", this->Triangles.size());
  // A glyph mapper's settings place its glyphs.
  key.Add("glyphs", this->IsOfGlyphs ? this->Mapper : nullptr);
  vtkPlaneCollection* planes = this->Mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    key.Add("clipping planes", planes->GetItem(i));
  }
  key.Add("placement", this->ToWorld);
}

//------------------------------------------------------------------------------
size_t vtkIndirectPolygons::GetBytes() const
{
  return this->Positions.size() * sizeof(glm::dvec3) + this->Triangles.size() * sizeof(Triangle) +
    this->Glyphs.size() * sizeof(Glyph) + this->Material.GetBytes();
}
