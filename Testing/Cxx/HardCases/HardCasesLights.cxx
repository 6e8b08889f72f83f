// SPDX-License-Identifier: BSD-3-Clause
// Lights at extreme positions, of extreme shapes and strengths.
#include "vtkIndirectHardCase.h"

#include "vtkLight.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

using namespace vtkIndirectTest;

namespace
{
// Solid angle of a rectangle, a corner of which lies at distance d in front of the eye.
double RectangleAngle(double a, double b, double d)
{
  return std::atan(a * b / (d * std::sqrt(a * a + b * b + d * d)));
}

void CheckDark(HardCase& scene)
{
  scene.CheckEstimators(1,
    [&](const EstimatorEntry&)
    { CheckEqual("largest irradiance", GetLargest(scene.Copy("irradiance")), 0.0); });
}
}

VTK_INDIRECT_TEST(LightOnSurface)
{
  {
    // The walls get all light of a point in the floor: with falloff 1 / d^2, albedo 1 reflects as
    // much flux as the walls' solid angle.
    HardCase scene("a point light in the floor");
    scene.AddCorner();
    scene.AddPoint({ 0.5, 0.0, 0.5 }, { 0, 0, 1 });
    scene.Pass->SetReflectiveShadowMapResolution(64);
    scene.CheckEstimators(1,
      [&](const EstimatorEntry& estimator)
      {
        if (estimator.Sum == EstimatorEntry::ALL_TEXELS)
        {
          CheckRelative("reflected flux", scene.GetReflectedFlux().x,
            4.0 * RectangleAngle(0.5, 1.0, 0.5), 0.02, "outlines, of 40 texels along an edge");
        }
        const Image direct = scene.Copy("direct");
        const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
        double brightest = 0.0;
        for (size_t i = 0; i < receivers.size(); ++i)
        {
          if (receivers[i].Normal.y > 0.99)
          {
            brightest = std::max(brightest, double(direct.Values[3 * i]));
          }
        }
        CheckAtMost("brightest pixel of the floor", brightest, 1e-3,
          "the cosine is rounding, below 1e-6, and the nearest pixel 0.03 away");
      });
  }
  {
    HardCase scene("a point light in the corner's vertex");
    scene.AddCorner();
    scene.AddPoint({ 0.0, 0.0, 0.0 }, { 0, 0, 1 });
    CheckDark(scene);
  }
  {
    HardCase scene("a spot in the floor that shines along it");
    scene.AddCorner();
    scene.AddSpot({ 0.5, 0.0, 0.5 }, { 0.2, 0.0, 0.2 }, 45, 1, { 1, 0, 0 });
    scene.CheckEstimators(1);
  }
  {
    HardCase scene("a directional light along two of the planes");
    scene.AddCorner();
    scene.AddDirectional({ 1, 0, 0 });
    scene.Radiance = 1.0;
    scene.CheckEstimators(1,
      [&](const EstimatorEntry&)
      {
        CheckAtMost("largest irradiance", GetLargest(scene.Copy("irradiance")), 1e-7,
          "the lit wall sends to its other side: positions are rounded to 1e-7, and lie 1e-3 "
          "apart");
      });
  }
}

// Least distance of a light from a surface: 1 / 1024 of its farthest surface, along the axis of a
// face of its map. A nearer surface is lost.
VTK_INDIRECT_TEST(LightNearSurface)
{
  for (double height : { 0.1, 1e-2, 1.5e-3, 5e-4, 1e-6 })
  {
    char name[64];
    std::snprintf(name, sizeof(name), "a point light %g above the floor", height);
    HardCase scene(name);
    scene.AddCorner();
    scene.AddPoint({ 0.5, height, 0.5 }, { 0, 0, 1 });
    scene.Pass->SetReflectiveShadowMapResolution(64);
    const double walls =
      2.0 * (2.0 * RectangleAngle(0.5, 1.0 - height, 0.5) + 2.0 * RectangleAngle(0.5, height, 0.5));
    const double floor = 4.0 * RectangleAngle(0.5, 0.5, height);
    // The farthest surface is 1.0 away along an axis.
    const bool seen = height > 1.001 / 1024.0;
    scene.CheckEstimators(1,
      [&](const EstimatorEntry& estimator)
      {
        if (estimator.Sum == EstimatorEntry::ALL_TEXELS)
        {
          const double flux = scene.GetReflectedFlux().x;
          CheckAtMost("reflected flux", flux, 1.02 * (walls + floor), "outlines in whole texels");
          CheckAtLeast("reflected flux", flux, 0.98 * (seen ? walls + floor : walls),
            seen ? "outlines in whole texels" : "what is nearer than 1 / 1024 is lost");
        }
      });
  }
}

VTK_INDIRECT_TEST(LightPlaces)
{
  {
    HardCase scene("a point light in a closed box");
    scene.AddCorner();
    scene.AddBox({ 0.3, 0.25, 0.35 }, { 0.5, 0.55, 0.6 }, glm::dvec3(1.0));
    scene.AddPoint({ 0.41, 0.37, 0.45 }, { 0, 0, 1 });
    scene.Radiance = 100.0; // 1 / d^2 at the box
    scene.Pass->SetReflectiveShadowMapResolution(64);
    scene.CheckEstimators(1,
      [&](const EstimatorEntry& estimator)
      {
        if (estimator.Sum == EstimatorEntry::ALL_TEXELS)
        {
          CheckRelative("reflected flux", scene.GetReflectedFlux().x, 4.0 * vtkMath::Pi(), 1e-3,
            "all of it is caught; the solid angle of texels is that of their centre");
        }
        CheckEqual("brightest direct light outside", GetLargest(scene.Copy("direct")), 0.0);
      });
  }
  {
    HardCase scene("a point light in the eye");
    scene.AddCorner();
    scene.AddPoint({ 2.2, 1.6, 2.3 }, { 0, 1, 0 });
    scene.CheckEstimators(1);
  }
  {
    HardCase scene("a headlight");
    scene.AddCorner();
    vtkNew<vtkLight> light;
    light->SetLightTypeToHeadlight();
    scene.Renderer->AddLight(light);
    scene.CheckEstimators(0);
  }
  {
    HardCase scene("a point light a million sizes away");
    scene.AddCorner();
    scene.AddPoint({ 1e6, 1e6, 1e6 }, { 1, 0, 0 });
    scene.Radiance = 1.0;
    scene.CheckEstimators(1);
  }
  {
    HardCase scene("a spot that shines on nothing");
    scene.AddCorner();
    scene.AddSpot({ 0.5, 0.5, 0.5 }, { 0.5, 0.5, 2.0 }, 30, 1, { 1, 0, 0 });
    CheckDark(scene);
  }
  {
    HardCase scene("six point lights");
    scene.AddCorner();
    for (int i = 0; i < 6; ++i)
    {
      scene.AddPoint({ 0.1 + 0.1 * i, 0.5, 0.5 }, { 0, 0, 1 })->SetIntensity(1e-3);
    }
    scene.CheckEstimators(6);
  }
}

// In a closed box, albedo 1 reflects the solid angle of the cone.
VTK_INDIRECT_TEST(LightCones)
{
  for (double cone : { 0.01, 0.1, 59.9, 60.1, 89.9, 90.0 })
  {
    HardCase scene("a spot of " + std::to_string(cone) + " degrees");
    scene.AddBox({ 0, 0, 0 }, { 1, 1.2, 1.4 }, glm::dvec3(1.0));
    scene.AddSpot({ 0.45, 0.6, 0.75 }, { 0.41, 0.0, 0.67 }, cone, 0, { 0, 0, 1 });
    scene.SetEye({ 0.9, 1.1, 1.3 }, { 0.2, 0.1, 0.2 }, { 0, 1, 0 }, 60, 0.01, 4);
    scene.Pass->SetReflectiveShadowMapResolution(64);
    const double angle =
      cone < 90.0 ? 2.0 * (1.0 - std::cos(vtkMath::RadiansFromDegrees(cone))) : 4.0;
    scene.CheckEstimators(1,
      [&](const EstimatorEntry& estimator)
      {
        if (estimator.Sum == EstimatorEntry::ALL_TEXELS)
        {
          CheckRelative("reflected flux", scene.GetReflectedFlux().x, vtkMath::Pi() * angle, 5e-3,
            "the rim in whole texels: 0.23 % for a disk in 64 squared, more over cube faces");
        }
      });
  }
  HardCase scene("a spot without a direction, of exponent 128");
  scene.AddCorner();
  scene.AddSpot({ 0.5, 0.5, 0.5 }, { 0.5, 0.5, 0.5 }, 45, 128, { 1, 0, 0 });
  scene.CheckEstimators(1);
}

// Light is linear, however weak or strong.
VTK_INDIRECT_TEST(LightStrength)
{
  HardCase scene("a point light");
  scene.AddCorner({ 0.75, 0.5, 0.25 });
  scene.AddSphere({ 0.6, 0.25, 0.5 }, 0.2, 48, { 0.25, 0.5, 0.75 });
  vtkLight* light = scene.AddPoint({ 0.5, 0.7, 0.6 }, { 0.2, 0, 1 });
  std::map<std::string, Image> unit;
  const char* const names[] = { "final", "direct", "indirect", "irradiance" };
  scene.CheckEstimators(1,
    [&](const EstimatorEntry& estimator)
    {
      for (const char* name : names)
      {
        unit[std::string(estimator.Name) + name] = scene.Copy(name);
      }
    });
  for (double intensity : { 1e-12, 1e12 })
  {
    light->SetIntensity(intensity);
    scene.CheckEstimators(1,
      [&](const EstimatorEntry& estimator)
      {
        for (const char* name : names)
        {
          Comparison how;
          how.Factor = intensity;
          CheckAtMost(
            std::string(name) + ": share of pixels that are not intensity times the light",
            GetShareOfDifferent(scene.Copy(name), unit[std::string(estimator.Name) + name],
              std::max(1e-5, estimator.Rounding), how),
            0.0, "every decision is on surfaces, none on strength");
        }
      });
  }
  light->SetIntensity(1.0);
  light->SetColor(0.0, 0.0, 1e-30);
  scene.CheckEstimators(1,
    [&](const EstimatorEntry&)
    {
      const Image irradiance = scene.Copy("irradiance");
      CheckEqual("red irradiance of a blue light", irradiance.Mean(0), 0.0);
      CheckAtLeast(
        "blue irradiance over the light", irradiance.Mean(2) / 1e-30, 1e-3, "nothing underflows");
    });
}

// From far away, a point light or a wide spot acts as a directional light.
VTK_INDIRECT_TEST(FarLight)
{
  const glm::dvec3 there = glm::normalize(glm::dvec3(0.7, 0.9, 0.5));
  const double intensity = 1.5;
  HardCase sun("a directional light");
  sun.AddCorner(Albedo);
  sun.AddSphere({ 0.6, 0.25, 0.5 }, 0.2, 48, Albedo);
  sun.AddDirectional(-there)->SetIntensity(intensity);
  sun.Pass->SetReflectiveShadowMapResolution(64);
  const Image expected = sun.CheckEstimators(1);
  const Image direct = sun.Copy("direct");
  CheckAtLeast("mean irradiance", expected.Mean(), 1e-3, "the test's own power");
  for (double distance : { 30.0, 100.0, 1e3, 1e4 })
  {
    for (double cone : { 180.0, 70.0, 20.0 })
    {
      char name[96];
      std::snprintf(name, sizeof(name), "a light of %g degrees, %g sizes away", cone, distance);
      HardCase scene(name);
      scene.AddCorner(Albedo);
      scene.AddSphere({ 0.6, 0.25, 0.5 }, 0.2, 48, Albedo);
      const glm::dvec3 place = glm::dvec3(0.5) + distance * there;
      // The falloff is one at the scene.
      vtkLight* light =
        scene.AddSpot(place, glm::dvec3(0.45), cone, 0, { 0, 0, 1.0 / (distance * distance) });
      light->SetIntensity(intensity);
      scene.Pass->SetReflectiveShadowMapResolution(64);
      const Image truth = scene.CheckEstimators(1);
      const double tolerance = 2.0 / distance + 0.01;
      const char* const origin = "size over distance, in falloff and direction; outlines";
      CheckRelative("mean irradiance", truth.Mean(), expected.Mean(), tolerance, origin);
      CheckRelative(
        "mean direct light", scene.Copy("direct").Mean(), direct.Mean(), tolerance, origin);
    }
  }
}
