// SPDX-License-Identifier: BSD-3-Clause
// Decisions about a frame from plain facts.
#include "vtkIndirectTestUtilities.h"

#include "vtkIndirectPlanScene.h"

#include "vtkLightCollection.h"
#include "vtkNew.h"
#include <algorithm>

#include <string>

using namespace vtkIndirectTest;

// At most one filter works on edges: the renderer's if the user has chosen it.
VTK_INDIRECT_TEST(PlanAntialiasing)
{
  const vtkIndirectFrame frame = MakeFrame({ MakeLight() });
  const std::string what = "antialiased edges";
  vtkIndirectSettings settings;
  vtkIndirectPlan plan = vtkIndirectPlan::Make(frame, settings, {}, {});
  Check("by default", plan.Antialiasing);
  Check(
    "the report says so", !Find(plan.Modelled, what).empty() && Find(plan.LeftOut, what).empty());
  vtkIndirectCircumstances circumstances;
  circumstances.OtherAntialiasing = "the renderer's FXAA";
  plan = vtkIndirectPlan::Make(frame, settings, {}, circumstances);
  Check("not beside the renderer's FXAA", !plan.Antialiasing && Find(plan.Modelled, what).empty());
  Check("which is the reason", Find(plan.LeftOut, what).find("FXAA") != std::string::npos);
  settings.Antialiasing = false;
  for (const char* other : { "", "vtkSSAAPass" })
  {
    circumstances.OtherAntialiasing = other;
    plan = vtkIndirectPlan::Make(frame, settings, {}, circumstances);
    Check("not where it is off", !plan.Antialiasing && Find(plan.Modelled, what).empty());
    Check("which is the reason", Find(plan.LeftOut, what) == "Antialiasing is off");
  }
  // The irradiance does not depend on this setting.
  Check("no part of the key",
    plan.MakeKey(frame) == vtkIndirectPlan::Make(frame, {}, {}, {}).MakeKey(frame));
  settings = vtkIndirectSettings();
  plan = vtkIndirectPlan::Make(MakeFrame({}), settings, {}, {});
  Check("not where the delegate alone draws",
    !plan.Antialiasing && Find(plan.Modelled, what).empty() && Find(plan.LeftOut, what).empty());
}

VTK_INDIRECT_TEST(PlanDelegateAlone)
{
  const vtkIndirectFrame frame = MakeFrame({ MakeLight() });
  auto why = [](const vtkIndirectFrame& facts, const vtkIndirectSettings& settings = {},
               const vtkIndirectCircumstances& circumstances = {})
  {
    const vtkIndirectPlan plan = vtkIndirectPlan::Make(facts, settings, {}, circumstances);
    Check("nothing is drawn besides: " + plan.WhyDelegate,
      plan.WhyDelegate.empty() || (!plan.Irradiance && !plan.Shadows && plan.MapLights.empty()));
    return plan.WhyDelegate;
  };
  Check("a lit scene is modelled", why(frame).empty());
  vtkIndirectFrame other = frame;
  other.Size[0] = 0;
  Check("an empty viewport", why(other) == "the viewport is empty");
  other = frame;
  other.Casters.clear();
  Check("nothing opaque", why(other) == "nothing opaque is visible");
  Check("no light", why(MakeFrame({})) == "no light is on");
  vtkIndirectCircumstances emitter;
  emitter.NumberOfOtherEmitters = 1;
  Check("no vtkLight, but light from elsewhere", why(MakeFrame({}), {}, emitter).empty());
  vtkIndirectCircumstances refused;
  refused.DelegateIsRefused = "because";
  Check("a delegate without surfaces", why(frame, {}, refused) == "because");
  vtkIndirectSettings settings;
  settings.IndirectScale = 0.0;
  Check("no indirect light, but shadows", why(frame, settings).empty());
  settings.Shadows = false;
  Check("neither", why(frame, settings) == "IndirectScale is 0 and Shadows are off");
}

VTK_INDIRECT_TEST(PlanSenders)
{
  auto make = [](const vtkIndirectFrame& frame, const vtkIndirectSettings& settings = {})
  { return vtkIndirectPlan::Make(frame, settings, {}, {}); };
  vtkIndirectPlan plan = make(MakeFrame({ MakeLight(), MakeLight(0.0), MakeLight(2.0) }));
  CheckEqual("senders of lights", plan.Senders, vtkIndirectPlan::MAPS);
  CheckEqual("lights with maps", static_cast<double>(plan.MapLights.size()), 2);
  Check("the first and the third", plan.MapLights == std::vector<int>{ 0, 2 });
  Check("the second is left out", Find(plan.LeftOut, "light 1") == "it emits nothing");
  Check("shadows", plan.Shadows);
  Check("irradiance", plan.Irradiance);

  plan = make(MakeFrame({ MakeLight(0.0) }));
  CheckEqual("senders of a dark light", plan.Senders, vtkIndirectPlan::NO_SENDERS);
  Check("no shadows", !plan.Shadows);
  Check("no irradiance",
    !plan.Irradiance && Find(plan.LeftOut, "indirect light") == "no light emits anything");
  // Points under a sky receive its light and send none.
  vtkIndirectFrame points = MakeFrame({ MakeLight() });
  points.Casters.clear();
  points.NumberOfOtherReceivers = 1;
  vtkIndirectCircumstances sky;
  sky.Environment = true;
  sky.EnvironmentIrradiance = 1.0;
  plan = vtkIndirectPlan::Make(points, {}, {}, sky);
  Check("nothing that sends light",
    !plan.Irradiance && Find(plan.LeftOut, "indirect light") == "no surface sends light");

  plan = make(MakeFrame({ MakeHeadlight() }));
  CheckEqual("senders of a headlight", plan.Senders, vtkIndirectPlan::HEADLIGHT);
  Check("it has no map", plan.MapLights.empty() && !plan.Shadows && plan.Irradiance);
  Check("what is off screen is left out", !Find(plan.LeftOut, "senders outside the view").empty());
  vtkIndirectFrame frame = MakeFrame({ MakeHeadlight() });
  frame.AllSendLight = false;
  CheckEqual("a headlight where a prop is not to send", make(frame).Senders, vtkIndirectPlan::MAPS);
  frame = MakeFrame({ MakeHeadlight() });
  frame.Lights[0].Positional = true;
  CheckEqual("a positional headlight", make(frame).Senders, vtkIndirectPlan::MAPS);
  CheckEqual("a headlight and another light",
    make(MakeFrame({ MakeHeadlight(), MakeLight() })).Senders, vtkIndirectPlan::MAPS);

  frame = MakeFrame({ MakeHeadlight() });
  frame.Lights[0].Fill = true;
  CheckEqual("a light that nothing hides", make(frame).Senders, vtkIndirectPlan::NO_SENDERS);
  frame = MakeFrame({ MakeLight(), MakeLight() });
  frame.Lights[0].Fill = true;
  Check("it has no map beside another", make(frame).MapLights == std::vector<int>{ 1 });

  vtkIndirectSettings settings;
  settings.Shadows = false;
  plan = make(MakeFrame({ MakeLight() }), settings);
  Check(
    "without Shadows there are maps, and no look-ups", !plan.Shadows && plan.MapLights.size() == 1);
  settings = {};
  settings.IndirectScale = 0.0;
  plan = make(MakeFrame({ MakeLight() }), settings);
  Check("with IndirectScale 0 there are shadows alone",
    plan.Shadows && !plan.Irradiance && plan.WhyNoIrradiance == "IndirectScale is 0");
}

// Maps are as fine as the frame's pixels where shadows are looked up and no estimator sums texels.
VTK_INDIRECT_TEST(PlanMapTexels)
{
  vtkIndirectFrame frame = MakeFrame({ MakeLight() });
  vtkIndirectAbilities lights;
  lights.TakesSampler = true;
  auto find = [&frame](int width, int height, bool shadows, const vtkIndirectAbilities& estimator)
  {
    frame.Size[0] = width;
    frame.Size[1] = height;
    vtkIndirectSettings settings;
    settings.Shadows = shadows;
    return vtkIndirectPlan::Make(frame, settings, estimator, {}).MapTexels;
  };
  CheckEqual("a small frame", find(384, 64, true, lights), 512);
  CheckEqual("a frame of middle size", find(64, 385, true, lights), 1024);
  CheckEqual("a larger one", find(455, 64, true, lights), 1024);
  CheckEqual("a tall one", find(64, 456, true, lights), 2048);
  CheckEqual("a large one", find(1920, 1080, true, lights), 2048);
  CheckEqual("no more", find(3840, 2160, true, lights), 2048);
  CheckEqual("without shadows", find(1920, 1080, false, lights), 512);
  CheckEqual("an estimator that sums texels", find(1920, 1080, true, {}), 512);
}

VTK_INDIRECT_TEST(PlanBuffers)
{
  vtkIndirectFrame frame = MakeFrame({ MakeLight() });
  vtkIndirectAbilities glossy;
  glossy.ComputesGlossy = true;
  vtkIndirectCircumstances circumstances;
  vtkIndirectPlan plan = vtkIndirectPlan::Make(frame, {}, glossy, {});
  Check("albedo in alpha where all covers fully", plan.AlbedoInAlpha && !plan.Specular);
  Check("no receiver is specular",
    Find(plan.EstimateLeftOut, "specular indirect light").find("no receiver") != std::string::npos);
  circumstances.OwnDelegate = true;
  plan = vtkIndirectPlan::Make(frame, {}, glossy, circumstances);
  Check("not under a delegate of the user's", !plan.AlbedoInAlpha);
  frame.CoversFully = false;
  Check(
    "not where something is blended", !vtkIndirectPlan::Make(frame, {}, glossy, {}).AlbedoInAlpha);
  frame.CoversFully = frame.Specular = true;
  plan = vtkIndirectPlan::Make(frame, {}, glossy, {});
  Check("specular receivers have a channel of their own", plan.Specular && !plan.AlbedoInAlpha);
  Check("an estimator that takes receivers as diffuse",
    !vtkIndirectPlan::Make(frame, {}, {}, {}).Specular);
  glossy.SpecularTransport = false;
  plan = vtkIndirectPlan::Make(frame, {}, glossy, {});
  Check("SpecularTransport off",
    !plan.Specular &&
      Find(plan.EstimateLeftOut, "specular indirect light") == "SpecularTransport is off");
  vtkIndirectSettings settings;
  settings.IndirectScale = 0.0;
  glossy.SpecularTransport = true;
  Check("IndirectScale 0", !vtkIndirectPlan::Make(frame, settings, glossy, {}).Specular);
}

// Area lights in specular lobes, and visible ones.
VTK_INDIRECT_TEST(PlanAreaLights)
{
  vtkIndirectFrame frame = MakeFrame({ MakeLight() });
  vtkIndirectCircumstances circumstances;
  circumstances.AreaLights = true;
  vtkIndirectPlan plan = vtkIndirectPlan::Make(frame, {}, {}, circumstances);
  Check("no receiver is specular",
    !plan.AreaSpecular && !plan.SurfacesAreSpecular && plan.AlbedoInAlpha);
  CheckEqual("none is seen", plan.VisibleAreaLights, 0);
  frame.Specular = true;
  plan = vtkIndirectPlan::Make(frame, {}, {}, circumstances);
  Check("whatever the estimator does",
    plan.AreaSpecular && plan.SurfacesAreSpecular && !plan.Specular && !plan.AlbedoInAlpha);
  Check("without area lights", !vtkIndirectPlan::Make(frame, {}, {}, {}).SurfacesAreSpecular);
  frame.Specular = false;
  frame.PhysicallyBased = true;
  plan = vtkIndirectPlan::Make(frame, {}, {}, circumstances);
  Check("PBR",
    plan.AreaSpecular && !plan.Specular &&
      Find(plan.Modelled, "area lights in specular lobes").find("PBR") != std::string::npos);
  vtkIndirectSettings settings;
  settings.IndirectScale = 0.0;
  circumstances.VisibleAreaLights = 2;
  plan = vtkIndirectPlan::Make(frame, settings, {}, circumstances);
  Check("IndirectScale 0", !plan.AreaSpecular);
  CheckEqual("they are seen all the same", plan.VisibleAreaLights, 2);
}

// Area lights are virtual lights where their Method says so, or is automatic with a paper's preset.
VTK_INDIRECT_TEST(PlanVirtualAreaLights)
{
  const vtkIndirectFrame frame = MakeFrame({ MakeLight() });
  vtkIndirectCircumstances circumstances;
  circumstances.AreaLights = true;
  circumstances.AutomaticAreaLights = true;
  vtkIndirectAbilities estimator;
  auto make = [&]() { return vtkIndirectPlan::Make(frame, {}, estimator, circumstances); };
  Check("automatic", make().AreaLights && !make().VirtualAreaLights);
  circumstances.VirtualAreaLights = true;
  Check("some of them", make().AreaLights && make().VirtualAreaLights);
  Check("but no automatic ones", !make().AutomaticAreaLightsAreVirtual);
  estimator.IsOfPaper = true;
  Check("all of a paper's",
    !make().AreaLights && make().VirtualAreaLights && make().AutomaticAreaLightsAreVirtual);
  circumstances.ClosedAreaLights = true;
  Check("but those of closed form", make().AreaLights && make().VirtualAreaLights);
  estimator.ReadsMaps = true;
  Check("none beside maps that are read", make().AreaLights && !make().VirtualAreaLights);
  Check("as the report says", !Find(make().LeftOut, "area lights as virtual lights").empty());
}

// The estimator resolves automatic visibility, and the user's choice has priority.
VTK_INDIRECT_TEST(PlanVisibility)
{
  const vtkIndirectFrame frame = MakeFrame({ MakeLight() });
  vtkIndirectSettings settings;
  vtkIndirectAbilities estimator;
  auto visibility = [&]()
  { return vtkIndirectPlan::Make(frame, settings, estimator, {}).Visibility; };
  estimator.TakesLightMaps = true;
  CheckEqual("of an estimator that chooses none", visibility(), vtkIndirectVisibilityNone);
  for (const int choice : { vtkIndirectVisibilityVoxels, vtkIndirectVisibilityMaps })
  {
    estimator.AutomaticVisibility = choice;
    CheckEqual("of an estimator that chooses", visibility(), choice);
  }
  estimator.IsOfPaper = true;
  CheckEqual("of a paper's preset", visibility(), vtkIndirectVisibilityNone);
  settings.Visibility = vtkIndirectVisibilityVoxels;
  CheckEqual(
    "of a paper's preset where the user wants voxels", visibility(), vtkIndirectVisibilityVoxels);
  settings.Visibility = vtkIndirectVisibilityNone;
  CheckEqual("where the user wants none", visibility(), vtkIndirectVisibilityNone);
  settings.Visibility = vtkIndirectVisibilityMaps;
  CheckEqual("where he wants maps", visibility(), vtkIndirectVisibilityMaps);
  estimator.TakesLightMaps = false;
  CheckEqual("which cannot be", visibility(), vtkIndirectVisibilityVoxels);
}

// Refinements of a still picture.
VTK_INDIRECT_TEST(PlanRefinements)
{
  const vtkIndirectFrame frame = MakeFrame({ MakeLight() });
  vtkIndirectSettings settings;
  settings.Visibility = vtkIndirectVisibilityMaps;
  vtkIndirectAbilities estimator;
  estimator.Refines = estimator.TakesLightMaps = true;
  vtkIndirectCircumstances circumstances;
  const auto refinements = [&]
  { return vtkIndirectPlan::Make(frame, settings, estimator, circumstances).Refinements; };
  CheckEqual("of a window that nobody draws again", refinements(), 0);
  circumstances.IdleFrames = true;
  CheckEqual("of a window whose interactor draws again", refinements(), 2);
  Check("a fade", vtkIndirectPlan::Make(frame, settings, estimator, circumstances).RefinementFades);
  circumstances.UpdateRate = 15.0;
  CheckEqual("in motion", refinements(), 0);
  circumstances.UpdateRate = 0.0001;
  settings.NumberOfRefinements = 0;
  CheckEqual("where the user wants none", refinements(), 0);
  settings.NumberOfRefinements = 1;
  CheckEqual("where one is wanted", refinements(), 1);
  settings.NumberOfRefinements = -1;
  circumstances.OffScreen = true;
  CheckEqual("off screen", refinements(), 0);
  settings.ErrorTolerance = 0.1;
  CheckEqual("off screen with a tolerance: at most", refinements(), 3);
  circumstances.UpdateRate = 0.01;
  CheckEqual("with a tolerance, frame by frame", refinements(), 0);
  circumstances.UpdateRate = 0.0001;
  settings.NumberOfRefinements = 0;
  CheckEqual("with a tolerance, where the user wants none", refinements(), 0);
  settings.NumberOfRefinements = -1;
  settings.ErrorTolerance = 0.0;
  settings.TimeBudget = 4.0;
  const vtkIndirectPlan plan = vtkIndirectPlan::Make(frame, settings, estimator, circumstances);
  CheckEqual("off screen with a budget: at most", plan.Refinements, 3);
  CheckEqual("seconds", plan.RefinementSeconds, 4.0);
  Check("no fade off screen", !plan.RefinementFades);
  estimator.Refines = false;
  CheckEqual("of an estimator that sums no batches", refinements(), 0);
  const auto saysWhy = [&]
  {
    const auto entries = vtkIndirectPlan::Make(frame, settings, estimator, circumstances).LeftOut;
    return std::any_of(entries.begin(), entries.end(),
      [](const auto& entry) { return entry.first == "refinement of the still picture"; });
  };
  Check("the plan says why", saysWhy());
  settings.TimeBudget = 0.0;
  circumstances.OffScreen = false;
  Check("but not where nobody asked", !saysWhy());
  circumstances.Environment = true;
  circumstances.EnvironmentIrradiance = 3.0;
  const vtkIndirectPlan sky = vtkIndirectPlan::Make(frame, settings, estimator, circumstances);
  CheckEqual("the sky of the same estimator", sky.Refinements, 2);
  Check("without its lights", !sky.RefinesLights);
}

// Path tracing corrects refined pictures, unless something shines that paths know nothing of.
VTK_INDIRECT_TEST(PlanPaths)
{
  vtkIndirectFrame frame = MakeFrame({ MakeLight() });
  vtkIndirectSettings settings;
  settings.Visibility = vtkIndirectVisibilityMaps;
  settings.NumberOfRefinements = 1;
  vtkIndirectAbilities estimator;
  estimator.Refines = estimator.TakesLightMaps = estimator.SumsLobes = true;
  const vtkIndirectCircumstances circumstances;
  const auto traces = [&]
  { return vtkIndirectPlan::Make(frame, settings, estimator, circumstances).TracesPaths; };
  const auto why = [&]
  {
    const auto entries = vtkIndirectPlan::Make(frame, settings, estimator, circumstances).LeftOut;
    const auto found = std::find_if(entries.begin(), entries.end(),
      [](const auto& entry) { return entry.first == "correction by path tracing"; });
    return found == entries.end() ? std::string() : found->second;
  };
  Check("a refined picture", traces());
  Check("has nothing to say", why().empty());
  settings.IndirectScale = 0.5;
  Check("half of the light: none", !traces());
  Check("half of the light: why", why() == "IndirectScale is not 1");
  settings.IndirectScale = 1.0;
  frame.SendersAreSpecular = true;
  Check("specular surfaces: none", !traces());
  Check("specular surfaces: why", why() == "paths are not reflected specularly");
  settings.NumberOfRefinements = 0;
  Check("no refinement: none", !traces());
  Check("no refinement: nothing to say", why().empty());
}

// Number of maps that a frame draws.
VTK_INDIRECT_TEST(PlanTiles)
{
  const double still = 0.0001;
  const double moving = 15.0;
  auto tiles = [](double triangles, double rate)
  { return vtkIndirectPlan::FindTilesPerFrame(triangles, 1.0, rate); };
  CheckAtLeast("of 100,000 triangles, still", tiles(1e5, still), 256, "one a light by default");
  CheckEqual("of ever so many, still", tiles(1e9, still), 64);
  CheckEqual("of ever so many, moving", tiles(1e9, moving), 4);
  CheckAtLeast("of few, moving", tiles(1e3, moving), 64, "100e6 / 45 over 20e3 + 200 + 3e3");
  Check("more props, fewer tiles",
    vtkIndirectPlan::FindTilesPerFrame(1e3, 1000.0, moving) < tiles(1e3, moving));
  Check("a lower rate, more tiles", tiles(1e5, 2.0) > tiles(1e5, 4.0));
  CheckEqual("as many as a still picture has", tiles(1e5, 0.33), tiles(1e5, still));
  CheckEqual("and where no rate is asked for", tiles(1e5, 0.0), tiles(1e5, still));
  Check("a second is waited for", vtkIndirectPlan::IsInteractive(1.0));
  vtkIndirectFrame frame = MakeFrame({ MakeLight() });
  frame.Casters[0].Triangles = 1e9;
  vtkIndirectCircumstances circumstances;
  vtkIndirectPlan plan = vtkIndirectPlan::Make(frame, {}, {}, circumstances);
  Check("a window that waits", !plan.Interactive && plan.TilesPerFrame == 64);
  circumstances.UpdateRate = moving;
  plan = vtkIndirectPlan::Make(frame, {}, {}, circumstances);
  Check("one in which a camera turns", plan.Interactive && plan.TilesPerFrame == 4);
}

// Rectangles and other sources of virtual lights.
VTK_INDIRECT_TEST(PlanOtherLights)
{
  vtkIndirectCircumstances circumstances;
  circumstances.AreaLights = true;
  circumstances.AreaLightIrradiance = 3.0;
  circumstances.NumberOfOtherEmitters = 1;
  vtkIndirectPlan plan = vtkIndirectPlan::Make(MakeFrame({}), {}, {}, circumstances);
  Check("without any vtkLight", plan.Irradiance && plan.AreaLights && plan.OtherSamplers);
  Check("which surfaces reflect", plan.AreaLightsBounce);
  CheckEqual("what light is stored in units of", plan.IrradianceUnit, 4.0);
  plan = vtkIndirectPlan::Make(MakeFrame({ MakeLight() }), {}, {}, circumstances);
  Check("beside a light", plan.AreaLights && plan.OtherSamplers);
  vtkIndirectAbilities reader;
  reader.Name = "it";
  reader.ReadsMaps = true;
  plan = vtkIndirectPlan::Make(MakeFrame({ MakeLight() }), {}, reader, circumstances);
  Check("direct light whoever estimates", plan.AreaLights && plan.Irradiance);
  Check("no bounce of who reads maps", !plan.AreaLightsBounce && !plan.OtherSamplers);
  Check("which is said",
    Find(plan.LeftOut, "bounces of light from area lights").find("it reads") == 0 &&
      Find(plan.LeftOut, "light of further samplers").find("it reads") == 0);
  plan = vtkIndirectPlan::Make(MakeFrame({}), {}, reader, circumstances);
  Check("unless there are none", plan.AreaLightsBounce && plan.OtherSamplers);
  vtkIndirectSettings settings;
  settings.IndirectScale = 0.0;
  plan = vtkIndirectPlan::Make(MakeFrame({ MakeLight() }), settings, {}, circumstances);
  Check("not where IndirectScale is 0", !plan.AreaLights && !plan.Irradiance);
}

VTK_INDIRECT_TEST(PlanLimits)
{
  const vtkIndirectFrame frame = MakeFrame({ MakeLight() });
  vtkIndirectSettings settings;
  vtkIndirectAbilities estimator;
  estimator.Name = "it";
  settings.NumberOfBounces = 3;
  estimator.MaximumNumberOfBounces = 2;
  estimator.ReadsMaps = true;
  vtkIndirectPlan plan = vtkIndirectPlan::Make(frame, settings, estimator, {});
  CheckEqual("bounces", plan.NumberOfBounces, 2);
  Check("the third is left out", !Find(plan.EstimateLeftOut, "bounces beyond 2").empty());
  CheckEqual("it takes no lights of a walk", plan.WalkedBounces, 0);
  estimator.ReadsMaps = false;
  plan = vtkIndirectPlan::Make(frame, settings, estimator, {});
  CheckEqual("one that does", plan.WalkedBounces, 3);
  Check("says so", !Find(plan.EstimateModelled, "bounces 2 to 3").empty());
  vtkIndirectCircumstances walking;
  walking.SamplerWalks = true;
  plan = vtkIndirectPlan::Make(frame, settings, estimator, walking);
  Check("a sampler that walks has all of them",
    plan.WalkedBounces == 0 && plan.SampledBounces == 3 &&
      Find(plan.EstimateLeftOut, "bounces beyond 2").empty());
  settings.Shadows = false;
  plan = vtkIndirectPlan::Make(frame, settings, estimator, walking);
  Check("and needs no maps without shadows",
    plan.Senders == vtkIndirectPlan::RAYS && plan.MapLights.empty());
  settings.Shadows = true;

  // With an automatic number of bounces.
  settings.NumberOfBounces = 0;
  estimator.MaximumNumberOfBounces = 1;
  estimator.TakesSampler = true;
  plan = vtkIndirectPlan::Make(frame, settings, estimator, {});
  CheckEqual("automatic", plan.WalkedBounces, 128);
  CheckEqual("of which the estimator's", plan.NumberOfBounces, 1);
  estimator.TakesSampler = false;
  plan = vtkIndirectPlan::Make(frame, settings, estimator, {});
  CheckEqual("of an estimator with lights of its own", plan.WalkedBounces, 0);
  estimator.MaximumNumberOfBounces = 16;
  plan = vtkIndirectPlan::Make(frame, settings, estimator, {});
  CheckEqual("of an estimator that computes several itself", plan.NumberOfBounces, 8);
  Check("what it leaves out", !Find(plan.EstimateLeftOut, "bounces after bounce 8").empty());
  estimator.IsOfPaper = true;
  plan = vtkIndirectPlan::Make(frame, settings, estimator, {});
  Check("as published",
    plan.NumberOfBounces == 1 && !Find(plan.EstimateLeftOut, "bounces after bounce 1").empty());
  estimator.IsOfPaper = false;
  estimator.MaximumNumberOfBounces = 1;
  vtkIndirectLight following = MakeLight();
  following.FollowsCamera = true;
  estimator.TakesSampler = true;
  plan = vtkIndirectPlan::Make(MakeFrame({ following }), settings, estimator, {});
  estimator.TakesSampler = false;
  Check("of lights that follow the camera",
    plan.WalkedBounces == 0 && !Find(plan.EstimateLeftOut, "bounces after bounce 1").empty());
  // A sampler that joins senders gets their light from directions that stand.
  estimator.TakesSampler = true;
  vtkIndirectCircumstances joins;
  joins.SamplerTakesSenders = true;
  plan = vtkIndirectPlan::Make(MakeFrame({ following }), settings, estimator, joins);
  Check("of lights that turn", plan.LightsTurn && plan.WalkedBounces == 128 && plan.Irradiance);
  CheckEqual("which have maps for shadows", plan.Senders, vtkIndirectPlan::MAPS);
  settings.Shadows = false;
  plan = vtkIndirectPlan::Make(MakeFrame({ following }), settings, estimator, joins);
  Check("which reflect without shadows", plan.LightsTurn && plan.Irradiance);
  CheckEqual("and without maps", plan.Senders, vtkIndirectPlan::NO_SENDERS);
  settings.Shadows = true;
  Check("none beside a light that stands",
    !vtkIndirectPlan::Make(MakeFrame({ following, MakeLight() }), settings, estimator, joins)
       .LightsTurn);
  following.Positional = true;
  Check("none with a place",
    !vtkIndirectPlan::Make(MakeFrame({ following }), settings, estimator, joins).LightsTurn);
  following.Positional = false;
  vtkNew<vtkLightCollection> replaced;
  vtkIndirectFrame preset = MakeFrame({ MakeLight() });
  preset.ReplacedLights = replaced;
  Check(
    "all lights of a preset", vtkIndirectPlan::Make(preset, settings, estimator, joins).LightsTurn);
  estimator.TakesSampler = false;
  settings.NumberOfBounces = 3;
  estimator.MaximumNumberOfBounces = 16;
  plan = vtkIndirectPlan::Make(frame, settings, estimator, {});
  CheckEqual("bounces of one that computes more", plan.NumberOfBounces, 3);

  settings.ErrorTolerance = 0.01;
  estimator.ErrorTolerance = 0.01;
  plan = vtkIndirectPlan::Make(frame, settings, estimator, {});
  Check("a tolerance that is honoured",
    Find(plan.EstimateLeftOut, "ErrorTolerance 0.01").empty() && plan.ErrorTolerance == 0.01);
  estimator.ErrorTolerance = 0.05;
  plan = vtkIndirectPlan::Make(frame, settings, estimator, {});
  Check(
    "one that is another", Find(plan.EstimateLeftOut, "ErrorTolerance 0.01") == "it aims at 0.05");
  estimator.ErrorTolerance = 0.0;
  plan = vtkIndirectPlan::Make(frame, settings, estimator, {});
  Check("one that nothing follows",
    Find(plan.EstimateLeftOut, "ErrorTolerance 0.01") ==
      "it has no parameters that are chosen by it");

  CheckEqual("threshold of the tolerance that it was found for",
    vtkIndirectPlan::ScaleThreshold(0.25, 0.02, 100.0), 0.25);
  CheckEqual("of half of it", vtkIndirectPlan::ScaleThreshold(0.25, 0.01, 100.0), 0.125);
  CheckEqual("at most", vtkIndirectPlan::ScaleThreshold(0.25, 1.0, 2.0), 2.0);
  CheckEqual("hints along an edge for 0.0833", vtkIndirectPlan::FindGridEdge(12.0 / 144.0), 12);
  CheckEqual("for a quarter of that error", vtkIndirectPlan::FindGridEdge(3.0 / 144.0), 24);
}

VTK_INDIRECT_TEST(PlanUnit)
{
  vtkIndirectLight lamp = MakeLight(3.0);
  lamp.Positional = true;
  lamp.PositionWC = glm::dvec3(0.0, 0.0, 10.0);
  lamp.Attenuation = glm::dvec3(0.0, 0.0, 1.0);
  auto unit = [](const vtkIndirectFrame& frame)
  { return vtkIndirectPlan::Make(frame, {}, {}, {}).IrradianceUnit; };
  CheckEqual("a light of 1", unit(MakeFrame({ MakeLight() })), 1.0);
  CheckEqual("a light of 3: the next power of two", unit(MakeFrame({ MakeLight(3.0) })), 4.0);
  CheckEqual("of 1e-12", unit(MakeFrame({ MakeLight(1e-12) })), std::exp2(-39.0));
  CheckEqual("a lamp of 3 at 10: 0.03", unit(MakeFrame({ lamp })), 1.0 / 32.0);
  CheckEqual("the strongest counts", unit(MakeFrame({ lamp, MakeLight(3.0) })), 4.0);
  CheckEqual("no light", unit(MakeFrame({ MakeLight(0.0) })), 1.0);
}

VTK_INDIRECT_TEST(PlanKeys)
{
  const vtkIndirectFrame frame = MakeFrame({ MakeLight() });
  const vtkIndirectPlan plan = vtkIndirectPlan::Make(frame, {}, {}, {});
  const vtkIndirectKey key = plan.MakeKey(frame);
  Check("equal facts make equal keys",
    vtkIndirectPlan::Make(MakeFrame({ MakeLight() }), {}, {}, {}).MakeKey(frame) == key);
  vtkIndirectFrame other = frame;
  other.Lights[0].Color = glm::dvec3(2.0);
  Check("a light's strength", plan.MakeKey(other) != key);
  other = frame;
  other.WorldToView[3][0] = 1.0;
  Check("the eye's place", plan.MakeKey(other) != key);
  other = frame;
  other.Projection[0][0] = 2.0;
  Check("its angle", plan.MakeKey(other) != key);
  other = frame;
  other.Size[1] = 49;
  Check("the image's size", plan.MakeKey(other) != key);
  vtkIndirectSettings settings;
  settings.ErrorTolerance = 0.01;
  Check("the tolerance", vtkIndirectPlan::Make(frame, settings, {}, {}).MakeKey(frame) != key);
}
