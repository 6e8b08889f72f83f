// SPDX-License-Identifier: BSD-3-Clause
// Light through bodies of glass: Snell's and Fresnel's laws, flux and focus.
#include "vtkIndirectTestUtilities.h"

#include "Senders/vtkIndirectRefraction.h"
#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkRSMGatherPass.h"
#include "vtkRSMReferencePass.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace vtkIndirectTest;

namespace
{
void MakeGlass(vtkActor* actor, double index)
{
  actor->GetProperty()->SetInterpolationToPBR();
  actor->GetProperty()->SetBaseIOR(index);
  actor->GetProperty()->SetOpacity(0.1);
  actor->GetProperty()->SetRoughness(0.1);
}

// Light of a scene's glass on the ground: its total, and the share within a distance of a position.
struct Found
{
  double Flux = 0.0;
  double Within = 0.0;
};
Found Sum(Scene& scene, const glm::dvec3& place, double radius, double width)
{
  scene.Render();
  const Image e = scene.Copy("irradiance");
  const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
  const double pixel = width / e.Width * width / e.Width;
  Found found;
  for (const Scene::Receiver& receiver : receivers)
  {
    if (receiver.Lit)
    {
      const double value = e.Color(receiver.X, receiver.Y).x * pixel;
      found.Flux += value;
      found.Within += glm::distance(receiver.Position, place) < radius ? value : 0.0;
    }
  }
  return found;
}

// Black ground, so that only glass sends; the eye looks at it from below.
void AddGround(Scene& scene, double height)
{
  scene.AddQuad({ -1, height, -1 }, { -1, height, 1 }, { 1, height, -1 }, { 0, 0, 0 });
  scene.SetEye({ 0, height + 3, 0 }, { 0, height, 0 }, { 0, 0, -1 }, 30, 1, 6);
  scene.SetParallelEye(1.0);
  scene.Pass->SetReflectiveShadowMapResolution(32);
  scene.Gather->SetModeToVirtualLights();
  scene.Gather->InterpolationOff();
  scene.Sampler->SetNumberOfLights(1024);
}
}

VTK_INDIRECT_TEST(RefractionLaws)
{
  using Refraction = vtkIndirectRefraction;
  Random random(5);
  double snell = 0.0;
  double reversed = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    const glm::dvec3 n = random.NextDirection();
    glm::dvec3 d = random.NextDirection();
    d = glm::dot(d, n) > 0.0 ? -d : d;
    const double index = random.Next(1.01, 2.5);
    const glm::dvec3 t = Refraction::Refract(d, n, 1.0, index);
    snell = std::max(snell, glm::length(glm::cross(d, n) - index * glm::cross(t, n)));
    reversed = std::max(reversed, glm::distance(Refraction::Refract(-t, -n, index, 1.0), -d));
  }
  CheckAtMost("Snell's law", snell, 1e-12, "rounding");
  CheckAtMost("the way back", reversed, 1e-6, "rounding at grazing angles");
  CheckRelative(
    "Fresnel, straight, glass", Refraction::Reflectance(1.0, 1.0, 1.5), 0.04, 1e-12, "");
  CheckEqual("beyond the critical angle", Refraction::Reflectance(0.5, 1.5, 1.0), 1.0);
  const double brewster = std::cos(std::atan(1.5));
  const double s = (brewster - std::sqrt(2.25 - 1.0 + brewster * brewster)) /
    (brewster + std::sqrt(2.25 - 1.0 + brewster * brewster));
  CheckRelative("at Brewster's angle one polarisation", Refraction::Reflectance(brewster, 1.0, 1.5),
    0.5 * s * s, 1e-9, "closed form");
}

VTK_INDIRECT_TEST(RefractionOfPlate)
{
  Scene scene(64, 64);
  AddGround(scene, -0.3);
  MakeGlass(scene.AddBox({ -0.3, 0.0, -0.2 }, { 0.3, 0.1, 0.2 }, { 1, 1, 1 }), 1.5);
  scene.AddDirectional({ 0, -1, 0 });
  const Found found = Sum(scene, { 0, -0.3, 0 }, 0.4, 2.0);
  // Two faces, each of which transmits 0.96, and VTK's opacity twice.
  CheckRelative("light that comes through a plate", found.Flux, 0.24 * std::pow(0.96 * 0.9, 2.0),
    0.05, "squares at its edges, 45 of which span its bounds' sphere");
  scene.CheckBuffers(1);
  scene.Gather->SpecularTransportOff();
  CheckEqual("without specular transport none", Sum(scene, { 0, 0, 0 }, 1.0, 2.0).Flux, 0.0);
}

// A ball of index n focuses parallel light at n R / (2 (n - 1)) from its centre, paraxially.
VTK_INDIRECT_TEST(RefractionOfBall)
{
  const double radius = 0.25;
  double expected = 0.0;
  const int steps = 4000;
  for (int i = 0; i < steps; ++i)
  {
    const double h = (i + 0.5) / steps;
    const double cosine = std::sqrt(1.0 - h * h);
    // The angles at both faces are equal.
    const double through = 1.0 - vtkIndirectRefraction::Reflectance(cosine, 1.0, 1.5);
    expected += 2.0 * vtkMath::Pi() * h * radius * radius * through * through * 0.81 / steps;
  }
  double within[2];
  const double heights[2] = { -1.5 * radius, -3.0 * radius };
  for (int i = 0; i < 2; ++i)
  {
    Scene scene(96, 96);
    AddGround(scene, heights[i]);
    MakeGlass(scene.AddSphere({ 0, 0, 0 }, radius, 64, { 1, 1, 1 }), 1.5);
    scene.AddDirectional({ 0, -1, 0 });
    const Found found = Sum(scene, { 0, heights[i], 0 }, 0.4 * radius, 2.0);
    CheckRelative("light that comes through a ball", found.Flux, expected, i == 0 ? 0.03 : 0.06,
      "squares at its rim, facets, and lobes of rays by the rim that end beside the ground");
    within[i] = found.Within / found.Flux;
    // The double-precision reference has the same lights.
    if (i == 0)
    {
      const Image e = scene.Copy("irradiance");
      vtkNew<vtkRSMReferencePass> reference;
      reference->SetModeToVirtualLights();
      scene.Pass->SetEstimator(reference);
      scene.Render();
      CheckRelative("against the reference", scene.Copy("irradiance").Mean(), e.Mean(), 1e-3,
        "the lobe's integral");
      scene.Pass->SetEstimator(scene.Gather);
    }
  }
  CheckAtLeast("share within 0.4 radii of the axis in the focus", within[0], 0.75,
    "but for aberration of the rim");
  CheckAtMost("twice as far away", within[1], 0.4 * within[0], "it has spread");
}
