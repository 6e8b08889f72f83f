// SPDX-License-Identifier: BSD-3-Clause
// Light of the sky near a contact: a sphere on a plane, against the view factor of the sphere.
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkEnvironmentLight.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <cmath>
#include <cstdio>
#include <string>

using namespace vtkIndirectTest;

namespace
{
// Position of the eye, three radii from the contact, and its target. From an elevation phi the eye
// sees the plane in front of the contact from the distance tan(phi / 2) radii on.
struct View
{
  double Height;
  double Target; // distance from the contact
  double Angle;  // degrees
};
constexpr View Views[] = { { 0.05, 0.1185, 0.08 }, { 0.9, 1.435, 26.0 } };
constexpr double EyeDistance = 3.0;
constexpr int NumberOfAzimuths = 8;

// Receivers between two distances from the contact.
struct Ring
{
  double From;
  double To;
  double Squares = 0.0;
  double Sum = 0.0;
  double Expected = 0.0;
  int Count = 0;
};

// A sphere of radius 1 that touches the plane fills (1 + a^2)^(-3/2) of the view of an element of
// the plane, at a distance a: its angular radius has the sine 1 / d, its centre the cosine 1 / d,
// with d^2 = 1 + a^2, and none of it is below the horizon.
double FindIrradiance(double a)
{
  return 1.0 - std::pow(1.0 + a * a, -1.5);
}

void CheckContact(double halfEdge)
{
  Scene scene(16, 128);
  scene.Pass->SetVisibilityToAuto();
  scene.AddQuad({ -halfEdge, 0, halfEdge }, { halfEdge, 0, halfEdge }, { -halfEdge, 0, -halfEdge },
    glm::dvec3(0.8));
  scene.AddSphere({ 0, 1, 0 }, 1.0, 192, glm::dvec3(0.8));
  vtkNew<vtkEnvironmentLight> sky;
  scene.Pass->SetEnvironment(sky);
  Ring rings[] = { { 0.01, 0.02 }, { 0.02, 0.05 }, { 0.05, 0.1 }, { 0.1, 0.2 }, { 0.2, 0.5 },
    { 0.5, 1.0 }, { 1.0, 2.0 } };
  for (const View& view : Views)
  {
    for (int i = 0; i < NumberOfAzimuths; ++i)
    {
      const double azimuth = 2.0 * vtkMath::Pi() * (i + 0.5) / NumberOfAzimuths;
      const glm::dvec3 towards(std::cos(azimuth), 0.0, std::sin(azimuth));
      scene.SetEye(EyeDistance * towards + glm::dvec3(0, view.Height, 0), view.Target * towards,
        { 0, 1, 0 }, view.Angle, 0.5, 10.0);
      scene.Render();
      const Image light = scene.Copy("sky");
      const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
      for (size_t j = 0; j < receivers.size(); ++j)
      {
        const Scene::Receiver& r = receivers[j];
        if (!r.Lit || r.Normal.y < 0.999 || std::abs(r.Position.y) > 1e-4)
        {
          continue; // the sphere, or the background
        }
        const double a = glm::length(glm::dvec2(r.Position.x, r.Position.z));
        const double expected = FindIrradiance(a);
        const double error = light.Values[3 * j] - expected;
        for (Ring& ring : rings)
        {
          if (a >= ring.From && a < ring.To)
          {
            ring.Squares += error * error;
            ring.Sum += error;
            ring.Expected += expected;
            ++ring.Count;
          }
        }
      }
    }
  }
  for (const Ring& ring : rings)
  {
    char name[256];
    std::snprintf(name, sizeof(name),
      "ground of %g radii, %g to %g from the contact, E of %.4f L off by %+.4f L: RMS error over L",
      2.0 * halfEdge, ring.From, ring.To, ring.Expected / ring.Count, ring.Sum / ring.Count);
    const double rms = std::sqrt(ring.Squares / ring.Count);
    Check("receivers are seen", ring.Count > 100, "a test of nothing passes");
    if (ring.To <= 0.1)
    {
      CheckAtMost(name, rms, 4.0 / 256.0, "one of 256 directions where it faces the plane");
    }
    else
    {
      CheckAtMost(name, rms, 0.02, "256 directions, each hard");
    }
  }
}
}

// A tile has 128 texels over all casters of shadows on other things, 37 of them along the sphere's
// radius, independent of the size of the ground.
VTK_INDIRECT_TEST(SkyContactOfASphere)
{
  for (const double halfEdge : { 3.0, 6.0, 30.0, 300.0 })
  {
    CheckContact(halfEdge);
  }
}
