// SPDX-License-Identifier: BSD-3-Clause
#include "vtkProxySurface.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace
{
constexpr int LeafSize = 4;
constexpr double FourPi = 12.566370614359172;
// Distance, in radii, from which a group of triangles counts as a dipole.
constexpr double DipoleReach = 2.3;

// Signed solid angle of a triangle.
double SolidAngle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c)
{
  const double la = glm::length(a);
  const double lb = glm::length(b);
  const double lc = glm::length(c);
  const double volume = glm::dot(a, glm::cross(b, c));
  const double base =
    la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  return 2.0 * std::atan2(volume, base);
}

double DistanceToBox(const glm::dvec3& p, const glm::dvec3& low, const glm::dvec3& high)
{
  const glm::dvec3 d = glm::max(glm::max(low - p, p - high), glm::dvec3(0.0));
  return glm::dot(d, d);
}
}

//------------------------------------------------------------------------------
std::vector<vtkProxySurface::Triangle> vtkProxySurface::Triangulate(
  vtkPolyData* mesh, std::vector<long long>* cells)
{
  std::vector<Triangle> triangles;
  long long cell = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    if (a != b && b != c && c != a)
    {
      triangles.push_back({ a, b, c });
      if (cells)
      {
        cells->push_back(cell);
      }
    }
  };
  vtkNew<vtkPolygon> polygon;
  vtkNew<vtkIdList> parts;
  vtkIdType size;
  const vtkIdType* ids;
  auto polygons = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal();
       polygons->GoToNextCell(), ++cell)
  {
    polygons->GetCurrentCell(size, ids);
    if (size == 3)
    {
      add(ids[0], ids[1], ids[2]);
    }
    else if (size > 3)
    {
      polygon->Initialize(static_cast<int>(size), ids, mesh->GetPoints());
      if (polygon->EarCutTriangulation(parts) && parts->GetNumberOfIds() >= 3)
      {
        for (vtkIdType i = 0; i + 2 < parts->GetNumberOfIds(); i += 3)
        {
          add(ids[parts->GetId(i)], ids[parts->GetId(i + 1)], ids[parts->GetId(i + 2)]);
        }
        continue;
      }
      for (vtkIdType i = 1; i + 1 < size; ++i)
      {
        add(ids[0], ids[i], ids[i + 1]);
      }
    }
  }
  auto strips = vtk::TakeSmartPointer(mesh->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell(), ++cell)
  {
    strips->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      add(ids[i], ids[i + 1 + i % 2], ids[i + 2 - i % 2]);
    }
  }
  return triangles;
}

//------------------------------------------------------------------------------
bool vtkProxySurface::Build(vtkPolyData* mesh, std::string& wrong)
{
  *this = vtkProxySurface();
  const vtkIdType count = mesh->GetNumberOfPoints();
  this->Points.resize(static_cast<size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    this->Points[static_cast<size_t>(i)] = { p[0], p[1], p[2] };
  }
  this->Triangles = Triangulate(mesh);
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(-std::numeric_limits<double>::max());
  for (const Triangle& triangle : this->Triangles)
  {
    for (long long id : triangle)
    {
      const glm::dvec3& p = this->Points[static_cast<size_t>(id)];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      {
        wrong = "point " + std::to_string(id) + " of the input is not finite";
        *this = vtkProxySurface();
        return false;
      }
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  if (this->Triangles.empty())
  {
    return true;
  }
  this->Center = 0.5 * low + 0.5 * high;
  this->Diagonal = glm::length(high - low);
  if (!(this->Diagonal > 0.0) || !std::isfinite(this->Diagonal))
  {
    this->Triangles.clear();
    if (!std::isfinite(this->Diagonal))
    {
      wrong = "the input's bounds are too large for double precision";
      return false;
    }
    this->Diagonal = 1.0;
    return true;
  }
  for (glm::dvec3& p : this->Points)
  {
    p = this->FromWorld(p);
  }
  // Rounded coordinates give degenerate triangles some area; below this it is ignored.
  auto flat = [this](const Triangle& t)
  {
    const glm::dvec3& a = this->Points[static_cast<size_t>(t[0])];
    const glm::dvec3 u = this->Points[static_cast<size_t>(t[1])] - a;
    const glm::dvec3 v = this->Points[static_cast<size_t>(t[2])] - a;
    return !(glm::length(glm::cross(u, v)) > 1e-14);
  };
  this->Triangles.erase(
    std::remove_if(this->Triangles.begin(), this->Triangles.end(), flat), this->Triangles.end());
  if (!this->Triangles.empty())
  {
    this->FindOpenParts();
    this->BuildTree();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkProxySurface::BuildTree()
{
  std::vector<glm::dvec3> middles(this->Triangles.size());
  for (size_t i = 0; i < middles.size(); ++i)
  {
    const int t = static_cast<int>(i);
    middles[i] = (this->Corner(t, 0) + this->Corner(t, 1) + this->Corner(t, 2)) / 3.0;
  }
  this->Nodes.reserve(this->Triangles.size());
  this->Nodes.emplace_back();
  this->BuildNode(0, 0, static_cast<int>(this->Triangles.size()), middles);
  double area = 0.0;
  this->Cumulated.reserve(this->Triangles.size());
  for (size_t i = 0; i < this->Triangles.size(); ++i)
  {
    const int t = static_cast<int>(i);
    area += 0.5 *
      glm::length(glm::cross(
        this->Corner(t, 1) - this->Corner(t, 0), this->Corner(t, 2) - this->Corner(t, 0)));
    this->Cumulated.push_back(area);
  }
}

//------------------------------------------------------------------------------
void vtkProxySurface::BuildNode(int node, int first, int count, std::vector<glm::dvec3>& middles)
{
  Node made;
  made.Low = glm::dvec3(std::numeric_limits<double>::max());
  made.High = -made.Low;
  glm::dvec3 low = made.Low;
  glm::dvec3 high = made.High;
  double area = 0.0;
  for (int t = first; t < first + count; ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      made.Low = glm::min(made.Low, this->Corner(t, i));
      made.High = glm::max(made.High, this->Corner(t, i));
    }
    const glm::dvec3 normal = 0.5 *
      glm::cross(this->Corner(t, 1) - this->Corner(t, 0), this->Corner(t, 2) - this->Corner(t, 0));
    const double a = glm::length(normal);
    area += a;
    made.Normal[this->IsOpen[static_cast<size_t>(t)] ? 1 : 0] += normal;
    made.Middle += a * middles[static_cast<size_t>(t)];
    low = glm::min(low, middles[static_cast<size_t>(t)]);
    high = glm::max(high, middles[static_cast<size_t>(t)]);
  }
  made.Middle /= area;
  for (int t = first; t < first + count; ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      made.Radius = std::max(made.Radius, glm::length(this->Corner(t, i) - made.Middle));
    }
  }
  if (count <= LeafSize)
  {
    made.First = first;
    made.Count = count;
    this->Nodes[static_cast<size_t>(node)] = made;
    return;
  }
  const glm::dvec3 extent = high - low;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  // Ties are ordered as the input, so that the tree is the same with every library.
  std::vector<int> order(static_cast<size_t>(count));
  std::iota(order.begin(), order.end(), first);
  std::sort(order.begin(), order.end(),
    [&](int a, int b)
    {
      const double x = middles[static_cast<size_t>(a)][axis];
      const double y = middles[static_cast<size_t>(b)][axis];
      return x < y || (x == y && a < b);
    });
  std::vector<Triangle> triangles(order.size());
  std::vector<glm::dvec3> places(order.size());
  std::vector<char> open(order.size());
  for (size_t i = 0; i < order.size(); ++i)
  {
    triangles[i] = this->Triangles[static_cast<size_t>(order[i])];
    places[i] = middles[static_cast<size_t>(order[i])];
    open[i] = this->IsOpen[static_cast<size_t>(order[i])];
  }
  std::copy(triangles.begin(), triangles.end(), this->Triangles.begin() + first);
  std::copy(places.begin(), places.end(), middles.begin() + first);
  std::copy(open.begin(), open.end(), this->IsOpen.begin() + first);
  const int half = count / 2;
  made.First = static_cast<int>(this->Nodes.size());
  this->Nodes[static_cast<size_t>(node)] = made;
  this->Nodes.emplace_back();
  this->Nodes.emplace_back();
  this->BuildNode(made.First, first, half, middles);
  this->BuildNode(made.First + 1, first + half, count - half, middles);
}

//------------------------------------------------------------------------------
void vtkProxySurface::FindOpenParts()
{
  // Merges points at the same position.
  std::vector<int> order(this->Points.size());
  std::iota(order.begin(), order.end(), 0);
  auto before = [this](int a, int b)
  {
    const glm::dvec3& p = this->Points[static_cast<size_t>(a)];
    const glm::dvec3& q = this->Points[static_cast<size_t>(b)];
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
  };
  // Unused points may have any value; NaN has no order.
  std::vector<char> used(this->Points.size(), 0);
  for (const Triangle& triangle : this->Triangles)
  {
    for (long long id : triangle)
    {
      used[static_cast<size_t>(id)] = 1;
    }
  }
  order.erase(std::remove_if(order.begin(), order.end(),
                [&used](int i) { return !used[static_cast<size_t>(i)]; }),
    order.end());
  std::sort(order.begin(), order.end(), before);
  std::vector<int> merged(this->Points.size(), -1);
  int last = -1;
  for (int i : order)
  {
    last = last >= 0 && !before(last, i) ? last : i;
    merged[static_cast<size_t>(i)] = last;
  }
  // Parts are sets of triangles that share points: union-find trees with the smallest id at the
  // root.
  std::vector<int> parents = merged;
  auto top = [&parents](int i)
  {
    while (parents[static_cast<size_t>(i)] != i)
    {
      i = parents[static_cast<size_t>(i)] =
        parents[static_cast<size_t>(parents[static_cast<size_t>(i)])];
    }
    return i;
  };
  struct Edge
  {
    int Low;
    int High;
    int Balance;
    bool operator<(const Edge& other) const
    {
      return this->Low != other.Low ? this->Low < other.Low : this->High < other.High;
    }
  };
  std::vector<Edge> edges;
  edges.reserve(3 * this->Triangles.size());
  for (const Triangle& triangle : this->Triangles)
  {
    for (size_t i = 0; i < 3; ++i)
    {
      const int a = merged[static_cast<size_t>(triangle[i])];
      const int b = merged[static_cast<size_t>(triangle[(i + 1) % 3])];
      if (a != b)
      {
        edges.push_back({ std::min(a, b), std::max(a, b), a < b ? 1 : -1 });
        const int x = top(a);
        const int y = top(b);
        parents[static_cast<size_t>(std::max(x, y))] = std::min(x, y);
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<char> openParts(this->Points.size(), 0);
  for (size_t i = 0; i < edges.size();)
  {
    const size_t first = i;
    int balance = 0;
    for (; i < edges.size() && !(edges[first] < edges[i]); ++i)
    {
      balance += edges[i].Balance;
    }
    if (balance != 0)
    {
      openParts[static_cast<size_t>(top(edges[first].Low))] = 1;
    }
  }
  this->IsOpen.resize(this->Triangles.size());
  for (size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const int part = top(merged[static_cast<size_t>(this->Triangles[t][0])]);
    this->IsOpen[t] = openParts[static_cast<size_t>(part)];
    this->Open = this->Open || this->IsOpen[t];
  }
}

//------------------------------------------------------------------------------
glm::dvec3 vtkProxySurface::NearestOfTriangle(
  const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  // Distinguishes the regions around the triangle: Ericson 2005, "Real-time collision detection",
  // 5.1.5.
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const glm::dvec3 ap = p - a;
  const double d1 = glm::dot(ab, ap);
  const double d2 = glm::dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return a;
  }
  const glm::dvec3 bp = p - b;
  const double d3 = glm::dot(ab, bp);
  const double d4 = glm::dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return b;
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    return a + d1 / (d1 - d3) * ab;
  }
  const glm::dvec3 cp = p - c;
  const double d5 = glm::dot(ab, cp);
  const double d6 = glm::dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return c;
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    return a + d2 / (d2 - d6) * ac;
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
  {
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  }
  const double sum = va + vb + vc;
  return a + vb / sum * ab + vc / sum * ac;
}

//------------------------------------------------------------------------------
vtkProxySurface::Nearest vtkProxySurface::FindNearest(const glm::dvec3& p, double within) const
{
  Nearest found;
  double best = within * within;
  int stack[128];
  int size = 0;
  stack[size++] = 0;
  while (size > 0)
  {
    const Node& node = this->Nodes[static_cast<size_t>(stack[--size])];
    if (DistanceToBox(p, node.Low, node.High) > best)
    {
      continue;
    }
    if (node.Count == 0)
    {
      const Node& left = this->Nodes[static_cast<size_t>(node.First)];
      const Node& right = this->Nodes[static_cast<size_t>(node.First) + 1];
      const bool leftFirst =
        DistanceToBox(p, left.Low, left.High) <= DistanceToBox(p, right.Low, right.High);
      stack[size++] = node.First + (leftFirst ? 1 : 0);
      stack[size++] = node.First + (leftFirst ? 0 : 1);
      continue;
    }
    for (int t = node.First; t < node.First + node.Count; ++t)
    {
      const glm::dvec3 q =
        NearestOfTriangle(p, this->Corner(t, 0), this->Corner(t, 1), this->Corner(t, 2));
      const double d2 = glm::dot(q - p, q - p);
      if (d2 < best || (found.Triangle < 0 && d2 <= best))
      {
        best = d2;
        found.Point = q;
        found.Triangle = t;
      }
    }
  }
  found.Distance = std::sqrt(best);
  return found;
}

//------------------------------------------------------------------------------
vtkProxySurface::Winding vtkProxySurface::GetWinding(const glm::dvec3& p) const
{
  double sums[2] = {};
  int stack[128];
  int size = 0;
  stack[size++] = 0;
  while (size > 0)
  {
    const Node& node = this->Nodes[static_cast<size_t>(stack[--size])];
    const glm::dvec3 way = node.Middle - p;
    const double distance = glm::length(way);
    if (distance > DipoleReach * node.Radius)
    {
      const double weight = 1.0 / (distance * distance * distance);
      sums[0] += weight * glm::dot(way, node.Normal[0]);
      sums[1] += weight * glm::dot(way, node.Normal[1]);
    }
    else if (node.Count == 0)
    {
      stack[size++] = node.First;
      stack[size++] = node.First + 1;
    }
    else
    {
      for (int t = node.First; t < node.First + node.Count; ++t)
      {
        sums[this->IsOpen[static_cast<size_t>(t)] ? 1 : 0] +=
          SolidAngle(this->Corner(t, 0) - p, this->Corner(t, 1) - p, this->Corner(t, 2) - p);
      }
    }
  }
  return { sums[0] / FourPi, sums[1] / FourPi };
}

//------------------------------------------------------------------------------
glm::dvec3 vtkProxySurface::GetNormal(int t) const
{
  return glm::normalize(
    glm::cross(this->Corner(t, 1) - this->Corner(t, 0), this->Corner(t, 2) - this->Corner(t, 0)));
}

//------------------------------------------------------------------------------
std::vector<vtkProxySurface::Sample> vtkProxySurface::MakeSamples(int count) const
{
  // The tree keeps neighbours together, so that equal steps of area are spread over the surface.
  std::vector<Sample> samples(static_cast<size_t>(count));
  const double area = this->GetArea();
  for (int i = 0; i < count; ++i)
  {
    const double at = (i + 0.5) / count * area;
    const auto found = std::upper_bound(this->Cumulated.begin(), this->Cumulated.end(), at);
    const int t = std::min(static_cast<int>(found - this->Cumulated.begin()),
      static_cast<int>(this->Triangles.size()) - 1);
    // Two irrational numbers fill the square evenly: Roberts 2018, "The unreasonable effectiveness
    // of quasirandom sequences".
    double u = 0.5 + i * 0.7548776662466927;
    double v = 0.5 + i * 0.5698402909980532;
    u -= std::floor(u);
    v -= std::floor(v);
    if (u + v > 1.0)
    {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    const glm::dvec3& a = this->Corner(t, 0);
    samples[static_cast<size_t>(i)] = {
      a + u * (this->Corner(t, 1) - a) + v * (this->Corner(t, 2) - a), this->GetNormal(t)
    };
  }
  return samples;
}
