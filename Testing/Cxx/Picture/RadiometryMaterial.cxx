// SPDX-License-Identifier: BSD-3-Clause
// VTK's two kinds of shading: Phong has no 1 / pi and is linear, PBR has it and is gamma-encoded.
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkRSMGatherPass.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace vtkIndirectTest;

namespace
{
enum Material
{
  Phong,
  Rough,
  Metal
};

struct MaterialCorner : Scene
{
  explicit MaterialCorner(Material material)
    : Scene(48, 48)
  {
    vtkActor* actors[2] = { this->AddQuad(
                              { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.75, 0.5, 0.25 }),
      this->AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.75, 0.5, 0.25 }) };
    for (vtkActor* actor : actors)
    {
      if (material != Phong)
      {
        actor->GetProperty()->SetInterpolationToPBR();
        actor->GetProperty()->SetRoughness(1.0);
        actor->GetProperty()->SetMetallic(material == Metal ? 1.0 : 0.0);
        // Index 1: no reflection at the surface, except at grazing angles.
        actor->GetProperty()->SetBaseIOR(1.0);
      }
    }
    this->AddSpot({ 0.8, 0.5, 0.9 }, { 0.3, 0.5, 0 }, 40, 0, { 0, 0, 1 });
    this->SetEye({ 2.0, -1.0, 1.8 }, { 0.4, 0.5, 0.3 }, { 0, 0, 1 }, 34, 0.5, 6);
    this->Pass->SetReflectiveShadowMapResolution(64);
    this->Render();
  }
};

glm::dvec3 Decode(const glm::dvec3& c)
{
  return { std::pow(c.x, 2.2), std::pow(c.y, 2.2), std::pow(c.z, 2.2) };
}
}

VTK_INDIRECT_TEST(PhysicallyBased)
{
  MaterialCorner phong(Phong);
  MaterialCorner pbr(Rough);
  const Image densityPhong = phong.Copy("rsm0.density");
  const Image densityPBR = pbr.Copy("rsm0.density");
  const Image albedo = pbr.Copy("albedo");
  const Image albedoPhong = phong.Copy("albedo");
  // The albedo of VTK's PBR comes from the buffer.
  glm::dvec3 ratio(0.0);
  for (int y = 0; y < albedo.Height; ++y)
  {
    for (int x = 0; x < albedo.Width; ++x)
    {
      if (albedoPhong.At(x, y)[0] > 0.0f)
      {
        ratio = albedo.Color(x, y) / albedoPhong.Color(x, y);
      }
    }
  }
  std::printf("       albedo of PBR over Phong's: %.6g %.6g %.6g\n", ratio.x, ratio.y, ratio.z);
  double worst = 0.0;
  int texels = 0;
  for (int y = 0; y < densityPhong.Height; ++y)
  {
    for (int x = 0; x < densityPhong.Width; ++x)
    {
      const glm::dvec3 a = densityPhong.Color(x, y);
      const glm::dvec3 b = densityPBR.Color(x, y);
      if (a.x > 0.0)
      {
        ++texels;
        for (int c = 0; c < 3; ++c)
        {
          worst = std::max(worst, std::abs(b[c] / (a[c] * ratio[c] / vtkMath::Pi()) - 1.0));
        }
      }
    }
  }
  CheckAtLeast("texels", texels, 1000, "the test's own power");
  CheckAtMost("a sender's density is 1 / pi of Phong's: worst deviation", worst, 3e-3,
    "the eye's albedos, whose roots have ten bits, against the map's half floats");

  const Image irradiancePhong = phong.Copy("irradiance");
  const Image irradiance = pbr.Copy("irradiance");
  CheckRelative("irradiance over Phong's", irradiance.Mean() / irradiancePhong.Mean(),
    ratio.x / vtkMath::Pi(), 1e-3, "the senders' 1 / pi");

  const Image direct = pbr.Copy("direct");
  const Image final = pbr.Copy("final");
  double composed = 0.0;
  double undivided = 0.0;
  std::vector<double> diffuse;
  for (int y = 0; y < direct.Height; ++y)
  {
    for (int x = 0; x < direct.Width; ++x)
    {
      if (albedo.At(x, y)[0] <= 0.0f)
      {
        continue;
      }
      const glm::dvec3 added = Decode(final.Color(x, y)) - Decode(direct.Color(x, y));
      const glm::dvec3 expected = albedo.Color(x, y) * irradiance.Color(x, y);
      const glm::dvec3 whole = Decode(final.Color(x, y));
      composed = std::max(composed, std::abs(added.x - expected.x) / whole.x);
      undivided = std::max(undivided, std::abs(added.x - expected.x / vtkMath::Pi()) / whole.x);
    }
  }
  CheckAtMost("what a receiver adds after decoding, against albedo E: worst", composed, 2e-5,
    "two rounded powers");
  CheckAtLeast("with another 1 / pi it would be off by", undivided, 1e-3, "the test's own power");
  pbr.CheckBuffers(1);
}

// Checks a PBR sender against VTK's own shading: it reflects what its lit pixels show.
VTK_INDIRECT_TEST(SenderShowsWhatItSends)
{
  for (Material material : { Phong, Rough })
  {
    Scene scene(8, 8);
    vtkActor* actor = scene.AddQuad({ -1, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 }, { 0.75, 0.5, 0.25 });
    if (material == Rough)
    {
      actor->GetProperty()->SetInterpolationToPBR();
      actor->GetProperty()->SetRoughness(1.0);
      actor->GetProperty()->SetMetallic(0.0);
      actor->GetProperty()->SetBaseIOR(1.0);
    }
    scene.AddDirectional({ 0, 0, -1 })->SetIntensity(0.8);
    scene.SetEye({ 0, 0, 6 }, { 0, 0, 0 }, { 0, 1, 0 }, 12, 1, 10);
    scene.Pass->SetReflectiveShadowMapResolution(202);
    scene.Render();
    const glm::dvec3 pixel = scene.Copy("direct").Color(4, 4);
    const glm::dvec3 radiance = material == Phong ? pixel : Decode(pixel);
    const glm::dvec3 sent = scene.GetReflectedFlux() / 4.0;
    for (int c = 0; c < 3; ++c)
    {
      CheckRelative(std::string(material == Phong ? "Phong" : "PBR") +
          ", B over the pixel's radiance, channel " + std::to_string(c),
        sent[c] / radiance[c], 1.0, material == Phong ? 1e-3 : 0.01,
        "half floats; what the Fresnel term leaves of an index of one");
    }
  }
}

VTK_INDIRECT_TEST(Metal)
{
  MaterialCorner scene(Metal);
  double density = 0.0;
  for (float v : scene.Copy("rsm0.density").Values)
  {
    density = std::max<double>(density, v);
  }
  CheckEqual("largest density that metal sends", density, 0.0);
  double indirect = 0.0;
  for (float v : scene.Copy("indirect").Values)
  {
    indirect = std::max<double>(indirect, v);
  }
  CheckEqual("largest indirect light on metal", indirect, 0.0);
  CheckAtLeast("depth of the map: something is there", scene.Copy("rsm0.depth").Mean(), 0.1,
    "the test's own power");
  scene.CheckBuffers(1);
}
