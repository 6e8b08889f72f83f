// SPDX-License-Identifier: BSD-3-Clause
// Specular senders: the flux of their lobes, its destination, and the estimators that sum it.
#include "Maps/vtkIndirectLightMaps.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkCylinderSource.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightTreeSampler.h"
#include "vtkMath.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkProperty.h"
#include "vtkRSMGatherPass.h"
#include "vtkRSMReferencePass.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace vtkIndirectTest;

namespace
{
struct Lobe
{
  glm::dvec3 Direction;
  double Exponent;
  glm::dvec3 Flux;
};

std::vector<Lobe> CopyLobes(Scene& scene)
{
  vtkNew<vtkImageData> image;
  std::vector<Lobe> lobes;
  if (scene.Pass->CopyBuffer("lobes", image))
  {
    const auto* v = static_cast<const float*>(image->GetScalarPointer());
    for (int i = 0; i < image->GetDimensions()[1]; ++i, v += 8)
    {
      lobes.push_back({ { v[0], v[1], v[2] }, v[3], { v[4], v[5], v[6] } });
    }
  }
  return lobes;
}

glm::dvec3 SumFlux(const std::vector<Lobe>& lobes)
{
  glm::dvec3 sum(0.0);
  for (const Lobe& lobe : lobes)
  {
    sum += lobe.Flux;
  }
  return sum;
}

// Flux of VTK's specular term of coefficient one over area and strength: the integral of max(r.w,
// 0)^power (n.w) above the surface, by rings about r.
double PhongFlux(double power, double cosine)
{
  const double c = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
  return Integrate(
    0.0, 1.0,
    [&](double u)
    {
      const double a = 0.5 * vtkMath::Pi() * u * u;
      const double mean = cosine * std::cos(a);
      const double swing = c * std::sin(a);
      const double t = mean < swing ? std::acos(std::max(-mean / swing, -1.0)) : vtkMath::Pi();
      return std::pow(std::cos(a), power) * std::sin(a) * 2.0 * (mean * t + swing * std::sin(t)) *
        vtkMath::Pi() * u;
    },
    2000);
}

void MakePhong(vtkActor* actor, double specular, double power)
{
  actor->GetProperty()->SetDiffuse(0.0);
  actor->GetProperty()->SetSpecular(specular);
  actor->GetProperty()->SetSpecularPower(power);
}

// Makes a metal with nearly all light in its lobe, of exponent 1 / (2 alpha^2) - 1 / 2.
void MakeMetal(vtkActor* actor, double roughness)
{
  actor->GetProperty()->SetInterpolationToPBR();
  actor->GetProperty()->SetMetallic(1.0);
  actor->GetProperty()->SetRoughness(roughness);
}

double MeanSquare(const Image& a, const Image& b)
{
  double sum = 0.0;
  size_t count = 0;
  for (size_t i = 0; i < a.Values.size(); i += static_cast<size_t>(a.Components))
  {
    sum += std::pow(static_cast<double>(a.Values[i]) - b.Values[i], 2.0);
    ++count;
  }
  return sum / static_cast<double>(count);
}

// Flux on the ground, seen from above by a parallel eye whose window is `width` wide.
double GroundFlux(const Image& irradiance, double width, const std::vector<Scene::Receiver>& seen)
{
  double sum = 0.0;
  size_t pixel = 0;
  for (const Scene::Receiver& receiver : seen)
  {
    if (receiver.Lit && receiver.Normal.y > 0.99)
    {
      sum += irradiance.Values[pixel * static_cast<size_t>(irradiance.Components)];
    }
    ++pixel;
  }
  const double edge = width / irradiance.Width;
  return sum * edge * edge;
}
}

VTK_INDIRECT_TEST(SenderLobeFluxOfMaps)
{
  for (const double degrees : { 0.0, 40.0, 75.0, 86.0 })
  {
    const double angle = vtkMath::RadiansFromDegrees(degrees);
    for (const double power : { 0.0, 1.0, 20.0, 128.0 })
    {
      Scene scene(8, 8);
      MakePhong(scene.AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 1, 1, 1 }), 0.5, power);
      scene.AddQuad({ 2, 0, 0 }, { 2, 1, 0 }, { 2, 0, 1 }, { 0.5, 0.5, 0.5 });
      scene.SetEye({ 0.5, 3, 0.5 }, { 0.5, 0, 0.5 }, { 0, 0, 1 }, 50, 0.5, 6);
      scene.AddDirectional({ std::sin(angle), -std::cos(angle), 0 });
      scene.Pass->SetReflectiveShadowMapResolution(256);
      scene.Render();
      const std::vector<Lobe> lobes = CopyLobes(scene);
      const double expected = 0.5 * PhongFlux(power, std::cos(angle)) / vtkMath::Pi();
      // Texels resolve the silhouette, and fewer fall on a plane seen edge-on.
      CheckRelative("Phong, power " + std::to_string(static_cast<int>(power)) + " at " +
          std::to_string(static_cast<int>(degrees)) + " degrees",
        SumFlux(lobes).x, expected, degrees > 80.0 ? 0.05 : 0.02,
        "texels along the silhouette, and 0.2 % of the closed form");
      int wrong = 0;
      for (const Lobe& lobe : lobes)
      {
        wrong += lobe.Flux.x > 0.0 &&
            glm::distance(lobe.Direction, { std::sin(angle), std::cos(angle), 0 }) > 1e-3
          ? 1
          : 0;
      }
      CheckEqual("lobes that do not go along the mirror direction", wrong, 0);
    }
  }
  // A metal reflects nearly all light, in units of VTK's PBR: I cos / pi.
  Scene scene(8, 8);
  MakeMetal(scene.AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0.9, 0.6, 0.3 }), 0.3);
  scene.AddQuad({ 2, 0, 0 }, { 2, 1, 0 }, { 2, 0, 1 }, { 0.5, 0.5, 0.5 });
  scene.SetEye({ 0.5, 3, 0.5 }, { 0.5, 0, 0.5 }, { 0, 0, 1 }, 50, 0.5, 6);
  const double angle = vtkMath::RadiansFromDegrees(40.0);
  scene.AddDirectional({ std::sin(angle), -std::cos(angle), 0 });
  scene.Pass->SetReflectiveShadowMapResolution(256);
  scene.Render();
  const glm::dvec3 flux = SumFlux(CopyLobes(scene)) * vtkMath::Pi() / std::cos(angle);
  CheckRelative("metal, red", flux.x, 0.9, 0.05,
    "4 % stay between the facets, which VTK's PBR does not give back");
  CheckRelative("metal, blue over red", flux.z / flux.x, 0.3 / 0.9, 0.03, "Schlick at 40 degrees");
}

// A tilted plate, and a wall that catches all of its beam.
VTK_INDIRECT_TEST(SenderLobeArrives)
{
  for (const double scale : { 1.0, 1e-9, 1e6 })
  {
    for (const bool metal : { true, false })
    {
      Scene scene(96, 96);
      // The plate reflects light from above along +x onto the wall, of which the eye sees the plan.
      vtkActor* plate = scene.AddQuad(scale * glm::dvec3(0, 0, 0), scale * glm::dvec3(0, 0, 1),
        scale * glm::dvec3(1, -1, 0), { 1, 1, 1 });
      metal ? MakeMetal(plate, 0.25) : MakePhong(plate, 1.0, 128.0);
      scene.AddQuad(scale * glm::dvec3(3, -3, -2), scale * glm::dvec3(3, -3, 3),
        scale * glm::dvec3(3, 2, -2), { 0.5, 0.5, 0.5 });
      scene.SetEye(scale * glm::dvec3(-4, -0.5, 0.5), scale * glm::dvec3(3, -0.5, 0.5), { 0, 1, 0 },
        30, 5.0 * scale, 9 * scale);
      scene.SetParallelEye(2.5 * scale);
      scene.AddDirectional({ 0, -1, 0 });
      scene.Pass->SetReflectiveShadowMapResolution(64);
      scene.Render();
      const double sent = SumFlux(CopyLobes(scene)).x;
      const Image e = scene.Copy("irradiance");
      double arrived = 0.0;
      for (int p = 0; p < 96 * 96; ++p)
      {
        arrived += e.Values[static_cast<size_t>(p) * e.Components];
      }
      arrived *= std::pow(5.0 * scale / 96, 2.0);
      CheckRelative(
        std::string(metal ? "metal" : "Phong") + ", light on the wall over what is sent",
        arrived / sent, 1.0, 0.03,
        "0.4 % of the lobe's integral, pixels, and a tail past the wall");
      scene.CheckBuffers(1);
    }
  }
}

namespace
{
constexpr double Radius = 0.6;
constexpr double Height = 0.5;
constexpr double Slope = 0.7; // slope of the light, height over length
constexpr double Width = 3.0; // width of the window over the ground

// A metal ring about the y axis on the ground, under light from above along +x; the eye looks down.
void AddRing(Scene& scene, vtkActor*& ring)
{
  vtkNew<vtkCylinderSource> source;
  source->SetRadius(Radius);
  source->SetHeight(Height);
  source->SetCenter(0, 0.5 * Height + 1e-3, 0);
  source->SetResolution(256);
  source->CappingOff();
  ring = scene.AddSource(source, { 1, 1, 1 });
  MakeMetal(ring, 0.12);
  scene.AddQuad({ -1.5, 0, -1.5 }, { -1.5, 0, 1.5 }, { 1.5, 0, -1.5 }, { 0.5, 0.5, 0.5 });
  scene.SetEye({ 0, 5, 0 }, { 0, 0, 0 }, { 0, 0, -1 }, 30, 3, 6);
  scene.SetParallelEye(0.5 * Width);
  scene.Pass->SetReflectiveShadowMapResolution(128);
  scene.Pass->SetVisibility(vtkIndirectIlluminationPass::NONE);
  scene.Pass->SetErrorTolerance(0.0);
  scene.Gather->SetModeToVirtualLights();
  scene.Sampler->SetNumberOfLights(4096);
}

// The distance from the axis of the brightest point along it, on the far side.
double FindCusp(const Image& e, double width)
{
  const int row = e.Height / 2;
  double best = -1.0;
  double at = 0.0;
  for (int i = e.Width / 2; i < e.Width; ++i)
  {
    const double x = (i + 0.5) / e.Width * width - 0.5 * width;
    // Two rows lie beside the axis.
    const double value = e.Values[static_cast<size_t>(row * e.Width + i) * e.Components] +
      e.Values[static_cast<size_t>((row - 1) * e.Width + i) * e.Components];
    if (value > best && x < 0.95 * Radius)
    {
      best = value;
      at = x;
    }
  }
  return at;
}
}

VTK_INDIRECT_TEST(RingCaustic)
{
  Scene scene(128, 128);
  vtkActor* ring = nullptr;
  AddRing(scene, ring);
  vtkLight* light = scene.AddDirectional({ 1.0, -Slope, 0.0 });
  scene.Gather->InterpolationOff();
  vtkNew<vtkLightTreeSampler> tree;
  tree->SetNumberOfLights(4096);
  scene.Pass->SetSampler(tree);
  scene.Render();
  const double sent = SumFlux(CopyLobes(scene)).x;
  // Flux onto the walls, by quadrature: onto the outer wall where it is lit, onto the inner one
  // below the near rim's shadow.
  double projected = 0.0;
  const int steps = 20000;
  for (int i = 0; i < steps; ++i)
  {
    const double z = 2.0 * Radius * ((i + 0.5) / steps - 0.5);
    const double chord = 2.0 * std::sqrt(Radius * Radius - z * z);
    projected += (Height + std::min(chord * Slope, Height)) * 2.0 * Radius / steps;
  }
  CheckRelative("flux that the ring reflects, over that of light that falls onto it", sent,
    projected / std::sqrt(1.0 + Slope * Slope) / vtkMath::Pi(), 0.03,
    "texels along rims, and 1 to 2 % that VTK's metal keeps");
  const Image clusters = scene.Copy("irradiance");
  const double arrived = GroundFlux(clusters, Width, scene.GetReceivers());
  CheckRelative("light on the ground over what the ring reflects", arrived / sent, 1.0, 0.03,
    "pixels that the rim covers, what is widened at the ring's foot, and a tail past the ground");
  scene.CheckBuffers(1);

  // The same lights, interpolated where they vary little.
  scene.Gather->InterpolationOn();
  scene.Render();
  const double mean = clusters.Mean();
  CheckAtMost("interpolated, RMS difference over the mean",
    std::sqrt(MeanSquare(scene.Copy("irradiance"), clusters)) / mean, 0.03,
    "a tolerance of 0.05 of the light there, which is many times the mean in the caustic");
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  scene.Pass->SetEstimator(splatting);
  scene.Render();
  CheckAtMost("multiresolution splatting, RMS difference over the mean",
    std::sqrt(MeanSquare(scene.Copy("irradiance"), clusters)) / mean, 0.03, "the same");
  scene.Pass->SetEstimator(scene.Gather);

  // Against all texels: the error of fewer lights.
  scene.Gather->SetModeToAllTexels();
  scene.Render();
  const Image all = scene.Copy("irradiance");
  scene.Gather->SetModeToVirtualLights();
  scene.Pass->SetSampler(scene.Sampler);
  scene.Render();
  const Image uniform = scene.Copy("irradiance");
  CheckRelative("light of uniform lights on the ground, over what is sent",
    GroundFlux(uniform, Width, scene.GetReceivers()) / sent, 1.0, 0.07,
    "a few hundred of 4096 lie on the ring: near its foot lobes are widened over the horizon");
  scene.Pass->SetSampler(tree);
  tree->SetNumberOfLights(256);
  scene.Render();
  const Image few = scene.Copy("irradiance");
  CheckRelative("light of 256 clusters on the ground, over what is sent",
    GroundFlux(few, Width, scene.GetReceivers()) / sent, 1.0, 0.08, "the same, and wider lobes");
  const double a = std::sqrt(MeanSquare(clusters, all)) / all.Mean();
  const double b = std::sqrt(MeanSquare(uniform, all)) / all.Mean();
  const double c = std::sqrt(MeanSquare(few, all)) / all.Mean();
  double square = 0.0;
  for (size_t i = 0; i < all.Values.size(); i += 3)
  {
    square += all.Values[i] * all.Values[i] * 3.0 / all.Values.size();
  }
  const double whole = std::sqrt(square) / all.Mean();
  std::cout << "  all texels, RMS over the mean " << whole << "; difference of 4096 clusters " << a
            << ", of 4096 uniform lights " << b << ", of 256 clusters " << c << "\n";
  CheckAtMost("4096 clusters, RMS difference to all texels over the RMS", a / whole, 0.35,
    "measured 0.29; of uniform lights 0.25");
  CheckAtMost("256 clusters", c / whole, 0.65, "measured 0.52: a caustic as wide as their lobes");

  // Mirrors of radius R focus parallel light at R / 2, paraxially, and the caustic opens from there
  // towards the wall: its brightest point along the axis, within the blur of the lobes.
  tree->SetNumberOfLights(4096);
  scene.SetParallelEye(0.5);
  scene.Render();
  CheckAbsolute("cusp of the caustic of 4096 lights from the axis",
    FindCusp(scene.Copy("irradiance"), 1.0), 0.5 * Radius, 0.05, "the width of their lobes there");
  scene.Gather->SetModeToAllTexels();
  scene.Render();
  CheckAbsolute("cusp of the caustic from the axis", FindCusp(scene.Copy("irradiance"), 1.0),
    0.5 * Radius, 0.03,
    "the lobe's width over the way, 0.014, and that of texels, 0.01, of light "
    "on one side");
  // A point at distance d along the axis: 1 / s + 1 / (d + R) = 2 / R, s from the wall.
  light->SwitchOff();
  scene.AddSpot({ -1.5, 1.5 * Slope, 0 }, { 0, 0, 0 }, 35, 0, { 1, 0, 0 });
  scene.Render();
  const double s = 1.0 / (2.0 / Radius - 1.0 / (1.5 + Radius));
  CheckAbsolute("cusp of a near light's from the axis", FindCusp(scene.Copy("irradiance"), 1.0),
    Radius - s, 0.03, "the same");
  scene.Pass->SetSampler(scene.Sampler);
}

VTK_INDIRECT_TEST(SenderLobesAgainstReference)
{
  // Phong senders and a specular receiver, a few lights, double precision.
  Scene scene(48, 48);
  vtkActor* plate = scene.AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0.6, 0.5, 0.4 });
  plate->GetProperty()->SetSpecular(0.8);
  plate->GetProperty()->SetSpecularPower(30);
  vtkActor* wall = scene.AddQuad({ 1, 0, 0 }, { 1, 0, 1 }, { 1, 1, 0 }, { 0.5, 0.6, 0.7 });
  wall->GetProperty()->SetSpecular(0.5);
  wall->GetProperty()->SetSpecularPower(15);
  scene.SetEye({ -1.5, 1.5, 1.8 }, { 0.7, 0.3, 0.5 }, { 0, 1, 0 }, 40, 0.5, 6);
  scene.AddSpot({ -1, 1.2, 0.5 }, { 0.5, 0, 0.5 }, 40, 0, { 1, 0, 0 });
  scene.Pass->SetReflectiveShadowMapResolution(64);
  scene.Pass->SetVisibility(vtkIndirectIlluminationPass::NONE);
  scene.Sampler->SetNumberOfLights(200);
  scene.Gather->SetModeToVirtualLights();
  scene.Gather->InterpolationOff();
  scene.Render();
  const Image e = scene.Copy("irradiance");
  const Image s = scene.Copy("glossy");
  vtkNew<vtkRSMReferencePass> reference;
  reference->SetModeToVirtualLights();
  scene.Pass->SetEstimator(reference);
  scene.Render();
  CheckAtMost("irradiance, RMS difference over the mean",
    std::sqrt(MeanSquare(e, scene.Copy("irradiance"))) / e.Mean(), 2e-3,
    "0.04 % of the lobe's integral twice, and rounding");
  CheckAtMost("glossy, RMS difference over the mean",
    std::sqrt(MeanSquare(s, scene.Copy("glossy"))) / s.Mean(), 2e-3, "the same");
  scene.Pass->SetEstimator(scene.Gather);

  // Without lobes the picture differs; nothing is allocated for them.
  scene.Gather->SpecularTransportOff();
  scene.Render();
  Check("without specular transport maps hold nothing for lobes",
    !vtkIndirectLightMaps::Get(scene.Pass->GetReflectiveShadowMaps()).HasSpecular());
  Check("and the picture is darker", scene.Copy("irradiance").Mean() < 0.999 * e.Mean());
  scene.Gather->SpecularTransportOn();
}

// All results are numbers: mirrors and matt metal, light along the surface and nearly so, black.
VTK_INDIRECT_TEST(SenderLobesOfExtremes)
{
  Scene scene(24, 24);
  vtkActor* plate = scene.AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 1, 1, 1 });
  vtkActor* wall = scene.AddQuad({ 1, 0, 0 }, { 1, 0, 1 }, { 1, 1, 0 }, { 0.5, 0.6, 0.7 });
  MakePhong(wall, 1.0, 128.0);
  scene.SetEye({ -1.5, 1.5, 1.8 }, { 0.7, 0.3, 0.5 }, { 0, 1, 0 }, 40, 0.5, 6);
  scene.Pass->SetReflectiveShadowMapResolution(32);
  scene.Gather->SetModeToVirtualLights();
  scene.Sampler->SetNumberOfLights(64);
  vtkLight* lights[] = { scene.AddDirectional({ 1, -1e-3, 0 }),
    scene.AddDirectional({ 0.1, -1, 0 }), scene.AddPoint({ 0.5, 1e-4, 0.5 }, { 1, 0, 0 }),
    scene.AddPoint({ 0.5, 1e-4, 0.5 }, { 0, 0, 1 }) };
  for (vtkLight* one : lights)
  {
    for (vtkLight* light : lights)
    {
      light->SetSwitch(light == one);
    }
    for (const double roughness : { -1.0, 0.0, 0.03, 1.0 })
    {
      if (roughness < 0.0)
      {
        plate->GetProperty()->SetInterpolationToPhong();
        MakePhong(plate, 1.0, 0.0);
      }
      else
      {
        plate->GetProperty()->SetDiffuse(1.0);
        MakeMetal(plate, roughness);
      }
      for (const bool interpolated : { false, true })
      {
        scene.Gather->SetInterpolation(interpolated);
        scene.Render();
        scene.CheckBuffers(1);
      }
    }
  }
  // Black metal, and black Phong: no flux, and no NaN.
  plate->GetProperty()->SetColor(0, 0, 0);
  MakePhong(wall, 0.0, 1.0);
  wall->GetProperty()->SetColor(0, 0, 0);
  scene.Render();
  scene.CheckBuffers(1);
  CheckAtMost("flux of what is black, over that of what is white", SumFlux(CopyLobes(scene)).x,
    1e-6, "F0 of a black metal is zero");
}
