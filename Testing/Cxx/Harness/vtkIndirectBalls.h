// SPDX-License-Identifier: BSD-3-Clause
// Balls of several sizes as points, for mappers that draw spheres of them.
#ifndef vtkIndirectBalls_h
#define vtkIndirectBalls_h

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/glm.hpp>
#include <vector>

namespace vtkIndirectTest
{
struct Ball
{
  glm::dvec3 Center;
  double Radius;
};

/** Makes the data's points the centers, and its array `size` the radii. */
inline void SetBalls(vtkPolyData* data, const std::vector<Ball>& balls)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> sizes;
  sizes->SetName("size");
  vtkNew<vtkCellArray> cells;
  for (const Ball& ball : balls)
  {
    const vtkIdType id = points->InsertNextPoint(ball.Center.x, ball.Center.y, ball.Center.z);
    sizes->InsertNextValue(static_cast<float>(ball.Radius));
    cells->InsertNextCell(1, &id);
  }
  data->SetPoints(points);
  data->SetVerts(cells);
  data->GetPointData()->AddArray(sizes);
}
}

#endif
