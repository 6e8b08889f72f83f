// SPDX-License-Identifier: BSD-3-Clause
// The disk kernel of a virtual light.
#include "OpenGL/vtkIndirectKernels.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

namespace
{
const vec3 Up(0.0f, 0.0f, 1.0f);

double Weight(const glm::dvec3& d, const glm::dvec3& s, const glm::dvec3& r, double area)
{
  const double r2 = glm::dot(d, d);
  return std::max(-glm::dot(s, d), 0.0) * std::max(glm::dot(r, d), 0.0) / r2 /
    (vtkMath::Pi() * r2 + area);
}
}

VTK_INDIRECT_TEST(DiskFormFactor)
{
  Random random(9);
  double worst = 0.0;
  for (int i = 0; i < 10000; ++i)
  {
    const double r = random.NextMagnitude(1e-4, 1e2);
    const double radius = random.NextMagnitude(1e-4, 1e2);
    const double area = vtkMath::Pi() * radius * radius;
    const double weight = vtkiVirtualLightWeight(
      vec3(0.0f, 0.0f, static_cast<float>(r)), -Up, Up, static_cast<float>(area));
    // Exact on the axis: radius^2 / (radius^2 + r^2).
    const double exact = radius * radius / (radius * radius + r * r);
    worst = std::max(worst, std::abs(weight * area / exact - 1.0));
  }
  CheckAtMost("disk seen on its axis, worst relative error", worst, 1e-6, "ten roundings");

  // Integration over the disk confirms the closed form.
  const double integral = Integrate(
    0.0, 1.0, [](double x) { return 2.0 * x * 4.0 / std::pow(x * x + 4.0, 2.0); }, 8);
  CheckRelative(
    "closed form against quadrature, radius 1 at 2", integral, 0.2, 1e-12, "quadrature");
  Check("a kernel without pi would be rejected",
    !WouldPass(1.0 / (4.0 + vtkMath::Pi()), 0.2 / vtkMath::Pi(), 1e-2));
}

VTK_INDIRECT_TEST(KernelLimits)
{
  Random random(10);
  double farField = 0.0;
  double against = 0.0;
  int unbounded = 0;
  int behind = 0;
  for (int i = 0; i < 200000; ++i)
  {
    const glm::dvec3 d = random.NextDirection() * random.NextMagnitude(1e-6, 1e3);
    const glm::dvec3 s = random.NextDirection();
    const glm::dvec3 r = random.NextDirection();
    const double area = random.NextMagnitude(1e-12, 1e6);
    const vec3 df(d);
    const vec3 sf(s);
    const vec3 rf(r);
    const auto areaf = static_cast<float>(area);
    const double w = vtkiVirtualLightWeight(df, sf, rf, areaf);
    const double cosS = -glm::dot(glm::dvec3(sf), glm::dvec3(df)) / glm::length(glm::dvec3(df));
    const double cosR = glm::dot(glm::dvec3(rf), glm::dvec3(df)) / glm::length(glm::dvec3(df));
    unbounded += w * areaf > 1.0 + 1e-6;
    behind += (cosS < -1e-6 || cosR < -1e-6) && w != 0.0;
    if (cosS > 0.05 && cosR > 0.05)
    {
      const double expected = Weight(glm::dvec3(df), glm::dvec3(sf), glm::dvec3(rf), areaf);
      against = std::max(against, std::abs(w / expected - 1.0));
      const double r2 = glm::dot(d, d);
      if (area < 1e-3 * r2)
      {
        farField = std::max(farField,
          std::abs(w / (cosS * cosR / (vtkMath::Pi() * r2)) - 1.0) /
            (area / (vtkMath::Pi() * r2) + 5e-6));
      }
    }
  }
  CheckEqual("weights above one over the area", unbounded, 0);
  CheckEqual("weights where one lies behind the other", behind, 0);
  // A dot product that cancels to 0.05 of its terms carries 20 times their rounding.
  CheckAtMost(
    "worst relative error against double precision", against, 1e-5, "cancelling dot products");
  CheckAtMost("far field, deviation over A / (pi r^2)", farField, 1.0, "series of the kernel");
  CheckEqual(
    "sender and receiver in one place", vtkiVirtualLightWeight(vec3(0.0f), -Up, Up, 1.0f), 0.0);
}

VTK_INDIRECT_TEST(KernelExtremes)
{
  Random random(11);
  int bad = 0;
  int unbounded = 0;
  for (int i = 0; i < 1000000; ++i)
  {
    const vec3 d = vec3(random.NextDirection() * random.NextMagnitude(1e-18, 1e18));
    const auto area = static_cast<float>(random.NextMagnitude(1e-18, 1e18));
    const float w =
      vtkiVirtualLightWeight(d, vec3(random.NextDirection()), vec3(random.NextDirection()), area);
    bad += !std::isfinite(w) || w < 0.0f;
    // For a denormal denominator, the bound holds only to its few bits.
    const double r2 = glm::dot(glm::dvec3(d), glm::dvec3(d));
    const bool normal = r2 * (vtkMath::Pi() * r2 + area) > 1.2e-38;
    unbounded += normal && double(w) * area > 1.0 + 1e-6;
  }
  CheckEqual("weights that are not finite or negative", bad, 0);
  CheckEqual("weights above one over the area", unbounded, 0);
}

// The kernel's bias in a closed sphere: numbers used by the radiometry tests.
VTK_INDIRECT_TEST(ClosedSphereBias)
{
  for (int n : { 64, 256, 1024, 4096 })
  {
    // u = r^2 / (4 R^2) is uniform over the sphere; cosS = cosR = sqrt(u).
    const double area = 4.0 * vtkMath::Pi() / n;
    const double mean = Integrate(
      0.0, 1.0,
      [&](double t)
      {
        const double u = t * t * t; // resolves the steep start
        const double r = 2.0 * std::sqrt(u);
        const vec3 receiver(0.0f, 0.0f, 1.0f);
        // A unit sphere: receiver at its south pole looking up, sender at distance r.
        const double z = 0.5 * r * r;
        const double x = std::sqrt(std::max(r * r - z * z, 0.0));
        const vec3 normal(-x, 0.0, 1.0 - z);
        return 3.0 * t * t * n * area *
          vtkiVirtualLightWeight(vec3(x, 0.0, z), normal, receiver, static_cast<float>(area));
      },
      64);
    CheckRelative("mean of " + std::to_string(n) + " lights in a sphere", mean,
      1.0 - std::log(1.0 + n) / n, 1e-5, "quadrature of a float kernel");
  }
}

VTK_INDIRECT_TEST(Curvature)
{
  // A light in a floor, at distance a from the wall that rises over it; receivers at height r.
  // Error of linear interpolation midway, from the kernel itself, against the prediction by the
  // curvature.
  const double a = 0.3;
  const double area = 1e-4;
  const glm::dvec3 across(1.0, 0.0, 0.0);
  const glm::dvec3 up(0.0, 0.0, 1.0);
  auto at = [&](double r) { return Weight(glm::dvec3(a, 0.0, -r), up, across, area); };
  auto estimate = [&](double r, double h, double density)
  {
    return 0.125 * h * h *
      vtkiVirtualLightCurvature(vec3(static_cast<float>(a), 0.0f, static_cast<float>(-r)),
        Up * static_cast<float>(density), vec3(across), static_cast<float>(area));
  };
  // At the strongest irradiance, with no other light (a density of 1e9 times it).
  const double h = 0.02 * a;
  const double r = a / std::sqrt(3.0);
  const double missed = 1.0 - 0.5 * (at(r - 0.5 * h) + at(r + 0.5 * h)) / at(r);
  CheckRelative("error where the light is strongest", estimate(r, h, 1e9), missed, 0.01,
    "the next term goes with h^2 / d^2, 3e-4, the disk with area / d^2, 8e-4");

  // Elsewhere at most twice: 12 E / d^2 is the limit on both sides.
  double least = 1e30;
  double greatest = 0.0;
  for (int i = 1; i < 200; ++i)
  {
    const double place = 0.02 * i * a;
    const double midway =
      std::abs(1.0 - 0.5 * (at(place - 0.5 * h) + at(place + 0.5 * h)) / at(place));
    const double ratio = midway / estimate(place, h, 1e9);
    least = std::min(least, ratio);
    greatest = std::max(greatest, ratio);
  }
  CheckAtMost("largest error over the estimate", greatest, 2.05, "12 over 6, and h of 0.02");
  CheckAtMost("smallest error over the estimate", least, 0.2, "there is a turning point at r = a");

  // A light with a tenth of the irradiance has a tenth of its curvature, and behind a surface none.
  CheckRelative("light beside nine times as much",
    estimate(r, h, 1.0 / (9.0 * at(r))) / estimate(r, h, 1e9), 0.1, 1e-5, "float");
  CheckEqual("light from behind",
    vtkiVirtualLightCurvature(vec3(-0.3f, 0.0f, -0.1f), Up, vec3(across), 1e-4f), 0.0f);
  CheckEqual("sender and receiver coincide",
    vtkiVirtualLightCurvature(vec3(0.0f), Up, vec3(across), 0.0f), 0.0f);
}

// A wall of square patches of area one down to the floor, and a plane of them, for receivers on the
// floor and facing the plane: half of the light, and all of it, at any distance.
VTK_INDIRECT_TEST(PatchesOfPlanes)
{
  constexpr int rows = 200;
  const vec3 normal(0.0f, 0.0f, 1.0f);
  auto sum = [&normal](const vec3& receiver, const vec3& facing, int first, auto weight)
  {
    double all = 0.0;
    for (int i = first; i < rows; ++i)
    {
      for (int k = -rows; k < rows; ++k)
      {
        const vec3 middle(static_cast<float>(k) + 0.5f, static_cast<float>(i) + 0.5f, 0.0f);
        all += weight(middle - receiver, normal, facing);
      }
    }
    return all;
  };
  auto patch = [](const vec3& d, const vec3& n, const vec3& m)
  { return double(vtkiPatchLightWeight(d, n, m, 1.0f, 1.0f)); };
  auto onAxis = [](const vec3& d, const vec3& n, const vec3& m)
  { return double(vtkiVirtualLightWeight(d, n, m, 1.0f)); };
  const vec3 along(0.0f, 1.0f, 0.0f);
  const char* rest =
    "0.03 where patches end beside the receiver, measured; 0.005 beyond 200 of them";
  const char* facing =
    "0.113 of patches nearer than half of their sides, measured; 0.09 but for VTKI_PATCH_FACET";
  // Rounding places a receiver on the crease at, or just behind, the plane of the patches.
  for (const float height : { -1.0e-5f, 0.0f, 1.0e-5f, 0.05f, 0.2f, 0.5f, 1.0f, 2.0f })
  {
    const std::string at = " at " + std::to_string(height);
    for (const float place : { 0.0f, 0.25f, 0.5f })
    {
      CheckRelative(
        "a wall" + at, sum(vec3(place, 0.0f, height), along, 0, patch), 0.5, 0.04, rest);
      // Near receivers that face it may be on the other side of a sheet.
      if (height > 0.1f)
      {
        CheckRelative("a plane" + at, sum(vec3(place, place, height), -normal, -rows, patch), 1.0,
          0.12, facing);
      }
    }
  }
  // In the wall's plane, beside it: h / sqrt(h^2 + y^2) of half a plane's light.
  for (const float beside : { 2.0f, 5.0f })
  {
    const double found = sum(vec3(0.0f, -beside, 0.05f), along, 0, patch) / 0.5;
    CheckAbsolute("in the plane of a wall, " + std::to_string(beside) + " from its end", found,
      0.05 / beside, 0.5 / std::pow(beside, 2.5), "(b / R)^3, and 1 / R for all patches");
  }
  CheckAtMost("a wall at 0.02 by the kernel of the axis",
    sum(vec3(0.0f, 0.0f, 0.02f), along, 0, onAxis), 0.05, "goes to zero there");
}

// A patch against the mean over its points.
VTK_INDIRECT_TEST(PatchIsSecondOrder)
{
  Random random(31);
  const vec3 normal(0.0f, 0.0f, 1.0f);
  double worst[2] = { 0.0, 0.0 };
  double squares[2] = { 0.0, 0.0 };
  for (const int far : { 0, 1 })
  {
    const float distance = far ? 6.0f : 3.0f;
    for (int i = 0; i < 2000;)
    {
      const vec3 way = vec3(random.NextDirection());
      const vec3 facing = vec3(random.NextDirection());
      // Patch and receiver are wholly in front of each other.
      if (way.z < 0.05f || glm::dot(facing, way) > -0.4f)
      {
        continue;
      }
      ++i;
      constexpr int points = 16;
      double mean = 0.0;
      for (int k = 0; k < points * points; ++k)
      {
        const vec3 point((static_cast<float>(k % points) + 0.5f) / points - 0.5f,
          (static_cast<float>(k / points) + 0.5f) / points - 0.5f, 0.0f);
        mean += vtkiVirtualLightWeight(point - distance * way, normal, facing, 0.0f);
      }
      mean /= points * points;
      const double scale = 1.0 / (vtkMath::Pi() * distance * distance);
      const double patch =
        vtkiPatchLightWeight(-distance * way, normal, facing, 1.0f, 1.0f / 64.0f);
      worst[far] = std::max(worst[far], std::abs(patch - mean) / scale);
      squares[far] += std::pow((patch - mean) / scale, 2.0) / 2000.0;
    }
  }
  CheckAtMost(
    "three widths away", worst[0], 0.02, "fourth order: 1 / 81, of a coefficient about one");
  CheckAtMost("six widths away, over three", std::sqrt(squares[1] / squares[0]), 1.0 / 8.0,
    "1 / 16 were it of fourth order alone");
}

VTK_INDIRECT_TEST(PointLimits)
{
  Random random(15);
  int bad = 0;
  double far = 0.0;
  for (int i = 0; i < 200000; ++i)
  {
    const vec3 d = vec3(random.NextDirection() * random.NextMagnitude(1e-6, 1e3));
    const auto area = static_cast<float>(random.NextMagnitude(1e-12, 1e3));
    const vec3 s = vec3(random.NextDirection());
    const vec3 r = vec3(random.NextDirection());
    const double w = double(vtkiPointLightStrength(d, s, r, area)) * std::max(glm::dot(r, d), 0.0f);
    bad += !std::isfinite(w) || w < 0.0;
    const double length = glm::length(glm::dvec3(d));
    const double cosS = -glm::dot(glm::dvec3(s), glm::dvec3(d)) / length;
    const double cosR = glm::dot(glm::dvec3(r), glm::dvec3(d)) / length;
    if (cosS > 0.05 && cosR > 0.05)
    {
      const double expected =
        cosS * cosR / std::max(vtkMath::Pi() * length * length, area / 1024.0);
      far = std::max(far, std::abs(w / expected - 1.0));
    }
  }
  CheckEqual("weights that are not finite or negative", bad, 0);
  CheckAtMost("worst relative error against double precision", far, 4e-3,
    "the mean of normals within rounding of one length spreads the cosine by 1.2e-2");
  CheckEqual("in one place", vtkiPointLightStrength(vec3(0.0f), -Up, Up, 0.0f), 0.0);
}

VTK_INDIRECT_TEST(PatchLimits)
{
  Random random(14);
  int bad = 0;
  double largest = 0.0;
  int behind = 0;
  double far = 0.0;
  for (int i = 0; i < 500000; ++i)
  {
    // In a scene of length one; normals of clusters are shorter.
    const vec3 d = vec3(random.NextDirection() * random.NextMagnitude(1e-6, 1e3));
    const auto area = static_cast<float>(random.NextMagnitude(1e-12, 1e3));
    const float softening = area * static_cast<float>(random.NextMagnitude(1.0, 16.0));
    const vec3 unit = vec3(random.NextDirection());
    const vec3 normalS = static_cast<float>(random.NextMagnitude(0.01, 1.0)) * unit;
    const vec3 normalR = vec3(random.NextDirection());
    const float w = vtkiPatchLightWeight(d, normalS, normalR, area, softening);
    bad += !std::isfinite(w) || w < 0.0f;
    largest = std::max(largest, double(w) * area);
    // Rounding places receivers on a crease just behind the patch (PatchesOfPlanes), so that those
    // across its plane are lit down to a thousandth of the softening behind it; others are not.
    const bool across = glm::dot(unit, normalR) < 0.5f;
    behind += glm::dot(unit, d) > (across ? 1e-3f * std::sqrt(softening) : 0.0f) &&
      vtkiPatchLightWeight(d, unit, normalR, area, softening) > 1e-4f / area;
    const double radius = std::sqrt(std::max(area, softening) / vtkMath::Pi());
    const double r = glm::length(glm::dvec3(d));
    const double before = -glm::dot(glm::dvec3(unit), glm::dvec3(d)) / r;
    const double facing = glm::dot(glm::dvec3(normalR), glm::dvec3(d)) / r;
    if (r > 1e3 * radius && before > 0.1 && facing > 0.1)
    {
      const double ratio = double(vtkiPatchLightWeight(d, unit, normalR, area, softening)) /
        vtkiVirtualLightWeight(d, unit, normalR, area);
      far = std::max(far, std::abs(ratio - 1.0));
    }
  }
  CheckEqual("weights that are not finite or negative", bad, 0);
  CheckAtMost("the largest weight times the area", largest, 1.0, "all of a light arrives at most");
  CheckEqual("weights behind a flat light", behind, 0);
  CheckAtMost("from 1000 radii on, beside the kernel of the axis", far, 1e-3,
    "a hundred times (radius / r)^2 at the least cosines, and rounding");
  CheckEqual(
    "in one place, without an area", vtkiPatchLightWeight(vec3(0.0f), -Up, Up, 0.0f, 0.0f), 0.0);
  CheckRelative("a point, at one", vtkiPatchLightWeight(Up, -Up, Up, 0.0f, 0.0f),
    1.0 / vtkMath::Pi(), 1e-6, "rounding");
  CheckRelative("a patch before the receiver, at one",
    vtkiPatchLightWeight(Up, -Up, Up, 3.0f, 0.0f), 0.5 / vtkMath::Pi(), 1e-6,
    "1 / (pi (r^2 + 4 variance)), of a disk of that variance; rounding");
}
