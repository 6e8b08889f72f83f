// SPDX-License-Identifier: BSD-3-Clause
// Simplified meshes: distances both ways by brute force, borders, data, hard input.
#include "ProxiesTestTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMeshSimplificationFilter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace proxytest;

namespace
{
// The larger of both directions, at corners and samples.
double Hausdorff(vtkPolyData* one, vtkPolyData* other)
{
  double worst = 0.0;
  for (int way = 0; way < 2; ++way)
  {
    const std::vector<Triangle> from = TrianglesOf(way ? other : one);
    const std::vector<Triangle> to = TrianglesOf(way ? one : other);
    std::vector<glm::dvec3> places = SampleTriangles(from, 3000);
    for (const Triangle& t : from)
    {
      places.push_back(t.A);
      places.push_back(t.B);
      places.push_back(t.C);
    }
    for (const glm::dvec3& p : places)
    {
      worst = std::max(worst, DistanceToTriangles(to, p));
    }
  }
  return worst;
}

vtkSmartPointer<vtkDoubleArray> Numbers(const char* name, vtkIdType count)
{
  auto numbers = vtkSmartPointer<vtkDoubleArray>::New();
  numbers->SetName(name);
  for (vtkIdType i = 0; i < count; ++i)
  {
    numbers->InsertNextValue(static_cast<double>(i));
  }
  return numbers;
}
}

VTK_INDIRECT_TEST(SimplificationError)
{
  auto mesh = MakeTorus(60, 30);
  vtkIdType before = mesh->GetNumberOfPolys();
  for (double error : { 0.004, 0.008, 0.02 })
  {
    vtkNew<vtkMeshSimplificationFilter> filter;
    filter->SetInputData(mesh);
    filter->SetMaximumError(error);
    filter->Update();
    const std::string name = "error " + std::to_string(error);
    const double apart = Hausdorff(mesh, filter->GetOutput());
    const double bound = error * mesh->GetLength();
    CheckAtMost(name + ": apart, over the bound", apart / bound, 1.0 + 1e-6, "asked for");
    CheckNear(name + ": reported, over measured", filter->GetMaximumDistance() / apart, 1.0, 0.2,
      "samples of both");
    Check(name + ": fewer triangles", filter->GetOutput()->GetNumberOfPolys() < before);
    before = filter->GetOutput()->GetNumberOfPolys();
  }
  CheckAtMost("triangles left of 3600 within 2 %", static_cast<double>(before), 700,
    "a bound of 0.02 is a fifth of the thinnest tube");
  vtkNew<vtkMeshSimplificationFilter> filter;
  filter->SetInputData(mesh);
  filter->SetErrorUnitToWorldUnits();
  filter->SetMaximumError(0.02 * mesh->GetLength());
  filter->Update();
  CheckNear("the same in world units", static_cast<double>(filter->GetOutput()->GetNumberOfPolys()),
    static_cast<double>(before), 0.0, "the same bound");
}

VTK_INDIRECT_TEST(SimplificationTarget)
{
  auto mesh = MakeTorus(60, 30);
  vtkNew<vtkMeshSimplificationFilter> filter;
  filter->SetInputData(mesh);
  filter->SetMaximumError(0.5);
  filter->SetTargetNumberOfTriangles(1000);
  filter->Update();
  CheckNear("triangles of a target of 1000",
    static_cast<double>(filter->GetOutput()->GetNumberOfPolys()), 1000, 2, "a collapse takes two");
}

VTK_INDIRECT_TEST(SimplificationBorder)
{
  // Flat: two triangles would suffice, but for the border.
  auto mesh = MakeSquare(20);
  mesh->GetPointData()->AddArray(Numbers("point", mesh->GetNumberOfPoints()));
  mesh->GetCellData()->AddArray(Numbers("cell", mesh->GetNumberOfCells()));
  vtkNew<vtkMeshSimplificationFilter> filter;
  filter->SetInputData(mesh);
  filter->SetMaximumError(0.0);
  filter->Update();
  vtkPolyData* made = filter->GetOutput();
  int border = 0;
  bool same = true;
  vtkDataArray* numbers = made->GetPointData()->GetArray("point");
  for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
  {
    double p[3];
    made->GetPoint(i, p);
    border += p[0] == 0.0 || p[0] == 1.0 || p[1] == 0.0 || p[1] == 1.0;
    double q[3];
    mesh->GetPoint(static_cast<vtkIdType>(numbers->GetComponent(i, 0)), q);
    same = same && p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
  }
  CheckNear("points on the border", border, 80, 0.0, "all of them");
  CheckAtMost("points inside", static_cast<double>(made->GetNumberOfPoints() - border), 12,
    "of 361; flat parts need none");
  Check("points have their own data", same);
  vtkDataArray* cells = made->GetCellData()->GetArray("cell");
  Check("cells have data", cells && cells->GetNumberOfTuples() == made->GetNumberOfCells());
  filter->PreserveBoundaryOff();
  filter->Update();
  CheckAtMost("triangles where the border may change",
    static_cast<double>(filter->GetOutput()->GetNumberOfPolys()), 30, "of 800");
  CheckAtMost("corners are kept", Hausdorff(mesh, filter->GetOutput()), 1e-6, "an error of zero");
}

VTK_INDIRECT_TEST(SimplificationHardInput)
{
  vtkNew<vtkMeshSimplificationFilter> filter;
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  Check("empty", CountErrors(filter) == 0 && filter->GetOutput()->GetNumberOfPolys() == 0);
  auto square = MakeSquare(4);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  filter->SetInputData(Map(
    square, [&](const glm::dvec3& p) { return p.x == 0.5 && p.y == 0.5 ? glm::dvec3(nan) : p; }));
  std::string text;
  Check("a point that is no number: one error", CountErrors(filter, &text) == 1, text);
  Check("and nothing", filter->GetOutput()->GetNumberOfPolys() == 0);
  // Three sheets at one edge, and points of no triangle.
  auto torus = MakeTorus(40, 20);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> soup;
  for (const Triangle& t : TrianglesOf(torus))
  {
    vtkIdType ids[3];
    int i = 0;
    for (const glm::dvec3& p : { t.A, t.B, t.C })
    {
      ids[i++] = points->InsertNextPoint(p.x, p.y, p.z);
    }
    soup->InsertNextCell(3, ids);
  }
  vtkNew<vtkPolyData> loose;
  loose->SetPoints(points);
  loose->SetPolys(soup);
  filter->SetInputData(loose);
  Check("no shared points", CountErrors(filter) == 0);
  CheckAtMost("simplifies all the same",
    static_cast<double>(filter->GetOutput()->GetNumberOfPolys()), 1000, "of 1600");
  vtkNew<vtkPoints> fan;
  vtkNew<vtkCellArray> wings;
  fan->InsertNextPoint(0.0, 0.0, 0.0);
  fan->InsertNextPoint(0.0, 0.0, 1.0);
  for (int i = 0; i < 3; ++i)
  {
    const vtkIdType ids[3] = { 0, 1,
      fan->InsertNextPoint(std::cos(2.0 * i), std::sin(2.0 * i), 0.5) };
    wings->InsertNextCell(3, ids);
  }
  vtkNew<vtkPolyData> three;
  three->SetPoints(fan);
  three->SetPolys(wings);
  filter->SetInputData(three);
  Check("three triangles at an edge", CountErrors(filter) == 0);
  CheckNear("all are there", static_cast<double>(filter->GetOutput()->GetNumberOfPolys()), 3, 0.0,
    "nothing of them can go");
  for (double scale : { 1e-9, 1e6 })
  {
    auto scaled = Map(torus, [&](const glm::dvec3& p) { return scale * p; });
    filter->SetInputData(scaled);
    filter->Update();
    CheckAtMost("scale " + std::to_string(scale) + ": apart, over the bound",
      Hausdorff(scaled, filter->GetOutput()) / (0.01 * scaled->GetLength()), 1.0 + 1e-6,
      "asked for");
  }
}
