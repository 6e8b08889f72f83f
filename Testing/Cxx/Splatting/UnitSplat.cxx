// SPDX-License-Identifier: BSD-3-Clause
// Bounds of virtual lights contain all places where these count.
#include "OpenGL/vtkIndirectKernels.h"
#include "Splatting/vtkIndirectSplatMesh.h"
#include "vtkIndirectTestUtilities.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

namespace
{
/** Place of a point relative to an ellipsoid, in double precision: 1 on it, more outside. */
double FindPlace(const vtkiSplat& splat, const glm::dvec3& p)
{
  const glm::dvec3 d = p - glm::dvec3(splat.center);
  const double along = glm::dot(d, glm::dvec3(splat.axis));
  const glm::dvec3 aside = d - along * glm::dvec3(splat.axis);
  return std::hypot(along / splat.along, glm::length(aside) / splat.across);
}

/** The largest place of any point of the iso-surface cos(a)^n / r^2 = 1. */
double FindFarthest(const vtkiSplat& splat, double exponent, double size)
{
  double farthest = 0.0;
  auto look = [&](double cosine)
  {
    const double r = size * std::pow(cosine, 0.5 * exponent);
    farthest = std::max(
      farthest, FindPlace(splat, { r * std::sqrt(1.0 - cosine * cosine), 0.0, r * cosine }));
  };
  for (int i = 1; i <= 4000; ++i)
  {
    look(i / 4000.0);
    // Narrow lobes: cosines of 1 - 1e-12 to 1/2.
    look(1.0 - 0.5 * std::pow(10.0, -12.0 * i / 4000.0));
  }
  return farthest;
}

vtkiSplat RandomSplat(Random& random)
{
  const auto exponent = static_cast<float>(random.NextMagnitude(0.1, 1e6));
  const auto size = static_cast<float>(random.NextMagnitude(1e-3, 2.0));
  const auto ball =
    static_cast<float>(random.Next() < 0.3 ? size * random.NextMagnitude(1e-3, 1.0) : 0.0);
  return vtkiMakeSplat(vec3(random.NextDirection() * random.Next(0.0, 0.5)),
    vec3(random.NextDirection()), exponent, size, ball);
}
}

VTK_INDIRECT_TEST(SplatHoldsSurface)
{
  const vec3 up(0.0f, 0.0f, 1.0f);
  double outside = 0.0;
  double loosest = 0.0;
  double printed = 0.0;
  double exact = 0.0;
  int exponents = 0;
  // From 0 to 1e6, including the paper's 1 to 1e4, twelve a decade.
  for (int i = -37; i <= 72; ++i, ++exponents)
  {
    const double n = i == -37 ? 0.0 : std::pow(10.0, i / 12.0);
    const vtkiSplat splat = vtkiMakeSplat(vec3(0.0f), up, static_cast<float>(n), 0.5f, 0.0f);
    const double farthest = FindFarthest(splat, n, 0.5);
    outside = std::max(outside, farthest);
    loosest = std::max(loosest, 1.0 / farthest);
    // With equation (8) as printed: n / (n + 2) times (n + 2) / 4.
    vtkiSplat wrong = splat;
    const double c = n / 4.0;
    wrong.center = vec3(0.0f, 0.0f, static_cast<float>(0.5 * c));
    wrong.along = static_cast<float>(0.5 * std::max(c, std::abs(1.0 - c)));
    wrong.across = static_cast<float>(0.5 * std::pow(c, n / (n + 2.0)) *
      std::sqrt(std::max(1.0 - std::pow(c, 4.0 / (n + 2.0)), 0.0)));
    printed = std::max(printed, FindFarthest(wrong, n, 0.5));
    // The widest place in double precision, by its closed form.
    const double k = n / (n + 2.0);
    const vec2 widest = vtkiSplatWidest(static_cast<float>(n));
    exact = std::max({ exact, std::abs(widest.x - (n > 0.0 ? std::pow(k, (n + 2.0) / 4.0) : 0.0)),
      std::abs(
        widest.y / ((n > 0.0 ? std::pow(k, n / 4.0) : 1.0) * std::sqrt(2.0 / (n + 2.0))) - 1.0) });
  }
  CheckEqual("exponents", exponents, 110);
  CheckAtMost("farthest point of an iso-surface, in half axes", outside, 1.0,
    "an ellipsoid that holds it; the margin covers rounding");
  CheckAtMost("and how much larger an ellipsoid is than it has to be", loosest, 1.0 + 3e-4,
    "the margin, twice, and rounding: they touch");
  CheckAtMost("centre and width against their closed forms", exact, 2e-6, "floats");
  CheckAtLeast("the same by equation (8) as printed", printed, 2.0, "the test's own power");
}

VTK_INDIRECT_TEST(SplatHoldsWidenedLobe)
{
  // Within `ball` the exponent is n r / ball: the surface there lies anywhere within the ball.
  Random random(31);
  double outside = 0.0;
  double inBall = 0.0;
  for (int i = 0; i < 300; ++i)
  {
    const double n = random.NextMagnitude(1.0, 1e6);
    const double size = random.NextMagnitude(1e-3, 1.0);
    const double ball = size * random.NextMagnitude(1e-4, 10.0);
    const vtkiSplat splat = vtkiMakeSplat(vec3(0.0f), vec3(0.0f, 0.0f, 1.0f), static_cast<float>(n),
      static_cast<float>(size), static_cast<float>(ball));
    outside = std::max(outside, FindFarthest(splat, n, size));
    for (int k = 0; k < 100; ++k)
    {
      inBall = std::max(inBall, FindPlace(splat, ball * random.NextDirection()));
    }
  }
  CheckAtMost("farthest point of an iso-surface, in half axes", outside, 1.0, "it is held");
  CheckAtMost("farthest point of the ball", inBall, 1.0, "it is held, too");
  CheckAtLeast("and the ball is not far inside", inBall, 0.9, "the test's own power");
}

VTK_INDIRECT_TEST(SplatMeshHoldsEllipsoid)
{
  const vtkIndirectSplatMesh::Polyhedron mesh = vtkIndirectSplatMesh::MakePolyhedron();
  CheckEqual("corners", static_cast<double>(mesh.Corners.size()), 42);
  CheckEqual("triangles", static_cast<double>(mesh.Triangles.size()), 80);
  double nearest = 1e9;
  double farthest = 0.0;
  double area = 0.0;
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : mesh.Triangles)
  {
    const glm::dvec3 a = mesh.Corners[t[0]];
    const glm::dvec3 normal = glm::cross(mesh.Corners[t[1]] - a, mesh.Corners[t[2]] - a);
    nearest = std::min(nearest, glm::dot(glm::normalize(normal), a));
    area += 0.5 * glm::length(normal);
    for (int i = 0; i < 3; ++i)
    {
      ++edges[{ t[i], t[(i + 1) % 3] }];
      farthest = std::max(farthest, glm::length(mesh.Corners[t[i]]));
    }
  }
  int closed = 0;
  for (const auto& edge : edges)
  {
    const auto other = edges.find({ edge.first.second, edge.first.first });
    closed += edge.second == 1 && other != edges.end() && other->second == 1;
  }
  CheckEqual("edges that two triangles share in opposite order", closed, 240);
  CheckAbsolute("distance of the nearest face", nearest, 1.0, 1e-12, "circumscribed to rounding");
  CheckAtMost("distance of the farthest corner", farthest, 1.08, "measured: 1.07");
  CheckAtMost("mean area of its outline over the ball's", area / (4.0 * 3.14159265), 1.07,
    "a convex body's outline is a quarter of its surface in the mean; measured 1.064");

  // Mapped to ellipsoids, the planes of the faces still enclose them.
  Random random(32);
  double outside = 1e9;
  for (int i = 0; i < 200; ++i)
  {
    // About the middle of the scene: elsewhere positions are rounded by up to 3e-8 scene units.
    vtkiSplat splat = RandomSplat(random);
    splat.center = vec3(0.0f);
    for (const auto& t : mesh.Triangles)
    {
      glm::dvec3 p[3];
      for (int k = 0; k < 3; ++k)
      {
        p[k] = glm::dvec3(vtkiSplatPoint(splat, vec3(mesh.Corners[t[k]] * (1.0 + 1e-6))));
      }
      const glm::dvec3 normal = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
      const double along = splat.along * glm::dot(normal, glm::dvec3(splat.axis));
      const double across = splat.across *
        glm::length(normal - glm::dot(normal, glm::dvec3(splat.axis)) * glm::dvec3(splat.axis));
      const double height = glm::dot(normal, p[0] - glm::dvec3(splat.center));
      outside = std::min(outside, height / std::hypot(along, across));
    }
  }
  CheckAtLeast("nearest face of 200 ellipsoids, over what each reaches towards it", outside,
    1.0 - 1e-5, "floats; a tenth of the ellipsoids' margin");
}

VTK_INDIRECT_TEST(SplatMeetsBox)
{
  Random random(33);
  int missed = 0;
  int met = 0;
  int refused = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const vtkiSplat splat = RandomSplat(random);
    const vec3 middle(0.7 * random.NextDirection() * random.Next());
    const vec3 halfSize(static_cast<float>(random.NextMagnitude(1e-4, 0.3)),
      static_cast<float>(random.NextMagnitude(1e-4, 0.3)),
      static_cast<float>(random.NextMagnitude(1e-4, 0.3)));
    const bool meets = vtkiSplatMeetsBox(splat, middle, halfSize);
    // The box's point nearest to a point of the ellipsoid: if that is in the ellipsoid, both meet.
    bool inside = false;
    for (int k = 0; k < 30; ++k)
    {
      const glm::dvec3 unit = random.NextDirection() * std::cbrt(random.Next());
      const glm::dvec3 p(vtkiSplatPoint(splat, vec3(unit)));
      const glm::dvec3 nearest = glm::clamp(
        p, glm::dvec3(middle) - glm::dvec3(halfSize), glm::dvec3(middle) + glm::dvec3(halfSize));
      inside = inside || FindPlace(splat, nearest) < 1.0 - 1e-5;
    }
    missed += inside && !meets;
    met += inside;
    refused += !meets;
  }
  CheckEqual("boxes that meet an ellipsoid and are refused", missed, 0);
  CheckAtLeast("boxes that meet", met, 1000, "the test's own power");
  CheckAtLeast("boxes that are refused", refused, 5000, "of 20000: it leaves something out");
  vtkiSplat none = RandomSplat(random);
  none.across = -1.0f;
  Check("where there is no splat nothing is met", !vtkiSplatMeetsBox(none, vec3(0.0f), vec3(1.0f)));
}

VTK_INDIRECT_TEST(SplatRange)
{
  Random random(34);
  double outside = 0.0;
  double loose = 0.0;
  int front = 0;
  int behind = 0;
  int wrong = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const vtkiSplat splat = RandomSplat(random);
    // Any projection: x / w, w the distance from a plane, or one for parallel projection.
    const bool parallel = i % 4 == 0;
    const vec3 x(random.NextDirection() * random.Next(0.5, 2.0));
    const vec3 w(parallel ? glm::dvec3(0.0) : random.NextDirection());
    const vec4 rowX(x, static_cast<float>(random.Next(-1.0, 1.0)));
    const vec4 rowW(w, parallel ? 1.0f : static_cast<float>(random.Next(-0.5, 1.5)));
    vec2 range;
    const int where = vtkiSplatRange(splat, rowX, rowW, range);
    double least = 1e30;
    double lower = 1e30;
    double upper = -1e30;
    double greatest = -1e30;
    for (int k = 0; k < 400; ++k)
    {
      const glm::dvec3 unit = random.NextDirection();
      const double along = glm::dot(unit, glm::dvec3(splat.axis));
      const glm::dvec3 p = glm::dvec3(splat.center) + double(splat.across) * unit +
        (double(splat.along) - splat.across) * along * glm::dvec3(splat.axis);
      const double depth = glm::dot(glm::dvec3(w), p) + rowW.w;
      const double value = (glm::dot(glm::dvec3(x), p) + rowX.w) / depth;
      least = std::min(least, depth);
      greatest = std::max(greatest, depth);
      lower = std::min(lower, value);
      upper = std::max(upper, value);
    }
    wrong += (where > 0 && least <= 0.0) || (where < 0 && greatest >= 0.0);
    front += where > 0;
    behind += where < 0;
    if (where > 0)
    {
      const double scale = 1.0 + std::max(std::abs(lower), std::abs(upper));
      outside = std::max({ outside, (range.x - lower) / scale, (upper - range.y) / scale });
      loose = std::max(
        loose, upper - lower > 1e-2 && least > 0.1 ? (range.y - range.x) / (upper - lower) : 0.0);
    }
  }
  CheckAtLeast("splats in front of the eye's plane", front, 1000, "the test's own power");
  CheckAtLeast("splats behind it", behind, 100, "the test's own power");
  CheckEqual("splats told to be on the side that they are not", wrong, 0);
  CheckAtMost("how far an ellipsoid leaves its range", outside, 2e-5,
    "floats; the rectangle has a margin of 1e-4");
  CheckAtMost("width of the range over that of 400 points", loose, 1.6,
    "points of a narrow ellipsoid's tips are rare");
}

VTK_INDIRECT_TEST(SplatWithinScene)
{
  Random random(35);
  int outside = 0;
  for (int i = 0; i < 20000; ++i)
  {
    // A receiver in the ellipsoid is also in the result of vtkiWithinScene.
    const glm::dvec3 light = 0.5 * random.NextDirection() * random.Next();
    const glm::dvec3 receiver = 0.5 * random.NextDirection() * random.Next();
    const vtkiSplat splat = vtkiMakeSplat(vec3(light), vec3(random.NextDirection()),
      static_cast<float>(random.NextMagnitude(0.1, 100.0)),
      static_cast<float>(random.NextMagnitude(0.1, 1e6)), 0.0f);
    const vtkiSplat within = vtkiWithinScene(splat);
    outside += FindPlace(splat, receiver) <= 1.0 && FindPlace(within, receiver) > 1.0;
  }
  CheckEqual("receivers that are lost", outside, 0);
}

VTK_INDIRECT_TEST(SplatShare)
{
  Check("nothing below one, all from one on without a far field",
    vtkiSplatShare(0.999f, false) == 0.0f && vtkiSplatShare(1.0f, false) == 1.0f);
  Check("nothing at one, all from two on with it",
    vtkiSplatShare(1.0f, true) == 0.0f && vtkiSplatShare(2.0f, true) == 1.0f);
  double step = 0.0;
  float last = 0.0f;
  for (int i = 0; i <= 3000; ++i)
  {
    const float share = vtkiSplatShare(static_cast<float>(i) / 1000.0f, true);
    step = std::max(step, std::abs(double(share) - last));
    last = share;
  }
  CheckAtMost("largest step in a thousandth", step, 1.51e-3, "a slope of 3/2 at most");
}
