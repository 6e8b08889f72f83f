// SPDX-License-Identifier: BSD-3-Clause
// Kernels of a light's map: solid angles, faces of the cube, VTK's attenuation and cone.
#include "OpenGL/vtkIndirectKernels.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

namespace
{
// Solid angle of the rectangle from (0,0) to (x,y) on the plane at distance one.
double Corner(double x, double y)
{
  return std::atan2(x * y, std::sqrt(1.0 + x * x + y * y));
}
}

VTK_INDIRECT_TEST(TexelSolidAngle)
{
  for (double halfWidth : { 1.0, std::sqrt(3.0), 0.1 })
  {
    for (int n : { 16, 64, 512 })
    {
      const double h = 2.0 * halfWidth / n;
      double sum = 0.0;
      double worst = 0.0;
      for (int j = 0; j < n; ++j)
      {
        for (int i = 0; i < n; ++i)
        {
          const double x = -halfWidth + h * i;
          const double y = -halfWidth + h * j;
          const double exact =
            Corner(x + h, y + h) - Corner(x, y + h) - Corner(x + h, y) + Corner(x, y);
          const double value =
            vtkiTexelSolidAngle(vec2(x + 0.5 * h, y + 0.5 * h), static_cast<float>(h));
          sum += value;
          worst = std::max(worst, std::abs(value / exact - 1.0));
        }
      }
      const std::string what = "half width " + std::to_string(halfWidth) + ", " + std::to_string(n);
      // Midpoint rule: h^2 / 24 times the Laplacian of (1 + r^2)^-3/2 over itself, which is at most
      // 6.
      CheckAtMost(what + ": worst texel against its exact solid angle", worst, h * h / 4 + 4e-6,
        "midpoint rule; differences of double-precision arctangents and floats");
      CheckRelative(
        what + ": sum", sum, 4.0 * Corner(halfWidth, halfWidth), h * h / 4 + 1e-6, "midpoint rule");
      if (halfWidth == 1.0)
      {
        CheckRelative(
          what + ": six faces", 6.0 * sum, 4.0 * vtkMath::Pi(), h * h / 4 + 1e-6, "midpoint rule");
      }
    }
  }
}

VTK_INDIRECT_TEST(CubeFaces)
{
  const vec3 ex(1.0f, 0.0f, 0.0f);
  const vec3 ey(0.0f, 1.0f, 0.0f);
  const vec3 ez(0.0f, 0.0f, 1.0f);
  for (int face = 0; face < 6; ++face)
  {
    const mat3 m(vtkiToFace(ex, face), vtkiToFace(ey, face), vtkiToFace(ez, face));
    CheckEqual("determinant of face " + std::to_string(face), glm::determinant(m), 1.0);
    Check("face " + std::to_string(face) + " is orthogonal", glm::transpose(m) * m == mat3(1.0f));
  }
  Random random(5);
  int outside = 0;
  int used[6] = {};
  int nonlinear = 0;
  for (int i = 0; i < 200000; ++i)
  {
    vec3 p = vec3(random.NextDirection() * random.NextMagnitude(1e-12, 1e12));
    if (i % 4 == 0)
    {
      // Exactly on an edge between faces.
      p.y = random.Next() < 0.5 ? p.x : -p.x;
    }
    const int face = vtkiFaceOf(p);
    const vec3 q = vtkiToFace(p, face);
    ++used[face];
    outside += !(q.z < 0.0f && std::abs(q.x) <= -q.z && std::abs(q.y) <= -q.z);
    nonlinear += vtkiToFace(2.0f * p, face) != 2.0f * q;
  }
  CheckEqual("points outside the projection of their face", outside, 0);
  CheckEqual("points that do not scale", nonlinear, 0);
  for (int face = 0; face < 6; ++face)
  {
    CheckAtLeast("share of face " + std::to_string(face), used[face] / 200000.0, 0.1, "one sixth");
  }
  CheckEqual("face of forward", vtkiFaceOf(-ez), 0);
  CheckEqual("face of backward", vtkiFaceOf(ez), 5);
  // Wide spots of less than 90 degrees lack face 5: no point in front may need it.
  int backward = 0;
  for (int i = 0; i < 100000; ++i)
  {
    vec3 p = vec3(random.NextDirection());
    p.z = -std::abs(p.z);
    backward += vtkiFaceOf(p) == 5;
  }
  CheckEqual("forward directions on the backward face", backward, 0);
}

VTK_INDIRECT_TEST(Attenuation)
{
  Random random(6);
  double worst = 0.0;
  double worstUnlit = 0.0;
  for (int i = 0; i < 200000; ++i)
  {
    double c[3];
    for (double& value : c)
    {
      value = random.Next() < 0.3 ? 0.0 : random.NextMagnitude(1e-12, 1e12);
    }
    const auto d = static_cast<float>(random.NextMagnitude(1e-6, 1e6));
    const vec3 attenuation(c[0], c[1], c[2]);
    const double dd = d;
    const double denominator =
      double(attenuation.x) + dd * (double(attenuation.y) + dd * double(attenuation.z));
    const double value = vtkiAttenuationTimesDistance2(attenuation, d);
    if (denominator > 0.0)
    {
      worst = std::max(worst, std::abs(value / (dd * dd / denominator) - 1.0));
    }
    else
    {
      worstUnlit = std::max(worstUnlit, std::abs(value));
    }
  }
  // Six roundings of 6e-8.
  CheckAtMost("worst relative error", worst, 4e-7, "six roundings");
  CheckEqual("without any attenuation, which VTK divides by zero for", worstUnlit, 0.0);
  CheckEqual("d = 0, constant", vtkiAttenuationTimesDistance2(vec3(1.0f, 0.0f, 0.0f), 0.0f), 0.0);
  CheckEqual("d = 0, linear", vtkiAttenuationTimesDistance2(vec3(0.0f, 1.0f, 0.0f), 0.0f), 0.0);
  CheckEqual("d = 0, quadratic", vtkiAttenuationTimesDistance2(vec3(0.0f, 0.0f, 4.0f), 0.0f), 0.25);
  CheckEqual("d = 0, none", vtkiAttenuationTimesDistance2(vec3(0.0f), 0.0f), 0.0);
  for (float d : { 1e-19f, 1e-12f, 1.0f, 1e12f, 1e18f })
  {
    const float value = vtkiAttenuationTimesDistance2(vec3(0.0f, 0.0f, 2.0f), d);
    // Below 1e-19 the square leaves the range of floats; scene units keep distances far above that.
    CheckRelative("pure quadratic at " + std::to_string(std::log10(d)), value, 0.5,
      d < 1e-18f ? 1e-3 : 1e-6, "denormals at the low end");
  }
}

VTK_INDIRECT_TEST(ConeFactor)
{
  Random random(7);
  double worst = 0.0;
  int edges = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const auto cosCone = static_cast<float>(random.Next(0.0, 1.0));
    const auto cosAxis = static_cast<float>(random.Next(-1.0, 1.0));
    const float exponent = i % 5 == 0 ? 0.0f : static_cast<float>(random.Next(0.0, 64.0));
    const float value = vtkiConeFactor(cosAxis, cosCone, exponent);
    if (cosAxis < cosCone)
    {
      edges += value != 0.0f;
      continue;
    }
    const double expected = std::pow(double(cosAxis), double(exponent));
    // exponent 64 multiplies the logarithm's rounding.
    worst = std::max(worst, std::abs(value - expected) / std::max(expected, 1e-30));
  }
  CheckEqual("light outside the cone", edges, 0);
  CheckAtMost("worst relative error inside", worst, 1e-5, "rounding of pow");
  CheckEqual("on the edge", vtkiConeFactor(0.5f, 0.5f, 0.0f), 1.0);
  CheckEqual("no cone, backward", vtkiConeFactor(-1.0f, -2.0f, 8.0f), 1.0);
  CheckEqual("exponent 0 on a cone of 90 degrees", vtkiConeFactor(0.0f, 0.0f, 0.0f), 1.0);
}

VTK_INDIRECT_TEST(CosineRatio)
{
  Random random(8);
  double worst = 0.0;
  int wrong = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const auto cosine = static_cast<float>(random.Next(0.01, 1.0));
    worst = std::max(worst, std::abs(vtkiCosineRatio(cosine, cosine, 0.001f) - 1.0));
    wrong += vtkiCosineRatio(-cosine, cosine, 0.001f) != 0.0f;
    // Grazing: the surface of a texel is bounded, and so is its reflection.
    wrong += vtkiCosineRatio(cosine, 0.0f, 0.01f) > 1.0f / 0.01f;
  }
  CheckAtMost("equal normals: the cosine cancels", worst, 1e-7, "one division");
  CheckEqual("unlit or unbounded values", wrong, 0);
  CheckEqual("both cosines zero", vtkiCosineRatio(0.0f, 0.0f, 0.01f), 0.0);
}
