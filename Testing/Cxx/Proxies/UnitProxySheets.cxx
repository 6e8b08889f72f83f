// SPDX-License-Identifier: BSD-3-Clause
// Meshes that enclose no volume, which spheres cannot represent.
#include "Proxies/vtkIndirectProxyShapes.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"

#include <cmath>

using namespace vtkIndirectTest;

VTK_INDIRECT_TEST(ProxySheets)
{
  const auto isSheet = [](vtkAlgorithm* source)
  {
    source->Update();
    return vtkIndirectProxyShapes::IsSheet(
      vtkPolyData::SafeDownCast(source->GetOutputDataObject(0)));
  };
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  Check("a sphere is none", !isSheet(sphere));
  // Holes about its poles, as scans have them: two rims of 0.2 of its equator's length.
  sphere->SetStartPhi(11.5);
  sphere->SetEndPhi(168.5);
  sphere->SetPhiResolution(21);
  Check("with two holes", !isSheet(sphere));
  sphere->SetStartPhi(0.0);
  sphere->SetEndPhi(90.0);
  Check("half a sphere is one", isSheet(sphere));
  vtkNew<vtkCubeSource> cube; // its sides do not share points
  Check("a cube is none", !isSheet(cube));
  vtkNew<vtkCylinderSource> tube;
  tube->SetResolution(16);
  tube->SetRadius(0.5);
  tube->SetHeight(30.0);
  tube->CappingOff();
  Check("a long tube is none", !isSheet(tube));
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(20, 20);
  plane->Update();
  vtkPoints* points = plane->GetOutput()->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    points->SetPoint(i, p[0], p[1], 0.2 * std::sin(9.0 * p[0]) * std::sin(7.0 * p[1]));
  }
  Check("hills are one", vtkIndirectProxyShapes::IsSheet(plane->GetOutput()));
  vtkNew<vtkStripper> strips;
  vtkNew<vtkSphereSource> whole;
  strips->SetInputConnection(whole->GetOutputPort());
  Check("a sphere of strips is none", !isSheet(strips));
}
