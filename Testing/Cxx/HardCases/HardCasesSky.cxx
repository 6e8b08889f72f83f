// SPDX-License-Identifier: BSD-3-Clause
// Light of the sky that surfaces reflect, in scenes of any size, on black surfaces, and under skies
// that change in every frame.
#include "vtkIndirectHardCase.h"

#include "vtkActor.h"
#include "vtkEnvironmentLight.h"
#include "vtkIndirectIlluminationPass.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLightKit.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"

#include <cmath>
#include <functional>
#include <map>

using namespace vtkIndirectTest;

namespace
{
// Renders once with every estimator that works without a light's map.
void ForEstimators(HardCase& scene, const std::function<void(const EstimatorEntry&)>& check)
{
  for (const EstimatorEntry& estimator : GetEstimators())
  {
    estimator.Install(scene.Pass, 64);
    scene.Render();
    scene.CheckBuffers(0);
    check(estimator);
  }
}

// Means of `bounce` by estimator. No number here is round: see HardCases.Scale.
std::map<std::string, double> MeasureAt(double scale, double radiance)
{
  HardCase scene("a sky");
  auto at = [&](double x, double y, double z) { return scale * glm::dvec3(x, y, z); };
  scene.AddQuad(at(0, 0, 0), at(0, 0, 1.013), at(1.037, 0, 0), Albedo);
  scene.AddQuad(at(0, 0, 0), at(0, 0.981, 0), at(0, 0, 1.013), Albedo);
  scene.AddSphere(at(0.6123, 0.2571, 0.5317), 0.2013 * scale, 32, Albedo);
  scene.SetEye(at(2.213, 1.617, 2.331), at(0.417, 0.313, 0.433), { 0, 1, 0 }, 32, scale, 6 * scale);
  vtkNew<vtkEnvironmentLight> sky;
  sky->SetRadiance(radiance, radiance, radiance);
  scene.Pass->SetEnvironment(sky);
  std::map<std::string, double> means;
  ForEstimators(scene,
    [&](const EstimatorEntry& estimator)
    { means[estimator.Name] = scene.Copy("bounce").Mean() / radiance; });
  return means;
}
}

VTK_INDIRECT_TEST(SkyScale)
{
  const std::map<std::string, double> expected = MeasureAt(1.0, 1.0);
  for (const auto& entry : expected)
  {
    Check(entry.first + ": something is reflected", entry.second > 0.01);
  }
  struct Case
  {
    double Scale;
    double Radiance;
  };
  for (const Case& c : { Case{ 1e-6, 1.0 }, Case{ 1e6, 1.0 }, Case{ 1.0, 1e-6 }, Case{ 1.0, 1e6 } })
  {
    const std::map<std::string, double> means = MeasureAt(c.Scale, c.Radiance);
    for (const auto& entry : expected)
    {
      // Rounding decides texels of outlines, and clusters with them.
      const double tolerance = c.Scale == 1.0 ? 1e-3 : 0.01;
      CheckRelative(entry.first + ": mean at scale " + std::to_string(c.Scale) + ", radiance " +
          std::to_string(c.Radiance),
        means.at(entry.first), entry.second, tolerance, "half floats; single texels of outlines");
    }
  }
}

VTK_INDIRECT_TEST(SkyOverNothing)
{
  vtkNew<vtkEnvironmentLight> sky;
  {
    HardCase scene("black surfaces");
    scene.AddCorner(glm::dvec3(0.0));
    scene.Pass->SetEnvironment(sky);
    ForEstimators(scene,
      [&](const EstimatorEntry&)
      {
        CheckEqual("largest bounce", GetLargest(scene.Copy("bounce")), 0.0);
        Check("the sky lights them", GetLargest(scene.Copy("sky")) > 0.5);
      });
  }
  {
    HardCase scene("surfaces that send nothing");
    scene.AddCorner(Albedo);
    vtkPropCollection* props = scene.Renderer->GetViewProps();
    for (int i = 0; i < props->GetNumberOfItems(); ++i)
    {
      vtkNew<vtkInformation> keys;
      keys->Set(vtkIndirectIlluminationPass::SENDS_LIGHT(), 0);
      vtkProp::SafeDownCast(props->GetItemAsObject(i))->SetPropertyKeys(keys);
    }
    scene.Pass->SetEnvironment(sky);
    ForEstimators(scene,
      [&](const EstimatorEntry&)
      { CheckEqual("largest bounce", GetLargest(scene.Copy("bounce")), 0.0); });
  }
  {
    HardCase scene("a black sky");
    scene.AddCorner(Albedo);
    vtkNew<vtkEnvironmentLight> black;
    black->SetRadiance(0.0, 0.0, 0.0);
    scene.Pass->SetEnvironment(black);
    scene.AddDirectional({ -1, -2, -1.5 });
    ForEstimators(scene,
      [&](const EstimatorEntry&)
      { CheckEqual("largest of the sky", GetLargest(scene.Copy("sky")), 0.0); });
  }
  {
    HardCase scene("one point");
    vtkActor* quad = scene.AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, Albedo);
    quad->SetScale(1e-30);
    scene.Pass->SetEnvironment(sky);
    scene.Render();
  }
  {
    HardCase scene("nothing that casts shadows");
    vtkActor* quad = scene.AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, Albedo);
    quad->GetProperty()->SetOpacity(0.5);
    scene.Pass->SetEnvironment(sky);
    scene.Render();
    Check("the delegate alone draws",
      scene.Pass->GetReport().find("nothing opaque is visible") != std::string::npos);
    quad->GetProperty()->SetOpacity(1.0);
    scene.Render();
    scene.CheckBuffers(0);
  }
}

// VTK's light kit beside a sky: their light adds up.
VTK_INDIRECT_TEST(SkyBesideALightKit)
{
  Image images[3]; // the sky's, the kit's, both
  for (int which = 0; which < 3; ++which)
  {
    HardCase scene("a light kit and a sky");
    scene.AddCorner(Albedo);
    vtkNew<vtkEnvironmentLight> sky;
    scene.Pass->SetEnvironment(which != 1 ? sky.Get() : nullptr);
    vtkNew<vtkLightKit> kit;
    if (which != 0)
    {
      kit->AddLightsToRenderer(scene.Renderer);
      kit->Update();
    }
    GetEstimators()[3].Install(scene.Pass, 64);
    scene.Render();
    scene.CheckBuffers(which != 0 ? 5 : 0);
    images[which] = scene.Copy("bounce");
    Check("there is a bounce", images[which].Mean() > 1e-4);
  }
  Image sum = images[0];
  for (size_t i = 0; i < sum.Values.size(); ++i)
  {
    sum.Values[i] += images[1].Values[i];
  }
  CheckAtMost("share of pixels that are not the sum", GetShareOfDifferent(images[2], sum, 1e-4),
    0.0, "the order of a sum of floats");
}

// Another sky in every frame: its light equals that of a scene with only this sky.
VTK_INDIRECT_TEST(SkyOfEveryFrame)
{
  HardCase scene("a sky that changes");
  scene.AddCorner(Albedo);
  vtkNew<vtkEnvironmentLight> sky;
  scene.Pass->SetEnvironment(sky);
  const EstimatorEntry& estimator = GetEstimators()[3];
  estimator.Install(scene.Pass, 64);
  for (int frame = 0; frame < 6; ++frame)
  {
    const double radiance = std::pow(10.0, frame - 3);
    sky->SetRadiance(radiance, 0.5 * radiance, frame == 4 ? 0.0 : radiance);
    sky->SetUp(std::sin(frame), std::cos(frame), 0.3);
    scene.Render();
    scene.CheckBuffers(0);
    const Image changed = scene.Copy("bounce");
    HardCase fresh("that sky alone");
    fresh.AddCorner(Albedo);
    fresh.Pass->SetEnvironment(sky);
    estimator.Install(fresh.Pass, 64);
    fresh.Render();
    CheckAtMost("share of pixels that are otherwise in a new scene",
      GetShareOfDifferent(changed, fresh.Copy("bounce"), 1e-5), 0.0, "the same sums");
  }
}
