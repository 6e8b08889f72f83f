// SPDX-License-Identifier: BSD-3-Clause
// Specular indirect light of Phong receivers, against sums in double precision and VTK's lights.
#include "Gather/vtkIndirectGlossyRoom.h"
#include "vtkIndirectDetails.h"

#include "vtkAssembly.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkPropAssembly.h"
#include "vtkRSMReferencePass.h"
#include "vtkRadianceHintsPass.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
// A light this close to a receiver's horizon, where VTK's Phong model steps from zero to its full
// lobe, may count or not: positions and normals are read back as 32-bit floats.
constexpr double Horizon = 1e-5;

// Independent sum in double precision: reflection by lobes of specular coefficient one. step: adds
// the possible change by lights on the horizon.
glm::dvec3 SumLobe(const std::vector<VirtualLight>& lights, const glm::dvec3& position,
  const glm::dvec3& normal, const glm::dvec3& toEye, double power, double* step = nullptr)
{
  glm::dvec3 sum(0.0);
  for (const VirtualLight& light : lights)
  {
    const glm::dvec3 d = light.Position - position;
    const double r = glm::length(d);
    const glm::dvec3 l = d / r;
    const double sender = -glm::dot(light.Normal, l);
    const double mirrored = glm::dot(glm::reflect(-l, normal), toEye);
    const double cosine = glm::dot(normal, l);
    if (r > 0.0 && sender > 0.0 && cosine > -Horizon && mirrored > 0.0)
    {
      const glm::dvec3 share = light.DensityArea *
        (sender / (vtkMath::Pi() * r * r + light.Area) * std::pow(mirrored, power));
      sum += cosine > 0.0 ? share : glm::dvec3(0.0);
      if (step && cosine < Horizon)
      {
        *step += glm::length(share);
      }
    }
  }
  return sum;
}

struct OracleResult
{
  double Worst = 0.0; // over a pixel's value, or over a hundredth of the largest
  double Largest = 0.0;
  double WithoutMirror = 0.0; // with the lobe around the normal
  int Receivers = 0;
  int Steps = 0; // receivers with a light on their horizon
};

OracleResult CompareWithOracle(Scene& scene, const glm::dvec3& eye)
{
  const Image glossy = scene.Copy("glossy");
  const Image specular = scene.Copy("specular");
  const std::vector<VirtualLight> lights = scene.CopyLights();
  const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
  OracleResult result;
  std::vector<glm::dvec3> expected(receivers.size(), glm::dvec3(0.0));
  std::vector<glm::dvec3> wrong(receivers.size(), glm::dvec3(0.0));
  std::vector<double> steps(receivers.size(), 0.0);
  for (size_t i = 0; i < receivers.size(); ++i)
  {
    const float* s = &specular.Values[4 * i];
    const Scene::Receiver& r = receivers[i];
    if (r.Lit && s[0] > 0.0f)
    {
      const glm::dvec3 color(s[0], s[1], s[2]);
      const glm::dvec3 toEye = glm::normalize(eye - r.Position);
      const glm::dvec3 n = glm::normalize(r.Normal);
      expected[i] = color * SumLobe(lights, r.Position, n, toEye, s[3], &steps[i]);
      wrong[i] = color * SumLobe(lights, r.Position, n, n, s[3]);
      result.Largest = std::max(result.Largest, glm::length(expected[i]));
      ++result.Receivers;
    }
  }
  for (size_t i = 0; i < receivers.size(); ++i)
  {
    const glm::dvec3 measured(
      glossy.Values[3 * i], glossy.Values[3 * i + 1], glossy.Values[3 * i + 2]);
    const double scale = std::max(glm::length(expected[i]), 1e-2 * result.Largest);
    if (scale > 0.0)
    {
      result.Steps += steps[i] > 1e-5 * scale ? 1 : 0;
      result.Worst = std::max(
        result.Worst, std::max(glm::length(measured - expected[i]) - steps[i], 0.0) / scale);
      result.WithoutMirror =
        std::max(result.WithoutMirror, glm::length(measured - wrong[i]) / scale);
    }
  }
  return result;
}
}

VTK_INDIRECT_TEST(Oracle)
{
  for (double power : { 1.0, 8.0, 60.0, 128.0 })
  {
    GlossyRoom scene(72, 56, 0.7, power);
    // The reference has only diffuse senders.
    for (vtkActor* actor : { scene.Floor, scene.Ball })
    {
      vtkNew<vtkInformation> keys;
      keys->Set(vtkIndirectIlluminationPass::SENDS_LIGHT(), 0);
      actor->SetPropertyKeys(keys);
    }
    scene.Render();
    const OracleResult result = CompareWithOracle(scene, { 1.9, 0.2, 0.9 });
    const std::string what = "power " + std::to_string(static_cast<int>(power)) + ": ";
    CheckAtLeast(what + "specular pixels", result.Receivers, 1500, "the test's own power");
    CheckAtLeast(what + "brightest", result.Largest, 1e-4, "the test's own power");
    CheckAtMost(what + "worst relative difference to the sum in double precision", result.Worst,
      2e-4,
      "a mirrored cosine of 32-bit floats to the power of 128: 128 times 2^-23; senders at a "
      "grazing angle");
    CheckAtMost(what + "pixels with a light on their horizon", result.Steps,
      0.01 * result.Receivers, "they are let off: the rest is the test");
    CheckAtLeast(
      what + "with the lobe around the normal", result.WithoutMirror, 0.05, "the test's own power");
    scene.CheckBuffers(1);
    // Interpolation applies to the irradiance, not to the lobes.
    const Image all = scene.Copy("glossy");
    scene.Gather->InterpolationOn();
    scene.Render();
    CheckAtMost(what + "interpolation changes the lobes by", Difference(scene.Copy("glossy"), all),
      1e-36,
      "terms below 1.2e-38, the least normal float: not all threads that draw flush them to zero");
  }
}

VTK_INDIRECT_TEST(Reference)
{
  GlossyRoom scene(40, 32, 0.7, 40);
  scene.AddPoint({ 0.5, 0.1, 1.2 }, { 1, 0, 1 });
  scene.AddDirectional({ -0.8, 0.1, -0.5 });
  vtkNew<vtkRSMReferencePass> reference;
  for (bool all : { false, true })
  {
    scene.Pass->SetEstimator(scene.Gather);
    scene.Gather->SetMode(all ? vtkRSMGatherPass::ALL_TEXELS : vtkRSMGatherPass::VIRTUAL_LIGHTS);
    scene.Pass->SetReflectiveShadowMapResolution(32);
    scene.Render();
    const Image gathered = scene.Copy("glossy");
    reference->SetMode(all ? vtkRSMReferencePass::ALL_TEXELS : vtkRSMReferencePass::VIRTUAL_LIGHTS);
    scene.Pass->SetEstimator(reference);
    scene.Render();
    const Image exact = scene.Copy("glossy");
    const std::string what = all ? "all texels of three maps: " : "virtual lights of three lamps: ";
    CheckAtLeast(what + "brightest", Largest(exact), 1e-3, "the test's own power");
    CheckAtMost(what + "worst difference of the reference over the brightest",
      Difference(gathered, exact) / Largest(exact), 1e-4, "32-bit floats, see GlossyOracle");
    scene.CheckBuffers(3);
  }
  // In the paper's own mode the sum is restricted to a disk; the whole map with many samples gives
  // the sum over all texels, but for the pattern's error.
  scene.Pass->SetEstimator(scene.Gather);
  scene.Render();
  const Image exact = scene.Copy("glossy");
  scene.Gather->SetModeToNeighborhood();
  scene.Gather->InterpolationOff();
  scene.Gather->SetNeighborhoodRadius(1.5);
  scene.Gather->SetNumberOfSamples(4096);
  scene.Render();
  CheckRelative("mean in mode NEIGHBORHOOD over that of all texels",
    scene.Copy("glossy").Mean() / exact.Mean(), 1.0, 0.1,
    "4096 samples of a disk that covers the map of 32 texels squared; the cube's faces overlap");
}

// Senders hidden from diffuse reflection are hidden from the lobes too, in every estimator.
VTK_INDIRECT_TEST(Hidden)
{
  GlossyRoom scene(64, 48, 0.7, 20);
  scene.AddQuad({ 0.2, 0.2, 0.1 }, { 0.2, 0.8, 0.1 }, { 0.2, 0.2, 0.6 }, glm::dvec3(0.5));
  vtkNew<vtkRSMReferencePass> reference;
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  SET_DETAIL(splatting, HalfFloats, false);
  reference->SetModeToVirtualLights();
  vtkIndirectEstimatorPass* const estimators[] = { reference, scene.Gather, splatting };
  Image expected;
  for (vtkIndirectEstimatorPass* estimator : estimators)
  {
    scene.Pass->SetEstimator(estimator);
    scene.Pass->SetVisibilityToNone();
    scene.Render();
    const Image open = scene.Copy("glossy");
    scene.Pass->SetVisibilityToVoxels();
    scene.Render();
    const Image hidden = scene.Copy("glossy");
    const std::string what = std::string(estimator->GetClassName()) + ": ";
    CheckAtMost(what + "light in the lobes over that without voxels", hidden.Mean() / open.Mean(),
      0.9, "the plate stands before the wall");
    if (estimator == reference)
    {
      expected = hidden;
      continue;
    }
    // Single precision may decide otherwise on a segment that grazes a voxel.
    int differ = 0;
    for (size_t i = 0; i < hidden.Values.size(); ++i)
    {
      differ += std::abs(hidden.Values[i] - expected.Values[i]) > 1e-3 * Largest(expected) ? 1 : 0;
    }
    CheckAtMost(what + "share of values that differ from the reference",
      static_cast<double>(differ) / hidden.Values.size(), 0.002, "measured 0");
  }
}

// A small distant sender acts as a VTK light, whose specular reflection checks the formula:
// position, normal, mirror direction, power, specular colour and the missing cosine.
VTK_INDIRECT_TEST(IsVTKs)
{
  for (double power : { 1.0, 30.0 })
  {
    Scene scene(48, 48);
    vtkActor* ball = scene.AddSphere({ 0, 0, 0 }, 0.5, 64, { 0, 0, 0 });
    ball->GetProperty()->SetSpecular(0.8);
    ball->GetProperty()->SetSpecularPower(power);
    ball->GetProperty()->SetSpecularColor(1.0, 0.5, 0.25);
    // A plate that faces the ball from the right, lit from the left without occluders.
    const glm::dvec3 at(4, 1, 1);
    const double e = 0.02;
    scene.AddQuad(at + glm::dvec3(0, -e, -e), at + glm::dvec3(0, -e, e), at + glm::dvec3(0, e, -e),
      glm::dvec3(0.9));
    scene.AddSpot(at + glm::dvec3(-1.0, 0, 0), at, 8, 0, { 1, 0, 0 });
    scene.SetEye({ 0.5, -3, 0.4 }, { 0, 0, 0 }, { 0, 0, 1 }, 24, 0.5, 10);
    scene.Pass->ShadowsOff();
    scene.Pass->SetReflectiveShadowMapResolution(32);
    scene.Render();
    const Image glossy = scene.Copy("glossy");
    const std::vector<VirtualLight> lights = scene.CopyLights();
    glm::dvec3 flux(0.0);
    for (const VirtualLight& light : lights)
    {
      flux += light.DensityArea;
    }
    // A VTK light of the same strength at the ball's centre, where the plate's own cosine and area
    // are those of one distant disk.
    Scene lamp(48, 48);
    vtkActor* other = lamp.AddSphere({ 0, 0, 0 }, 0.5, 64, { 0, 0, 0 });
    other->GetProperty()->SetSpecular(0.8);
    other->GetProperty()->SetSpecularPower(power);
    other->GetProperty()->SetSpecularColor(1.0, 0.5, 0.25);
    vtkLight* light = lamp.AddPoint(at, { 0, 0, vtkMath::Pi() });
    light->SetIntensity(flux.x);
    lamp.SetEye({ 0.5, -3, 0.4 }, { 0, 0, 0 }, { 0, 0, 1 }, 24, 0.5, 10);
    lamp.Pass->ShadowsOff();
    lamp.Pass->SetReflectiveShadowMapResolution(8); // its indirect light is not used
    lamp.Render();
    const Image direct = lamp.Copy("direct");
    const Image normal = lamp.Copy("normal");
    const std::vector<Scene::Receiver> receivers = lamp.GetReceivers();
    double worst = 0.0;
    double brightest = Largest(direct);
    int lit = 0;
    for (size_t i = 0; i < receivers.size(); ++i)
    {
      const glm::dvec3 to = glm::normalize(at - receivers[i].Position);
      if (!receivers[i].Lit || glm::dot(receivers[i].Normal, to) < 0.05)
      {
        continue;
      }
      // A VTK light has no such cosine.
      const double cosine = to.x;
      for (int c = 0; c < 3; ++c)
      {
        const double expected = direct.Values[3 * i + c] * cosine;
        worst = std::max(worst, std::abs(glossy.Values[3 * i + c] - expected) / brightest);
      }
      lit += direct.Values[3 * i] > 0.1 * brightest ? 1 : 0;
    }
    const std::string what = "power " + std::to_string(static_cast<int>(power)) + ": ";
    CheckAtLeast(what + "pixels in the highlight", lit, 8, "the test's own power");
    CheckAtMost(what + "worst difference to VTK's own lamp over its brightest", worst, 2e-3,
      "the plate is 0.04 wide at a distance of 3.6: its lights lie 0.32 degrees off at most; in "
      "pairs "
      "what is odd cancels, and 30 / 2 times the square is 5e-4; the power in half floats");
  }
}

VTK_INDIRECT_TEST(Strength)
{
  GlossyRoom scene(40, 32, 0.7, 20);
  scene.Render();
  const Image unit = scene.Copy("glossy");
  for (double intensity : { 1e-12, 1e12 })
  {
    scene.SetIntensities(intensity);
    scene.Render();
    Image scaled = scene.Copy("glossy");
    for (float& value : scaled.Values)
    {
      value = static_cast<float>(value / intensity);
    }
    CheckAtMost("strength " + std::to_string(std::log10(intensity)) +
        " decades: worst difference over the brightest",
      Difference(scaled, unit) / Largest(unit), 1e-5, "rounding");
    scene.CheckBuffers(1);
  }
}

// Scenes without specular receivers are unchanged: same bytes, same shader sources, same pixels;
// and every kind of prop can make a scene specular.
VTK_INDIRECT_TEST(OnlyWhereNeeded)
{
  GlossyRoom scene(64, 48, 0.0, 60);
  scene.Render();
  const size_t geometry = static_cast<size_t>(64) * 48 * (16 + 8 + 4);
  auto bytes = [&scene]() { return static_cast<size_t>(scene.ReadReport("bytes")); };
  const size_t plain = bytes();
  CheckAtLeast("bytes of a frame", static_cast<double>(plain), static_cast<double>(geometry),
    "the geometry buffer is part of it");
  const Image without = scene.Copy("final");
  const double builds = scene.ReadReport("shader_builds");
  CheckEqual("largest of glossy", Largest(scene.Copy("glossy")), 0.0);
  CheckEqual("largest of specular", Largest(scene.Copy("specular")), 0.0);

  scene.Ball->GetProperty()->SetSpecular(0.5);
  scene.Render();
  const size_t pixels = static_cast<size_t>(64) * 48;
  // The map's channel, a row of the table of lobes, and the table of Fresnel integrals.
  const size_t ofSenders = static_cast<size_t>(64) * 64 * 8 + static_cast<size_t>(256) * 2 * 16 +
    static_cast<size_t>(24) * 24 * 2 * 4;
  CheckEqual("more bytes when a material is specular", static_cast<double>(bytes() - plain),
    static_cast<double>(pixels * (4 + 8 + 16) + ofSenders));
  CheckAtLeast("largest of glossy", Largest(scene.Copy("glossy")), 1e-4, "the test's own power");
  // The floor's own coefficient is zero.
  const Image specular = scene.Copy("specular");
  CheckAbsolute(
    "largest specular colour", Largest(specular), 60.0, 0.03, "the power, in half floats");
  double leak = 0.0;
  const Image glossy = scene.Copy("glossy");
  for (size_t i = 0; i < glossy.Values.size(); ++i)
  {
    leak += specular.Values[4 * (i / 3)] == 0.0f ? glossy.Values[i] : 0.0f;
  }
  CheckEqual("glossy light where nothing is specular", leak, 0.0);
  const Image indirect = scene.Copy("indirect");
  const Image irradiance = scene.Copy("irradiance");
  const Image albedo = scene.Copy("albedo");
  double worst = 0.0;
  for (size_t i = 0; i < indirect.Values.size(); ++i)
  {
    worst = std::max<double>(worst,
      std::abs(indirect.Values[i] - albedo.Values[i] * irradiance.Values[i] - glossy.Values[i]));
  }
  CheckAtMost("indirect against albedo E + glossy", worst, 1e-6, "rounding of values below one");
  const Image final = scene.Copy("final");
  const Image direct = scene.Copy("direct");
  worst = 0.0;
  for (size_t i = 0; i < final.Values.size(); ++i)
  {
    worst =
      std::max<double>(worst, std::abs(final.Values[i] - direct.Values[i] - indirect.Values[i]));
  }
  CheckAtMost("final against direct + indirect", worst, 1e-6, "rounding");

  for (int off = 0; off < 2; ++off)
  {
    if (off == 0)
    {
      scene.Gather->SpecularTransportOff();
    }
    else
    {
      scene.Gather->SpecularTransportOn();
      scene.Ball->GetProperty()->SetSpecular(0.0);
    }
    scene.Render();
    const std::string what = off ? "not specular again: " : "SpecularTransport off: ";
    CheckEqual(what + "bytes", static_cast<double>(bytes()), static_cast<double>(plain));
    CheckEqual(what + "glossy", Largest(scene.Copy("glossy")), 0.0);
  }
  CheckEqual(
    "the picture is the first one, bitwise", Difference(scene.Copy("final"), without), 0.0);
  CheckAtLeast("sources built since", scene.ReadReport("shader_builds"), builds + 3.0,
    "switching it rebuilds each");

  // PBR has no Phong lobe; unlit surfaces reflect nothing.
  scene.Ball->GetProperty()->SetSpecular(0.5);
  scene.Ball->GetProperty()->SetInterpolationToPBR();
  scene.Render();
  CheckEqual(
    "bytes with PBR", static_cast<double>(bytes()), static_cast<double>(plain + ofSenders));
  scene.Ball->GetProperty()->SetInterpolationToFlat();
  scene.Render();
  CheckAtLeast("flat shading", Largest(scene.Copy("glossy")), 1e-4, "VTK lights it like Phong");
  scene.Ball->GetProperty()->LightingOff();
  scene.Render();
  CheckEqual("bytes with an unlit ball", static_cast<double>(bytes()), static_cast<double>(plain));
  scene.Ball->GetProperty()->LightingOn();

  scene.Renderer->RemoveActor(scene.Ball);
  vtkNew<vtkAssembly> assembly;
  vtkNew<vtkPropAssembly> props;
  vtkNew<vtkActor> copy;
  copy->ShallowCopy(scene.Floor);
  vtkNew<vtkProperty> property;
  property->SetSpecular(0.5);
  property->SetSpecularPower(10);
  copy->SetProperty(property);
  copy->SetPosition(0, 0, 0.02);
  assembly->AddPart(copy);
  scene.Renderer->AddViewProp(assembly);
  scene.Render();
  CheckAtLeast("in an assembly", Largest(scene.Copy("glossy")), 1e-4, "a part is specular");
  scene.Renderer->RemoveViewProp(assembly);
  scene.Render();
  CheckEqual("without it", Largest(scene.Copy("glossy")), 0.0);
  props->AddPart(copy);
  scene.Renderer->AddViewProp(props);
  scene.Render();
  CheckAtLeast(
    "in an assembly of props", Largest(scene.Copy("glossy")), 1e-4, "a part is specular");

  // An estimator without specular light reports it.
  vtkNew<vtkRadianceHintsPass> hints;
  scene.Pass->SetEstimator(hints);
  scene.Pass->SetVisibilityToAuto();
  scene.Render();
  CheckEqual("hints: glossy", Largest(scene.Copy("glossy")), 0.0);
  Check("hints: the report says that it is left out",
    scene.Pass->GetReport().find("vtkRadianceHintsPass takes receivers as diffuse") !=
      std::string::npos);
}
