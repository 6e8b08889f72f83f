// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkIndirectTestSheet_h
#define vtkIndirectTestSheet_h

#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSmartPointer.h"

#include <functional>

namespace vtkIndirectTest
{
// A sheet over a square of two, z up, with smooth normals.
inline vtkSmartPointer<vtkPolyDataNormals> MakeSheet(
  int edge, const std::function<double(double, double)>& height)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1, -1, 0);
  plane->SetPoint1(1, -1, 0);
  plane->SetPoint2(-1, 1, 0);
  plane->SetResolution(edge, edge);
  plane->Update();
  vtkNew<vtkPolyData> data;
  data->DeepCopy(plane->GetOutput());
  data->GetPointData()->Initialize();
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    data->GetPoints()->SetPoint(i, p[0], p[1], height(p[0], p[1]));
  }
  auto normals = vtkSmartPointer<vtkPolyDataNormals>::New();
  normals->SetInputData(data);
  normals->SplittingOff();
  normals->ConsistencyOff();
  return normals;
}
}
#endif
