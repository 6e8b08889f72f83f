// SPDX-License-Identifier: BSD-3-Clause
#include "Visibility/vtkIndirectPolygons.h"

#include "Frame/vtkIndirectFrame.h"
#include "vtkActor.h"
#include "vtkAssemblyPath.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkDataSetMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
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
#include <cstring>
#include <iterator>
#include <string>

namespace
{
// Whether what an actor draws is no more than its data's polygons and strips. Of derived classes
// nothing is known; lines and vertices lie where no triangle does.
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

// Others draw something else at the points of their data: glyphs, impostors, splats.
bool DrawsPolygons(vtkMapper* mapper)
{
  return (mapper->IsA("vtkPolyDataMapper") || mapper->IsA("vtkCompositePolyDataMapper")) &&
    !mapper->IsA("vtkOpenGLSphereMapper") && !mapper->IsA("vtkOpenGLStickMapper") &&
    !mapper->IsA("vtkPointGaussianMapper");
}

// How a block alone shows scalars and textures: since VTK 9.3 and 9.6.
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

// The blocks that a composite mapper draws with all else that is opaque, each with what it inherits
// from those around it.
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
    if (auto* dataSetMapper = vtkDataSetMapper::SafeDownCast(mapper))
    {
      mapper = dataSetMapper->GetPolyDataMapper();
    }
    if (!mapper || mapper->GetNumberOfInputPorts() < 1 ||
      mapper->GetNumberOfInputConnections(0) < 1)
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
      piece.Actor = actor;
      piece.Mapper = mapper;
      piece.Data = data;
      piece.ToWorld = toWorld;
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
bool vtkIndirectPolygons::Repeat(
  const vtkIndirectFrame& frame, const std::vector<glm::dmat4>& places, size_t mostTriangles)
{
  if (!this->Data->GetPoints() || this->Data->GetPoints()->GetNumberOfPoints() == 0)
  {
    return true;
  }
  for (const glm::dmat4& place : places)
  {
    this->Fill(frame, place);
    if (this->Triangles.size() > mostTriangles)
    {
      this->Positions = {};
      this->Triangles = {};
      return false;
    }
  }
  return true;
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
    this->Positions[first + i] = (glm::dvec3(world) - frame.SceneCenter) * frame.SceneScale;
    // What casts lies in the scene's bounds, of size one; points beyond are no places.
    there[i] = glm::length(this->Positions[first + i]) <= 1e3;
    for (int k = 0; planes && k < planes->GetNumberOfItems(); ++k)
    {
      shown[i] = shown[i] && planes->GetItem(k)->EvaluateFunction(&world[0]) >= 0.0;
    }
  }

  const vtkIdType base = static_cast<vtkIdType>(first);
  auto add = [&](vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c)
  {
    // A triangle that a plane cuts counts whole: it blocks at most its own length too much.
    if ((shown[static_cast<size_t>(a)] || shown[static_cast<size_t>(b)] ||
          shown[static_cast<size_t>(c)]) &&
      there[static_cast<size_t>(a)] && there[static_cast<size_t>(b)] &&
      there[static_cast<size_t>(c)])
    {
      this->Triangles.push_back({ cell, { base + a, base + b, base + c } });
    }
  };
  // Cell data count vertices and lines first.
  vtkIdType cell = this->Data->GetNumberOfVerts() + this->Data->GetNumberOfLines();
  vtkIdType count;
  const vtkIdType* ids;
  auto polygons = vtk::TakeSmartPointer(this->Data->GetPolys()->NewIterator());
  for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal();
       polygons->GoToNextCell(), ++cell)
  {
    polygons->GetCurrentCell(count, ids);
    for (vtkIdType i = 2; i < count; ++i)
    {
      add(cell, ids[0], ids[i - 1], ids[i]);
    }
  }
  auto strips = vtk::TakeSmartPointer(this->Data->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell(), ++cell)
  {
    strips->GetCurrentCell(count, ids);
    for (vtkIdType i = 2; i < count; ++i)
    {
      // Every other one is wound the other way.
      const vtkIdType odd = i % 2;
      add(cell, ids[i - 2 + odd], ids[i - 1 - odd], ids[i]);
    }
  }
}
