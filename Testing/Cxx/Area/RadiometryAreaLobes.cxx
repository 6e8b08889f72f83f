// SPDX-License-Identifier: BSD-3-Clause
// Specular reflection of area lights by receivers, against sums over many pieces of the light in
// double precision, of the lobes as VTK's lights evaluate them.
#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkImageData.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkRSMGatherPass.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
constexpr int MirrorTexels = 32;
using LobeFunction = std::function<double(const glm::dvec3& toLight, const glm::dvec3& toEye)>;
using TexelPicture = std::function<double(int, int)>;
using Sight = std::function<bool(const glm::dvec3& from, const glm::dvec3& to)>;

bool IsOpen(const glm::dvec3&, const glm::dvec3&)
{
  return true;
}
double IsEven(int, int)
{
  return 1.0;
}

// A lamp that stands on a floor, and an eye that sees its mirror image.
struct MirrorScene : Scene
{
  const glm::dvec3 Corner{ -0.6, 1.2, 0.2 };
  const glm::dvec3 Edge1{ 1.2, 0.0, 0.0 };
  const glm::dvec3 Edge2{ 0.0, 0.0, 0.8 };
  const glm::dvec3 Eye;
  vtkActor* Floor;
  vtkNew<vtkAreaLight> Lamp;
  vtkNew<vtkImageData> Data;

  MirrorScene(int size, double eyeHeight)
    : Scene(size, size)
    , Eye(0.0, -2.0, eyeHeight)
  {
    this->Gather->SetModeToVirtualLights();
    this->Floor = this->AddQuad({ -2, -1.5, 0 }, { 2, -1.5, 0 }, { -2, 2.5, 0 }, { 0.9, 0.6, 0.3 });
    this->SetEye(this->Eye, { 0, 0.2, 0 }, { 0, 0, 1 }, 40.0, 0.1, 20.0);
    this->Lamp->SetOrigin(this->Corner.x, this->Corner.y, this->Corner.z);
    this->Lamp->SetPoint1(0.6, 1.2, 0.2);
    this->Lamp->SetPoint2(-0.6, 1.2, 1.0);
    this->Pass->AddAreaLight(this->Lamp);
    this->SetMoving(false);
  }

  void SetMoving(bool moving) { this->Window->SetDesiredUpdateRate(moving ? 15.0 : 1e-4); }

  void SetPower(double specular, double power)
  {
    this->Floor->GetProperty()->SetInterpolationToFlat();
    this->Floor->GetProperty()->SetSpecularColor(1.0, 1.0, 1.0);
    this->Floor->GetProperty()->SetSpecular(specular);
    this->Floor->GetProperty()->SetSpecularPower(power);
  }

  void Show(const TexelPicture& picture)
  {
    this->Data->SetDimensions(MirrorTexels, MirrorTexels, 1);
    this->Data->AllocateScalars(VTK_FLOAT, 1);
    auto* values = static_cast<float*>(this->Data->GetScalarPointer());
    for (int i = 0; i < MirrorTexels * MirrorTexels; ++i)
    {
      values[i] = static_cast<float>(picture(i % MirrorTexels, i / MirrorTexels));
    }
    this->Data->Modified();
    this->Lamp->SetImage(this->Data);
  }

  // The integral of radiance times lobe over the directions of the lamp.
  double Sum(const Receiver& receiver, const LobeFunction& lobe, int edge,
    const TexelPicture& picture = IsEven, const Sight& sees = IsOpen) const
  {
    const glm::dvec3 span = glm::cross(this->Edge1, this->Edge2);
    const glm::dvec3 toEye = glm::normalize(this->Eye - receiver.Position);
    double sum = 0.0;
    for (int j = 0; j < edge; ++j)
    {
      for (int i = 0; i < edge; ++i)
      {
        const glm::dvec3 place =
          this->Corner + (i + 0.5) / edge * this->Edge1 + (j + 0.5) / edge * this->Edge2;
        const glm::dvec3 d = place - receiver.Position;
        const double r = glm::length(d);
        const double front = -glm::dot(d, span);
        if (front > 0.0 && sees(receiver.Position, place))
        {
          sum += picture(i * MirrorTexels / edge, j * MirrorTexels / edge) * lobe(d / r, toEye) *
            front / (r * r * r);
        }
      }
    }
    return sum / edge / edge;
  }
};

// Receivers are floors with the normal (0, 0, 1). VTK's own lobe, in its units.
LobeFunction MakePower(double specular, double power)
{
  return [=](const glm::dvec3& toLight, const glm::dvec3& toEye)
  {
    const glm::dvec3 mirror(-toEye.x, -toEye.y, toEye.z);
    const double mirrored = toLight.z > 0.0 ? glm::dot(mirror, toLight) : 0.0;
    return mirrored > 0.0 ? specular * std::pow(mirrored, power) / vtkMath::Pi() : 0.0;
  };
}

// D V F cosL of VTK's PBR.
LobeFunction MakePhysical(double straight, double roughness)
{
  return [=](const glm::dvec3& light, const glm::dvec3& view)
  {
    if (light.z <= 0.0)
    {
      return 0.0;
    }
    const glm::dvec3 middle = glm::normalize(light + view);
    const double alpha2 = std::pow(roughness, 4.0);
    const double d = (middle.z * alpha2 - middle.z) * middle.z + 1.0;
    const double a2 = roughness * roughness;
    const double shared = 0.5 /
      (light.z * std::sqrt(a2 + view.z * view.z * (1.0 - a2)) +
        view.z * std::sqrt(a2 + light.z * light.z * (1.0 - a2)));
    const double fresnel =
      straight + (1.0 - straight) * std::pow(1.0 - glm::dot(middle, light), 5.0);
    return alpha2 / (vtkMath::Pi() * d * d) * shared * fresnel * light.z;
  };
}

bool OnFloor(const Scene::Receiver& receiver)
{
  return receiver.Normal.z > 0.9;
}
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(AreaLobeOfPhong)
{
  for (const double height : { 0.4, 1.5 })
  {
    MirrorScene scene(24, height);
    for (const double power : { 1.0, 10.0, 60.0, 100.0 })
    {
      scene.SetPower(0.5, power);
      const LobeFunction lobe = MakePower(0.5, power);
      for (const bool moving : { false, true })
      {
        scene.SetMoving(moving);
        CompareLight(
          scene, "glossy", OnFloor, [&](const auto& r) { return scene.Sum(r, lobe, 100); },
          { 2e-3, 4e-3, "half floats of ks and power, normals of 15 bits" },
          "eye at " + std::to_string(height) + ", power " + std::to_string(power) +
            (moving ? ", moving" : ", still"));
      }
    }
  }
}

//------------------------------------------------------------------------------
// The fit's error grows with the angle of the view: see UnitLobe.cxx. Where Fresnel's term
// dominates, at F0 of 0.04, the lamp's own angle should count, but that of the whole lobe is used:
// errors are a few hundredths of a mirror's reflection.
VTK_INDIRECT_TEST(AreaLobeOfPBR)
{
  struct Eye
  {
    double Height;
    double Metallic;
    double Mean;
    double RMS;
  };
  for (const Eye& eye : { Eye{ 3.0, 1.0, 0.06, 0.09 }, Eye{ 1.2, 1.0, 0.1, 0.15 },
         Eye{ 3.0, 0.0, 0.15, 0.25 }, Eye{ 1.2, 0.0, 0.25, 0.4 } })
  {
    MirrorScene scene(24, eye.Height);
    vtkProperty* property = scene.Floor->GetProperty();
    property->SetInterpolationToPBR();
    property->SetMetallic(eye.Metallic);
    for (const double roughness : { 0.1, 0.3, 0.6, 1.0 })
    {
      property->SetRoughness(roughness);
      scene.Render();
      const Image specular = scene.Copy("specular");
      const double straight = specular.At(12, 12)[0];
      CheckAbsolute("F0", straight, eye.Metallic > 0.5 ? 0.9 : 0.04, 1e-3, "half floats");
      CheckAbsolute("roughness", specular.At(12, 12)[3], -roughness, 1e-3, "half floats");
      const LobeFunction lobe = MakePhysical(straight, roughness);
      CompareLight(
        scene, "glossy", OnFloor,
        [&](const auto& r) { return scene.Sum(r, lobe, roughness < 0.2 ? 300 : 80); },
        { eye.Mean, eye.RMS, "the fit's own error" },
        "eye at " + std::to_string(eye.Height) + ", metallic " + std::to_string(eye.Metallic) +
          ", roughness " + std::to_string(roughness));
    }
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(AreaLobeOfImages)
{
  auto step = [](int x, int) { return x < 10 ? 2.0 : 0.2; };
  auto checkers = [](int x, int y) { return (x / 4 + y / 4) % 2 ? 1.0 : 0.0; };
  MirrorScene scene(24, 1.5);
  for (const TexelPicture& picture : { TexelPicture(step), TexelPicture(checkers) })
  {
    scene.Show(picture);
    for (const double power : { 4.0, 20.0, 100.0 })
    {
      scene.SetPower(1.0, power);
      const LobeFunction lobe = MakePower(1.0, power);
      CompareLight(
        scene, "glossy", OnFloor, [&](const auto& r) { return scene.Sum(r, lobe, 96, picture); },
        { 0.03, 0.2, "parts of the image are weighed by a lobe of other tails" },
        "power " + std::to_string(power));
    }
    scene.Floor->GetProperty()->SetInterpolationToPBR();
    scene.Floor->GetProperty()->SetMetallic(1.0);
    scene.Floor->GetProperty()->SetRoughness(0.3);
    const LobeFunction lobe = MakePhysical(0.9, 0.3);
    CompareLight(
      scene, "glossy", OnFloor, [&](const auto& r) { return scene.Sum(r, lobe, 160, picture); },
      { 0.05, 0.12, "the fit's own error" }, "PBR");
  }
}

//------------------------------------------------------------------------------
// A wall in front of the left half of the lamp.
VTK_INDIRECT_TEST(AreaLobeIsHidden)
{
  MirrorScene scene(48, 1.5);
  scene.Pass->SetVisibilityToMaps();
  scene.AddQuad({ -2, 0.6, 0 }, { 0, 0.6, 0 }, { -2, 0.6, 2 }, { 0, 0, 0 });
  auto sees = [](const glm::dvec3& from, const glm::dvec3& to)
  {
    const double share = (0.6 - from.y) / (to.y - from.y);
    return from.y > 0.6 || from.x + share * (to.x - from.x) > 0.0;
  };
  auto before = [](const Scene::Receiver& receiver)
  { return OnFloor(receiver) && receiver.Position.y < 0.5; };
  for (const double power : { 4.0, 20.0, 60.0 })
  {
    scene.SetPower(1.0, power);
    const LobeFunction lobe = MakePower(1.0, power);
    for (const bool moving : { false, true })
    {
      scene.SetMoving(moving);
      for (int frame = 0; frame < 20; ++frame)
      {
        scene.Render(); // until all depth maps are complete
      }
      CompareLight(
        scene, "glossy", before,
        [&](const auto& r) { return scene.Sum(r, lobe, 64, IsEven, sees); },
        { moving ? 0.12 : 0.04, moving ? 0.3 : 0.2,
          "steps of a share by 64 points, in moving frames 16" },
        "power " + std::to_string(power) + (moving ? ", moving" : ", still"));
    }
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(AreaLobeCostsNothingWithoutReceivers)
{
  MirrorScene scene(64, 1.5);
  scene.SetPower(0.0, 1.0);
  scene.Render();
  const double without = scene.ReadReport("bytes");
  const Image glossy = scene.Copy("glossy");
  CheckEqual("glossy", *std::max_element(glossy.Values.begin(), glossy.Values.end()), 0.0);
  scene.SetPower(0.5, 1.0);
  scene.Render();
  // Images for specular reflectance and for their sum; and the albedo.
  CheckAtLeast("bytes more", scene.ReadReport("bytes") - without, 64 * 64 * (8 + 16), "two images");
  scene.SetPower(0.0, 1.0);
  scene.Render();
  CheckEqual("bytes again", scene.ReadReport("bytes"), without);
}
