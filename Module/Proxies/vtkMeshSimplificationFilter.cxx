// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshSimplificationFilter.h"

#include "vtkProxySurface.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wextra"
#endif
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkMeshSimplificationFilter);

namespace
{
constexpr int DistanceSamples = 20000;
constexpr int Tries = 6;

struct Traits : public OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

// Triangles between points of the input, and the cell from which each comes.
struct Simplified
{
  std::vector<vtkProxySurface::Triangle> Triangles;
  std::vector<long long> Cells;
};

// OpenMesh reports refused faces on the standard error output; here refusals are expected.
class Quiet
{
public:
  Quiet() { omerr().disable(); }
  ~Quiet() { omerr().enable(); }
};

//------------------------------------------------------------------------------
// The first of the points at the same position with the same data.
std::vector<long long> JoinPoints(vtkPolyData* input, const std::vector<glm::dvec3>& points)
{
  vtkPointData* data = input->GetPointData();
  auto compare = [&](long long a, long long b)
  {
    const glm::dvec3& p = points[static_cast<size_t>(a)];
    const glm::dvec3& q = points[static_cast<size_t>(b)];
    for (int i = 0; i < 3; ++i)
    {
      if (p[i] != q[i])
      {
        return p[i] < q[i] ? -1 : 1;
      }
    }
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      if (!array)
      {
        // Strings are never merged.
        return a < b ? -1 : a > b ? 1 : 0;
      }
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        const double x = array->GetComponent(a, c);
        const double y = array->GetComponent(b, c);
        if (x != y && !(std::isnan(x) && std::isnan(y)))
        {
          return std::isnan(x) || x < y ? -1 : 1;
        }
      }
    }
    return 0;
  };
  std::vector<long long> order;
  for (long long i = 0; i < static_cast<long long>(points.size()); ++i)
  {
    const glm::dvec3& p = points[static_cast<size_t>(i)];
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
    {
      order.push_back(i);
    }
  }
  std::sort(order.begin(), order.end(),
    [&](long long a, long long b)
    {
      const int c = compare(a, b);
      return c < 0 || (c == 0 && a < b);
    });
  std::vector<long long> joined(points.size());
  std::iota(joined.begin(), joined.end(), 0LL);
  for (size_t i = 1; i < order.size(); ++i)
  {
    if (compare(order[i - 1], order[i]) == 0)
    {
      joined[static_cast<size_t>(order[i])] = joined[static_cast<size_t>(order[i - 1])];
    }
  }
  return joined;
}

//------------------------------------------------------------------------------
Simplified Simplify(const vtkProxySurface& surface, const Simplified& input, double tolerance,
  size_t target, bool keepBorder)
{
  const Quiet quiet;
  Mesh mesh;
  OpenMesh::VPropHandleT<long long> idOf;
  OpenMesh::FPropHandleT<long long> cellOf;
  mesh.add_property(idOf);
  mesh.add_property(cellOf);
  const std::vector<glm::dvec3>& points = surface.GetPoints();
  std::vector<Mesh::VertexHandle> handles(points.size());
  auto add = [&](long long id)
  {
    const glm::dvec3& p = points[static_cast<size_t>(id)];
    const Mesh::VertexHandle made = mesh.add_vertex(Mesh::Point(p.x, p.y, p.z));
    mesh.property(idOf, made) = id;
    return made;
  };
  for (size_t t = 0; t < input.Triangles.size(); ++t)
  {
    const vtkProxySurface::Triangle& triangle = input.Triangles[t];
    Mesh::VertexHandle corners[3];
    for (int i = 0; i < 3; ++i)
    {
      Mesh::VertexHandle& handle = handles[static_cast<size_t>(triangle[i])];
      if (!handle.is_valid())
      {
        handle = add(triangle[i]);
      }
      corners[i] = handle;
    }
    Mesh::FaceHandle face = mesh.add_face(corners[0], corners[1], corners[2]);
    if (!face.is_valid())
    {
      // An edge has more than two triangles, or two sheets touch at a point: these points stay.
      for (int i = 0; i < 3; ++i)
      {
        mesh.status(corners[i]).set_locked(true);
        corners[i] = add(triangle[i]);
        mesh.status(corners[i]).set_locked(true);
      }
      face = mesh.add_face(corners[0], corners[1], corners[2]);
    }
    mesh.property(cellOf, face) = input.Cells[t];
  }
  if (keepBorder)
  {
    for (Mesh::VertexHandle vertex : mesh.vertices())
    {
      if (mesh.is_boundary(vertex))
      {
        mesh.status(vertex).set_locked(true);
      }
    }
  }
  mesh.update_face_normals();
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  OpenMesh::Decimater::ModHausdorffT<Mesh>::Handle distance;
  OpenMesh::Decimater::ModNormalFlippingT<Mesh>::Handle flipping;
  decimater.add(quadric);
  decimater.add(distance);
  decimater.add(flipping);
  decimater.module(quadric).unset_max_err();
  decimater.module(distance).set_tolerance(tolerance);
  decimater.module(flipping).set_max_normal_deviation(90.0f);
  if (decimater.initialize())
  {
    decimater.decimate_to_faces(0, target);
  }
  Simplified found;
  for (Mesh::FaceHandle face : mesh.faces()) // skips deleted faces
  {
    vtkProxySurface::Triangle triangle{};
    size_t i = 0;
    for (Mesh::VertexHandle vertex : mesh.fv_range(face))
    {
      triangle[i++] = mesh.property(idOf, vertex);
    }
    found.Triangles.push_back(triangle);
    found.Cells.push_back(mesh.property(cellOf, face));
  }
  return found;
}

//------------------------------------------------------------------------------
// Largest distance of points and samples of one surface from the other, in the lengths of `from`.
double OneWay(const vtkProxySurface& from, const vtkProxySurface& to)
{
  double worst = 0.0;
  auto look = [&](const glm::dvec3& p)
  {
    const double d = to.FindNearest(to.FromWorld(from.ToWorld(p))).Distance;
    worst = std::max(worst, d * to.GetDiagonal() / from.GetDiagonal());
  };
  for (const vtkProxySurface::Triangle& triangle : from.GetTriangles())
  {
    for (long long id : triangle)
    {
      look(from.GetPoints()[static_cast<size_t>(id)]);
    }
  }
  for (const vtkProxySurface::Sample& sample : from.MakeSamples(DistanceSamples))
  {
    look(sample.Point);
  }
  return worst;
}

//------------------------------------------------------------------------------
void Write(vtkPolyData* input, const Simplified& mesh, vtkPolyData* output)
{
  std::vector<vtkIdType> places(static_cast<size_t>(input->GetNumberOfPoints()), -1);
  vtkNew<vtkPoints> points;
  if (input->GetPoints())
  {
    points->SetDataType(input->GetPoints()->GetDataType());
  }
  vtkNew<vtkCellArray> polygons;
  vtkPointData* pointData = output->GetPointData();
  vtkCellData* cellData = output->GetCellData();
  pointData->CopyAllOn();
  cellData->CopyAllOn();
  pointData->CopyAllocate(input->GetPointData());
  cellData->CopyAllocate(input->GetCellData());
  for (size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    vtkIdType ids[3];
    for (size_t i = 0; i < 3; ++i)
    {
      const vtkIdType old = static_cast<vtkIdType>(mesh.Triangles[t][i]);
      vtkIdType& place = places[static_cast<size_t>(old)];
      if (place < 0)
      {
        double p[3];
        input->GetPoint(old, p);
        place = points->InsertNextPoint(p);
        pointData->CopyData(input->GetPointData(), old, place);
      }
      ids[i] = place;
    }
    const vtkIdType cell = polygons->InsertNextCell(3, ids);
    cellData->CopyData(input->GetCellData(), static_cast<vtkIdType>(mesh.Cells[t]), cell);
  }
  output->SetPoints(points);
  output->SetPolys(polygons);
}
}

//------------------------------------------------------------------------------
int vtkMeshSimplificationFilter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->MaximumDistance = 0.0;
  vtkProxySurface surface;
  std::string wrong;
  if (!surface.Build(input, wrong))
  {
    vtkErrorMacro("the mesh was not simplified: " << wrong);
    return 1;
  }
  Simplified result;
  if (!surface.Empty())
  {
    Simplified whole;
    whole.Triangles = vtkProxySurface::Triangulate(input, &whole.Cells);
    const std::vector<long long> joined = JoinPoints(input, surface.GetPoints());
    size_t kept = 0;
    for (size_t t = 0; t < whole.Triangles.size(); ++t)
    {
      vtkProxySurface::Triangle triangle = whole.Triangles[t];
      for (long long& id : triangle)
      {
        id = joined[static_cast<size_t>(id)];
      }
      if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      {
        whole.Triangles[kept] = triangle;
        whole.Cells[kept++] = whole.Cells[t];
      }
    }
    whole.Triangles.resize(kept);
    whole.Cells.resize(kept);

    const double bound = this->ErrorUnit == WORLD_UNITS ? this->MaximumError / surface.GetDiagonal()
                                                        : this->MaximumError;
    // Rounding error of positions: a surface within this is flat.
    const double least = 1e-7;
    double tolerance = std::min(std::max(bound, least), 1.0);
    for (int i = 0; i < Tries; ++i)
    {
      result = Simplify(surface, whole, tolerance,
        static_cast<size_t>(this->TargetNumberOfTriangles), this->PreserveBoundary);
      this->UpdateProgress((i + 1.0) / Tries);
      vtkNew<vtkPolyData> tried;
      Write(input, result, tried);
      vtkProxySurface simplified;
      simplified.Build(tried, wrong);
      this->MaximumDistance = surface.GetDiagonal();
      if (!simplified.Empty())
      {
        this->MaximumDistance *= std::max(OneWay(surface, simplified),
          OneWay(simplified, surface) * simplified.GetDiagonal() / surface.GetDiagonal());
      }
      if (this->MaximumDistance <= std::max(bound, least) * surface.GetDiagonal())
      {
        break;
      }
      if (i + 2 >= Tries)
      {
        tolerance = 0.0;
        result = whole;
        this->MaximumDistance = 0.0;
        break;
      }
      tolerance *= 0.8 * std::max(bound, least) * surface.GetDiagonal() / this->MaximumDistance;
    }
  }
  Write(input, result, output);
  vtkNew<vtkDoubleArray> distance;
  distance->SetName("MaximumDistance");
  distance->InsertNextValue(this->MaximumDistance);
  output->GetFieldData()->AddArray(distance);
  return 1;
}

//------------------------------------------------------------------------------
void vtkMeshSimplificationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent
     << "ErrorUnit: " << (this->ErrorUnit == WORLD_UNITS ? "WORLD_UNITS" : "SHARE_OF_DIAGONAL")
     << "\n";
  os << indent << "TargetNumberOfTriangles: " << this->TargetNumberOfTriangles << "\n";
  os << indent << "PreserveBoundary: " << (this->PreserveBoundary ? "on" : "off") << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
}
