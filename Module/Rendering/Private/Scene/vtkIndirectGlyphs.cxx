// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectGlyphs.h"

#include "Scene/vtkIndirectActors.h"
#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkQuaternion.h"

#include <algorithm>
#include <cmath>

namespace
{
// Gives access to members that VTK keeps for its derived classes.
struct GlyphAccess : public vtkGlyph3DMapper
{
  static vtkDataArray* GetScale(vtkGlyph3DMapper* mapper, vtkDataSet* data)
  {
    return (mapper->*(&GlyphAccess::GetScaleArray))(data);
  }
  static vtkDataArray* GetOrientation(vtkGlyph3DMapper* mapper, vtkDataSet* data)
  {
    return (mapper->*(&GlyphAccess::GetOrientationArray))(data);
  }
  static vtkDataArray* GetMask(vtkGlyph3DMapper* mapper, vtkDataSet* data)
  {
    return (mapper->*(&GlyphAccess::GetMaskArray))(data);
  }
  static vtkDataArray* GetIndex(vtkGlyph3DMapper* mapper, vtkDataSet* data)
  {
    return (mapper->*(&GlyphAccess::GetSourceIndexArray))(data);
  }
};

glm::dmat3 FindTurn(int mode, const double* o)
{
  vtkQuaterniond turn;
  const auto about = [](double degrees, int axis)
  {
    const double half = 0.5 * vtkMath::RadiansFromDegrees(degrees);
    double q[4] = { std::cos(half), 0.0, 0.0, 0.0 };
    q[1 + axis] = std::sin(half);
    return vtkQuaterniond(q);
  };
  if (mode == vtkGlyph3DMapper::ROTATION)
  {
    turn = about(o[2], 2) * about(o[0], 0) * about(o[1], 1);
  }
  else if (mode == vtkGlyph3DMapper::QUATERNION)
  {
    turn.Set(o[0], o[1], o[2], o[3]);
  }
  else if (o[1] == 0.0 && o[2] == 0.0)
  {
    if (o[0] < 0.0)
    {
      turn.Set(0.0, 0.0, 1.0, 0.0);
    }
  }
  else
  {
    // VTK makes half a turn about the middle between the x axis and the direction.
    const glm::dvec3 way(o[0], o[1], o[2]);
    const glm::dvec3 middle = glm::normalize(way + glm::dvec3(glm::length(way), 0.0, 0.0));
    turn.Set(0.0, middle.x, middle.y, middle.z);
  }
  double rows[3][3];
  turn.ToMatrix3x3(rows);
  glm::dmat3 result;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      result[column][row] = rows[row][column];
    }
  }
  return result;
}
}

//------------------------------------------------------------------------------
std::vector<std::vector<vtkPolyData*>> vtkIndirectGlyphs::FindSources(vtkGlyph3DMapper* mapper)
{
  std::vector<std::vector<vtkPolyData*>> sources;
  auto add = [&sources](vtkDataObject* source)
  {
    sources.emplace_back();
    vtkIndirectActors::ForEachBlock<vtkPolyData>(
      source, [&sources](vtkPolyData* mesh) { sources.back().push_back(mesh); });
  };
  if (mapper->GetUseSourceTableTree() && mapper->GetSourceTableTree())
  {
    vtkDataObjectTree* table = mapper->GetSourceTableTree();
    for (vtkDataObject* child : vtk::Range(table, vtk::DataObjectTreeOptions::None))
    {
      add(child);
    }
    return sources;
  }
  for (int i = 0; i < mapper->GetNumberOfInputConnections(1); ++i)
  {
    add(mapper->GetInputDataObject(1, i));
  }
  return sources;
}

//------------------------------------------------------------------------------
void vtkIndirectGlyphs::ForEach(vtkGlyph3DMapper* mapper, vtkDataSet* data, size_t numberOfSources,
  const std::function<void(const Instance&)>& call)
{
  const auto hold = [data](vtkDataArray* array)
  { return array && array->GetNumberOfTuples() >= data->GetNumberOfPoints() ? array : nullptr; };
  vtkDataArray* index =
    mapper->GetSourceIndexing() ? hold(GlyphAccess::GetIndex(mapper, data)) : nullptr;
  vtkDataArray* scale = hold(GlyphAccess::GetScale(mapper, data));
  vtkDataArray* ways =
    mapper->GetOrient() ? hold(GlyphAccess::GetOrientation(mapper, data)) : nullptr;
  const int mode = mapper->GetOrientationMode();
  if (ways && ways->GetNumberOfComponents() != (mode == vtkGlyph3DMapper::QUATERNION ? 4 : 3))
  {
    return; // VTK draws nothing in this case, after an error
  }
  auto* mask = mapper->GetMasking()
    ? vtkBitArray::SafeDownCast(hold(GlyphAccess::GetMask(mapper, data)))
    : nullptr;
  const double* range = mapper->GetRange();
  const double width = range[1] != range[0] ? range[1] - range[0] : 1.0;
  const int scaling = mapper->GetScaleMode();
  for (vtkIdType i = 0; numberOfSources > 0 && i < data->GetNumberOfPoints(); ++i)
  {
    if (mask && mask->GetValue(i) == 0)
    {
      continue;
    }
    Instance instance;
    instance.Point = i;
    const double number =
      index ? vtkMath::Norm(index->GetTuple(i), index->GetNumberOfComponents()) : 0.0;
    instance.Source =
      number > 0.0 ? static_cast<size_t>(std::min(number, numberOfSources - 1.0)) : 0;
    glm::dvec3 factors(1.0);
    if (scale && scaling == vtkGlyph3DMapper::SCALE_BY_MAGNITUDE)
    {
      factors = glm::dvec3(vtkMath::Norm(scale->GetTuple(i), scale->GetNumberOfComponents()));
    }
    else if (scale && scale->GetNumberOfComponents() == 3 &&
      scaling == vtkGlyph3DMapper::SCALE_BY_COMPONENTS)
    {
      const double* tuple = scale->GetTuple(i);
      factors = glm::dvec3(tuple[0], tuple[1], tuple[2]);
    }
    if (scale && mapper->GetClamping() && scaling != vtkGlyph3DMapper::NO_DATA_SCALING)
    {
      factors = (glm::clamp(factors, range[0], range[1]) - range[0]) / width;
    }
    instance.Factors = mapper->GetScaling() ? factors * mapper->GetScaleFactor() : glm::dvec3(1.0);
    const glm::dmat3 turn = ways ? FindTurn(mode, ways->GetTuple(i)) : glm::dmat3(1.0);
    double place[3];
    data->GetPoint(i, place);
    for (int k = 0; k < 3; ++k)
    {
      instance.ToData[k] = glm::dvec4(instance.Factors[k] * turn[k], 0.0);
    }
    instance.ToData[3] = glm::dvec4(place[0], place[1], place[2], 1.0);
    call(instance);
  }
}
