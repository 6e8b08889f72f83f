// SPDX-License-Identifier: BSD-3-Clause
// The gather's disk in the cube map of a point light: it crosses faces without a seam.
#include "vtkIndirectTestUtilities.h"

#include "vtkLight.h"
#include "vtkRSMGatherPass.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
const glm::dvec3 Lamp(0.45, 0.6, 0.55);

// A closed room with the light in its middle; the eye looks at a wall, part of another and the
// floor, which several faces of the light's cube see.
struct LitRoom : Scene
{
  vtkLight* Light;

  LitRoom()
    : Scene(32, 24)
  {
    this->AddBox({ 0, 0, 0 }, { 1, 1, 1 }, { 0.75, 0.5, 0.25 });
    this->Light = this->AddPoint(Lamp, { 0.2, 0.0, 1.0 });
    this->SetEye({ 0.9, 0.8, 0.9 }, { 0.1, 0.2, 0.1 }, { 0, 1, 0 }, 80.0, 0.02, 5.0);
    this->Pass->SetReflectiveShadowMapResolution(64);
  }
};

// Sum over all texels of the map whose directions from the light lie in the disk, in double
// precision.
double SumInDisk(const std::vector<VirtualLight>& lights, const Scene::Receiver& receiver,
  double radius, double& all)
{
  const glm::dvec3 axis = glm::normalize(receiver.Position - Lamp);
  double sum = 0.0;
  all = 0.0;
  for (const VirtualLight& light : lights)
  {
    const glm::dvec3 direction = light.Position - Lamp;
    const double along = glm::dot(direction, axis);
    const double e = Gather({ light }, receiver.Position, receiver.Normal).x;
    all += e;
    // On the plane that touches the sphere of directions; a face is two wide.
    if (along > 0.0 && glm::length(direction / along - axis) < 2.0 * radius)
    {
      sum += e;
    }
  }
  return sum;
}
}

VTK_INDIRECT_TEST(NeighborhoodFaces)
{
  for (const double coneAngle : { 180.0, 80.0 })
  {
    LitRoom scene;
    scene.Light->SetConeAngle(coneAngle);
    scene.Render();
    const std::vector<VirtualLight> lights = scene.CopyLights();
    const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
    for (const double radius : { 0.15, 0.3, 1.5 })
    {
      const std::string what = "cone " + std::to_string(static_cast<int>(coneAngle)) + ", radius " +
        std::to_string(radius).substr(0, 4) + ": ";
      scene.Gather->SetModeToNeighborhood();
      scene.Gather->SetNeighborhoodRadius(radius);
      scene.Gather->SetNumberOfSamples(8192);
      scene.Render();
      const Image image = scene.Copy("irradiance");
      const bool reported =
        scene.Pass->GetReport().find("senders outside the disk") != std::string::npos;
      double sum = 0.0;
      double expected = 0.0;
      double whole = 0.0;
      double squares = 0.0;
      double beyond = 0.0; // by receivers near an edge of the cube, over the expected sum
      for (size_t i = 0; i < receivers.size(); ++i)
      {
        double all = 0.0;
        const double e = receivers[i].Lit ? SumInDisk(lights, receivers[i], radius, all) : 0.0;
        const double value = image.Values[3 * i];
        sum += value;
        expected += e;
        whole += all;
        squares += (value - e) * (value - e);
        glm::dvec3 d = glm::abs(receivers[i].Position - Lamp);
        d /= std::max({ d.x, d.y, d.z });
        beyond += d.x + d.y + d.z - std::max({ d.x, d.y, d.z }) > 1.0 ? e : 0.0;
      }
      const double count = static_cast<double>(receivers.size());
      CheckAtLeast(what + "share near edges", beyond / expected, 0.2, "the test's own power");
      CheckRelative(what + "sum over that in the disk", sum, expected, 0.005,
        "texels on the rim, 20 to 200 of a disk's 300 to 10000, count whole or not at all");
      CheckAtMost(what + "RMSE over the mean", std::sqrt(squares / count) / (expected / count),
        0.05, "as above, and sampling");
      CheckAtMost(what + "sum over all texels", sum / whole, 1.001, "a part of them");
      Check(what + "what it leaves is reported", reported);
    }
  }
  // One face, wholly covered: its neighbours add nothing.
  LitRoom scene;
  scene.Light->SetConeAngle(40.0);
  scene.Light->SetFocalPoint(0.1, 0.1, 0.1);
  scene.Gather->SetModeToNeighborhood();
  scene.Gather->SetNeighborhoodRadius(1.5);
  scene.Render();
  Check("a disk over all of a map leaves nothing",
    scene.Pass->GetReport().find("senders outside the disk") == std::string::npos);
  scene.Gather->SetNeighborhoodRadius(0.5);
  scene.Render();
  Check("a smaller one does",
    scene.Pass->GetReport().find("senders outside the disk") != std::string::npos);
}
