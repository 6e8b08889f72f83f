// SPDX-License-Identifier: BSD-3-Clause
// Spherical harmonics and irradiance against quadrature.
#include "OpenGL/vtkIndirectKernels.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

namespace
{
// Directions and weights of a midpoint rule over the sphere.
void ForSphere(const std::function<void(const glm::dvec3&, double)>& f)
{
  const int around = 32;
  const int rings = 400;
  for (int j = 0; j < rings; ++j)
  {
    const double z = -1.0 + (2.0 * j + 1.0) / rings;
    const double s = std::sqrt(1.0 - z * z);
    for (int i = 0; i < around; ++i)
    {
      const double phi = 2.0 * vtkMath::Pi() * (i + 0.5) / around;
      f({ s * std::cos(phi), s * std::sin(phi), z }, 4.0 * vtkMath::Pi() / rings / around);
    }
  }
}

void Basis(const glm::dvec3& d, double y[9])
{
  const vec4 low = vtkiHarmonicsLow(vec3(d));
  const vec4 high = vtkiHarmonicsHigh(vec3(d));
  for (int i = 0; i < 4; ++i)
  {
    y[i] = low[i];
    y[4 + i] = high[i];
  }
  y[8] = vtkiHarmonicsLast(vec3(d));
}
}

VTK_INDIRECT_TEST(HarmonicsOrthonormal)
{
  double products[9][9] = {};
  ForSphere(
    [&](const glm::dvec3& d, double weight)
    {
      double y[9];
      Basis(d, y);
      for (int i = 0; i < 9; ++i)
      {
        for (int j = 0; j < 9; ++j)
        {
          products[i][j] += weight * y[i] * y[j];
        }
      }
    });
  double worst = 0.0;
  for (int i = 0; i < 9; ++i)
  {
    for (int j = 0; j < 9; ++j)
    {
      worst = std::max(worst, std::abs(products[i][j] - (i == j ? 1.0 : 0.0)));
    }
  }
  CheckAtMost("products of the nine functions, off from orthonormal", worst, 5e-5,
    "midpoint rule of 400 rings: 1/400^2 times the second derivative");
}

VTK_INDIRECT_TEST(HarmonicsIrradiance)
{
  // A light of low order: the irradiance is exact. E = 1/pi int L cos.
  Random random(5);
  double worst = 0.0;
  for (int trial = 0; trial < 20; ++trial)
  {
    double c[9];
    for (double& v : c)
    {
      v = random.Next(-1.0, 1.0);
    }
    const glm::dvec3 n = random.NextDirection();
    double exact = 0.0;
    ForSphere(
      [&](const glm::dvec3& d, double weight)
      {
        double y[9];
        Basis(d, y);
        double radiance = 0.0;
        for (int i = 0; i < 9; ++i)
        {
          radiance += c[i] * y[i];
        }
        exact += weight * radiance * std::max(0.0, glm::dot(d, n)) / vtkMath::Pi();
      });
    const double e = vtkiIrradianceLow(vec4(c[0], c[1], c[2], c[3]), vec3(n)) +
      vtkiIrradianceHigh(vec4(c[4], c[5], c[6], c[7]), static_cast<float>(c[8]), vec3(n));
    worst = std::max(worst, std::abs(e - exact));
  }
  CheckAtMost("irradiance of light of order 3 against quadrature", worst, 2e-3,
    "32 directions around cut the clamped cosine's edge");
}

VTK_INDIRECT_TEST(HarmonicsLobe)
{
  // Cones of constant radiance, from the whole sphere to one direction.
  for (double half : { 180.0, 120.0, 90.0, 60.0, 30.0, 5.0 })
  {
    const double cosine = std::cos(half * vtkMath::Pi() / 180.0);
    const double r0 = 0.5 * (1.0 - cosine);                   // mean over the sphere
    const double first = 0.25 * (1.0 - cosine * cosine) / r0; // mean cosine over 1
    // c00 = 4 pi Y00 mean; |c1| = sqrt(3) c00 (mean cosine of the light)
    const double c00 = 4.0 * vtkMath::Pi() * 0.28209479 * r0;
    const double c1 = std::sqrt(3.0) * c00 * first;
    const vec4 c(static_cast<float>(c00), 0.0f, static_cast<float>(c1), 0.0f);
    const std::string what = "cone of " + std::to_string(static_cast<int>(half)) + " degrees: ";
    // A facing surface: E = L sin^2; for more than a hemisphere all of the front, L.
    const double facing = half >= 90.0 ? 1.0 : 1.0 - cosine * cosine;
    CheckRelative(what + "in front", vtkiIrradianceLobe(c, vec3(0, 0, 1)),
      half > 90.0 ? vtkiIrradianceLow(c, vec3(0, 0, 1)) : facing, 1e-4,
      "exact for cones up to a hemisphere, the linear form beyond");
    double least = INFINITY;
    for (int i = 0; i <= 100; ++i)
    {
      const double x = -1.0 + 0.02 * i;
      least = std::min<double>(
        least, vtkiIrradianceLobe(c, vec3(std::sqrt(std::max(0.0, 1.0 - x * x)), 0.0, x)));
    }
    CheckAtLeast(what + "least", least, -1e-6 * r0, "irradiance is never negative");
    if (half <= 60.0)
    {
      CheckAtMost(what + "least of the linear form", vtkiIrradianceLow(c, vec3(0, 0, -1)),
        -0.1 * r0, "what the lobe cures");
    }
  }
  // A hemisphere of radiance L gives L, one behind gives nothing.
  const double c00 = 2.0 * vtkMath::Pi() * 0.28209479;
  const vec4 half(static_cast<float>(c00), 0.0f, static_cast<float>(std::sqrt(0.75) * c00), 0.0f);
  CheckRelative(
    "half-space, in front", vtkiIrradianceLobe(half, vec3(0, 0, 1)), 1.0, 1e-5, "exact");
  CheckAbsolute("half-space, behind", vtkiIrradianceLobe(half, vec3(0, 0, -1)), 0.0, 1e-5, "exact");
  CheckEqual("no light", vtkiIrradianceLobe(vec4(0.0f), vec3(0, 0, 1)), 0.0);
}

VTK_INDIRECT_TEST(PatchSolidAngle)
{
  const vec3 up(0, 0, 1);
  auto seen = [&](const vec3& toSender, float softening)
  { return vtkiPatchSolidAngle(vtkiPatchOffset(toSender, up, softening), up); };
  // A disk seen from its axis: solid angle 2 pi (1 - 1 / sqrt(1 + (a/h)^2)).
  const double area = vtkMath::Pi() * 0.01;
  for (double height : { 0.01, 0.05, 0.1, 0.3, 1.0, 10.0 })
  {
    const double exact =
      2.0 * vtkMath::Pi() * (1.0 - 1.0 / std::sqrt(1.0 + 0.01 / height / height));
    const double measured =
      area * seen(vec3(0, 0, -height), static_cast<float>(area / (2.0 * vtkMath::Pi())));
    // The limits are equal; between them 1 / (h^2 + a^2 / 2) exceeds the disk's solid angle.
    CheckRelative("disk at " + std::to_string(height / 0.1) + " radii", measured, exact, 0.21,
      "same limits near and far; a fifth too much at half a radius");
    CheckAtMost(
      "no more than half of the sphere", measured, 2.0 * vtkMath::Pi() * 1.000001, "limit");
  }
  CheckEqual("from behind", seen(vec3(0, 0, 1), 0.1f), 0.0);
  CheckEqual("from within", seen(vec3(0.0f), 0.0f), 0.0);
  // A large plane of patches fills half of all directions, at any distance, and its light is that
  // of a hemisphere.
  const double edge = 0.1;
  const float softening = static_cast<float>(edge * edge / (2.0 * vtkMath::Pi()));
  for (double height : { 0.002, 0.02, 0.1, 0.3 })
  {
    double sum = 0.0;
    double vertical = 0.0;
    const int count = 600;
    for (int j = -count; j < count; ++j)
    {
      for (int i = -count; i < count; ++i)
      {
        // The point is above no corner or middle of a patch.
        const vec3 toSender(edge * (i + 0.3), edge * (j + 0.2), -height);
        const vec3 offset = vtkiPatchOffset(toSender, up, softening);
        const double share = edge * edge * vtkiPatchSolidAngle(offset, up);
        sum += share;
        vertical -= share * offset.z / glm::length(offset);
      }
    }
    // Beyond the patches lies h'/R of the plane; h' is at most 0.3, R 60 and more. Sums over
    // patches in place of an integral: the kernel is as wide as sqrt(s), 0.4 of a patch.
    CheckAbsolute("plane from a height of " + std::to_string(height / edge) + " patches",
      sum / (2.0 * vtkMath::Pi()), 1.0, 0.09, "sum over patches of a kernel half as wide");
    CheckAbsolute("its light straight up", vertical / vtkMath::Pi(), 1.0, 0.09, "as above");
  }
}
