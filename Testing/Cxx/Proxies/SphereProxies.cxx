// SPDX-License-Identifier: BSD-3-Clause
// Spheres that represent meshes: reported measures against brute force, motion, hard input.
#include "ProxiesTestTools.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereProxyFilter.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace proxytest;

namespace
{
// The filter's measures against brute force; `closed` meshes have an inside.
void CheckMeasures(const std::string& name, vtkPolyData* mesh, vtkSphereProxyFilter* filter)
{
  const std::vector<Triangle> triangles = TrianglesOf(mesh);
  const std::vector<Sphere> spheres = SpheresOf(filter->GetOutput());
  const double error = filter->GetError();
  double gap = -1e30;
  double squares = 0.0;
  int covered = 0;
  const int count = 20000;
  for (const glm::dvec3& p : SampleTriangles(triangles, count))
  {
    const double d = DistanceToSpheres(spheres, p);
    gap = std::max(gap, d);
    squares += d * d;
    covered += d <= error ? 1 : 0;
  }
  CheckNear(name + ": covered area", filter->GetCoveredArea(), covered / double(count), 0.006,
    "four standard deviations of 20000 samples at 0.01");
  CheckNear(name + ": largest gap over the error", filter->GetMaximumGap() / error,
    std::max(gap, 0.0) / error, 0.3, "the largest of 20000 samples, twice");
  CheckNear(name + ": root mean square over the error", filter->GetRootMeanSquareError() / error,
    std::sqrt(squares / count) / error, 0.02, "two sets of 20000 samples");
  // Largest extent of spheres outside of the solid, at random points of them.
  Random random(3);
  double out = 0.0;
  for (const Sphere& sphere : spheres)
  {
    for (int i = 0; i < 60; ++i)
    {
      const double z = 2.0 * random.Next() - 1.0;
      const double turn = 6.283185307 * random.Next();
      const double s = std::sqrt(1.0 - z * z);
      const glm::dvec3 p =
        sphere.Center + sphere.Radius * glm::dvec3(s * std::cos(turn), s * std::sin(turn), z);
      if (!IsInside(triangles, p))
      {
        out = std::max(out, DistanceToTriangles(triangles, p));
      }
    }
  }
  CheckAtMost(name + ": protrusion over what is reported", out / filter->GetMaximumProtrusion(),
    1.0 + 1e-6, "radius less depth of the center is a bound");
  CheckAtLeast(name + ": the same", out / filter->GetMaximumProtrusion(), 0.6,
    "60 places a sphere miss the farthest");
  // Volumes.
  double bounds[6];
  mesh->GetBounds(bounds);
  const double grow = filter->GetMaximumProtrusion();
  const glm::dvec3 low(bounds[0] - grow, bounds[2] - grow, bounds[4] - grow);
  const glm::dvec3 high(bounds[1] + grow, bounds[3] + grow, bounds[5] + grow);
  int inside = 0;
  int both = 0;
  int outside = 0;
  const int places = 20000;
  for (int i = 0; i < places; ++i)
  {
    const double x = random.Next();
    const double y = random.Next();
    const glm::dvec3 p = low + (high - low) * glm::dvec3(x, y, random.Next());
    const bool in = IsInside(triangles, p);
    const bool of = DistanceToSpheres(spheres, p) <= 0.0;
    inside += in;
    both += in && of;
    outside += !in && of;
  }
  const glm::dvec3 box = high - low;
  const double part = box.x * box.y * box.z / places;
  const std::string origin = "four standard deviations of 20000 places";
  CheckNear(name + ": volume of the solid, over its own",
    filter->GetSolidVolume() / (inside * part), 1.0, 4.0 / std::sqrt(inside), origin);
  CheckNear(name + ": covered volume", filter->GetCoveredVolume(), both / double(inside),
    4.0 * 0.25 / std::sqrt(inside), origin);
  CheckNear(name + ": protruding volume, over the solid's",
    filter->GetProtrudingVolume() / filter->GetSolidVolume(), outside / double(inside),
    4.0 * std::sqrt(outside) / inside, origin);
}

vtkSmartPointer<vtkPolyData> Join(const std::vector<vtkPolyData*>& meshes)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  for (vtkPolyData* mesh : meshes)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      points->InsertNextPoint(mesh->GetPoint(i));
    }
    for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
    {
      vtkIdType size;
      const vtkIdType* ids;
      mesh->GetPolys()->GetCellAtId(i, size, ids);
      const vtkIdType moved[3] = { ids[0] + first, ids[1] + first, ids[2] + first };
      polygons->InsertNextCell(3, moved);
    }
  }
  auto joined = vtkSmartPointer<vtkPolyData>::New();
  joined->SetPoints(points);
  joined->SetPolys(polygons);
  return joined;
}
}

VTK_INDIRECT_TEST(SphereProxiesOfASphere)
{
  // One ball is one sphere, for either target.
  auto mesh = MakeSphere(40, 26);
  for (bool byError : { false, true })
  {
    vtkNew<vtkSphereProxyFilter> filter;
    filter->SetInputData(mesh);
    filter->SetNumberOfSpheres(1);
    filter->SetTarget(
      byError ? vtkSphereProxyFilter::MAXIMUM_ERROR : vtkSphereProxyFilter::NUMBER_OF_SPHERES);
    filter->SetMaximumError(0.01);
    filter->Update();
    const std::vector<Sphere> spheres = SpheresOf(filter->GetOutput());
    Check("one sphere", spheres.size() == 1);
    CheckAtMost("its center off the middle", glm::length(spheres[0].Center), 1e-3,
      "facets of 40 by 26 lie 0.007 below the sphere");
    CheckNear("its radius", spheres[0].Radius, 0.995, 0.005, "between facets and corners");
  }
}

VTK_INDIRECT_TEST(SphereProxiesMeasures)
{
  auto torus = MakeTorus(48, 24);
  auto cube = MakeCube();
  for (int count : { 40, 200 })
  {
    for (vtkPolyData* mesh : { torus.Get(), cube.Get() })
    {
      const std::string name =
        (mesh == cube ? "cube of " : "torus of ") + std::to_string(count) + " spheres";
      vtkNew<vtkSphereProxyFilter> filter;
      filter->SetInputData(mesh);
      filter->SetNumberOfSpheres(count);
      filter->Update();
      const auto made = static_cast<int>(filter->GetOutput()->GetNumberOfPoints());
      CheckAtMost(name + ": spheres", made, count, "asked for");
      CheckAtLeast(name + ": spheres", made, 0.9 * count, "the search ends near it");
      CheckMeasures(name, mesh, filter);
    }
  }
}

VTK_INDIRECT_TEST(SphereProxiesError)
{
  // The bound holds at points that the filter has not sampled.
  auto mesh = MakeTorus(64, 32);
  const std::vector<Triangle> triangles = TrianglesOf(mesh);
  vtkIdType before = 0;
  for (double error : { 0.05, 0.02, 0.01 })
  {
    vtkNew<vtkSphereProxyFilter> filter;
    filter->SetInputData(mesh);
    filter->SetTargetToMaximumError();
    filter->SetErrorUnitToWorldUnits();
    filter->SetMaximumError(error * mesh->GetLength());
    filter->Update();
    const std::string name = "error " + std::to_string(error);
    CheckNear(name + ": as asked", filter->GetError() / mesh->GetLength(), error, 1e-9, "rounding");
    const std::vector<Sphere> spheres = SpheresOf(filter->GetOutput());
    double gap = 0.0;
    double deep = 0.0;
    for (const glm::dvec3& p : SampleTriangles(triangles, 20000))
    {
      const double d = DistanceToSpheres(spheres, p);
      gap = std::max(gap, d);
      deep = std::max(deep, -d);
    }
    CheckAtMost(name + ": surface outside of spheres", gap / filter->GetError(), 1.0, "asked for");
    CheckAtMost(name + ": surface inside of spheres", deep / filter->GetError(), 1.0 + 1e-6,
      "spheres stick out by no more");
    CheckAtMost(name + ": protrusion", filter->GetMaximumProtrusion() / filter->GetError(),
      1.0 + 1e-9, "asked for");
    Check(name + ": more spheres than for a larger one",
      filter->GetOutput()->GetNumberOfPoints() > before);
    before = filter->GetOutput()->GetNumberOfPoints();
  }
}

VTK_INDIRECT_TEST(SphereProxiesRefine)
{
  auto mesh = MakeTorus(48, 24);
  double errors[2];
  double volumes[2];
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkSphereProxyFilter> filter;
    filter->SetInputData(mesh);
    filter->SetNumberOfSpheres(100);
    filter->SetRefinementSteps(i * 10);
    filter->Update();
    errors[i] = filter->GetRootMeanSquareError();
    volumes[i] = filter->GetProtrudingVolume();
  }
  CheckAtMost(
    "root mean square error, over that without steps", errors[1] / errors[0], 0.85, "0.7 measured");
  CheckAtMost(
    "protruding volume, over that without steps", volumes[1] / volumes[0], 0.75, "0.5 measured");
}

VTK_INDIRECT_TEST(SphereProxiesSheets)
{
  // A square, and half of a sphere: they enclose no volume, and transmit no light.
  auto ball = MakeSphere(32, 32);
  auto bowl = Map(ball, [](const glm::dvec3& p) { return p; });
  vtkNew<vtkCellArray> lower;
  for (vtkIdType i = 0; i < bowl->GetNumberOfPolys() / 2; ++i)
  {
    vtkIdType size;
    const vtkIdType* ids;
    bowl->GetPolys()->GetCellAtId(i, size, ids);
    lower->InsertNextCell(size, ids);
  }
  bowl->SetPolys(lower);
  auto square = MakeSquare(10);
  for (vtkPolyData* mesh : { square.Get(), bowl.Get() })
  {
    const std::string name = mesh == square ? "square" : "bowl";
    vtkNew<vtkSphereProxyFilter> filter;
    filter->SetInputData(mesh);
    filter->SetTargetToMaximumError();
    filter->SetMaximumError(0.03);
    filter->Update();
    const std::vector<Sphere> spheres = SpheresOf(filter->GetOutput());
    const std::vector<Triangle> triangles = TrianglesOf(mesh);
    double off = 0.0;
    for (const Sphere& sphere : spheres)
    {
      off = std::max(off, DistanceToTriangles(triangles, sphere.Center));
    }
    CheckAtMost(name + ": centers off the surface", off, 1e-9, "they are on it");
    double gap = -1.0;
    for (const glm::dvec3& p : SampleTriangles(triangles, 20000))
    {
      gap = std::max(gap, DistanceToSpheres(spheres, p));
    }
    CheckAtMost(name + ": surface outside of spheres, over the error", gap / filter->GetError(),
      0.03, "what lies between the filter's samples");
    CheckNear(name + ": volume that it encloses", filter->GetSolidVolume(), 0.0, 0.0, "none");
    CheckNear(name + ": protrusion", filter->GetMaximumProtrusion(), filter->GetError(), 1e-9,
      "the radius");
  }
  // A body with a hole of a twentieth of its surface is still a solid.
  auto holed = Map(ball, [](const glm::dvec3& p) { return p; });
  vtkNew<vtkCellArray> most;
  for (vtkIdType i = 0; i < holed->GetNumberOfPolys(); ++i)
  {
    vtkIdType size;
    const vtkIdType* ids;
    holed->GetPolys()->GetCellAtId(i, size, ids);
    if (i < 2 * 32 * 27)
    {
      most->InsertNextCell(size, ids);
    }
  }
  holed->SetPolys(most);
  vtkNew<vtkSphereProxyFilter> filter;
  filter->SetInputData(holed);
  filter->SetNumberOfSpheres(50);
  filter->Update();
  CheckNear("volume of a ball with a hole", filter->GetSolidVolume(), 4.0, 0.25,
    "the ball's 4.19, less facets and a cap of 0.5 radians");
  filter->SetMaximumOpening(0.0);
  filter->Update();
  CheckNear("where holes are not closed", filter->GetSolidVolume(), 0.0, 0.0, "none");
}

VTK_INDIRECT_TEST(SphereProxiesMotion)
{
  // A moving mesh; its spheres are bound to its points.
  auto mesh = MakeTorus(64, 32);
  vtkNew<vtkSphereProxyFilter> filter;
  filter->SetInputData(mesh);
  filter->SetNumberOfSpheres(150);
  filter->Update();
  const std::vector<Sphere> rest = SpheresOf(filter->GetOutput());
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  auto rigid = [&](const glm::dvec3& p)
  { return glm::dvec3(100.0 + c * p.x - s * p.z, p.y - 7.0, s * p.x + c * p.z); };
  filter->SetMovedData(Map(mesh, rigid));
  filter->Update();
  std::vector<Sphere> moved = SpheresOf(filter->GetOutput());
  double off = 0.0;
  double grown = 0.0;
  for (size_t i = 0; i < rest.size(); ++i)
  {
    off = std::max(off, glm::length(moved[i].Center - rigid(rest[i].Center)));
    grown = std::max(grown, std::abs(moved[i].Radius - rest[i].Radius));
  }
  CheckAtMost("rigid motion: centers", off, 1e-6, "weights of sum one that reach the center");
  CheckAtMost("rigid motion: radii", grown, 1e-9, "distances stay");
  // Bent around an axis, like skin over a joint.
  auto bent = [](const glm::dvec3& p)
  {
    const double turn = 0.5 * std::tanh(2.0 * p.x);
    return glm::dvec3(p.x * std::cos(turn) - p.z * std::sin(turn), 1.1 * p.y,
      p.x * std::sin(turn) + p.z * std::cos(turn));
  };
  auto deformed = Map(mesh, bent);
  filter->SetMovedData(deformed);
  filter->Update();
  moved = SpheresOf(filter->GetOutput());
  double squares = 0.0;
  double still = 0.0;
  const int samples = 5000;
  for (const glm::dvec3& p : SampleTriangles(TrianglesOf(deformed), samples))
  {
    const double d = DistanceToSpheres(moved, p);
    squares += d * d / samples;
    const double e = DistanceToSpheres(rest, p);
    still += e * e / samples;
  }
  CheckAtMost("bent: root mean square error over the diagonal",
    std::sqrt(squares) / deformed->GetLength(), 0.01,
    "0.35 of tube, stretched by up to 0.3 in one direction, of which balls know the mean");
  CheckAtLeast("bent: the same of spheres that stay", std::sqrt(still) / deformed->GetLength(),
    0.03, "points move by up to 0.2 of it");
  Check("one fit for all of it", filter->GetNumberOfFits() == 1);
  // Without the pipeline.
  vtkNew<vtkPolyData> out;
  vtkNew<vtkSphereProxyFilter> unmoved;
  unmoved->SetInputData(mesh);
  unmoved->SetNumberOfSpheres(150);
  unmoved->Update();
  Check("MoveSpheres", vtkSphereProxyFilter::MoveSpheres(unmoved->GetOutput(), deformed, out));
  const std::vector<Sphere> same = SpheresOf(out);
  off = 0.0;
  for (size_t i = 0; i < moved.size(); ++i)
  {
    off = std::max(off, glm::length(same[i].Center - moved[i].Center));
  }
  CheckAtMost("the same spheres", off, 0.0, "the same code, the same fit");
  std::string text;
  filter->SetMovedData(MakeSquare(3));
  Check("other points: one error", CountErrors(filter, &text) == 1, text);
}

VTK_INDIRECT_TEST(SphereProxiesScale)
{
  // The same spheres at all scales and places.
  auto mesh = MakeTorus(32, 16);
  std::vector<Sphere> first;
  for (double scale : { 1.0, 1e-9, 1e6 })
  {
    vtkNew<vtkSphereProxyFilter> filter;
    filter->SetInputData(Map(mesh, [&](const glm::dvec3& p) { return scale * p; }));
    filter->SetNumberOfSpheres(30);
    filter->Update();
    std::vector<Sphere> spheres = SpheresOf(filter->GetOutput());
    first = first.empty() ? spheres : first;
    Check("as many", first.size() == spheres.size());
    double off = 0.0;
    for (size_t i = 0; i < std::min(first.size(), spheres.size()); ++i)
    {
      off = std::max(off, glm::length(spheres[i].Center / scale - first[i].Center));
      off = std::max(off, std::abs(spheres[i].Radius / scale - first[i].Radius));
    }
    CheckAtMost("scale " + std::to_string(scale) + ": off", off, 1e-6, "rounding");
  }
}

VTK_INDIRECT_TEST(SphereProxiesSame)
{
  auto mesh = MakeTorus(32, 16);
  std::vector<Sphere> first;
  for (int run = 0; run < 2; ++run)
  {
    vtkNew<vtkSphereProxyFilter> filter;
    filter->SetInputData(mesh);
    filter->SetNumberOfSpheres(60);
    filter->Update();
    std::vector<Sphere> spheres = SpheresOf(filter->GetOutput());
    bool same = run == 0 || spheres.size() == first.size();
    for (size_t i = 0; run == 1 && same && i < spheres.size(); ++i)
    {
      same = spheres[i].Center == first[i].Center && spheres[i].Radius == first[i].Radius;
    }
    Check("bitwise the same", same);
    first = spheres;
  }
}

// Points moved to NaN affect no other spheres.
VTK_INDIRECT_TEST(SphereProxiesMovedToNowhere)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(16);
  source->SetPhiResolution(16);
  vtkNew<vtkSphereProxyFilter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetNumberOfSpheres(12);
  filter->Update();
  vtkNew<vtkPolyData> points;
  points->DeepCopy(source->GetOutput());
  points->GetPoints()->SetPoint(9, 0.1, std::numeric_limits<double>::quiet_NaN(), 0.2);
  vtkNew<vtkPolyData> moved;
  vtkObject::GlobalWarningDisplayOff();
  const bool done = vtkSphereProxyFilter::MoveSpheres(filter->GetOutput(), points, moved);
  vtkObject::GlobalWarningDisplayOn();
  Check("it moves them", done && moved->GetNumberOfPoints() > 0);
  auto* radii = vtkDataArray::SafeDownCast(moved->GetPointData()->GetAbstractArray("Radius"));
  int without = 0;
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    double p[3];
    moved->GetPoint(i, p);
    Check("finite", std::isfinite(p[0] + p[1] + p[2] + radii->GetComponent(i, 0)));
    without += radii->GetComponent(i, 0) == 0.0 ? 1 : 0;
  }
  Check("few have no radius", without < moved->GetNumberOfPoints() / 2);
}

VTK_INDIRECT_TEST(SphereProxiesHardInput)
{
  auto count = [](vtkPolyData* mesh, int* errors = nullptr, std::string* text = nullptr)
  {
    vtkNew<vtkSphereProxyFilter> filter;
    filter->SetInputData(mesh);
    filter->SetNumberOfSpheres(10);
    const int found = CountErrors(filter, text);
    if (errors)
    {
      *errors = found;
    }
    return filter->GetOutput()->GetNumberOfPoints();
  };
  vtkNew<vtkPolyData> empty;
  Check("empty", count(empty) == 0);
  vtkNew<vtkPolyData> point;
  vtkNew<vtkPoints> one;
  one->InsertNextPoint(1.0, 2.0, 3.0);
  vtkNew<vtkCellArray> vertex;
  const vtkIdType zero = 0;
  vertex->InsertNextCell(1, &zero);
  point->SetPoints(one);
  point->SetVerts(vertex);
  Check("one point", count(point) == 0);
  auto square = MakeSquare(4);
  Check("triangles of no area",
    count(Map(square, [](const glm::dvec3& p) { return glm::dvec3(p.x, 0.3 * p.x, 1.0); })) == 0);
  Check("triangles of one point",
    count(Map(square, [](const glm::dvec3&) { return glm::dvec3(5.0); })) == 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  auto broken = Map(
    square, [&](const glm::dvec3& p) { return p.x == 0.5 && p.y == 0.5 ? glm::dvec3(nan) : p; });
  int errors = 0;
  std::string text;
  Check("a point that is no number: no spheres", count(broken, &errors, &text) == 0);
  Check(
    "one error that names it", errors == 1 && text.find("point 12 ") != std::string::npos, text);
  // Without shared points the cube is still closed.
  auto cube = MakeCube();
  vtkNew<vtkPolyData> soup;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygons;
  for (const Triangle& t : TrianglesOf(cube))
  {
    vtkIdType ids[3];
    int i = 0;
    for (const glm::dvec3& p : { t.A, t.B, t.C })
    {
      ids[i++] = points->InsertNextPoint(p.x, p.y, p.z);
    }
    polygons->InsertNextCell(3, ids);
  }
  soup->SetPoints(points);
  soup->SetPolys(polygons);
  auto volume = [](vtkPolyData* mesh)
  {
    vtkNew<vtkSphereProxyFilter> filter;
    filter->SetInputData(mesh);
    filter->SetNumberOfSpheres(4);
    filter->SetResolution(32);
    filter->Update();
    return filter->GetSolidVolume();
  };
  CheckNear("volume of a cube without shared points", volume(soup), 1.0, 0.01,
    "100000 places in a box around it");
  // A nonconvex polygon has no spheres in its notch.
  vtkNew<vtkPolyData> notched;
  vtkNew<vtkPoints> corners;
  vtkNew<vtkCellArray> ell;
  const double places[6][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };
  ell->InsertNextCell(6);
  for (const auto& place : places)
  {
    ell->InsertCellPoint(corners->InsertNextPoint(place[0], place[1], 0.0));
  }
  notched->SetPoints(corners);
  notched->SetPolys(ell);
  vtkNew<vtkSphereProxyFilter> flat;
  flat->SetInputData(notched);
  flat->SetNumberOfSpheres(60);
  flat->Update();
  int inNotch = 0;
  double farthest = 0.0;
  for (const Sphere& sphere : SpheresOf(flat->GetOutput()))
  {
    inNotch += sphere.Center.x > 1.0 && sphere.Center.y > 1.0 ? 1 : 0;
    farthest = std::max(farthest, std::min(sphere.Center.x, 2.0 - sphere.Center.y));
  }
  CheckNear("centers in the notch of an L", inNotch, 0, 0.0, "it is no surface");
  CheckAtLeast("spheres are in its foot", farthest, 1.0, "it is");
  // Triangles of inconsistent orientation, walls through the middle, one cube in another.
  vtkNew<vtkPolyData> turned;
  vtkNew<vtkCellArray> mixed;
  for (vtkIdType i = 0; i < cube->GetNumberOfPolys(); ++i)
  {
    vtkIdType size;
    const vtkIdType* ids;
    cube->GetPolys()->GetCellAtId(i, size, ids);
    const vtkIdType other[3] = { ids[0], ids[i % 2 ? 1 : 2], ids[i % 2 ? 2 : 1] };
    mixed->InsertNextCell(3, other);
  }
  turned->SetPoints(cube->GetPoints());
  turned->SetPolys(mixed);
  CheckNear("volume of a cube of triangles turned at random", volume(turned), 1.0, 0.05,
    "voxels of a 32nd of its edge decide");
  auto beside = Map(cube, [](const glm::dvec3& p) { return p + glm::dvec3(1.0, 0.0, 0.0); });
  CheckNear("volume of two cubes that share a side", volume(Join({ cube, beside })), 2.0, 0.02,
    "100000 places");
  auto half = Map(cube, [](const glm::dvec3& p) { return 0.5 * p; });
  CheckNear("volume of a cube in a cube", volume(Join({ cube, half })), 1.0, 0.01, "100000 places");
  auto hollow = Map(cube, [](const glm::dvec3& p) { return glm::dvec3(-0.5, 0.5, 0.5) * p; });
  CheckNear("volume of a shell", volume(Join({ cube, hollow })), 0.875, 0.01, "100000 places");
}
