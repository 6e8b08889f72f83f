// SPDX-License-Identifier: BSD-3-Clause
// Senders and receivers that touch, or lie in one plane.
#include "vtkIndirectHardCase.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace vtkIndirectTest;

// Three walls equally lit by one sun have one radiance B: the irradiance of each is B times the
// form factor of the other two (Lambert).
VTK_INDIRECT_TEST(Corner)
{
  const double radiance = 0.75 / std::sqrt(3.0);
  for (double width : { 1.0, 1e-3, 1e-6 })
  {
    // Outlines in view count whole texels.
    const int texels = width == 1.0 ? 256 : 128;
    char name[64];
    std::snprintf(name, sizeof(name), "a corner, %g of it in view", width);
    HardCase scene(name, 33, 25);
    scene.AddCorner(glm::dvec3(0.75));
    scene.AddDirectional({ -1, -1, -1 });
    scene.Radiance = radiance;
    scene.Pass->SetReflectiveShadowMapResolution(texels);
    // The middle pixel's centre is the vertex itself.
    scene.SetEye(
      4.0 * width * glm::dvec3(0.6, 0.5, 0.7), { 0, 0, 0 }, { 0, 1, 0 }, 20, width, 8.0 * width);
    // Texels of the map on a wall: width of the map over its texels, over cos.
    const double area = std::pow(1.01 * 2.0 * std::sqrt(2.0 / 3.0) / texels, 2.0) * std::sqrt(3.0);
    const double radius = 2.0 * std::sqrt(area / vtkMath::Pi());
    auto check = [&](const EstimatorEntry& estimator)
    {
      if (estimator.Sum != EstimatorEntry::OTHER)
      {
        CheckAtMost("brightest irradiance over the radiance of all senders",
          GetLargest(scene.Copy("irradiance")) / radiance, 1.0,
          "a constant radiance around gives as much irradiance");
      }
      if (estimator.Sum != EstimatorEntry::ALL_TEXELS)
      {
        return;
      }
      const Image irradiance = scene.Copy("irradiance");
      const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
      double above = 0.0;
      double worst = 0.0;
      int far = 0;
      for (size_t i = 0; i < receivers.size(); ++i)
      {
        const glm::dvec3 p = receivers[i].Position;
        const glm::dvec3 n = receivers[i].Normal;
        if (!receivers[i].Lit || std::max({ p.x, p.y, p.z }) > 1.0)
        {
          continue;
        }
        double factor = 0.0;
        double nearest = 1.0;
        for (int k = 0; k < 3; ++k)
        {
          if (std::abs(n[k]) < 0.5)
          {
            glm::dvec3 a(0.0);
            glm::dvec3 b(0.0);
            a[(k + 1) % 3] = 1.0;
            b[(k + 2) % 3] = 1.0;
            factor += PolygonFormFactor(p, n, { glm::dvec3(0.0), a, a + b, b });
            nearest = std::min(nearest, p[k]);
          }
        }
        const double value = irradiance.Values[3 * i];
        above = std::max(above, value / radiance - factor);
        if (nearest > 2.0 * radius)
        {
          ++far;
          worst = std::max(worst, std::abs(value / (radiance * factor) - 1.0));
        }
      }
      if (width == 1.0)
      {
        CheckAtLeast("receivers away from the other walls", far, 100, "the test's own power");
        CheckAtMost("away from the other walls: worst relative difference to Lambert's sum", worst,
          0.02,
          "half a texel of 149 at each outline; the kernel, A / (pi r^2) low for what is nearest");
      }
      CheckAtMost("excess over Lambert's sum, as a form factor", above, 0.005,
        "the kernel is low in contact; outlines in whole texels");
    };
    scene.CheckEstimators(1, check);
  }
}

VTK_INDIRECT_TEST(OnePlane)
{
  // Two quads in one plane, rotated by various angles, in light of each kind.
  for (int turn = 0; turn < 6; ++turn)
  {
    const double angle = 0.37 * turn;
    const glm::dvec3 x(std::cos(angle), 0.0, -std::sin(angle));
    const glm::dvec3 y(std::sin(angle) * std::sin(0.7 * angle), std::cos(0.7 * angle),
      std::cos(angle) * std::sin(0.7 * angle));
    const glm::dvec3 n = glm::cross(x, y);
    HardCase scene("one plane, turned by " + std::to_string(angle));
    scene.AddQuad({ 0, 0, 0 }, x, y, glm::dvec3(0.75));
    scene.AddQuad(1.2 * x, 2.2 * x, 1.2 * x + y, glm::dvec3(0.75));
    const glm::dvec3 over = 0.5 * x + 0.4 * y + 0.6 * n;
    scene.Radiance = 0.75;
    if (turn % 3 == 0)
    {
      scene.AddSpot(over, over - n + 0.2 * x, 50, 1, { 1, 0, 0 });
    }
    else if (turn % 3 == 1)
    {
      scene.AddPoint(over, { 0, 0, 1 });
    }
    else
    {
      scene.AddDirectional(-n + 0.3 * x + 0.1 * y);
    }
    scene.SetEye(x + 0.5 * y + 4.0 * n, x + 0.5 * y, y, 32, 0.5, 6);
    scene.CheckEstimators(1,
      [&](const EstimatorEntry& estimator)
      {
        CheckAtLeast(
          "mean direct light", scene.Copy("direct").Mean(), 0.05, "the test's own power");
        CheckAtMost("largest irradiance over the radiance",
          GetLargest(scene.Copy("irradiance")) / 0.75, std::max(1.7e-8, estimator.Blur),
          "exactly 0 but for the steps of normals, 1.3e-4 (Unit.PackSurface), in both cosines");
      });
  }
}

// A plane lit at ever smaller angles reflects albedo sin(angle) of the light per area; a wall
// behind it receives that.
VTK_INDIRECT_TEST(Grazing)
{
  const int texels = 128;
  for (double sine : { 0.5, 0.1, 1e-2, 1e-3, 1e-6, 0.0 })
  {
    char name[64];
    std::snprintf(name, sizeof(name), "a sun of sine %g over the floor", sine);
    HardCase scene(name);
    scene.AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, glm::dvec3(0.75));
    // Parallel to the sun, so that it is unlit.
    scene.AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, glm::dvec3(0.75));
    scene.Pass->SetReflectiveShadowMapResolution(texels);
    scene.AddDirectional({ -std::sqrt(1.0 - sine * sine), -sine, 0.0 });
    // The floor's height in the map is `sine`: a whole number of rows, plus or minus two.
    const double row = 2.0 * 1.01 * 0.5 * (std::sqrt(1.0 - sine * sine) + sine) / texels;
    scene.CheckEstimators(1,
      [&](const EstimatorEntry& estimator)
      {
        if (estimator.Sum == EstimatorEntry::ALL_TEXELS)
        {
          CheckAbsolute("reflected flux", scene.GetReflectedFlux().x, 0.75 * sine,
            0.75 * 2.0 * row * 1.01, "two rows of texels");
        }
        if (sine == 0.0)
        {
          CheckEqual("largest irradiance", GetLargest(scene.Copy("irradiance")), 0.0);
        }
      });
  }
}
