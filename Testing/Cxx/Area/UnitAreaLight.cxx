// SPDX-License-Identifier: BSD-3-Clause
// The form factor of a rectangle in single precision, against double precision and known values.
#include "OpenGL/vtkIndirectKernels.h"
#include "vtkIndirectTestUtilities.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

namespace
{
// Clips at the element's horizon, then sums Lambert's polygon, in double precision.
double Expect(const glm::dvec3& corner, const glm::dvec3& edge1, const glm::dvec3& edge2,
  const glm::dvec3& normal)
{
  const glm::dvec3 corners[4] = { corner, corner + edge1, corner + edge1 + edge2, corner + edge2 };
  std::vector<glm::dvec3> above;
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec3& a = corners[i];
    const glm::dvec3& b = corners[(i + 1) % 4];
    const double ha = glm::dot(normal, a);
    const double hb = glm::dot(normal, b);
    if (ha >= 0.0)
    {
      above.push_back(a);
    }
    if ((ha < 0.0) != (hb < 0.0))
    {
      above.push_back(a + ha / (ha - hb) * (b - a));
    }
  }
  return above.size() < 3 ? 0.0 : PolygonFormFactor(glm::dvec3(0.0), normal, above);
}

double Measure(const glm::dvec3& corner, const glm::dvec3& edge1, const glm::dvec3& edge2,
  const glm::dvec3& normal)
{
  return vtkiRectangleFormFactor(
    glm::vec3(corner), glm::vec3(edge1), glm::vec3(edge2), glm::vec3(normal));
}
}

VTK_INDIRECT_TEST(RectangleFormFactor)
{
  // Over the corner of a rectangle a by b at height h: a known value from handbooks.
  const double x = 0.5;
  const double y = 0.8;
  const double p = std::sqrt(1.0 + x * x);
  const double q = std::sqrt(1.0 + y * y);
  const double known =
    (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / (2.0 * 3.14159265358979323846);
  CheckRelative("over a corner", Measure({ 0, 0, 1 }, { x, 0, 0 }, { 0, y, 0 }, { 0, 0, 1 }), known,
    1e-6, "single precision");

  // Elements all around, from a thousandth of the edge to a thousand times it.
  Random random(5);
  double worst = 0.0;
  double worstFar = 0.0;
  for (int i = 0; i < 200000; ++i)
  {
    const glm::dvec3 edge1(1.0, 0.0, 0.0);
    const glm::dvec3 edge2(0.0, static_cast<float>(random.NextMagnitude(0.1, 1.0)), 0.0);
    const double distance = random.NextMagnitude(1e-3, 1e3);
    const glm::dvec3 nearest(random.Next(), random.Next() * edge2.y, 0.0);
    // Uses the rounded inputs of single precision.
    const glm::dvec3 corner(glm::vec3(-nearest - distance * random.NextDirection()));
    const glm::dvec3 normal(glm::vec3(random.NextDirection()));
    if (std::abs(corner.z) < 1e-5)
    {
      continue; // rounding decides its side of the light's plane
    }
    const double expected = Expect(corner, edge1, edge2, normal);
    const double measured = Measure(corner, edge1, edge2, normal);
    // Relative to the most that an element at this distance could get, beside which the rest is
    // negligible.
    const double most = edge2.y / (3.14159265358979323846 * distance * distance + edge2.y);
    double& error = distance > 5.0 ? worstFar : worst;
    error = std::max(error, std::abs(measured - expected) / std::max(expected, 0.05 * most));
  }
  CheckAtMost("near: error over the value, or a twentieth of the most", worst, 1e-3,
    "sums of four terms in single precision");
  CheckAtMost(
    "far", worstFar, 8e-3, "sums of four terms in single precision, disks from 30 edges on");
}

VTK_INDIRECT_TEST(RectangleAtTheHorizon)
{
  // Half of it above the horizon, standing on it: equal to the upper half alone.
  const glm::dvec3 normal(0, 0, 1);
  CheckRelative("cut in halves", Measure({ 1, -0.5, -1 }, { 0, 1, 0 }, { 0, 0, 2 }, normal),
    Measure({ 1, -0.5, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, normal), 1e-6, "single precision");
  CheckEqual("below", Measure({ 1, -0.5, -3 }, { 0, 1, 0 }, { 0, 0, 2 }, normal), 0.0);
  CheckEqual("along", Measure({ 1, -0.5, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, normal), 0.0);
  CheckRelative("all of the hemisphere",
    Measure({ -1e3, -1e3, 1e-2 }, { 2e3, 0, 0 }, { 0, 2e3, 0 }, normal), 1.0, 1e-5,
    "a square of 2000 at a hundredth");
  // On the light itself, looking away from it.
  CheckAbsolute("in its plane", Measure({ -0.5, -0.5, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, normal), 0.0,
    1e-6, "what lies in the horizon sends nothing");
}
