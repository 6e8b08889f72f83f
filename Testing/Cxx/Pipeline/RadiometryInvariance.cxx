// SPDX-License-Identifier: BSD-3-Clause
// Equivalent models of a scene have the same light.
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkCamera.h"
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

// Two walls that face the eye in full view, and a small plate before them.
struct HeadlitCorner : Scene
{
  HeadlitCorner(int width, int height, bool parallel, bool headlight)
    : Scene(width, height)
  {
    this->AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, Albedo);
    this->AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, Albedo);
    this->AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, Albedo);
    const glm::dvec3 eye(3.2, 2.6, 3.5);
    const glm::dvec3 target(0.4, 0.4, 0.4);
    // The narrower side of the window takes the whole corner in.
    const double fit = std::max(1.0, double(height) / width);
    const double angle = 2.0 * std::atan(fit * std::tan(vtkMath::RadiansFromDegrees(12.0)));
    this->SetEye(eye, target, { 0, 1, 0 }, vtkMath::DegreesFromRadians(angle), 1, 10);
    if (parallel)
    {
      this->SetParallelEye(0.95 * fit);
    }
    if (headlight)
    {
      vtkNew<vtkLight> light;
      light->SetLightTypeToHeadlight();
      light->SetIntensity(1.3);
      this->Renderer->AddLight(light);
    }
    else
    {
      this->AddDirectional(target - eye)->SetIntensity(1.3);
    }
    // About as many texels on the walls as the eye has pixels there.
    this->Pass->SetReflectiveShadowMapResolution(80);
    this->Render();
  }
};
}

VTK_INDIRECT_TEST(Headlight)
{
  const int sizes[][2] = { { 160, 96 }, { 80, 120 } };
  for (const auto& size : sizes)
  {
    for (bool parallel : { false, true })
    {
      HeadlitCorner eyeMap(size[0], size[1], parallel, true);
      HeadlitCorner ownMap(size[0], size[1], parallel, false);
      const Image a = eyeMap.Copy("irradiance");
      const Image b = ownMap.Copy("irradiance");
      const std::string what = std::to_string(size[0]) + " x " + std::to_string(size[1]) +
        (parallel ? ", parallel" : ", perspective");
      // Pixels of the eye are larger than the map's texels: they lose a little more where walls
      // meet, and the outline in whole pixels is off by up to one in 60.
      CheckRelative(what + ": reflected flux", eyeMap.GetReflectedFlux().x,
        ownMap.GetReflectedFlux().x, 0.02, "outlines in whole pixels");
      CheckRelative(what + ": mean irradiance", a.Mean(), b.Mean(), 0.02, "outlines and contact");
      std::vector<double> errors;
      for (size_t i = 0; i < a.Values.size(); ++i)
      {
        if (b.Values[i] > 0.0f)
        {
          errors.push_back(std::abs(a.Values[i] / double(b.Values[i]) - 1.0));
        }
      }
      CheckAtMost(what + ": 90th percentile of the difference", Percentile(errors, 0.9), 0.03,
        "outlines and contact");
      Check(what + ": pixels of equal area instead of equal angle would be rejected",
        parallel ||
          !WouldPass(1.03 * ownMap.GetReflectedFlux().x, ownMap.GetReflectedFlux().x, 0.02));
      eyeMap.CheckBuffers(0);
    }
  }
}

// The view's own footprint on a larger plane has no outline, hence an exact flux.
VTK_INDIRECT_TEST(HeadlightFlux)
{
  for (bool parallel : { false, true })
  {
    for (double tilt : { 0.0, 35.0 })
    {
      Scene scene(90, 60);
      scene.AddQuad({ -50, -50, 0 }, { 50, -50, 0 }, { -50, 50, 0 }, Albedo);
      // A receiver outside of the view: without one a frame sums nothing.
      const double a = vtkMath::RadiansFromDegrees(tilt);
      const glm::dvec3 back(std::sin(a), 0.0, std::cos(a));
      scene.SetEye(4.0 * back, { 0, 0, 0 }, { 0, 1, 0 }, 30, 1, 60);
      if (parallel)
      {
        scene.SetParallelEye(1.2);
      }
      vtkNew<vtkLight> light;
      light->SetLightTypeToHeadlight();
      scene.Renderer->AddLight(light);
      scene.Render();
      // Corners of the view on the plane z = 0.
      const double t = std::tan(vtkMath::RadiansFromDegrees(15.0));
      const glm::dvec3 right(std::cos(a), 0.0, -std::sin(a));
      const glm::dvec3 up(0.0, 1.0, 0.0);
      glm::dvec3 corner[4];
      const double signs[4][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
      for (int i = 0; i < 4; ++i)
      {
        const glm::dvec3 aside = 1.5 * signs[i][0] * right + signs[i][1] * up;
        const glm::dvec3 from = 4.0 * back + (parallel ? 1.2 * aside : glm::dvec3(0.0));
        const glm::dvec3 ray = -back + (parallel ? glm::dvec3(0.0) : t * aside);
        corner[i] = from - ray * (from.z / ray.z);
      }
      const double area =
        0.5 * std::abs(glm::cross(corner[2] - corner[0], corner[3] - corner[1]).z);
      CheckRelative(
        std::string(parallel ? "parallel" : "perspective") + ", tilt " + std::to_string(tilt),
        scene.GetReflectedFlux().x, Albedo.x * area * std::cos(a), 2e-3,
        "midpoint rule over pixels");
    }
  }
}
