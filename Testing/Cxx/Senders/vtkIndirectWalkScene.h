// SPDX-License-Identifier: BSD-3-Clause
// A scene whose virtual lights come from a random walk, or from maps.
#ifndef vtkIndirectWalkScene_h
#define vtkIndirectWalkScene_h

#include "vtkIndirectTestUtilities.h"

#include "vtkRSMGatherPass.h"
#include "vtkRandomWalkLightSampler.h"
#include "vtkUniformLightSampler.h"

#include <glm/glm.hpp>
#include <string>

namespace vtkIndirectTest
{
struct WalkScene : Scene
{
  vtkNew<vtkRandomWalkLightSampler> Walk;

  WalkScene(int width = 40, int height = 30)
    : Scene(width, height)
  {
    this->Gather->InterpolationOff();
    this->Pass->SetReflectiveShadowMapResolution(128);
  }
  ~WalkScene() { this->Pass->SetSampler(nullptr); }

  void UseWalk(int lights, int bounces = 1)
  {
    this->Gather->SetModeToVirtualLights();
    this->Walk->SetNumberOfLights(lights);
    this->Pass->SetSampler(this->Walk);
    this->Pass->SetNumberOfBounces(bounces);
    this->Render();
  }
  void UseMaps()
  {
    this->Gather->SetModeToAllTexels();
    this->Pass->SetSampler(this->Sampler);
    this->Pass->SetNumberOfBounces(1);
    this->Render();
  }

  void AddCorner(double scale = 1.0, const glm::dvec3& place = glm::dvec3(0.0))
  {
    auto at = [&](double x, double y, double z) { return place + scale * glm::dvec3(x, y, z); };
    this->AddQuad(at(0, 0, 0), at(0, 0, 1), at(1, 0, 0), { 0.8, 0.8, 0.8 });
    this->AddQuad(at(0, 0, 0), at(0, 1, 0), at(0, 0, 1), { 0.3, 0.6, 0.9 });
    this->AddBox(at(0.6, 0.0, 0.2), at(0.9, 0.5, 0.5), { 0.9, 0.9, 0.3 });
    this->SetEye(at(2.2, 1.6, 2.3), at(0.4, 0.3, 0.4), { 0, 1, 0 }, 36, 0.5 * scale, 6 * scale);
  }

  // Compares flux and irradiance of the first bounce, by rays and by maps.
  void CompareWithMaps(const std::string& what, int maps, double tolerance = 0.02)
  {
    this->UseMaps();
    const glm::dvec3 flux = this->GetReflectedFlux();
    const double mean = this->Copy("bounce").Mean();
    this->UseWalk(4096);
    const glm::dvec3 walked = this->GetReflectedFlux();
    this->CheckBuffers(maps);
    for (int c = 0; c < 3; ++c)
    {
      CheckRelative(what + ": flux", walked[c], flux[c], tolerance,
        "128 texels along an edge of a map have so much at its lit parts' borders");
    }
    CheckRelative(what + ": mean irradiance", this->Copy("bounce").Mean(), mean, 0.02,
      "of 4096 lights kernels have 1 % in contacts");
  }
};
}

#endif
