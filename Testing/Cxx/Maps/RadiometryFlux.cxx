// SPDX-License-Identifier: BSD-3-Clause
// The sum of B A over a light's map is the flux that the scene reflects, independent of the
// resolution.
#include "vtkIndirectTestUtilities.h"

#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkRSMGatherPass.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
const glm::dvec3 Albedo(0.75, 0.5, 0.25);

// Flux of a spot onto a plane (point, normal) in front of it, by quadrature over its cone:
// intensity att(d) d^2 cos^exponent, integrated over solid angle.
double ConeFlux(double cone, double exponent, const glm::dvec3& attenuation, const glm::dvec3& axis,
  double distance, const glm::dvec3& normal)
{
  const glm::dvec3 u = glm::normalize(
    glm::cross(axis, std::abs(axis.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 v = glm::cross(axis, u);
  return Integrate(
    std::cos(vtkMath::RadiansFromDegrees(cone)), 1.0,
    [&](double z)
    {
      const double r = std::sqrt(1.0 - z * z);
      return Integrate(
        0.0, 2.0 * vtkMath::Pi(),
        [&](double phi)
        {
          const glm::dvec3 w = z * axis + r * (std::cos(phi) * u + std::sin(phi) * v);
          const double d = distance / -glm::dot(w, normal);
          return d * d / (attenuation.x + d * (attenuation.y + d * attenuation.z)) *
            std::pow(z, exponent);
        },
        4);
    },
    4);
}

struct SpotCase
{
  const char* What;
  double Cone;
  double Exponent;
  glm::dvec3 Attenuation;
  double Tilt; // degrees between the axis and the plane's normal
};
const SpotCase SpotCases[] = {
  { "narrow, inverse square", 20.0, 0.0, { 0.0, 0.0, 1.0 }, 0.0 },
  { "wide, inverse square", 60.0, 0.0, { 0.0, 0.0, 2.0 }, 0.0 },
  { "no falloff", 40.0, 0.0, { 1.0, 0.0, 0.0 }, 0.0 },
  { "linear falloff", 40.0, 0.0, { 0.0, 1.0, 0.0 }, 20.0 },
  { "mixed falloff", 30.0, 0.0, { 0.5, 0.2, 0.3 }, 30.0 },
  { "exponent 1, VTK's default", 30.0, 1.0, { 1.0, 0.0, 0.0 }, 0.0 },
  { "exponent 8, tilted", 45.0, 8.0, { 0.0, 0.0, 1.0 }, 25.0 },
  { "tilted, no falloff", 25.0, 0.0, { 1.0, 0.0, 0.0 }, 40.0 },
};
}

VTK_INDIRECT_TEST(SpotFlux)
{
  // The quadrature itself: 2 pi (1 - cos) for the inverse square law, and with an exponent.
  const glm::dvec3 down(0, 0, -1);
  const double half = std::cos(vtkMath::RadiansFromDegrees(30.0));
  CheckRelative("quadrature, inverse square", ConeFlux(30, 0, { 0, 0, 1 }, down, 2.0, { 0, 0, 1 }),
    2.0 * vtkMath::Pi() * (1.0 - half), 1e-10, "closed form");
  CheckRelative("quadrature, exponent 4", ConeFlux(30, 4, { 0, 0, 1 }, down, 2.0, { 0, 0, 1 }),
    2.0 * vtkMath::Pi() * (1.0 - std::pow(half, 5.0)) / 5.0, 1e-10, "closed form");
  CheckRelative("quadrature, no falloff", ConeFlux(30, 0, { 1, 0, 0 }, down, 2.0, { 0, 0, 1 }),
    2.0 * vtkMath::Pi() * 4.0 * (1.0 / half - 1.0), 1e-10, "closed form");

  for (const SpotCase& c : SpotCases)
  {
    const double tilt = vtkMath::RadiansFromDegrees(c.Tilt);
    const glm::dvec3 axis(std::sin(tilt), 0.0, -std::cos(tilt));
    Scene scene(8, 8);
    scene.AddQuad({ -40, -40, 0 }, { 40, -40, 0 }, { -40, 40, 0 }, Albedo);
    const glm::dvec3 position(0.3, -0.2, 1.5);
    vtkLight* light = scene.AddSpot(position, position + axis, c.Cone, c.Exponent, c.Attenuation);
    light->SetIntensity(1.7);
    light->SetColor(1.0, 0.5, 0.25);
    scene.SetEye({ 0, 0, 20 }, { 0, 0, 0 }, { 0, 1, 0 }, 40, 1, 100);
    const double flux =
      1.7 * Albedo.x * ConeFlux(c.Cone, c.Exponent, c.Attenuation, axis, 1.5, { 0, 0, 1 });
    for (int n : { 64, 256 })
    {
      scene.Pass->SetReflectiveShadowMapResolution(n);
      scene.Render();
      const glm::dvec3 sum = scene.GetReflectedFlux();
      // The rim counts whole texels: 0.23 % of a disk of 64, 0.03 % of 256; with a larger weight
      // where d^2 grows.
      const std::string what = std::string(c.What) + ", " + std::to_string(n) + "^2";
      CheckRelative(what, sum.x, flux, n == 64 ? 0.005 : 0.002, "the cone's rim in whole texels");
      CheckRelative(what + ", green over red", sum.y / sum.x, 0.5 * Albedo.y / Albedo.x, 1e-5,
        "light's colour");
    }
    Check(
      std::string(c.What) + ": 3 % more would be rejected", !WouldPass(1.03 * flux, flux, 0.005));
    // A stored albedo cos with a fixed area would count the cosine twice.
    if (c.Tilt > 20.0)
    {
      Check(std::string(c.What) + ": a cosine counted twice would be rejected",
        !WouldPass(std::cos(tilt) * flux, flux, 0.005));
    }
  }
}

VTK_INDIRECT_TEST(WideSpotFlux)
{
  for (double cone : { 61.0, 75.0, 89.0 })
  {
    for (double exponent : { 0.0, 2.0 })
    {
      Scene scene(8, 8);
      scene.AddBox({ -1, -1.2, -0.8 }, { 1, 1.2, 0.8 }, Albedo);
      // A direction along no axis, so that the rim crosses faces of the map.
      const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
      scene.AddSpot(
        { 0.1, 0.2, -0.1 }, glm::dvec3(0.1, 0.2, -0.1) + axis, cone, exponent, { 0, 0, 1 });
      scene.SetEye({ 0, 0, 0.5 }, { 0, 0, -1 }, { 0, 1, 0 }, 60, 0.01, 10);
      const double edge = std::cos(vtkMath::RadiansFromDegrees(cone));
      const double flux =
        Albedo.x * 2.0 * vtkMath::Pi() * (1.0 - std::pow(edge, exponent + 1.0)) / (exponent + 1.0);
      for (int n : { 64, 256 })
      {
        scene.Pass->SetReflectiveShadowMapResolution(n);
        scene.Render();
        // A cone of nearly 90 degrees is parallel to the faces' rows: half a row may be lost.
        CheckRelative("cone " + std::to_string(cone) + ", exponent " + std::to_string(exponent) +
            ", " + std::to_string(n) + "^2",
          scene.GetReflectedFlux().x, flux, cone > 85.0 ? 1.0 / n : (n == 64 ? 0.005 : 0.002),
          "the cone's rim in whole texels");
      }
    }
  }
}

VTK_INDIRECT_TEST(PointFlux)
{
  struct
  {
    const char* What;
    glm::dvec3 Attenuation;
  } cases[] = { { "inverse square", { 0, 0, 4 } }, { "no falloff", { 1, 0, 0 } },
    { "mixed falloff", { 1, 0.5, 2 } } };
  for (const auto& c : cases)
  {
    Scene scene(8, 8);
    const glm::dvec3 half(1.0, 0.7, 1.3);
    scene.AddBox(-half, half, Albedo);
    const glm::dvec3 position(0.2, -0.3, 0.4);
    scene.AddPoint(position, c.Attenuation);
    scene.SetEye({ 0, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 }, 60, 0.01, 10);
    // Integral of cos / d^2 att d^2 over the six walls.
    double flux = 0.0;
    for (int i = 0; i < 6; ++i)
    {
      const int axis = i / 2;
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      const double h = half[axis] - (i % 2 ? -position[axis] : position[axis]);
      flux += Integrate(-half[u] - position[u], half[u] - position[u],
        [&](double x)
        {
          return Integrate(-half[v] - position[v], half[v] - position[v],
            [&](double y)
            {
              const double d = std::sqrt(h * h + x * x + y * y);
              return h / d / (c.Attenuation.x + d * (c.Attenuation.y + d * c.Attenuation.z));
            });
        });
    }
    if (c.Attenuation.x == 0.0)
    {
      CheckRelative("quadrature, inverse square", flux, vtkMath::Pi(), 1e-6, "4 pi / 4");
    }
    for (int n : { 64, 128 })
    {
      scene.Pass->SetReflectiveShadowMapResolution(n);
      scene.Render();
      CheckRelative(std::string(c.What) + ", " + std::to_string(n) + "^2",
        scene.GetReflectedFlux().x, Albedo.x * flux, n == 64 ? 0.005 : 0.002,
        "midpoint rule over texels");
    }
  }
}

VTK_INDIRECT_TEST(DirectionalFlux)
{
  {
    Scene scene(8, 8);
    scene.AddQuad({ 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, Albedo);
    scene.AddDirectional({ 0, 0, -3 });
    scene.SetEye({ 1, 1, 5 }, { 1, 1, 0 }, { 0, 1, 0 }, 40, 1, 20);
    scene.Pass->SetReflectiveShadowMapResolution(202);
    scene.Render();
    CheckRelative("a square seen straight, edges between texels", scene.GetReflectedFlux().x,
      Albedo.x * 4.0, 1e-4, "the map is 1.01 wide");
  }
  for (double tilt : { 30.0, 60.0 })
  {
    const double a = vtkMath::RadiansFromDegrees(tilt);
    Scene scene(8, 8);
    scene.AddQuad({ 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, Albedo);
    scene.AddDirectional({ std::sin(a), 0.4 * std::sin(a), -std::cos(a) });
    scene.SetEye({ 1, 1, 5 }, { 1, 1, 0 }, { 0, 1, 0 }, 40, 1, 20);
    const double cosine = std::cos(a) / std::sqrt(1.0 + 0.16 * std::sin(a) * std::sin(a));
    for (int n : { 256, 1024 })
    {
      scene.Pass->SetReflectiveShadowMapResolution(n);
      scene.Render();
      CheckRelative("a square at " + std::to_string(tilt) + " degrees, " + std::to_string(n) + "^2",
        scene.GetReflectedFlux().x, Albedo.x * 4.0 * cosine, 1.5 / n / std::cos(a),
        "a texel more or less across the shorter side");
    }
  }
  Scene scene(8, 8);
  scene.AddSphere({ 0.3, 0, 0 }, 1.5, 200, Albedo);
  scene.AddDirectional({ 0.3, -0.7, 0.2 });
  scene.SetEye({ 0, 0, 6 }, { 0, 0, 0 }, { 0, 1, 0 }, 40, 1, 20);
  for (int n : { 64, 256 })
  {
    scene.Pass->SetReflectiveShadowMapResolution(n);
    scene.Render();
    // Facets turned away at the outline lose their light; half a texel of the rim is 1 / n.
    CheckRelative("a sphere's cross section, " + std::to_string(n) + "^2",
      scene.GetReflectedFlux().x, Albedo.x * vtkMath::Pi() * 2.25, n == 64 ? 0.01 : 0.004,
      "the outline in whole texels");
  }
}

VTK_INDIRECT_TEST(SampledFlux)
{
  const char* const names[] = { "grid", "jittered", "low discrepancy" };
  const double cone = 35.0;
  const double flux = Albedo.x * ConeFlux(cone, 0, { 1, 0, 0 }, { 0, 0, -1 }, 1.5, { 0, 0, 1 });
  Scene scene(8, 8);
  scene.AddQuad({ -4, -4, 0 }, { 4, -4, 0 }, { -4, 4, 0 }, Albedo);
  scene.AddSpot({ 0, 0, 1.5 }, { 0, 0, 0 }, cone, 0, { 1, 0, 0 });
  scene.SetEye({ 0, 0, 20 }, { 0, 0, 0 }, { 0, 1, 0 }, 40, 1, 100);
  scene.Pass->SetReflectiveShadowMapResolution(1024);
  scene.Gather->SetModeToVirtualLights();
  for (int pattern = 0; pattern < 3; ++pattern)
  {
    scene.Sampler->SetPattern(pattern);
    for (int n : { 64, 256, 1024, 4096 })
    {
      scene.Sampler->SetNumberOfLights(n);
      scene.Render();
      const double error = std::abs(scene.GetReflectedFlux().x / flux - 1.0);
      CheckAtMost(
        std::string(names[pattern]) + ", " + std::to_string(n) + " lights: relative error", error,
        0.5 / n + (pattern == 1 ? 1e-3 : 3e-4),
        "falls as 1 / N to what 1024 texels resolve; d^2 grows by half to the rim");
    }
  }
}
