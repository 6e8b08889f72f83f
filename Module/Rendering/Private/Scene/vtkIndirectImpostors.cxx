// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectImpostors.h"

#include "Scene/vtkIndirectActors.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace
{
// Access to protected members of VTK.
struct SphereAccess : public vtkOpenGLSphereMapper
{
  static const char* GetScale(vtkOpenGLSphereMapper* mapper)
  {
    return mapper->*(&SphereAccess::ScaleArray);
  }
};

struct StickAccess : public vtkOpenGLStickMapper
{
  static const char* GetScale(vtkOpenGLStickMapper* mapper)
  {
    return mapper->*(&StickAccess::ScaleArray);
  }
  static const char* GetOrientation(vtkOpenGLStickMapper* mapper)
  {
    return mapper->*(&StickAccess::OrientationArray);
  }
};

vtkDataArray* FindArray(vtkDataSet* data, const char* name)
{
  return name ? data->GetPointData()->GetArray(name) : nullptr;
}

vtkDataArray* FindVectors(vtkDataSet* data, const char* name)
{
  vtkDataArray* array = FindArray(data, name);
  return array && array->GetNumberOfComponents() == 3 ? array : nullptr;
}

// Returns the largest of an array's numbers that are valid sizes: the square of one does not
// overflow. component: -1 for lengths of tuples.
double FindLargest(vtkDataArray* array, int component)
{
  constexpr double most = 1e18;
  double range[2] = { 0.0, 0.0 };
  array->GetFiniteRange(range, component); // the array keeps it
  if (range[1] <= most)
  {
    return std::max(range[1], 0.0);
  }
  double largest = 0.0;
  for (vtkIdType i = 0; component >= 0 && i < array->GetNumberOfTuples(); ++i)
  {
    const double size = array->GetComponent(i, component);
    largest = size <= most ? std::max(largest, size) : largest;
  }
  return largest;
}

double FindReachOf(vtkMapper* mapper, vtkDataSet* data)
{
  if (auto* spheres = vtkOpenGLSphereMapper::SafeDownCast(mapper))
  {
    vtkDataArray* radii = vtkIndirectImpostors::FindRadii(mapper, data);
    return radii ? FindLargest(radii, 0) : std::max(0.0, static_cast<double>(spheres->GetRadius()));
  }
  vtkDataArray* scales = vtkIndirectImpostors::FindStickScales(mapper, data);
  vtkDataArray* ways = vtkIndirectImpostors::FindStickDirections(mapper, data);
  return scales && ways
    ? 0.5 * FindLargest(scales, 0) * FindLargest(ways, -1) + FindLargest(scales, 1)
    : 0.0;
}
}

//------------------------------------------------------------------------------
vtkDataArray* vtkIndirectImpostors::FindRadii(vtkMapper* mapper, vtkDataSet* data)
{
  auto* spheres = vtkOpenGLSphereMapper::SafeDownCast(mapper);
  return spheres ? FindArray(data, SphereAccess::GetScale(spheres)) : nullptr;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkIndirectImpostors::FindStickScales(vtkMapper* mapper, vtkDataSet* data)
{
  auto* sticks = vtkOpenGLStickMapper::SafeDownCast(mapper);
  return sticks ? FindVectors(data, StickAccess::GetScale(sticks)) : nullptr;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkIndirectImpostors::FindStickDirections(vtkMapper* mapper, vtkDataSet* data)
{
  auto* sticks = vtkOpenGLStickMapper::SafeDownCast(mapper);
  return sticks ? FindVectors(data, StickAccess::GetOrientation(sticks)) : nullptr;
}

//------------------------------------------------------------------------------
double vtkIndirectImpostors::FindReach(vtkProp* prop)
{
  double reach = 0.0;
  vtkIndirectActors::ForEach(prop,
    [&reach](vtkActor* actor, vtkMatrix4x4* matrix)
    {
      vtkMapper* mapper = actor->GetMapper();
      if (!mapper->IsA("vtkOpenGLSphereMapper") && !mapper->IsA("vtkOpenGLStickMapper"))
      {
        return;
      }
      // VTK's shaders scale no radius; sums over spheres scale them.
      const glm::dmat4 toWorld = vtkIndirectFrame::ToGLM(matrix);
      const double stretch = std::max({ 1.0, glm::length(glm::dvec3(toWorld[0])),
        glm::length(glm::dvec3(toWorld[1])), glm::length(glm::dvec3(toWorld[2])) });
      vtkIndirectActors::ForEachBlock<vtkDataSet>(mapper->GetInputDataObject(0, 0),
        [&](vtkDataSet* data) { reach = std::max(reach, stretch * FindReachOf(mapper, data)); });
    });
  return std::isfinite(reach) ? reach : 0.0;
}
