// SPDX-License-Identifier: BSD-3-Clause
#include "Visibility/vtkIndirectPolygons.h"

#include "Frame/vtkIndirectFrame.h"
#include "vtkActor.h"
#include "vtkAssemblyPath.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"
#include "vtkVersionMacros.h"

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
    const auto add = [&](vtkPolyData* data)
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
      piece.Fill(frame);
      all = all && data->GetNumberOfVerts() == 0 && data->GetNumberOfLines() == 0;
      take(piece);
    };
    vtkDataObject* input = mapper->GetInputDataObject(0, 0);
    if (auto* data = vtkPolyData::SafeDownCast(input))
    {
      // Glyph mappers have points here and the polygons elsewhere.
      if (vtkPolyDataMapper::SafeDownCast(mapper))
      {
        add(data);
      }
    }
    else if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
    {
      auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
      for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
      {
        if (auto* leaf = vtkPolyData::SafeDownCast(it->GetCurrentDataObject()))
        {
          add(leaf);
        }
      }
    }
  }
  return all;
}

//------------------------------------------------------------------------------
void vtkIndirectPolygons::Fill(const vtkIndirectFrame& frame)
{
  vtkPoints* points = this->Data->GetPoints();
  this->Positions.resize(static_cast<size_t>(points->GetNumberOfPoints()));
  std::vector<char> shown(this->Positions.size(), 1);
  vtkPlaneCollection* planes = this->Mapper->GetClippingPlanes();
  for (size_t i = 0; i < this->Positions.size(); ++i)
  {
    double p[3];
    points->GetPoint(static_cast<vtkIdType>(i), p);
    const glm::dvec4 local(p[0], p[1], p[2], 1.0);
    glm::dvec4 world = this->ToWorld * local;
    this->Positions[i] = (glm::dvec3(world) - frame.SceneCenter) * frame.SceneScale;
    for (int k = 0; planes && k < planes->GetNumberOfItems(); ++k)
    {
      shown[i] = shown[i] && planes->GetItem(k)->EvaluateFunction(&world[0]) >= 0.0;
    }
  }
  this->FillColors();

  auto add = [&](vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c)
  {
    // A triangle that a plane cuts counts whole: it blocks at most its own length too much.
    if (shown[static_cast<size_t>(a)] || shown[static_cast<size_t>(b)] ||
      shown[static_cast<size_t>(c)])
    {
      this->Triangles.push_back({ cell, { a, b, c } });
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

//------------------------------------------------------------------------------
void vtkIndirectPolygons::FillColors()
{
  vtkProperty* property = this->Actor->GetProperty();
  this->Diffuse = property->GetDiffuse();
  if (property->GetInterpolation() == VTK_PBR)
  {
    this->PhysicallyBased = true;
    this->Encoded = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0);
  }
  const double* color = property->GetDiffuseColor();
  this->Color = this->Diffuse * glm::dvec3(color[0], color[1], color[2]);
  if (!this->Mapper->GetScalarVisibility())
  {
    return;
  }
  vtkMapper* mapper = this->Mapper;
  int cellFlag = 0;
  vtkAbstractArray* scalars =
    vtkAbstractMapper::GetAbstractScalars(this->Data, mapper->GetScalarMode(),
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cellFlag);
  if (scalars && mapper->GetLookupTable())
  {
    this->Colors.TakeReference(mapper->GetLookupTable()->MapScalars(
      scalars, mapper->GetColorMode(), mapper->GetArrayComponent()));
    this->ColorsAreOfCells = cellFlag != 0;
  }
  if (this->Colors && this->Colors->GetNumberOfComponents() < 3)
  {
    this->Colors = nullptr;
  }
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectPolygons::GetAlbedo(vtkIdType cell, vtkIdType point) const
{
  const double metallic = this->PhysicallyBased ? this->Actor->GetProperty()->GetMetallic() : 0.0;
  const vtkIdType at = this->ColorsAreOfCells ? cell : point;
  glm::dvec3 color = this->Color;
  if (this->Colors && at < this->Colors->GetNumberOfTuples())
  {
    const unsigned char* c = this->Colors->GetPointer(at * this->Colors->GetNumberOfComponents());
    color = this->Diffuse / 255.0 * glm::dvec3(c[0], c[1], c[2]);
    color = this->Encoded ? glm::pow(color, glm::dvec3(2.2)) : color;
  }
  // As the capture of surfaces clamps it.
  return glm::clamp((1.0 - metallic) * color, glm::dvec3(0.0), glm::dvec3(1.0));
}
