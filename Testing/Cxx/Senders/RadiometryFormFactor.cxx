// SPDX-License-Identifier: BSD-3-Clause
// Plates with known form factors: one is lit, and the other's irradiance is compared with B F.
#include "vtkIndirectTestUtilities.h"

#include "vtkLightTreeSampler.h"
#include "vtkMath.h"
#include "vtkRSMGatherPass.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
const glm::dvec3 Albedo(0.75, 0.5, 0.25);
using Polygon = std::vector<glm::dvec3>;

// Reflected flux of the sender plate z = 0, facing up: the sum of B A of its lights.
double SenderFlux(Scene& scene)
{
  double flux = 0.0;
  for (const VirtualLight& light : scene.CopyLights())
  {
    if (light.Normal.z > 0.5 && std::abs(light.Position.z) < 1e-3)
    {
      flux += light.DensityArea.x;
    }
  }
  return flux;
}
}

VTK_INDIRECT_TEST(FacingSquares)
{
  const Polygon sender = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  Scene scene(48, 48);
  scene.AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, Albedo);
  // Its front faces down; the light passes below its edge, and the lit back sends nothing downward.
  scene.AddQuad({ 0, 0, 1 }, { 0, 1, 1 }, { 1, 0, 1 }, Albedo);
  const glm::dvec3 toLight = glm::normalize(glm::dvec3(1.5, 0.0, 1.0));
  scene.AddDirectional(-toLight);
  scene.Pass->SetReflectiveShadowMapResolution(200);
  // Just above the sender, so that the receiver fills the view exactly.
  scene.SetEye({ 0.5, 0.5, 0.05 }, { 0.5, 0.5, 1 }, { 0, 1, 0 },
    2.0 * vtkMath::DegreesFromRadians(std::atan(0.5 / 0.95)), 0.01, 2.0);
  scene.Render();
  const Image irradiance = scene.Copy("irradiance");
  const double b = Albedo.x * toLight.z;
  const double flux = SenderFlux(scene);
  CheckRelative(
    "reflected flux of the sender", flux, b, 0.02, "texels on the edges: two in 90 across");
  double worst = 0.0;
  for (int y = 0; y < 48; ++y)
  {
    for (int x = 0; x < 48; ++x)
    {
      // Looking up with +y up, +x of the image is -x of the world.
      const glm::dvec3 p(1.0 - (x + 0.5) / 48.0, (y + 0.5) / 48.0, 1.0);
      const double f = PolygonFormFactor(p, { 0, 0, -1 }, sender);
      worst = std::max(worst, std::abs(irradiance.At(x, y)[0] / (flux * f) - 1.0));
    }
  }
  CheckAtMost(
    "worst pixel over the polygon's form factor", worst, 0.01, "one per cent at N > 64^2");
  // The midpoint rule over the receiver's 48^2 pixels is good to 1e-4.
  const double f = FacingSquaresFormFactor(1.0);
  CheckAbsolute("closed form of facing unit squares", f, 0.1998, 5e-5, "tables");
  CheckRelative("mean over the receiver / B", irradiance.Mean() / flux, f, 3e-3,
    "edge of the sender is a texel uncertain");
  CheckRelative("green against red", irradiance.Mean(1) / irradiance.Mean(0), Albedo.y / Albedo.x,
    1e-3, "albedo of two channels, half floats");
  const Image direct = scene.Copy("direct");
  CheckEqual("direct light on the receiver's lower side", direct.Mean(), 0.0);
  scene.CheckBuffers(1);
}

VTK_INDIRECT_TEST(FacingDisks)
{
  const double radius1 = 0.5;
  const double radius2 = 0.3;
  Scene scene(64, 64);
  scene.AddDisk({ 0, 0, 0 }, { 0, 0, 1 }, radius1, 256, Albedo);
  scene.AddDisk({ 0, 0, 1 }, { 0, 0, -1 }, radius2, 256, Albedo);
  const glm::dvec3 toLight = glm::normalize(glm::dvec3(1.0, 0.0, 1.0));
  scene.AddDirectional(-toLight);
  scene.Pass->SetReflectiveShadowMapResolution(200);
  scene.SetEye({ 0, 0, 0.05 }, { 0, 0, 1 }, { 0, 1, 0 },
    2.0 * vtkMath::DegreesFromRadians(std::atan(radius2 / 0.95)), 0.01, 2.0);
  scene.Render();
  const Image irradiance = scene.Copy("irradiance");
  const Image albedo = scene.Copy("albedo");
  double sum = 0.0;
  int pixels = 0;
  for (int y = 0; y < 64; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      if (albedo.At(x, y)[0] > 0.0f)
      {
        sum += irradiance.At(x, y)[0];
        ++pixels;
      }
    }
  }
  CheckRelative(
    "pixels of the receiver over its disk's", pixels, 0.25 * vtkMath::Pi() * 64 * 64, 0.01, "rim");
  const double area1 = vtkMath::Pi() * radius1 * radius1;
  const double flux = SenderFlux(scene);
  CheckRelative("reflected flux of the sender", flux, Albedo.x * toLight.z * area1, 0.01,
    "rim of 140 texels across");
  // By reciprocity, mean E over disk 2 is B times the form factor from disk 2 to disk 1.
  CheckRelative("mean over the receiver / B", sum / pixels / (flux / area1),
    FacingDisksFormFactor(radius2, radius1), 5e-3, "rims of both disks");
}

namespace
{
// A lit floor of exactly n x n texels, and a wall on its edge.
struct Corner : Scene
{
  Corner(int n, int pixels)
    : Scene(pixels, pixels)
  {
    // The wall is parallel to the light: only the floor is lit.
    this->AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, Albedo);
    this->AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, Albedo);
    this->AddDirectional({ 0, 0, -1 });
    // A black plate below widens the map to 5/4 n texels, with the floor's edges between texels.
    const double border = 0.5 * (1.25 / 1.01 - 1.0);
    const double lower = -border;
    const double upper = 1.0 + border;
    this->AddQuad(
      { lower, lower, -0.1 }, { upper, lower, -0.1 }, { lower, upper, -0.1 }, glm::dvec3(0.0));
    this->Pass->SetReflectiveShadowMapResolution(5 * n / 4);
    this->SetEye({ 0.95, 0.5, 0.5 }, { 0, 0.5, 0.5 }, { 0, 0, 1 },
      2.0 * vtkMath::DegreesFromRadians(std::atan(0.5 / 0.95)), 0.01, 2.0);
    this->Render();
  }
};
}

VTK_INDIRECT_TEST(PerpendicularSquares)
{
  const double f = PerpendicularSquaresFormFactor();
  CheckAbsolute("closed form of squares at a right angle", f, 0.20004, 5e-5, "tables");
  Corner scene(256, 64);
  CheckRelative(
    "reflected flux of the floor", SenderFlux(scene), Albedo.x, 1e-4, "edges between texels");
  const Image irradiance = scene.Copy("irradiance");
  CheckRelative("mean over the wall / B, 256^2 texels", irradiance.Mean() / Albedo.x, f, 0.004,
    "kernel's bias of -0.6 / 256; pixels next to the edge");
  const Polygon floor = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  double worst = 0.0;
  for (int y = 2; y < 64; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      const glm::dvec3 p(0.0, (x + 0.5) / 64.0, (y + 0.5) / 64.0);
      const double expected = Albedo.x * PolygonFormFactor(p, { 1, 0, 0 }, floor);
      worst = std::max(worst, std::abs(irradiance.At(x, y)[0] / expected - 1.0));
    }
  }
  CheckAtMost("worst pixel, two rows from the edge on", worst, 0.01, "one per cent");
  scene.CheckBuffers(1);
}

VTK_INDIRECT_TEST(PerpendicularSquaresBias)
{
  const double f = PerpendicularSquaresFormFactor();
  for (int n : { 16, 64 })
  {
    // Pixels a quarter of a texel high: pixels of a whole texel would hide the dark line on the
    // edge.
    Corner scene(n, 4 * n);
    CheckRelative(
      "reflected flux of the floor", SenderFlux(scene), Albedo.x, 1e-4, "edges between texels");
    const double bias = scene.Copy("irradiance").Mean() / Albedo.x / f - 1.0;
    // A third of the bias: the rule is rough, and zero bias would be off three times as much.
    CheckAbsolute("bias with N = " + std::to_string(n * n), bias, -0.6 / n, 0.2 / n,
      "known of the disk kernel: about -0.6 / sqrt(N)");
  }
}

// Nearest to the edge evenly spread lights are far apart; the tree's branches are not.
VTK_INDIRECT_TEST(PerpendicularSquaresLightTree)
{
  const Polygon floor = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  Corner scene(256, 64);
  vtkNew<vtkLightTreeSampler> tree;
  scene.Gather->SetModeToVirtualLights();
  auto measure = [&](vtkVirtualLightSampler* sampler)
  {
    scene.Pass->SetSampler(sampler);
    scene.Render();
    return scene.Copy("irradiance");
  };
  // Root mean square over a row of pixels, relative.
  auto findError = [&](const Image& image, int y)
  {
    double squares = 0.0;
    for (int x = 0; x < 64; ++x)
    {
      const glm::dvec3 p(0.0, (x + 0.5) / 64.0, (y + 0.5) / 64.0);
      const double expected = Albedo.x * PolygonFormFactor(p, { 1, 0, 0 }, floor);
      squares += std::pow(image.At(x, y)[0] / expected - 1.0, 2.0);
    }
    return std::sqrt(squares / 64.0);
  };
  const Image even = measure(scene.Sampler);
  const Image cut = measure(tree);
  for (const int y : { 1, 2, 4, 8 })
  {
    const std::string what = std::to_string(y) + " pixels from the edge: ";
    CheckAtMost(what + "error", findError(cut, y), 0.1, "contacts within 10 %");
    CheckAtLeast(what + "that of even lights", findError(even, y), y < 4 ? 0.15 : 0.02,
      "the test's own power");
  }
  const double f = PerpendicularSquaresFormFactor();
  CheckRelative("mean over the wall / B", cut.Mean() / Albedo.x, f, 5e-3,
    "a quarter of the tolerance where none is set");
  scene.Pass->SetErrorTolerance(0.0025);
  CheckRelative("tolerance 0.0025: mean over the wall / B", measure(tree).Mean() / Albedo.x, f,
    3e-3, "the tolerance, and clusters twice as long as wide that count as squares");
  scene.CheckBuffers(1);
  scene.Pass->SetSampler(nullptr);
}
