// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/vtkIndirectPlan.h"

#include "Plan/vtkIndirectReport.h"
#include "Scene/vtkIndirectFrame.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int MostMapTexels = 2048;
// Pictures of no more pixels along an edge have maps of 512 texels: finer maps of a light take 31
// MB more.
constexpr int SmallPicture = 384;
// VTK's own DesiredUpdateRate of windows that nobody has set is 0.0001.
constexpr double RateOfNobody = 0.001;
// RMS error over the mean of the sky's light under spheres: 0.041 to 0.056 on scenes of spheres
// (Documentation/methods/sphere-proxies.md).
constexpr double ErrorOfSpheres = 0.05;

// Returns the share of the sky in the light of surfaces that nothing else hides: the lights without
// shadows, which presets keep, light what the sky lights.
double FindShareOfSky(const vtkIndirectFrame& frame, double sky)
{
  double fill = 0.0;
  for (const vtkIndirectLight& light : frame.Lights)
  {
    fill += light.Fill ? std::max({ light.Color.x, light.Color.y, light.Color.z }) : 0.0;
  }
  return sky > 0.0 ? sky / (sky + fill) : 1.0;
}
}

//------------------------------------------------------------------------------
vtkIndirectPlan vtkIndirectPlan::Make(const vtkIndirectFrame& frame,
  const vtkIndirectSettings& settings, const vtkIndirectAbilities& estimator,
  const vtkIndirectCircumstances& circumstances)
{
  vtkIndirectPlan plan;
  plan.Caching = settings.Caching;
  plan.FindTolerances(frame, settings, estimator, circumstances);
  plan.IndirectScale = settings.IndirectScale;
  plan.Interactive = IsInteractive(circumstances.UpdateRate);
  plan.WaitsForMaps = settings.MapsFirst && settings.Caching && !plan.Interactive;
  // A picture that goes to a file is whole; applications that show such pictures set a rate.
  plan.FinishesAtOnce = circumstances.OffScreen && circumstances.UpdateRate <= RateOfNobody;
  if (!plan.FinishesAtOnce)
  {
    plan.TilesPerFrame = FindTilesPerFrame(frame.CountDepthTriangles(),
      static_cast<double>(frame.Casters.size()), circumstances.UpdateRate);
  }
  plan.NumberOfBounces =
    std::min(std::max(settings.NumberOfBounces, 1), estimator.MaximumNumberOfBounces);
  const int emitters = static_cast<int>(frame.Lights.size()) + circumstances.NumberOfOtherEmitters +
    (circumstances.Environment ? 1 : 0) + (circumstances.AreaLights ? 1 : 0);
  plan.WhyDelegate = settings.IndirectScale == 0.0 && !settings.Shadows
    ? "IndirectScale is 0 and Shadows are off"
    : frame.Size[0] < 1 || frame.Size[1] < 1 ? "the viewport is empty"
    : frame.Casters.empty() && !(circumstances.Environment && frame.NumberOfOtherReceivers > 0)
    ? "nothing opaque is visible"
    : emitters == 0 ? "no light is on"
                    : circumstances.DelegateIsRefused;
  if (!plan.WhyDelegate.empty())
  {
    plan.Modelled.emplace_back("the delegate alone", plan.WhyDelegate);
    return plan;
  }
  plan.VisibleAreaLights = circumstances.VisibleAreaLights;
  if (plan.VisibleAreaLights > 0)
  {
    plan.Modelled.emplace_back("area lights that are seen",
      std::to_string(plan.VisibleAreaLights) + " drawn as what they send");
  }

  plan.FindSenders(frame, settings, circumstances);
  if (estimator.SumsSky && !settings.Shadows && plan.Senders != NO_SENDERS)
  {
    plan.Senders = NO_SENDERS; // no stage would read their maps
    plan.MapLights.clear();
  }
  plan.FindVisibility(settings, estimator);
  plan.FindSky(frame, settings, estimator, circumstances);
  plan.FindTurningLights(frame, settings, estimator, circumstances);
  plan.FindOtherLights(frame, settings, estimator, circumstances);
  plan.FindCatchers(frame, estimator);
  plan.FindBounces(frame, settings, estimator, circumstances);
  plan.FindUnit(frame, circumstances);
  plan.Shadows = settings.Shadows && plan.Senders == MAPS;
  // Texels of a shadow are to be no wider than 1.5 pixels. In a brain, a frog and a protein in a
  // room a map of as many texels as the picture has pixels has texels of 3.0, 2.4 and 1.9 pixels,
  // in the median of the places that the eye sees. Maps of lights that turn are drawn in each
  // frame. An estimator that sums the maps' texels would take longer.
  const int edge = std::max(frame.Size[0], frame.Size[1]);
  const int least = plan.LightsTurn || edge <= SmallPicture ? edge : 9 * edge / 4;
  while (plan.Shadows && estimator.TakesSampler && plan.MapTexels < MostMapTexels &&
    plan.MapTexels < least)
  {
    plan.MapTexels *= 2;
  }
  const bool sent = !estimator.SumsSky &&
    (plan.Senders != NO_SENDERS || plan.HasSenderMaps() || plan.VirtualAreaLights ||
      plan.OtherSamplers);
  const bool sentBesides = plan.Sky && plan.SkySource != SKY_BY_MAPS;
  plan.WhyNoIrradiance = settings.IndirectScale == 0.0 ? "IndirectScale is 0"
    : sent || sentBesides                              ? ""
    : estimator.SumsSky                                ? "there is no environment"
    : frame.Casters.empty()                            ? "no surface sends light"
                                                       : "no light emits anything";
  plan.Irradiance = plan.WhyNoIrradiance.empty() && sent;
  plan.Specular = settings.IndirectScale > 0.0 && estimator.ComputesGlossy &&
    estimator.SpecularTransport && frame.Specular;
  plan.AreaSpecular = plan.AreaLights && (frame.Specular || frame.PhysicallyBased);
  if (plan.AreaSpecular)
  {
    plan.Modelled.emplace_back("area lights in specular lobes",
      frame.PhysicallyBased ? "receivers reflect them by Phong's lobes and VTK's PBR, without coat"
                            : "receivers reflect them by Phong's lobes");
  }
  plan.SurfacesAreSpecular = plan.Specular || plan.AreaSpecular;
  plan.Refraction = plan.Irradiance && !frame.Refractors.empty() && estimator.SumsLobes &&
    estimator.SpecularTransport && !frame.Lights.empty();
  plan.SendersAreSpecular = frame.SendersAreSpecular;
  plan.MapsSend = !plan.LightsTurn || plan.OtherSamplers;
  plan.SenderLobes = settings.IndirectScale > 0.0 && plan.Senders == MAPS && !plan.LightsTurn &&
    estimator.SumsLobes && estimator.SpecularTransport && frame.SendersAreSpecular;
  // If there is specular reflectance, the albedo has an image of its own in any case.
  plan.AlbedoInAlpha = frame.CoversFully && !circumstances.OwnDelegate && !plan.SurfacesAreSpecular;
  // Antialiasing twice blurs too much, and the user's choice has priority.
  const std::string& other = circumstances.OtherAntialiasing;
  plan.Antialiasing = settings.Antialiasing && other.empty();
  (plan.Antialiasing ? plan.Modelled : plan.LeftOut)
    .emplace_back("antialiased edges",
      plan.Antialiasing          ? "by their shapes: what the pass draws has no samples to average"
        : !settings.Antialiasing ? "Antialiasing is off"
                                 : other + " antialiases the picture");
  plan.FindRefinements(settings, estimator, circumstances);
  plan.ReportTolerances(estimator);
  plan.LeaveOut(settings, estimator, circumstances);
  return plan;
}

//------------------------------------------------------------------------------
// Resolves ErrorTolerance 0, for which each part of the light has a standard tolerance of its own.
void vtkIndirectPlan::FindTolerances(const vtkIndirectFrame& frame,
  const vtkIndirectSettings& settings, const vtkIndirectAbilities& estimator,
  const vtkIndirectCircumstances& circumstances)
{
  this->ErrorToleranceIsSet = settings.ErrorTolerance > 0.0;
  if (this->ErrorToleranceIsSet)
  {
    this->ErrorTolerance = this->SkyErrorTolerance = settings.ErrorTolerance;
  }
  else
  {
    this->SkyErrorTolerance =
      StandardSkyErrorTolerance / FindShareOfSky(frame, circumstances.EnvironmentIrradiance);
  }
  this->EstimatorErrorTolerance = estimator.ErrorTolerance;
}

//------------------------------------------------------------------------------
// Says which tolerance each part of the light aims at: the setting may be 0, and a part may not
// follow it.
void vtkIndirectPlan::ReportTolerances(const vtkIndirectAbilities& estimator)
{
  std::string why;
  auto add = [&](bool isThere, double tolerance, const std::string& part)
  {
    if (isThere && tolerance > 0.0)
    {
      why += (why.empty() ? "" : ", ") + vtkIndirectReport::Number(tolerance, 4) + " of " + part;
    }
  };
  add(this->Irradiance && estimator.TakesSampler, this->ErrorTolerance, "virtual lights");
  add(this->AreaLights, this->ErrorTolerance, "area lights");
  add(this->HasSkyMaps(), this->SkyErrorTolerance, "the sky");
  add(this->Irradiance, this->EstimatorErrorTolerance, estimator.Name);
  if (!why.empty())
  {
    this->Modelled.emplace_back("error tolerances", why);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectPlan::FindVisibility(
  const vtkIndirectSettings& settings, const vtkIndirectAbilities& estimator)
{
  this->Visibility = settings.Visibility != vtkIndirectVisibilityAutomatic ? settings.Visibility
    : estimator.IsOfPaper ? vtkIndirectVisibilityNone
                          : estimator.AutomaticVisibility;
  if (this->Visibility == vtkIndirectVisibilityMaps && !estimator.TakesLightMaps)
  {
    this->Visibility = vtkIndirectVisibilityVoxels;
    this->EstimateLeftOut.emplace_back("maps of virtual lights",
      estimator.Name + " does not sum single lights; visibility is looked up in voxels");
  }
}

//------------------------------------------------------------------------------
void vtkIndirectPlan::FindSky(const vtkIndirectFrame& frame, const vtkIndirectSettings& settings,
  const vtkIndirectAbilities& estimator, const vtkIndirectCircumstances& circumstances)
{
  this->Sky = circumstances.Environment && settings.IndirectScale > 0.0;
  this->SkyIsShadowed = settings.Visibility != vtkIndirectVisibilityNone && !frame.Casters.empty();
  this->ReplacesImageLight = this->Sky && circumstances.ImageBasedLighting;
  if (this->ReplacesImageLight)
  {
    this->LeftOut.emplace_back("specular environment light",
      "VTK adds that of the renderer's environment texture, without shadows");
  }
  else if (circumstances.ImageBasedLighting)
  {
    this->LeftOut.emplace_back("environment light",
      "VTK lights physically based props with the renderer's environment texture, without shadows; "
      "none of it is reflected further");
  }
  if (!this->Sky)
  {
    return;
  }
  this->FindSkySource(settings, estimator, circumstances);
  const bool bounces = !estimator.SumsSky &&
    (!estimator.ReadsMaps || this->Senders == NO_SENDERS) && !frame.Casters.empty();
  // Reflected light must not appear or vanish with the choice of the sky's method.
  this->SpheresBounceSky = bounces && this->SkySource == SKY_BY_SPHERES;
  this->SkyBounces = bounces && !this->SpheresBounceSky;
  if (this->SpheresBounceSky && settings.NumberOfBounces != 1)
  {
    this->LeftOut.emplace_back(
      "bounces of light from the sky after the first", "spheres send one; the result is too dark");
  }
  if (!bounces && !estimator.SumsSky && !frame.Casters.empty())
  {
    this->LeftOut.emplace_back("bounces of light from the sky",
      estimator.Name + " reads the lights' maps, and nothing beside them; the result is too dark");
  }
  // With fewer than 64 directions edges of their shadows show, which a tolerance may allow.
  // On a plane that catches light the shadows of single directions show: twice the usual number.
  const int fewest = this->ErrorToleranceIsSet ? 16 : !frame.Catchers.empty() ? 256 : 64;
  this->NumberOfStillSkyDirections = std::max(FindSkyDirections(this->SkyErrorTolerance), fewest);
  this->NumberOfSkyDirections = this->NumberOfStillSkyDirections;
  if (this->Interactive)
  {
    // A moving frame sums a quarter of the directions, and a pixel sixteen or thirty-two of them.
    this->NumberOfSkyDirections =
      std::max(this->NumberOfStillSkyDirections / 4, std::min(fewest, 64));
    this->SkyBlock = this->NumberOfSkyDirections >= 256 ? 4
      : this->NumberOfSkyDirections >= 64               ? 2
                                                        : 1;
  }
  if (!this->SkyIsShadowed && !frame.Casters.empty())
  {
    this->LeftOut.emplace_back(
      "what hides the sky", "Visibility is none; the result is too bright");
  }
}

//------------------------------------------------------------------------------
// Chooses how the sky is summed. Maps have to be drawn again when something has moved. Spheres cost
// the same in each frame: half of that or less for up to 10,000 spheres. In a still scene maps are
// kept, and they are more exact.
void vtkIndirectPlan::FindSkySource(const vtkIndirectSettings& settings,
  const vtkIndirectAbilities& estimator, const vtkIndirectCircumstances& circumstances)
{
  if (estimator.SumsSky)
  {
    this->SkySource = SKY_BY_ESTIMATOR;
    this->Modelled.emplace_back("sky by " + estimator.Name, "it is the estimator");
    return;
  }
  const bool asked = this->ErrorToleranceIsSet && this->ErrorTolerance < ErrorOfSpheres;
  std::string why;
  if (!this->SkyIsShadowed)
  {
    why = "nothing hides it";
  }
  else if (!settings.SpheresInMotion || !settings.Caching)
  {
    why = settings.SpheresInMotion ? "Caching is off" : "SpheresInMotion is off";
  }
  else if (circumstances.SpheresMove.empty())
  {
    why = "no spheres have moved in frames one after the other";
  }
  else if (!circumstances.SpheresFail.empty())
  {
    why = circumstances.SpheresMove + ", but " + circumstances.SpheresFail;
  }
  else if (asked)
  {
    why = "ErrorTolerance is below that of spheres, " + vtkIndirectReport::Number(ErrorOfSpheres);
  }
  this->SkySource = why.empty() ? SKY_BY_SPHERES : SKY_BY_MAPS;
  this->Modelled.emplace_back(why.empty() ? "sky by spheres" : "sky by depth maps",
    why.empty() ? circumstances.SpheresMove + "; depth maps do not show them as they are" : why);
}

//------------------------------------------------------------------------------
void vtkIndirectPlan::FindOtherLights(const vtkIndirectFrame& frame,
  const vtkIndirectSettings& settings, const vtkIndirectAbilities& estimator,
  const vtkIndirectCircumstances& circumstances)
{
  const bool takes = !estimator.SumsSky && (!estimator.ReadsMaps || this->Senders == NO_SENDERS);
  const std::string why = estimator.Name +
    (estimator.SumsSky
        ? " sums the light of the sky alone; the result is too dark"
        : " reads the lights' maps, and nothing beside them; the result is too dark");
  if (estimator.SumsSky && this->Senders != NO_SENDERS)
  {
    this->LeftOut.emplace_back("bounces of lights", why);
  }
  this->OtherSamplers = takes && circumstances.NumberOfOtherEmitters > 0;
  if (!takes && circumstances.NumberOfOtherEmitters > 0)
  {
    this->LeftOut.emplace_back("light of further samplers", why);
  }
  if (!circumstances.AreaLights || settings.IndirectScale == 0.0)
  {
    return;
  }
  // Estimators of the paper that read the lights' maps take no other lights.
  const bool automatic = estimator.IsOfPaper && !estimator.ReadsMaps && !estimator.SumsSky;
  const bool asked =
    circumstances.VirtualAreaLights || (automatic && circumstances.AutomaticAreaLights);
  this->VirtualAreaLights = takes && asked;
  this->AutomaticAreaLightsAreVirtual = this->VirtualAreaLights && automatic;
  this->MinMaxAreaLights = this->VirtualAreaLights && estimator.IsOfPaper;
  this->AreaLights = !this->VirtualAreaLights || circumstances.ClosedAreaLights ||
    (!automatic && circumstances.AutomaticAreaLights);
  if (asked)
  {
    (takes ? this->Modelled : this->LeftOut)
      .emplace_back("area lights as virtual lights",
        takes ? std::string(this->MinMaxAreaLights
                    ? "by least and greatest luminance, as the paper does"
                    : "pieces of pieces for receivers near them")
              : estimator.Name + " takes none beside the lights' maps; the closed form is used");
  }
  this->AreaIsShadowed = settings.Visibility != vtkIndirectVisibilityNone && !frame.Casters.empty();
  if (this->AreaLights && !this->AreaIsShadowed && !frame.Casters.empty())
  {
    this->LeftOut.emplace_back(
      "what hides area lights", "Visibility is none; the result is too bright");
  }
  this->AreaLightsBounce = takes && !frame.Casters.empty();
  if (!takes)
  {
    this->LeftOut.emplace_back("bounces of light from area lights", why);
  }
}

//------------------------------------------------------------------------------
// Props that catch light compare it with the same light if nothing was hidden, which has to be
// known by itself.
void vtkIndirectPlan::FindCatchers(
  const vtkIndirectFrame& frame, const vtkIndirectAbilities& estimator)
{
  if (frame.Catchers.empty())
  {
    return;
  }
  const bool skyFails = this->Sky && this->SkySource == SKY_BY_ESTIMATOR;
  this->Catches = !skyFails && !this->VirtualAreaLights;
  const std::string what = "props that catch light, " + std::to_string(frame.Catchers.size());
  if (this->Catches)
  {
    this->Modelled.emplace_back(what,
      "they show the background times the light on them over the light if they were alone, hide "
      "nothing and send nothing: what stands on them is too bright where a ground would hide the "
      "sky, too dark where it would reflect");
    return;
  }
  this->LeftOut.emplace_back(what,
    skyFails ? estimator.Name + " does not tell the light of a sky that nothing hides"
             : "virtual lights of area lights do not tell the light that nothing hides");
}

//------------------------------------------------------------------------------
void vtkIndirectPlan::FindUnit(
  const vtkIndirectFrame& frame, const vtkIndirectCircumstances& circumstances)
{
  // The unit is the irradiance from the strongest light on a surface that faces it in the middle of
  // the scene, so that 1e-7 to 65504 times that can be stored. Some surface may receive a quarter
  // or more of a sky's light.
  double unit = std::max(this->SkyBounces ? circumstances.EnvironmentIrradiance : 0.0,
    this->AreaLightsBounce || this->VirtualAreaLights ? circumstances.AreaLightIrradiance : 0.0);
  for (const vtkIndirectLight& light : frame.Lights)
  {
    const double color = std::max({ light.Color.x, light.Color.y, light.Color.z });
    double attenuation = 1.0;
    if (light.Positional)
    {
      const double d =
        std::max(glm::length(light.PositionWC - frame.SceneCenter), 0.1 / frame.SceneScale);
      const double denominator =
        light.Attenuation.x + d * (light.Attenuation.y + d * light.Attenuation.z);
      attenuation = denominator > 0.0 ? 1.0 / denominator : 1.0;
    }
    unit = std::max(unit, color * attenuation);
  }
  // A power of two loses no bits, except those that half floats lack.
  this->IrradianceUnit =
    unit > 0.0 && std::isfinite(unit) ? std::exp2(std::ceil(std::log2(unit))) : 1.0;
}

//------------------------------------------------------------------------------
void vtkIndirectPlan::LeaveOut(const vtkIndirectSettings& settings,
  const vtkIndirectAbilities& estimator, const vtkIndirectCircumstances& circumstances)
{
  if (!this->WhyNoIrradiance.empty())
  {
    this->LeftOut.emplace_back("indirect light", this->WhyNoIrradiance);
    return;
  }
  if (settings.ErrorTolerance > 0.0 && estimator.ErrorTolerance != settings.ErrorTolerance)
  {
    this->EstimateLeftOut.emplace_back(
      "ErrorTolerance " + vtkIndirectReport::Number(settings.ErrorTolerance),
      estimator.Name +
        (estimator.ErrorTolerance > 0.0
            ? " aims at " + vtkIndirectReport::Number(estimator.ErrorTolerance)
            : std::string(" has no parameters that are chosen by it")));
  }
  if (this->WalkedBounces > 0)
  {
    this->EstimateModelled.emplace_back(
      "bounces 2 to " + std::to_string(this->WalkedBounces), "virtual lights of a random walk");
  }
  else if (this->SampledBounces > estimator.MaximumNumberOfBounces && !circumstances.SamplerWalks &&
    !circumstances.OtherSamplerWalks)
  {
    this->EstimateLeftOut.emplace_back(
      "bounces beyond " + std::to_string(estimator.MaximumNumberOfBounces),
      estimator.Name + " computes no more; the result is too dark");
  }
  if (this->Specular)
  {
    this->EstimateModelled.emplace_back(
      "specular indirect light", "receivers reflect it by the lobes of Phong's model");
  }
  else
  {
    this->EstimateLeftOut.emplace_back("specular indirect light",
      !estimator.ComputesGlossy       ? estimator.Name + " takes receivers as diffuse"
        : estimator.SpecularTransport ? "no receiver is specular"
                                      : "SpecularTransport is off");
  }
  if (this->Refraction)
  {
    this->EstimateModelled.emplace_back("light through glass",
      "refracted at both faces, a lobe a virtual light; that bodies of glass hold light back "
      "is not");
  }
  if (this->SenderLobes)
  {
    this->EstimateModelled.emplace_back("specular reflection of senders",
      "a lobe a virtual light about the mirror direction of the light, of the flux of VTK's "
      "specular term");
  }
  const bool others = this->HasSenderMaps();
  if (!this->SenderLobes || others)
  {
    this->EstimateLeftOut.emplace_back(this->SenderLobes
        ? "specular reflection of senders, of the sky and area lights"
        : "specular reflection of senders",
      !estimator.SpecularTransport    ? "SpecularTransport is off"
        : !this->SendersAreSpecular   ? "no sender is specular"
        : others && this->SenderLobes ? "senders under these are taken as diffuse"
        : !estimator.SumsLobes        ? estimator.Name + " takes senders as diffuse"
                                      : "senders under these lights are taken as diffuse");
  }
}

//------------------------------------------------------------------------------
vtkIndirectKey vtkIndirectPlan::MakeKey(const vtkIndirectFrame& frame) const
{
  vtkIndirectKey key;
  key.Add("size", frame.Size[0]).Add("size", frame.Size[1]);
  key.Add("senders", this->Senders).Add("senders", this->SenderLobes);
  key.Add("senders", this->Refraction);
  key.Add("visibility", this->Visibility);
  // Moving frames look up fewer maps.
  key.Add("pace", this->Interactive && this->Visibility == vtkIndirectVisibilityMaps);
  key.Add("bounces", this->NumberOfBounces).Add("bounces", this->SampledBounces);
  key.Add("bounces", this->WalkedBounces).Add("bounces", this->SkyBounces);
  key.Add("bounces", this->AreaLightsBounce).Add("bounces", this->LightsTurn);
  key.Add("area lights", this->VirtualAreaLights).Add("area lights", this->MinMaxAreaLights);
  key.Add("error tolerance", this->ErrorTolerance);
  key.Add("error tolerance", this->EstimatorErrorTolerance);
  key.Add("props that catch light", static_cast<int>(frame.Catchers.size()));
  key.Add("sky", this->SkySource).Add("sky", this->SkyIsShadowed).Add("sky", this->Sky);
  frame.AppendTo(key);
  return key;
}

//------------------------------------------------------------------------------
double vtkIndirectPlan::ScaleThreshold(double standard, double tolerance, double most)
{
  return std::min(standard * tolerance / StandardErrorTolerance, most);
}

//------------------------------------------------------------------------------
int vtkIndirectPlan::FindGridEdge(double tolerance)
{
  return tolerance > 0.0 ? static_cast<int>(std::ceil(std::sqrt(12.0 / tolerance))) : 0;
}

//------------------------------------------------------------------------------
// The work that a frame may do for maps is a fixed number; nothing is measured. The unit is a third
// of a triangle. On two cores in software (72,000 to 448,000 triangles) a map took 0.3 ms, a prop 3
// us and a triangle 45 ns. With these times the work of a still picture takes a second and a half,
// and that of a moving one half of the frame time at its rate; a GPU is faster. However much work a
// map is, a still picture first draws 64 maps: other lights share them.
int vtkIndirectPlan::FindTilesPerFrame(double triangles, double props, double updateRate)
{
  constexpr double perTile = 20e3;
  constexpr double perProp = 200.0;
  constexpr double perTriangle = 3.0;
  constexpr double still = 100e6;
  const double work = still / std::max(3.0 * updateRate, 1.0);
  const double tiles = work / (perTile + perProp * props + perTriangle * triangles);
  const double least = IsInteractive(updateRate) ? 4.0 : 64.0;
  return static_cast<int>(std::min(std::max(tiles, least), 1e6));
}

//------------------------------------------------------------------------------
int vtkIndirectPlan::FindDirectionsOfOpening(double share) const
{
  constexpr double shareInTheOpen = 0.7; // 0.59 to 0.93 in ten scenes
  constexpr double fewestTimes = 4.0;    // fewer times as many take their time for little
  constexpr int most = 8192;
  const double times = shareInTheOpen / std::max(share, 1e-6);
  if (times < fewestTimes)
  {
    return 0;
  }
  int count = this->NumberOfStillSkyDirections;
  while (count < std::min<double>(most, times * this->NumberOfStillSkyDirections))
  {
    count *= 2;
  }
  return count;
}

//------------------------------------------------------------------------------
int vtkIndirectPlan::FindSkyDirections(double tolerance)
{
  int count = 16;
  while (count < 1024 && StandardSkyErrorTolerance * std::pow(256.0 / count, 0.75) > tolerance)
  {
    count *= 2;
  }
  return count;
}
