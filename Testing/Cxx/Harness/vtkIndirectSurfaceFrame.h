// SPDX-License-Identifier: BSD-3-Clause
// A frame over the unit cube, without a window, for tests of what the processor reads of actors.
#ifndef vtkIndirectSurfaceFrame_h
#define vtkIndirectSurfaceFrame_h

#include "Scene/vtkIndirectFrame.h" // for a member

#include "vtkActor.h"          // for members
#include "vtkCellArray.h"      // for meshes
#include "vtkNew.h"            // for meshes
#include "vtkPoints.h"         // for meshes
#include "vtkPolyData.h"       // for meshes
#include "vtkPolyDataMapper.h" // for meshes
#include "vtkProperty.h"       // for colours
#include "vtkSmartPointer.h"   // for members

#include <array>       // for triangles
#include <glm/glm.hpp> // for vectors
#include <vector>      // for members

namespace vtkIndirectTest
{
struct SurfaceFrame
{
  using Corners = std::array<glm::dvec3, 3>;

  vtkIndirectFrame Frame;
  std::vector<vtkSmartPointer<vtkActor>> Actors;

  SurfaceFrame()
  {
    for (int i = 0; i < 6; ++i)
    {
      this->Frame.SceneBounds[i] = i % 2;
    }
  }

  /** Adds any prop's actor as a caster. */
  void Add(vtkActor* actor)
  {
    this->Actors.emplace_back(actor);
    vtkIndirectCaster caster;
    caster.Prop = actor;
    caster.Revision = this->Actors.size();
    this->Frame.Casters.push_back(caster);
  }

  /** Adds an actor of triangles of one albedo, the same for all colours. */
  vtkActor* Add(const std::vector<Corners>& triangles, double albedo)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> cells;
    for (const Corners& corners : triangles)
    {
      cells->InsertNextCell(3);
      for (const glm::dvec3& corner : corners)
      {
        cells->InsertCellPoint(points->InsertNextPoint(corner.x, corner.y, corner.z));
      }
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(albedo, albedo, albedo);
    this->Add(actor);
    return actor;
  }
};
}
#endif
