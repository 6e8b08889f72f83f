// SPDX-License-Identifier: BSD-3-Clause
// Splats of specular senders' lobes: against sums over the lights that count, against the gather,
// their far field, and hard cases.
#include "vtkIndirectSplattingScene.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCylinderSource.h"
#include "vtkLight.h"
#include "vtkLightTreeSampler.h"
#include "vtkProperty.h"
#include "vtkRSMGatherPass.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkRenderWindow.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace vtkIndirectTest;

namespace
{
// In a plane with a light a receiver's cosine is rounding, which a wide lobe does not reduce.
constexpr double LeastOfLobes = 5e-3;

double Brightest(const glm::dvec3& color)
{
  return std::max({ color.x, color.y, color.z });
}

/** Phong's model of a power, or, if negative, VTK's metal of minus that roughness. */
void MakeSpecular(vtkActor* actor, double power)
{
  vtkProperty* property = actor->GetProperty();
  property->SetInterpolationToPhong();
  property->SetSpecular(0.6);
  property->SetSpecularPower(std::max(power, 0.0));
  if (power < 0.0)
  {
    property->SetInterpolationToPBR();
    property->SetMetallic(1.0);
    property->SetRoughness(-power);
  }
}

void MakeAllSpecular(Scene& scene, double power)
{
  vtkActorCollection* actors = scene.Renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    MakeSpecular(actor, power);
  }
}

/** Two plates that touch at a right angle, one of which mirrors light onto the other one. */
struct Corner : SplattingFrameOf<Scene>
{
  vtkActor* Plate;
  vtkActor* Wall;

  explicit Corner(double scale = 1.0)
    : SplattingFrameOf<Scene>(40, 32)
  {
    auto at = [scale](double x, double y, double z) { return scale * glm::dvec3(x, y, z); };
    this->Plate = this->AddQuad(at(0, 0, 0), at(0, 0, 1), at(1, 0, 0), { 0.8, 0.7, 0.6 });
    this->Wall = this->AddQuad(at(1, 0, 0), at(1, 0, 1), at(1, 1, 0), { 0.5, 0.6, 0.7 });
    this->SetEye(at(-1.5, 1.5, 1.8), at(0.7, 0.3, 0.5), { 0, 1, 0 }, 40, 0.5 * scale, 6 * scale);
    this->Pass->SetReflectiveShadowMapResolution(32);
    this->Pass->SetVisibilityToNone();
    this->Gather->SetModeToVirtualLights();
    this->Gather->InterpolationOff();
    this->Sampler->SetNumberOfLights(64);
  }

  Image GatherAll()
  {
    this->Pass->SetEstimator(this->Gather);
    this->Render();
    return this->Copy("irradiance");
  }
};
}

VTK_INDIRECT_TEST(LobesCutOff)
{
  // Without the far field: the sum over the lights and lobes that exceed I_low at the receiver.
  double worst = 0.0;
  WaysAgainstTiles ways;
  double inLobes = 0.0;
  double cutOfLobes = 0.0;
  int receivers = 0;
  // No power of zero, because receivers nearly in the plane of a sender would have all of its lobe,
  // or none.
  const double powers[] = { 5.0, 10.0, 20.0, 128.0, -0.2, -0.05 };
  int frames = 0;
  for (int number = 0; number < 12; ++number)
  {
    SplattingFrame scene(100 + number, { 67, 49 }, static_cast<FrameLight>(number % 4));
    MakeAllSpecular(scene, powers[number % 6]);
    scene.Sampler->SetNumberOfLights(150);
    scene.Sampler->LitTexelsOff();
    scene.Pass->SetReflectiveShadowMapResolution(64);
    if (number % 6 == 5)
    {
      scene.SetParallelEye(0.6);
    }
    scene.Splats->FarFieldOff();
    scene.Splats->SetIntensityThreshold(0.05);
    const Image image = scene.SplatLights(SplatWay::TILES);
    ways.Add(scene, image, Least);
    const std::vector<VirtualLight> lights = scene.CopyLights();
    const Image lobes = scene.Copy("lobes");
    std::vector<double> intensities;
    for (size_t i = 0; i < lights.size(); ++i)
    {
      const double flux =
        Brightest(lights[i].DensityArea) + Brightest(lobes.Color(1, static_cast<int>(i)));
      intensities.push_back(flux / 3.14159265358979);
    }
    const double low = FindLowest(scene, intensities);
    double largest = 0.0;
    for (float value : image.Values)
    {
      largest = std::max(largest, static_cast<double>(value));
    }
    // If all lit surfaces lie in a plane, light is rounding.
    if (largest < 1e-3)
    {
      continue;
    }
    ++frames;
    std::vector<double> errors;
    for (const Scene::Receiver& r : scene.GetReceivers())
    {
      if (!r.Lit || lights.empty())
      {
        continue;
      }
      glm::dvec3 sure(0.0);
      glm::dvec3 unsure(0.0);
      auto add = [&](double level, const glm::dvec3& e)
      {
        sure += level >= 1.002 ? e : glm::dvec3(0.0);
        unsure += level > 0.998 && level < 1.002 ? e : glm::dvec3(0.0);
      };
      for (size_t i = 0; i < lights.size(); ++i)
      {
        const VirtualLight& light = lights[i];
        const glm::dvec3 toReceiver = r.Position - light.Position;
        const double d = glm::length(toReceiver);
        add(Brightest(light.DensityArea) / 3.14159265358979 *
            std::max(glm::dot(light.Normal, toReceiver), 0.0) / (d * d * d * low),
          Gather({ light }, r.Position, r.Normal));
        const int row = static_cast<int>(i);
        const glm::dvec3 flux = lobes.Color(1, row);
        const double strength =
          vtkIndirectKernels::vtkiSenderLobeStrength(vtkIndirectKernels::vec3(-toReceiver),
            vtkIndirectKernels::vec3(light.Normal), vtkIndirectKernels::vec3(lobes.Color(0, row)),
            lobes.At(0, row)[3], static_cast<float>(light.Area));
        const double level = d * strength * Brightest(flux) / low;
        const double cosine = glm::dot(r.Normal, -toReceiver) / d;
        const glm::dvec3 e = flux * (strength * std::max(cosine, 0.0) * d);
        add(level, e);
        inLobes += e.x;
        cutOfLobes += level < 1.0 ? e.x : 0.0;
      }
      AddErrors(image.Color(r.X, r.Y), sure, unsure, LeastOfLobes * largest, errors);
      ++receivers;
    }
    if (!errors.empty())
    {
      worst = std::max(worst, Percentile(errors, 0.99));
      std::printf(
        "       %s: 99th percentile %.2e\n", scene.Name.c_str(), Percentile(errors, 0.99));
    }
  }
  CheckAtLeast("receivers", receivers, 5000, "the test's own power");
  CheckAtLeast(
    "share of lobes' light that is cut off", cutOfLobes / inLobes, 0.02, "the test's own power");
  CheckAtMost("99th percentile of the relative error", worst, 2e-3,
    "rounding of floats, largest where walls meet, and of lobes' angles");
  ways.Check();
}

VTK_INDIRECT_TEST(LobesAllIsGather)
{
  // With a threshold of zero: eyes among splats and parallel ones, trees, depth maps and voxels.
  double worst[NumberOfSplatWays] = {};
  double least = 1e9;
  const double powers[] = { 0.0, 20.0, 128.0, -0.05 };
  for (int number = 0; number < 5; ++number)
  {
    SplattingFrame scene(300 + number, { 61, 47 }, static_cast<FrameLight>(number % 4));
    MakeAllSpecular(scene, powers[number % 4]);
    vtkNew<vtkLightTreeSampler> tree;
    tree->SetNumberOfLights(32);
    scene.Sampler->SetNumberOfLights(60);
    if (number % 3 == 1)
    {
      scene.Pass->SetSampler(tree);
    }
    scene.Pass->SetReflectiveShadowMapResolution(64);
    const int visibility[] = { vtkIndirectIlluminationPass::NONE, vtkIndirectIlluminationPass::MAPS,
      vtkIndirectIlluminationPass::NONE, vtkIndirectIlluminationPass::MAPS,
      vtkIndirectIlluminationPass::VOXELS };
    scene.Pass->SetVisibility(visibility[number]);
    if (number % 4 == 3)
    {
      scene.SetParallelEye(0.4);
    }
    const Image expected = scene.GatherAll();
    least = std::min(least, Sum(expected));
    scene.Splats->SetIntensityThreshold(0.0);
    for (int way = 0; way < NumberOfSplatWays; ++way)
    {
      const ImageError error =
        Compare(scene.SplatLights(static_cast<SplatWay>(way)), expected, Least);
      worst[way] = std::max(worst[way], error.Worst);
    }
  }
  CheckAtLeast("light in the darkest frame", least, 0.01, "the test's own power");
  for (int way = 0; way < NumberOfSplatWays; ++way)
  {
    CheckAtMost(
      std::string("worst difference to the gather, ") + GetName(static_cast<SplatWay>(way)),
      worst[way], 1e-5, "the order of sums");
  }
}

VTK_INDIRECT_TEST(LobesAroundTheEye)
{
  // Eyes within lobes' splats, and splats behind eyes and around them; parallel eyes that see
  // backwards.
  WaysAgainstTiles ways;
  int lit = 0;
  const double powers[] = { 2.0, 40.0, -0.3, -0.05 };
  for (int number = 0; number < 6; ++number)
  {
    SplattingFrame scene(300 + number, { 90, 70 }, static_cast<FrameLight>(number % 4));
    MakeAllSpecular(scene, powers[number % 4]);
    SetEyeAmongSplats(scene, number);
    scene.Splats->SetFarField(number % 2 == 0);
    lit += ways.AddThresholds(scene, { 2e-3, 2e-2, 0.5 }, Least);
  }
  CheckAtLeast("frames with light, of 18", lit, 14, "the test's own power");
  ways.Check();
}

VTK_INDIRECT_TEST(LobesInReceiversLobes)
{
  // Specular reflection of lights and of lobes by receivers, by lists of tiles: no light is lost.
  double all = 0.0;
  double lists = 0.0;
  double moved = 0.0;
  double drawn = 0.0;
  double least = 1e9;
  const double powers[] = { 0.0, 3.0, 40.0, 128.0, 20.0 };
  for (int number = 0; number < 5; ++number)
  {
    SplattingFrame scene(500 + number, { 61, 47 }, static_cast<FrameLight>(number % 4));
    MakeAllSpecular(scene, powers[number]);
    vtkNew<vtkLightTreeSampler> tree;
    tree->SetNumberOfLights(40);
    scene.Sampler->SetNumberOfLights(280);
    if (number % 3 == 2)
    {
      scene.Pass->SetSampler(tree);
    }
    scene.Pass->SetReflectiveShadowMapResolution(64);
    scene.Pass->SetVisibility(
      number == 1 ? vtkIndirectIlluminationPass::MAPS : vtkIndirectIlluminationPass::NONE);
    if (number == 3)
    {
      scene.SetParallelEye(0.4);
    }
    scene.GatherAll();
    const Image expected = scene.Copy("glossy");
    least = std::min(least, Sum(expected));
    for (double threshold : { 0.0, 0.02, 0.5 })
    {
      scene.Splats->SetIntensityThreshold(threshold);
      scene.SplatLights(SplatWay::TILES);
      const Image image = scene.Copy("glossy");
      const double worst = Compare(image, expected, 1e-2).Worst;
      all = std::max(all, threshold > 0.0 ? 0.0 : worst);
      lists = std::max(lists, worst);
      moved = std::max(moved, std::abs(Sum(image) / Sum(expected) - 1.0));
    }
    scene.SplatLights(SplatWay::ELLIPSOIDS);
    drawn = std::max(drawn, Compare(scene.Copy("glossy"), expected, 1e-2).Worst);
  }
  CheckAtLeast("glossy light in the darkest frame", least, 0.01, "the test's own power");
  CheckAtMost("worst difference to the gather's, all counting", all, 1e-5, "the order of sums");
  CheckAtMost("the same for any threshold", lists, 0.05, "lobes' tails; measured 0.041");
  CheckAtMost("largest change of the mean", moved, 2e-4, "the same; measured 1.2e-4");
  CheckAtMost("worst difference where splats are drawn", drawn, 1e-5, "the gather's own sums");
}

VTK_INDIRECT_TEST(LobesKeepMean)
{
  // The ring, which has only lights with narrow lobes.
  SplattingFrameOf<Scene> scene(96, 96);
  vtkNew<vtkCylinderSource> source;
  source->SetRadius(0.6);
  source->SetHeight(0.5);
  source->SetCenter(0, 0.251, 0);
  source->SetResolution(128);
  source->CappingOff();
  MakeSpecular(scene.AddSource(source, { 1, 1, 1 }), -0.25);
  scene.AddQuad({ -1.5, 0, -1.5 }, { -1.5, 0, 1.5 }, { 1.5, 0, -1.5 }, { 0.5, 0.5, 0.5 });
  scene.SetEye({ 0, 5, 0 }, { 0, 0, 0 }, { 0, 0, -1 }, 30, 3, 6);
  scene.SetParallelEye(1.2);
  scene.AddDirectional({ 1.0, -0.7, 0.0 });
  scene.Pass->SetReflectiveShadowMapResolution(128);
  scene.Pass->SetVisibilityToNone();
  vtkNew<vtkLightTreeSampler> tree;
  tree->SetNumberOfLights(1024);
  scene.Pass->SetSampler(tree);
  scene.Splats->SetFarFieldStep(4);
  scene.Splats->SetIntensityThreshold(0.0);
  const Image expected = scene.SplatLights(SplatWay::TILES);
  const double mean = Sum(expected);
  double last = 0.0;
  double splats = 0.0;
  double worst = 0.0;
  double rms = 0.0;
  for (double threshold : { 0.0, 0.003, 0.02, 0.1, 0.5 })
  {
    scene.Splats->SetIntensityThreshold(threshold);
    scene.Splats->FarFieldOff();
    const double cut = 1.0 - Sum(scene.SplatLights(SplatWay::TILES)) / mean;
    const double count = 256.0 * scene.Copy("splat.overdraw").Mean();
    scene.Splats->FarFieldOn();
    const Image image = scene.SplatLights(SplatWay::TILES);
    const double moved = Sum(image) / mean - 1.0;
    const ImageError error = Compare(image, expected, Least);
    std::printf("       %g: cut off %.4f (said to be %.4f), %.1f splats a pixel, mean %+.4f, "
                "RMSE %.4f\n",
      threshold, cut, scene.ReadCutOffShare(), count, moved, error.RootMeanSquare);
    worst = std::max(worst, std::abs(moved));
    CheckAtLeast("change of what is cut off for a greater threshold", cut - last, -1e-6,
      "it grows, but for rounding");
    if (threshold == 0.02)
    {
      rms = error.RootMeanSquare;
      CheckAtMost("splats a pixel by default, of those with all counting", count / splats, 0.6,
        "narrow lobes are left out where they are not; lights on the ground are near it");
    }
    splats = threshold == 0.0 ? count : splats;
    last = cut;
  }
  CheckAtLeast("largest share that is cut off", last, 0.1, "the test's own power");
  CheckAtMost("largest change of the mean with the far field", worst, 0.01,
    "mean brightness may not depend on the threshold");
  CheckAtMost("RMSE over the mean by default", rms, 0.05, "the far field's interpolation");
}

VTK_INDIRECT_TEST(LobesOfExtremes)
{
  // Matt to mirrors, light along the plate, and lights that touch the wall they light.
  for (const double power : { 0.0, 1.0, 128.0, 1e6, -1.0, -0.05, -0.01, 0.01 })
  {
    for (const glm::dvec3& direction : { glm::dvec3(1, -1e-3, 0), glm::dvec3(0.5, -1, 0) })
    {
      Corner scene;
      MakeSpecular(scene.Plate, power);
      scene.AddDirectional(direction);
      const Image expected = scene.GatherAll();
      for (int way = 0; way < NumberOfSplatWays; ++way)
      {
        scene.Splats->SetIntensityThreshold(0.0);
        char name[80];
        std::snprintf(name, sizeof(name), "power %g, light %g up, %s", power, -direction.y,
          GetName(static_cast<SplatWay>(way)));
        CheckAtMost(std::string(name) + ": worst difference to the gather, all counting",
          Compare(scene.SplatLights(static_cast<SplatWay>(way)), expected, Least).Worst, 1e-5,
          "the order of sums");
        scene.Splats->SetIntensityThreshold(0.02);
        scene.Splats->SetFarFieldStep(2);
        const Image image = scene.SplatLights(static_cast<SplatWay>(way));
        Check("all of it finite", IsFinite(image));
        CheckRelative(std::string(name) + ": mean by default", Sum(image), Sum(expected), 0.02,
          "the far field's interpolation, in a small image");
      }
    }
  }
}

VTK_INDIRECT_TEST(LobesOfAnyScale)
{
  Image one;
  for (const double scale : { 1.0, 1e-9, 1e6 })
  {
    Corner scene(scale);
    MakeSpecular(scene.Plate, 128.0);
    scene.AddDirectional({ 0.5, -1, 0 });
    scene.Splats->SetFarFieldStep(2);
    for (int way = 0; way < NumberOfSplatWays; ++way)
    {
      const Image image = scene.SplatLights(static_cast<SplatWay>(way));
      one = scale == 1.0 && way == 0 ? image : one;
      CheckAtMost(std::string(GetName(static_cast<SplatWay>(way))) +
          ": worst difference to a scene of one unit",
        Compare(image, one, 1e-3).Worst, 5e-3,
        "places are rounded, and what is about to count differs by it");
    }
  }
}

VTK_INDIRECT_TEST(LobesOfNothing)
{
  Corner scene;
  for (vtkActor* actor : { scene.Plate, scene.Wall })
  {
    MakeSpecular(actor, -0.3);
    actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  }
  scene.AddDirectional({ 0.5, -1, 0 });
  for (int way = 0; way < NumberOfSplatWays; ++way)
  {
    const Image image = scene.SplatLights(static_cast<SplatWay>(way));
    Check("all of it finite", IsFinite(image));
    CheckAtMost(std::string(GetName(static_cast<SplatWay>(way))) + ": light of black metal",
      Sum(image), 1e-5, "VTK's black metal has an F0 of zero, and Schlick's grazing light");
  }
}

VTK_INDIRECT_TEST(LobesOfAThousandLightsInAPixel)
{
  for (int way = 0; way < NumberOfSplatWays; ++way)
  {
    SplattingFrame scene(4, { 5, 5 }, FrameLight::POINT);
    MakeAllSpecular(scene, 40.0);
    scene.SetEye({ 300, 200, 300 }, { 0.4, 0.2, 0.4 }, { 0, 1, 0 }, 1.0, 1.0, 1e4);
    scene.Sampler->SetNumberOfLights(1000);
    const Image expected = scene.GatherAll();
    scene.Splats->SetIntensityThreshold(1e-3);
    const Image image = scene.SplatLights(static_cast<SplatWay>(way));
    const std::string name = GetName(static_cast<SplatWay>(way));
    CheckAtLeast(name + ": sum over the image", Sum(expected), 1e-3, "the test's own power");
    CheckRelative(name + ": the same by splats", Sum(image), Sum(expected), 0.05,
      "one sample of the far field for all surfaces of a pixel");
  }
}
