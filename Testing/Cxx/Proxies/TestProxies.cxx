// SPDX-License-Identifier: BSD-3-Clause
// The program of the tests of VTK::IndirectProxies, and their shared parts.
#include "ProxiesTestTools.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>

namespace
{
constexpr double Pi = 3.14159265358979323846;

// Fails the test for all messages without an observer.
class Window : public vtkOutputWindow
{
public:
  static Window* New();
  vtkTypeMacro(Window, vtkOutputWindow);

  void DisplayErrorText(const char* text) override
  {
    vtkIndirectTest::AddFailure();
    std::cerr << "FAILED " << text << "\n";
  }
  void DisplayWarningText(const char* text) override { this->DisplayErrorText(text); }
  void DisplayGenericWarningText(const char* text) override { this->DisplayErrorText(text); }
  void DisplayText(const char* text) override { std::cerr << text << "\n"; }
};
vtkStandardNewMacro(Window);

struct Messages
{
  int Count = 0;
  std::string Text;
};

void Report(const std::string& what, double measured, const std::string& limit, bool good,
  const std::string& origin)
{
  vtkIndirectTest::AddCheck();
  if (!good)
  {
    vtkIndirectTest::AddFailure();
  }
  std::cout << (good ? "ok     " : "FAILED ") << what << ": " << measured << limit
            << (origin.empty() ? "" : "  (" + origin + ")") << "\n";
}

// A grid of quadrilaterals over (u, v), each two triangles; sides that wrap share points.
vtkSmartPointer<vtkPolyData> MakeGrid(int columns, int rows, bool wrapColumns, bool wrapRows,
  const std::function<glm::dvec3(double, double)>& place)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const int width = columns + (wrapColumns ? 0 : 1);
  const int height = rows + (wrapRows ? 0 : 1);
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      const glm::dvec3 p = place(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
      points->InsertNextPoint(p.x, p.y, p.z);
    }
  }
  vtkNew<vtkCellArray> polygons;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const vtkIdType a = j * width + i;
      const vtkIdType b = j * width + (i + 1) % width;
      const vtkIdType c = (j + 1) % height * width + (i + 1) % width;
      const vtkIdType d = (j + 1) % height * width + i;
      const vtkIdType first[3] = { a, b, c };
      const vtkIdType second[3] = { a, c, d };
      polygons->InsertNextCell(3, first);
      polygons->InsertNextCell(3, second);
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polygons);
  return mesh;
}
}

namespace proxytest
{
bool Check(const std::string& what, bool condition, const std::string& origin)
{
  Report(what, condition, "", condition, origin);
  return condition;
}

bool CheckAtMost(const std::string& what, double measured, double limit, const std::string& origin)
{
  Report(what, measured, " <= " + std::to_string(limit), measured <= limit, origin);
  return measured <= limit;
}

bool CheckAtLeast(const std::string& what, double measured, double limit, const std::string& origin)
{
  Report(what, measured, " >= " + std::to_string(limit), measured >= limit, origin);
  return measured >= limit;
}

bool CheckNear(const std::string& what, double measured, double expected, double tolerance,
  const std::string& origin)
{
  const bool good = std::abs(measured - expected) <= tolerance;
  Report(what, measured, " for " + std::to_string(expected) + " +- " + std::to_string(tolerance),
    good, origin);
  return good;
}

int CountErrors(vtkAlgorithm* algorithm, std::string* text)
{
  Messages messages;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&messages);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* data, void* call)
    {
      auto* to = static_cast<Messages*>(data);
      ++to->Count;
      to->Text += static_cast<const char*>(call);
    });
  algorithm->AddObserver(vtkCommand::ErrorEvent, command);
  algorithm->Update();
  algorithm->RemoveObserver(command);
  if (text)
  {
    *text = messages.Text;
  }
  return messages.Count;
}

std::vector<Triangle> TrianglesOf(vtkPolyData* mesh)
{
  std::vector<Triangle> triangles;
  auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCurrentCell(size, ids);
    glm::dvec3 corners[3];
    for (int i = 0; i < 3; ++i)
    {
      double p[3];
      mesh->GetPoint(ids[i], p);
      corners[i] = { p[0], p[1], p[2] };
    }
    triangles.push_back({ corners[0], corners[1], corners[2] });
  }
  return triangles;
}

std::vector<glm::dvec3> SampleTriangles(const std::vector<Triangle>& triangles, int count)
{
  std::vector<double> sums;
  double sum = 0.0;
  for (const Triangle& t : triangles)
  {
    sum += glm::length(glm::cross(t.B - t.A, t.C - t.A));
    sums.push_back(sum);
  }
  Random random(7);
  std::vector<glm::dvec3> samples;
  for (int i = 0; i < count; ++i)
  {
    const auto found = std::upper_bound(sums.begin(), sums.end(), random.Next() * sum);
    const auto& t = triangles[std::min<size_t>(found - sums.begin(), triangles.size() - 1)];
    const double root = std::sqrt(random.Next());
    const double v = random.Next();
    samples.push_back((1.0 - root) * t.A + root * (1.0 - v) * t.B + root * v * t.C);
  }
  return samples;
}

double DistanceToTriangles(const std::vector<Triangle>& triangles, const glm::dvec3& p)
{
  double least = std::numeric_limits<double>::max();
  for (const Triangle& t : triangles)
  {
    const glm::dvec3 corners[3] = { t.A, t.B, t.C };
    const glm::dvec3 normal = glm::cross(t.B - t.A, t.C - t.A);
    bool inside = true;
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3& a = corners[i];
      const glm::dvec3 edge = corners[(i + 1) % 3] - a;
      const double along =
        std::min(std::max(glm::dot(p - a, edge) / glm::dot(edge, edge), 0.0), 1.0);
      least = std::min(least, glm::length(a + along * edge - p));
      inside = inside && glm::dot(glm::cross(normal, edge), p - a) >= 0.0;
    }
    if (inside)
    {
      least = std::min(least, std::abs(glm::dot(p - t.A, glm::normalize(normal))));
    }
  }
  return least;
}

bool IsInside(const std::vector<Triangle>& triangles, const glm::dvec3& p)
{
  // Moeller and Trumbore 1997, along a direction that meets no edge of the tests' meshes.
  const glm::dvec3 way = glm::normalize(glm::dvec3(0.53761, 0.30127, 0.78707));
  int met = 0;
  for (const Triangle& t : triangles)
  {
    const glm::dvec3 u = t.B - t.A;
    const glm::dvec3 v = t.C - t.A;
    const glm::dvec3 h = glm::cross(way, v);
    const double determinant = glm::dot(u, h);
    if (determinant == 0.0)
    {
      continue;
    }
    const glm::dvec3 s = (p - t.A) / determinant;
    const double a = glm::dot(s, h);
    const glm::dvec3 q = glm::cross(s, u);
    const double b = glm::dot(way, q);
    met += a >= 0.0 && b >= 0.0 && a + b <= 1.0 && glm::dot(v, q) > 0.0 ? 1 : 0;
  }
  return met % 2 == 1;
}

std::vector<Sphere> SpheresOf(vtkPolyData* spheres)
{
  std::vector<Sphere> found;
  vtkDataArray* radii = spheres->GetPointData()->GetArray("Radius");
  for (vtkIdType i = 0; i < spheres->GetNumberOfPoints(); ++i)
  {
    double p[3];
    spheres->GetPoint(i, p);
    found.push_back({ { p[0], p[1], p[2] }, radii->GetComponent(i, 0) });
  }
  return found;
}

double DistanceToSpheres(const std::vector<Sphere>& spheres, const glm::dvec3& p)
{
  double least = std::numeric_limits<double>::max();
  for (const Sphere& sphere : spheres)
  {
    least = std::min(least, glm::length(p - sphere.Center) - sphere.Radius);
  }
  return least;
}

Random::Random(std::uint64_t seed)
  : State(seed * 6364136223846793005ULL + 1442695040888963407ULL)
{
}

double Random::Next()
{
  const std::uint64_t old = this->State;
  this->State = old * 6364136223846793005ULL + 1442695040888963407ULL;
  const auto shifted = static_cast<std::uint32_t>(((old >> 18u) ^ old) >> 27u);
  const auto rotation = static_cast<std::uint32_t>(old >> 59u);
  return ((shifted >> rotation) | (shifted << ((32u - rotation) & 31u))) / 4294967296.0;
}

vtkSmartPointer<vtkPolyData> MakeSphere(int around, int rings)
{
  return MakeGrid(around, rings, true, false,
    [](double u, double v)
    {
      return glm::dvec3(std::sin(Pi * v) * std::cos(2.0 * Pi * u),
        std::sin(Pi * v) * std::sin(2.0 * Pi * u), -std::cos(Pi * v));
    });
}

vtkSmartPointer<vtkPolyData> MakeCube()
{
  // The sphere's grid scaled to a cube: four sides, and lids of triangles at the poles.
  return MakeGrid(4, 3, true, false,
    [](double u, double v)
    {
      const double turn = 2.0 * Pi * (u + 0.125);
      const double r = v > 0.1 && v < 0.9 ? 1.0 / std::sqrt(0.5) : 0.0;
      return glm::dvec3(0.5 * r * std::cos(turn), 0.5 * r * std::sin(turn), v < 0.5 ? -0.5 : 0.5);
    });
}

vtkSmartPointer<vtkPolyData> MakeTorus(int around, int across)
{
  return MakeGrid(around, across, true, true,
    [](double u, double v)
    {
      const double a = 2.0 * Pi * u;
      const double b = 2.0 * Pi * v;
      const double tube = 0.35 + 0.1 * std::cos(3.0 * a);
      return glm::dvec3((1.0 + tube * std::cos(b)) * std::cos(a),
        (1.0 + tube * std::cos(b)) * std::sin(a), tube * std::sin(b));
    });
}

vtkSmartPointer<vtkPolyData> MakeSquare(int cells)
{
  return MakeGrid(
    cells, cells, false, false, [](double u, double v) { return glm::dvec3(u, v, 0.0); });
}

vtkSmartPointer<vtkPolyData> Map(
  vtkPolyData* mesh, const std::function<glm::dvec3(const glm::dvec3&)>& motion)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    const glm::dvec3 q = motion({ p[0], p[1], p[2] });
    points->InsertNextPoint(q.x, q.y, q.z);
  }
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(mesh);
  moved->SetPoints(points);
  return moved;
}
}

int main(int argc, char* argv[])
{
  const int result = vtkIndirectTest::Main(argc, argv,
    [](const std::string&)
    {
      vtkNew<Window> window;
      vtkOutputWindow::SetInstance(window);
    });
  vtkOutputWindow::SetInstance(nullptr);
  return result;
}
