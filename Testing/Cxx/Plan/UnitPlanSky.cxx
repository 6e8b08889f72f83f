// SPDX-License-Identifier: BSD-3-Clause
// Decisions about the sky of a frame from plain facts.
#include "vtkIndirectTestUtilities.h"

#include "vtkIndirectPlanScene.h"

#include <string>

using namespace vtkIndirectTest;

// Surfaces reflect the sky's light, with and without lights.
VTK_INDIRECT_TEST(PlanSky)
{
  const std::string bounces = "bounces of light from the sky";
  vtkIndirectCircumstances sky;
  sky.Environment = true;
  sky.EnvironmentIrradiance = 3.0;
  vtkIndirectPlan plan = vtkIndirectPlan::Make(MakeFrame({}), {}, {}, sky);
  CheckEqual("senders of a sky alone", plan.Senders, vtkIndirectPlan::NO_SENDERS);
  Check("it is reflected", plan.Sky && plan.SkyBounces && plan.Irradiance);
  Check("nothing of it is left out", Find(plan.LeftOut, bounces).empty());
  CheckEqual("its unit", plan.IrradianceUnit, 4.0);
  plan = vtkIndirectPlan::Make(MakeFrame({ MakeLight(20.0) }), {}, {}, sky);
  Check("beside a light", plan.SkyBounces && plan.Senders == vtkIndirectPlan::MAPS);
  CheckEqual("the stronger's unit", plan.IrradianceUnit, 32.0);
  plan = vtkIndirectPlan::Make(MakeFrame({ MakeHeadlight() }), {}, {}, sky);
  Check("beside a headlight", plan.SkyBounces && plan.Senders == vtkIndirectPlan::HEADLIGHT);
  plan = vtkIndirectPlan::Make(MakeFrame({ MakeLight(0.0) }), {}, {}, sky);
  Check("beside a dark light", plan.SkyBounces && plan.Irradiance);

  vtkIndirectAbilities reader;
  reader.Name = "it";
  reader.ReadsMaps = true;
  plan = vtkIndirectPlan::Make(MakeFrame({ MakeLight() }), {}, reader, sky);
  Check("not by an estimator that reads the lights' maps",
    plan.Sky && !plan.SkyBounces && Find(plan.LeftOut, bounces).find("it reads") == 0);
  CheckEqual("then its unit is the light's", plan.IrradianceUnit, 1.0);
  Check("which has none where there are no maps",
    vtkIndirectPlan::Make(MakeFrame({}), {}, reader, sky).SkyBounces);

  vtkIndirectSettings settings;
  settings.IndirectScale = 0.0;
  plan = vtkIndirectPlan::Make(MakeFrame({}), settings, {}, sky);
  Check("not where IndirectScale is 0", !plan.Sky && !plan.SkyBounces && !plan.Irradiance);
  Check(
    "not without a sky", !vtkIndirectPlan::Make(MakeFrame({ MakeLight() }), {}, {}, {}).SkyBounces);
}

// A pixel is to see as many directions through an opening as in the open.
VTK_INDIRECT_TEST(PlanDirectionsOfAnOpening)
{
  vtkIndirectPlan plan;
  for (const double share : { 1.0, 0.7, 0.3, 0.18 })
  {
    CheckEqual("the plan's number suffices", plan.FindDirectionsOfOpening(share), 0);
  }
  CheckEqual("less than a quarter of the share", plan.FindDirectionsOfOpening(0.174), 2048);
  CheckEqual("an eighth", plan.FindDirectionsOfOpening(0.09), 2048);
  CheckEqual("a pinhole", plan.FindDirectionsOfOpening(1e-6), 8192);
  plan.NumberOfStillSkyDirections = 64;
  CheckEqual("of a weak sky", plan.FindDirectionsOfOpening(0.08), 1024);
}

// The source of the sky; the estimator keeps the lights.
VTK_INDIRECT_TEST(PlanSkySource)
{
  vtkIndirectCircumstances sky;
  sky.Environment = true;
  sky.EnvironmentIrradiance = 3.0;
  vtkIndirectPlan plan = vtkIndirectPlan::Make(MakeFrame({ MakeLight() }), {}, {}, sky);
  CheckEqual("of what stands", plan.SkySource, vtkIndirectPlan::SKY_BY_MAPS);
  Check("by depth maps", plan.HasSkyMaps() && !Find(plan.Modelled, "sky by depth maps").empty());
  const vtkIndirectKey key = plan.MakeKey(MakeFrame({ MakeLight() }));

  sky.SpheresMove = "7 spheres have moved";
  plan = vtkIndirectPlan::Make(MakeFrame({ MakeLight() }), {}, {}, sky);
  CheckEqual("of what moves", plan.SkySource, vtkIndirectPlan::SKY_BY_SPHERES);
  Check("spheres send its light, and no virtual lights",
    plan.SpheresBounceSky && !plan.SkyBounces && !plan.HasSkyMaps());
  Check("the light is the estimator's",
    plan.Irradiance && plan.Shadows && plan.Senders == vtkIndirectPlan::MAPS);
  CheckEqual("whose unit is the light's", plan.IrradianceUnit, 1.0);
  Check("the report says why", Find(plan.Modelled, "sky by spheres").find("7 spheres") == 0);
  Check("another key", plan.MakeKey(MakeFrame({ MakeLight() })) != key);
  plan = vtkIndirectPlan::Make(MakeFrame({}), {}, {}, sky);
  Check("without a light there is nothing to estimate",
    !plan.Irradiance && plan.WhyNoIrradiance.empty() && plan.SpheresBounceSky);

  vtkIndirectAbilities reader;
  reader.ReadsMaps = true;
  plan = vtkIndirectPlan::Make(MakeFrame({ MakeLight() }), {}, reader, sky);
  Check("what is reflected does not depend on who makes the sky",
    plan.SkySource == vtkIndirectPlan::SKY_BY_SPHERES && !plan.SpheresBounceSky);
  vtkIndirectAbilities summer;
  summer.SumsSky = true;
  plan = vtkIndirectPlan::Make(MakeFrame({ MakeLight() }), {}, summer, sky);
  Check("an estimator that sums the sky",
    plan.SkySource == vtkIndirectPlan::SKY_BY_ESTIMATOR && !plan.Irradiance &&
      plan.WhyNoIrradiance.empty() && !plan.SkyBounces);
  sky.SpheresFail = "one is a cube";
  plan = vtkIndirectPlan::Make(MakeFrame({ MakeLight() }), {}, {}, sky);
  Check("not where spheres cannot stand for all",
    plan.HasSkyMaps() &&
      Find(plan.Modelled, "sky by depth maps").find("a cube") != std::string::npos);
  sky.SpheresFail.clear();
  for (int i = 0; i < 4; ++i)
  {
    vtkIndirectSettings settings;
    settings.SpheresInMotion = i != 0;
    settings.Caching = i != 1;
    settings.ErrorTolerance = i == 2 ? 0.02 : 0.0;
    settings.Visibility = i == 3 ? vtkIndirectVisibilityNone : vtkIndirectVisibilityAutomatic;
    plan = vtkIndirectPlan::Make(MakeFrame({ MakeLight() }), settings, {}, sky);
    CheckEqual("nor where a setting says otherwise", plan.SkySource, vtkIndirectPlan::SKY_BY_MAPS);
  }
}

// VTK's own light of the renderer's texture is replaced, not doubled.
VTK_INDIRECT_TEST(PlanImageBasedLighting)
{
  for (const bool environment : { false, true })
  {
    for (const bool images : { false, true })
    {
      for (const double scale : { 0.0, 1.0 })
      {
        vtkIndirectCircumstances circumstances;
        circumstances.Environment = environment;
        circumstances.ImageBasedLighting = images;
        vtkIndirectSettings settings;
        settings.IndirectScale = scale;
        const vtkIndirectPlan plan =
          vtkIndirectPlan::Make(MakeFrame({ MakeLight() }), settings, {}, circumstances);
        const bool replaced = environment && images && scale > 0.0;
        Check("replaced", plan.ReplacesImageLight == replaced);
        Check("said", Find(plan.LeftOut, "specular environment light").empty() != replaced);
        Check("left out", Find(plan.LeftOut, "environment light").empty() == (!images || replaced));
      }
    }
  }
}

// Moving frames sum a quarter of a still frame's directions, sixteen or thirty-two at a pixel.
VTK_INDIRECT_TEST(PlanSkyDirections)
{
  struct Case
  {
    double Tolerance;
    int Still;
    int Moving;
    int Block; // in a moving frame
  };
  const Case cases[] = { { 0.0, 256, 64, 2 }, { 1.0, 16, 16, 1 }, { 0.25, 32, 16, 1 },
    { 0.1, 64, 16, 1 }, { 0.06, 128, 32, 1 }, { 0.05, 256, 64, 2 }, { 0.035, 256, 64, 2 },
    { 0.021, 512, 128, 2 }, { 0.02, 1024, 256, 4 }, { 1e-6, 1024, 256, 4 } };
  vtkIndirectCircumstances circumstances;
  circumstances.Environment = true;
  for (const Case& one : cases)
  {
    const std::string name = "tolerance " + std::to_string(one.Tolerance);
    vtkIndirectSettings settings;
    settings.ErrorTolerance = one.Tolerance;
    for (const bool moving : { false, true })
    {
      circumstances.UpdateRate = moving ? 15.0 : 0.0001;
      const vtkIndirectPlan plan =
        vtkIndirectPlan::Make(MakeFrame({}), settings, {}, circumstances);
      Check(name + ": a sky", plan.Sky);
      CheckEqual(
        name + ": directions", plan.NumberOfSkyDirections, moving ? one.Moving : one.Still);
      CheckEqual(name + ": of a still frame", plan.NumberOfStillSkyDirections, one.Still);
      CheckEqual(name + ": block", plan.SkyBlock, moving ? one.Block : 1);
      const double aim = one.Tolerance > 0.0 ? one.Tolerance : 0.035;
      CheckEqual(name + ": in force", plan.SkyErrorTolerance, aim);
    }
  }
}

// Light that nothing hides leaves a sky a smaller share, and errors of a share count less.
VTK_INDIRECT_TEST(PlanSkyBesideFills)
{
  vtkIndirectCircumstances sky;
  sky.Environment = true;
  sky.EnvironmentIrradiance = 0.25;
  vtkIndirectLight fill = MakeLight(0.75);
  fill.Fill = true;
  vtkIndirectSettings settings;
  auto make = [&](const std::vector<vtkIndirectLight>& lights, double rate)
  {
    sky.UpdateRate = rate;
    return vtkIndirectPlan::Make(MakeFrame(lights), settings, {}, sky);
  };
  CheckEqual("alone", make({}, 0.0001).NumberOfSkyDirections, 256);
  CheckEqual(
    "beside a light with shadows", make({ MakeLight() }, 0.0001).NumberOfSkyDirections, 256);
  CheckEqual("a quarter of all light", make({ fill }, 0.0001).NumberOfSkyDirections, 64);
  CheckEqual("as many as of a moving frame", make({ fill }, 15.0).NumberOfSkyDirections, 64);
  fill.Color = glm::dvec3(0.25);
  const vtkIndirectPlan half = make({ fill }, 0.0001);
  CheckEqual("a half", half.NumberOfSkyDirections, 128);
  CheckRelative("its tolerance", half.SkyErrorTolerance, 0.07, 1e-12, "rounding");
  fill.Color = glm::dvec3(100.0);
  CheckEqual("at least", make({ fill }, 0.0001).NumberOfSkyDirections, 64);
  settings.ErrorTolerance = 0.035;
  CheckEqual("a tolerance that is set holds", make({ fill }, 0.0001).NumberOfSkyDirections, 256);
}
