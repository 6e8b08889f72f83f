// SPDX-License-Identifier: BSD-3-Clause
// Shared parts of the tests of spheres and simplified meshes: checks, messages, and distances by
// brute force.
#ifndef ProxiesTestTools_h
#define ProxiesTestTools_h

#include "vtkIndirectHarness.h" // for tests
#include "vtkPolyData.h"        // for meshes
#include "vtkSmartPointer.h"    // for meshes

#include <cstdint>     // for bits
#include <functional>  // for deformations
#include <glm/glm.hpp> // for vectors
#include <string>      // for names
#include <vector>      // for samples

class vtkAlgorithm;
class vtkObject;

namespace proxytest
{
// Checks print the measured and the expected value, and the origin of the limit.
bool Check(const std::string& what, bool condition, const std::string& origin = "");
bool CheckAtMost(const std::string& what, double measured, double limit, const std::string& origin);
bool CheckAtLeast(
  const std::string& what, double measured, double limit, const std::string& origin);
bool CheckNear(const std::string& what, double measured, double expected, double tolerance,
  const std::string& origin);

/** Updates, and returns the number of errors; `text` gets their messages. */
int CountErrors(vtkAlgorithm* algorithm, std::string* text = nullptr);

struct Triangle
{
  glm::dvec3 A, B, C;
};
std::vector<Triangle> TrianglesOf(vtkPolyData* mesh);

/** Even samples of all triangles, at random places of a fixed seed. */
std::vector<glm::dvec3> SampleTriangles(const std::vector<Triangle>& triangles, int count);

/** Over all triangles, each with its inside and its three edges. */
double DistanceToTriangles(const std::vector<Triangle>& triangles, const glm::dvec3& p);

/** True if a ray meets closed triangles an odd number of times. */
bool IsInside(const std::vector<Triangle>& triangles, const glm::dvec3& p);

struct Sphere
{
  glm::dvec3 Center;
  double Radius;
};
std::vector<Sphere> SpheresOf(vtkPolyData* spheres);
double DistanceToSpheres(const std::vector<Sphere>& spheres, const glm::dvec3& p);

/** Numbers in [0, 1) by PCG32 (O'Neill 2014). */
class Random
{
public:
  explicit Random(std::uint64_t seed);
  double Next();

private:
  std::uint64_t State = 0;
};

// Meshes of triangles.
vtkSmartPointer<vtkPolyData> MakeSphere(int around, int rings);
vtkSmartPointer<vtkPolyData> MakeCube();
/** A torus with a fold in it, closed. */
vtkSmartPointer<vtkPolyData> MakeTorus(int around, int across);
/** A square of cells in z = 0. */
vtkSmartPointer<vtkPolyData> MakeSquare(int cells);
vtkSmartPointer<vtkPolyData> Map(
  vtkPolyData* mesh, const std::function<glm::dvec3(const glm::dvec3&)>& motion);
}

#endif
