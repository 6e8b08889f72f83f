// SPDX-License-Identifier: BSD-3-Clause
// Triangles in a tree: nearest point of the surface, and winding number of a position.
#pragma once

#include <array>       // for triangles
#include <glm/glm.hpp> // for vectors
#include <string>      // for messages
#include <vector>      // for the members

class vtkPolyData;

struct vtkProxySphere
{
  glm::dvec3 Center{ 0.0 };
  double Radius = 0.0;
  bool Sheet = false; // covers a surface that encloses no volume
};

class vtkProxySurface
{
public:
  using Triangle = std::array<long long, 3>; // ids of the input's points

  struct Nearest
  {
    double Distance = 0.0;
    glm::dvec3 Point{ 0.0 };
    int Triangle = -1;
  };

  struct Sample
  {
    glm::dvec3 Point{ 0.0 };
    glm::dvec3 Normal{ 0.0 };
  };

  /**
   * Takes the polygons and strips of a mesh, without degenerate triangles. Positions become
   * relative to the middle of their bounds and are divided by their diagonal. False if a point is
   * not finite; `wrong` then names the point.
   */
  bool Build(vtkPolyData* mesh, std::string& wrong);

  /** Triangles of polygons and strips, and the cell of each if `cells` is given. */
  static std::vector<Triangle> Triangulate(
    vtkPolyData* mesh, std::vector<long long>* cells = nullptr);

  bool Empty() const { return this->Triangles.empty(); }
  /** True if a part has edges without equally many triangles either way. */
  bool HasOpenParts() const { return this->Open; }
  double GetArea() const { return this->Cumulated.empty() ? 0.0 : this->Cumulated.back(); }
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }
  const std::vector<glm::dvec3>& GetPoints() const { return this->Points; }
  const glm::dvec3& GetCenter() const { return this->Center; }
  double GetDiagonal() const { return this->Diagonal; }
  glm::dvec3 GetLow() const { return this->Nodes.front().Low; }
  glm::dvec3 GetHigh() const { return this->Nodes.front().High; }

  glm::dvec3 ToWorld(const glm::dvec3& p) const { return this->Center + this->Diagonal * p; }
  glm::dvec3 FromWorld(const glm::dvec3& p) const { return (p - this->Center) / this->Diagonal; }

  /** The nearest point of the surface within a distance; no triangle (-1) if there is none. */
  Nearest FindNearest(const glm::dvec3& p, double within = 1e30) const;

  /** Winding numbers of the closed parts and of the open ones around a position. */
  struct Winding
  {
    double Closed = 0.0; // an integer but for the dipoles' error
    double Open = 0.0;
  };
  /**
   * Winding number of the surface around a position: solid angle over 4 pi, summed over the
   * triangles (van Oosterom and Strackee 1983), far groups as their dipole (Barill, Dickson,
   * Schmidt, Levin, Jacobson 2018, "Fast winding numbers for soups and clouds"; error about 1 %).
   */
  Winding GetWinding(const glm::dvec3& p) const;

  /** Points evenly spread over the surface's area, always the same ones. */
  std::vector<Sample> MakeSamples(int count) const;

  glm::dvec3 GetNormal(int triangle) const;
  static glm::dvec3 NearestOfTriangle(
    const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

private:
  struct Node
  {
    glm::dvec3 Low{ 0.0 };
    glm::dvec3 High{ 0.0 };
    glm::dvec3 Middle{ 0.0 };  // mean position by area
    glm::dvec3 Normal[2] = {}; // sums of areas times normals: closed parts, open ones
    double Radius = 0.0;       // bounding radius of all triangles about the middle
    int First = 0;             // first triangle, or the first of the two children
    int Count = 0;             // number of triangles; 0: inner node
  };

  void BuildTree();
  void BuildNode(int node, int first, int count, std::vector<glm::dvec3>& middles);
  void FindOpenParts();
  const glm::dvec3& Corner(int triangle, int i) const
  {
    return this->Points[static_cast<size_t>(this->Triangles[triangle][i])];
  }

  std::vector<glm::dvec3> Points; // all points of the input
  std::vector<Triangle> Triangles;
  std::vector<char> IsOpen;      // one entry a triangle
  std::vector<double> Cumulated; // areas
  std::vector<Node> Nodes;
  glm::dvec3 Center{ 0.0 };
  double Diagonal = 1.0;
  bool Open = false;
};
