// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Pipeline/vtkIndirectPipeline.h"

#include "Capture/vtkIndirectDarkLight.h"
#include "Capture/vtkIndirectShadowMaps.h"
#include "Emitters/vtkIndirectEmitterAccess.h"
#include "OpenGL/vtkIndirectBackEndChoices.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "Scene/vtkIndirectLightScope.h"
#include "Senders/vtkIndirectAreaSamplerAccess.h"
#include "Sums/vtkIndirectSum.h"
#include "vtkAreaLight.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

//------------------------------------------------------------------------------
vtkIndirectPipeline::vtkIndirectPipeline()
{
  this->Identity.Modified();
}

//------------------------------------------------------------------------------
void vtkIndirectPipeline::Prepare(const vtkRenderState* s, const Request& request)
{
  this->FrameBegan = vtkIndirectRefinementSchedule::ReadClock();
  this->Renderer = s->GetRenderer();
  this->BuffersAreThere = false;
  for (Part& part : this->Parts)
  {
    part.IsThere = part.Waits = part.IsAsked = part.IsNew = false;
  }
  this->Estimator = request.Estimator;
  this->HeldEstimator = request.HoldEstimator ? request.Estimator : nullptr;
  this->Frame = vtkIndirectFrame();
  if (!request.Settings.Caching)
  {
    this->CasterBounds.Forget();
  }
  const bool interactive = vtkIndirectPlan::IsInteractive(request.Circumstances.UpdateRate);
  this->Frame.Build(s, &this->CasterBounds, interactive);
  // Points whose size is in pixels receive light where VTK draws them.
  this->Frame.NumberOfOtherReceivers += this->PointSpheres.CountPixelSized();
  this->Levels.Update(this->Frame);
  this->Frame.ReplacedLights = request.ReplacedLights;
  vtkIndirectCircumstances circumstances = request.Circumstances;
  circumstances.NumberOfOtherEmitters = static_cast<int>(this->Samplers.Others.size());
  this->UsableAreaLights.clear();
  for (const auto& light : this->AreaLights)
  {
    if (!light->GetSwitch() ||
      vtkIndirectEmitterAccess::ShinesInto(
        light, glm::value_ptr(this->Frame.SceneCenter), 1.0 / this->Frame.SceneScale))
    {
      this->UsableAreaLights.push_back(light);
    }
  }
  const auto findIrradiance = [this](const std::vector<vtkSmartPointer<vtkAreaLight>>& lights)
  { return vtkIndirectEmitters::FindIrradiance(lights, glm::value_ptr(this->Frame.SceneCenter)); };
  circumstances.AreaLightIrradiance = findIrradiance(this->UsableAreaLights);
  circumstances.AreaLights = circumstances.AreaLightIrradiance > 0.0;
  for (const auto& light : this->UsableAreaLights)
  {
    const int method = light->GetMethod();
    bool& shines = method == vtkAreaLight::AUTOMATIC ? circumstances.AutomaticAreaLights
      : method == vtkAreaLight::CLOSED_FORM          ? circumstances.ClosedAreaLights
                                                     : circumstances.VirtualAreaLights;
    shines = shines || findIrradiance({ light }) > 0.0;
  }
  circumstances.VisibleAreaLights = vtkIndirectVisibleLamps::Count(this->UsableAreaLights);
  this->Environment =
    request.Environment ? request.Environment : this->ImageLight.Find(this->Frame.Renderer);
  const vtkIndirectSkyProjection::Result dark;
  const vtkIndirectSkyProjection::Result& skyLight =
    this->Environment ? this->SkyProjection.Find(this->Environment) : dark;
  // A surface may receive all of the light at a right angle.
  circumstances.EnvironmentIrradiance =
    std::max({ skyLight.Total.x, skyLight.Total.y, skyLight.Total.z }) / vtkMath::Pi();
  circumstances.Environment = circumstances.EnvironmentIrradiance > 0.0;
  if (circumstances.Environment && request.Settings.Caching && request.Settings.SpheresInMotion)
  {
    this->SphereMotion.Update(this->Frame, skyLight.HasStrong(), interactive);
    circumstances.SpheresMove = this->SphereMotion.GetWhat();
    circumstances.SpheresFail = this->Frame.Catchers.empty()
      ? this->SphereMotion.GetWhyNot()
      : "spheres do not tell the light of a sky that nothing hides to props that catch light";
  }
  else
  {
    this->SphereMotion.Forget();
  }
  circumstances.ImageBasedLighting = this->Frame.Renderer->GetUseImageBasedLighting();
  const vtkIndirectAbilities abilities =
    vtkIndirectSum::Get(request.Estimator).GetAbilities(request.Settings.ErrorTolerance);
  if (abilities.TakesSampler)
  {
    const vtkIndirectSamplerAbilities sampler =
      vtkIndirectSampler::Get(request.Sampler)->GetAbilities();
    circumstances.SamplerWalks = sampler.Walks;
    circumstances.SamplerTakesSenders = sampler.TakesSenders;
  }
  circumstances.OtherSamplerWalks = this->Samplers.HasOtherWalk();
  this->EstimatedError.reset();
  this->Plan = vtkIndirectPlan::Make(this->Frame, request.Settings, abilities, circumstances);
  std::vector<vtkSmartPointer<vtkAreaLight>> virtualAreaLights;
  this->ClosedAreaLights.clear();
  for (const auto& light : this->UsableAreaLights)
  {
    const int method = light->GetMethod();
    const bool isVirtual =
      (this->Plan.VirtualAreaLights && method == vtkAreaLight::VIRTUAL_LIGHTS) ||
      (this->Plan.AutomaticAreaLightsAreVirtual && method == vtkAreaLight::AUTOMATIC);
    (isVirtual ? virtualAreaLights : this->ClosedAreaLights).push_back(light);
  }
  for (vtkIndirectFrameSamplers* samplers : { &this->Samplers, &this->FinerSamplers })
  {
    vtkIndirectAreaSamplerAccess::SetLights(samplers->Area, virtualAreaLights);
  }
  // Old maps are released: they would show outdated shadows when the sky comes from maps again.
  const bool sky = circumstances.Environment && request.Settings.IndirectScale > 0.0;
  if (!sky || this->Plan.SkySource != vtkIndirectPlan::SKY_BY_MAPS)
  {
    this->SkyMaps.Release(this->Frame.Window);
  }
  // Spheres are kept while they may move again, because building their programs takes seconds.
  if (!sky || !this->SphereMotion.HasMoved())
  {
    this->Spheres->ReleaseGraphicsResources(this->Frame.Window);
  }
  if (!circumstances.AreaLights || request.Settings.IndirectScale == 0.0 ||
    (this->Plan.VirtualAreaLights && !this->Plan.AreaLights))
  {
    this->Area.Release(this->Frame.Window);
  }
  if (!this->Plan.HasSenderMaps())
  {
    this->Samplers.ReleaseSenderMaps(this->Frame.Window);
  }
}

//------------------------------------------------------------------------------
// The maps come first because VTK's own shading needs the visibility of each light.
bool vtkIndirectPipeline::DrawSurfaces(const vtkRenderState* s, const Request& request)
{
  if (!this->Plan.Antialiasing)
  {
    this->Antialiasing.Release(this->Frame.Window);
  }
  if (!this->Plan.Shadows)
  {
    this->Penumbra.Release(this->Frame.Window);
  }
  this->BackEndChoices = vtkIndirectBackEndChoices::GetAll();
  this->DepthMaps.Begin(this->Frame, request.Settings.Caching);
  this->Capture->SetDelegatePass(request.Delegate);
  this->Capture->SetOutputs(
    { this->Plan.Shadows, this->Plan.SurfacesAreSpecular || this->Plan.SenderLobes,
      this->Plan.AreaSpecular && this->Frame.PhysicallyBased });
  this->Maps.SetContent(!this->Plan.MapsSend ? vtkIndirectLightMaps::SHADOWS
      : this->Plan.SenderLobes               ? vtkIndirectLightMaps::SPECULAR_SENDERS
                                             : vtkIndirectLightMaps::SENDERS);
  this->Capture->SetImageLight(!this->Plan.ReplacesImageLight);
  this->Capture->Attach(this->Frame);
  const vtkIndirectDarkLight dark(this->Frame);
  if (request.ReplacedLights)
  {
    vtkIndirectLightScope::Read(this->Frame.Renderer);
  }
  bool drawn = true;
  const bool maps = this->Plan.Senders != vtkIndirectPlan::HEADLIGHT;
  const bool skyMaps = this->Plan.Sky && this->Plan.SkySource == vtkIndirectPlan::SKY_BY_MAPS;
  if (maps || skyMaps)
  {
    this->Timer.Begin(vtkIndirectStageTimer::ReflectiveShadowMap);
    if (this->Plan.Shadows || skyMaps)
    {
      drawn = this->ViewSamples.Update(this->Frame, this->Plan.Interactive, this->Capture);
    }
    if (drawn && maps)
    {
      drawn =
        this->Maps.Update(this->Frame, this->Plan, this->Capture, this->MapsPass->GetResolution());
    }
    if (drawn && maps && this->Plan.Shadows)
    {
      drawn = this->Penumbra.Update(this->Frame, this->Maps, this->Capture);
    }
    this->Timer.End(vtkIndirectStageTimer::ReflectiveShadowMap);
  }
  drawn = drawn && this->UpdateSenderMaps(this->Samplers);
  this->Timer.Begin(vtkIndirectStageTimer::Geometry);
  vtkIndirectShadowMaps shadows;
  const bool shadowed = drawn && this->Plan.Shadows;
  if (shadowed)
  {
    shadows = this->Maps.ActivateShadows(this->Frame.Window);
    this->Penumbra.Activate(shadows);
    drawn = shadows.Unit >= 0;
  }
  {
    const vtkIndirectPointSpheres::EyeScope eye(this->PointSpheres);
    drawn = drawn &&
      this->Geometry.Update(
        s, this->Frame, this->Plan, this->Capture, shadowed ? &shadows : nullptr);
  }
  if (shadowed)
  {
    this->Maps.DeactivateShadows();
    this->Penumbra.Deactivate();
  }
  drawn = drawn && !this->IsRedirected() &&
    this->VisibleLamps.Draw(this->Frame, this->UsableAreaLights, this->Geometry) &&
    this->Catchers.Update(this->Frame, this->Capture);
  this->TargetIsClear = request.DepthCleared;
  const vtkIndirectPointSpheres::EyeScope eye(this->PointSpheres);
  this->DepthIsDrawn = drawn && !this->IsRedirected() && request.DepthCleared &&
    request.DepthOfSamples && this->Plan.VisibleAreaLights == 0 &&
    this->Geometry.DrawDepthOfSamples(s, this->Frame, this->Capture);
  this->Timer.End(vtkIndirectStageTimer::Geometry);
  this->Capture->Detach();
  return drawn && !this->IsRedirected();
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::UpdateSenderMaps(vtkIndirectFrameSamplers& samplers)
{
  if (!this->Plan.HasSenderMaps())
  {
    return true;
  }
  this->Timer.Begin(vtkIndirectStageTimer::ReflectiveShadowMap);
  vtkEnvironmentLight* const sky = this->Plan.SkyBounces ? this->Environment : nullptr;
  vtkIndirectKey source = vtkIndirectKey().Add("sky", sky);
  vtkIndirectEmitters::List turning;
  for (const vtkIndirectLight& light : this->Frame.Lights)
  {
    if (this->Plan.LightsTurn && light.IsReflected())
    {
      turning.push_back(light);
      turning.back().Color *= this->Frame.CastersArePhysicallyBased ? 1.0 / glm::pi<double>() : 1.0;
      turning.back().AppendTo(source);
    }
  }
  if (this->Plan.AreaLightsBounce)
  {
    this->AppendAreaLights(source);
  }
  const auto makeEmitters = [&](bool inHaste)
  {
    vtkIndirectEmitters::List emitters;
    if (sky || this->Plan.LightsTurn)
    {
      const bool anyView = this->Plan.LightsTurn && &samplers == &this->Samplers;
      (anyView ? vtkIndirectEmitters::AddSteadyDirections : vtkIndirectEmitters::AddDirections)(
        emitters, this->SkyProjection, sky, turning);
    }
    if (this->Plan.AreaLightsBounce)
    {
      vtkIndirectEmitters::AddAreaLights(emitters, this->UsableAreaLights, inHaste);
    }
    return emitters;
  };
  const bool drawn =
    samplers.UpdateSenderMaps(this->Frame, this->Plan, this->Capture, source, makeEmitters);
  this->Timer.End(vtkIndirectStageTimer::ReflectiveShadowMap);
  return drawn;
}

//------------------------------------------------------------------------------
void vtkIndirectPipeline::DrawLight(const Request& request)
{
  this->BuffersAreThere = true;
  this->LastFrameKey = std::move(this->FrameKey);
  this->FrameKey = this->MakeFrameKey();
  this->ChooseLights(request);
  this->Creases.Begin();
  const vtkIndirectFrameLight::Input input = this->MakeInput(this->Bounce.GetVisibility());
  for (Part& part : this->Parts)
  {
    if (part.IsAsked)
    {
      this->UpdatePart(part, input);
    }
    else
    {
      part.Key.Clear();
      part.Light->Rest(input);
    }
  }
  bool drawn = true;
  if (this->DepthMaps.HasRequests())
  {
    this->Timer.Begin(vtkIndirectStageTimer::Visibility);
    drawn = this->DepthMaps.Draw(this->Frame, this->Capture, this->Plan.TilesPerFrame);
    this->Timer.End(vtkIndirectStageTimer::Visibility);
  }
  for (Part& part : this->Parts)
  {
    if (part.IsNew)
    {
      this->SumPart(part, input, drawn);
    }
  }
  this->Refine(input);
  this->Timer.Begin(vtkIndirectStageTimer::Composite);
  this->FindBalance(request.MostReplaced);
  const bool composed = this->Composite.Composite(this->MakeCompositeInput());
  if (composed && this->Plan.Antialiasing)
  {
    this->Antialiasing.Apply(this->Frame, this->Geometry);
  }
  this->Timer.End(vtkIndirectStageTimer::Composite);
}

//------------------------------------------------------------------------------
// Sets the sources of each light of the plan for this frame.
void vtkIndirectPipeline::ChooseLights(const Request& request)
{
  vtkIndirectSum& own = vtkIndirectSum::Get(this->Estimator);
  own.HoldContext(this->Frame.Window, this->Identity.GetMTime());
  this->Samplers.Choose(this->Frame, this->Plan,
    own.ChooseSampler(vtkIndirectSampler::Get(request.Sampler), this->Plan));
  this->Bounce.SetSources(this->Estimator, request.Sampler);
  const bool ownSky = this->Plan.SkySource == vtkIndirectPlan::SKY_BY_ESTIMATOR;
  vtkIndirectFrameLight* sky = ownSky ? static_cast<vtkIndirectFrameLight*>(&own) : &this->SkyMaps;
  if (this->Plan.SkySource == vtkIndirectPlan::SKY_BY_SPHERES)
  {
    vtkIndirectSum& spheres = vtkIndirectSum::Get(this->Spheres);
    spheres.HoldContext(this->Frame.Window, this->Identity.GetMTime());
    this->Spheres->SetIndirectLight(this->Plan.SpheresBounceSky ? vtkProxyAccumulationPass::SHADOWED
                                                                : vtkProxyAccumulationPass::OFF);
    sky = &spheres;
  }
  auto choose =
    [](Part& part, const char* name, vtkIndirectFrameLight* light, bool isAsked, bool isOfEstimator)
  {
    part.Name = name;
    part.Light = light;
    part.IsAsked = isAsked;
    part.IsOfEstimator = isOfEstimator;
  };
  choose(this->Parts[0], "indirect light", &this->Bounce, this->Plan.Irradiance, true);
  choose(this->Parts[1], "light from the sky", sky, this->Plan.Sky, ownSky);
  choose(this->Parts[2], "light of area lights", &this->Area, this->Plan.AreaLights, false);
}

//------------------------------------------------------------------------------
vtkIndirectKey vtkIndirectPipeline::MakeFrameKey() const
{
  vtkIndirectKey key = this->Plan.MakeKey(this->Frame);
  this->Levels.AppendTo(key);
  // A lamp changes the receivers that it hides from the eye.
  if (this->Plan.VisibleAreaLights > 0)
  {
    this->AppendAreaLights(key);
  }
  return key;
}

//------------------------------------------------------------------------------
// Lets the light ask for its depth maps, unless its last result holds.
void vtkIndirectPipeline::UpdatePart(Part& part, const vtkIndirectFrameLight::Input& input)
{
  vtkIndirectFrameLight& light = *part.Light;
  vtkIndirectKey key = this->FrameKey;
  light.AppendTo(key, input);
  part.IsStill = key == part.Key && part.Time == light.GetEstimateTime() && !light.HasMore(input);
  part.IsThere = part.IsStill && this->Plan.Caching &&
    part.Result.State == vtkIndirectEstimate::CONVERGED && light.IsComplete();
  part.IsNew = !part.IsThere && key != part.Failed;
  if (part.IsThere)
  {
    return;
  }
  part.EyeMoved = this->Plan.Caching && this->Plan.Interactive && !part.Key.IsEmpty() &&
    part.Time == light.GetEstimateTime() && part.Result.State == vtkIndirectEstimate::CONVERGED &&
    light.IsComplete() &&
    key.DiffersOnlyIn({ "eye", "pace", "finest level", "windows of light maps" }, part.Key);
  part.Key.Clear();
  if (part.IsNew)
  {
    part.Failed = std::move(key); // until the result is there
    vtkIndirectFrameLight::Input own = input;
    own.Still = part.IsStill;
    part.IsNew = light.Update(own);
  }
}

//------------------------------------------------------------------------------
// Computes the light after depth maps have been drawn.
void vtkIndirectPipeline::SumPart(
  Part& part, const vtkIndirectFrameLight::Input& input, bool mapsDrawn)
{
  part.Waits = mapsDrawn && this->Plan.WaitsForMaps && !part.Light->IsComplete();
  if (part.Waits)
  {
    part.Failed.Clear();
    return;
  }
  vtkIndirectFrameLight::Input own = input;
  own.Still = part.IsStill;
  own.EyeMoved = part.EyeMoved;
  part.Result = mapsDrawn ? part.Light->MakeEstimate(own) : vtkIndirectEstimate();
  part.Time = part.Light->GetEstimateTime();
  part.IsThere = part.Result.State != vtkIndirectEstimate::FAILED;
  if (part.IsThere)
  {
    part.Key = std::move(part.Failed);
    part.Failed.Clear();
    this->NumberOfEstimates += part.IsOfEstimator ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
void vtkIndirectPipeline::AppendAreaLights(vtkIndirectKey& key) const
{
  for (const auto& light : this->AreaLights)
  {
    key.Add("area lights", light);
  }
}

//------------------------------------------------------------------------------
// Returns true if the last frame has this light, and no other pass has used its images since.
bool vtkIndirectPipeline::IsCurrent(const Part& part) const
{
  return part.IsThere && (this->Estimator || !part.IsOfEstimator) &&
    part.Time == part.Light->GetEstimateTime();
}

//------------------------------------------------------------------------------
// Returns a bound of the irradiance. If all light comes from the sky, a receiver sees radiances of
// the sky and of surfaces. No surface reflects more than it receives, so none of these radiances
// exceeds the sky's greatest. Lamps have no radiance that bounds their irradiance.
glm::dvec3 vtkIndirectPipeline::FindGreatestIrradiance(
  const std::vector<vtkIndirectContribution>& lights) const
{
  const bool lamps = this->Plan.AreaLights || this->Plan.VirtualAreaLights ||
    this->Plan.OtherSamplers ||
    std::any_of(this->Frame.Lights.begin(), this->Frame.Lights.end(),
      [](const vtkIndirectLight& light) { return light.Color != glm::dvec3(0.0); });
  const bool sky = std::any_of(lights.begin(), lights.end(),
    [](const auto& light) { return light.Kind == vtkIndirectContribution::SKY; });
  glm::dvec3 greatest(1e30);
  // The bound fails for an unoccluded sky, which shines through surfaces and adds to their light.
  if (sky && this->Plan.SkyIsShadowed && this->Environment && !lamps)
  {
    vtkIndirectEmitterAccess::GetGreatestRadiance(this->Environment, &greatest[0]);
  }
  return greatest;
}

//------------------------------------------------------------------------------
vtkIndirectComposite::Input vtkIndirectPipeline::MakeCompositeInput() const
{
  const bool maps = this->Plan.Senders == vtkIndirectPlan::MAPS;
  std::vector<vtkIndirectContribution> lights;
  for (const Part& part : this->Parts)
  {
    if (this->IsCurrent(part))
    {
      const auto& more = part.Result.Contributions;
      lights.insert(lights.begin(), more.begin(), more.end()); // the composite adds bounces last
    }
  }
  return { this->Frame, this->Geometry, maps ? &this->Maps : nullptr, lights,
    this->FindGreatestIrradiance(lights), this->Plan.IndirectScale, this->TargetIsClear,
    this->DepthIsDrawn, this->Plan.Catches ? &this->Catchers.GetOpen() : nullptr,
    this->LampsAreReplaceable, this->Balance };
}

//------------------------------------------------------------------------------
// Tiles have the balance of the last whole picture, or else of the first tile, and the right eye
// that of the left.
void vtkIndirectPipeline::FindBalance(double mostReplaced)
{
  this->LampsAreReplaceable = mostReplaced > 0.0 && !this->Frame.Lights.empty();
  if (!this->LampsAreReplaceable)
  {
    this->BalanceIsOfWhole = false;
    this->Balance = vtkIndirectLightBalance();
    return;
  }
  const bool whole = this->Frame.IsWhole();
  if (!this->Frame.IsFurtherPart() && (whole || !this->BalanceIsOfWhole))
  {
    this->BalanceIsOfWhole = whole;
    this->Balance = vtkIndirectLightBalance::Find(
      this->Composite.Measure(this->MakeCompositeInput()), mostReplaced);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::RenderChannel(const std::string& name)
{
  const vtkIndirectComposite::Input input = this->MakeCompositeInput();
  return this->Composite.RenderChannel(input, name) ||
    (std::any_of(std::begin(this->Parts), std::end(this->Parts),
       [this](const Part& part) { return part.IsOfEstimator && this->IsCurrent(part); }) &&
      this->Composite.RenderChannel(input,
        [&]() {
          return vtkIndirectSum::Get(this->Estimator)
            .DrawChannel(name, this->Frame, this->Geometry);
        }));
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::ShowChannel(const std::string& name)
{
  this->Timer.Begin(vtkIndirectStageTimer::Composite);
  const bool shown =
    this->RenderChannel(name) && this->Composite.ShowImage(this->MakeCompositeInput());
  this->Timer.End(vtkIndirectStageTimer::Composite);
  return shown;
}

//------------------------------------------------------------------------------
void vtkIndirectPipeline::Forget(const std::string& why)
{
  this->BuffersAreThere = false;
  for (Part& part : this->Parts)
  {
    part.IsThere = false;
    part.Key.Clear();
  }
  this->WhyNoBuffers = why;
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::IsInWindow() const
{
  return this->Renderer && this->Frame.Window &&
    this->Renderer->GetRenderWindow() == this->Frame.Window;
}

//------------------------------------------------------------------------------
std::string vtkIndirectPipeline::CopyChannel(const std::string& name, vtkImageData* image)
{
  if (!this->BuffersAreThere || !this->IsInWindow())
  {
    return "only the delegate drew the last frame, because " + this->WhyNoBuffers;
  }
  this->Frame.Window->MakeCurrent();
  if (vtkIndirectFrameSamplers::IsTable(name))
  {
    return this->Plan.Irradiance ? this->Samplers.Copy(this->Frame, name, image)
                                 : "the last frame used no virtual lights";
  }
  if (this->RenderChannel(name))
  {
    this->Composite.CopyImage(image);
    return {};
  }
  int map = 0;
  int channel = 0;
  if (!vtkIndirectComposite::ParseMapChannel(name, map, channel))
  {
    return std::any_of(std::begin(this->Parts), std::end(this->Parts),
             [this](const Part& part) { return part.IsThere && !this->IsCurrent(part); })
      ? "another pass has used its estimator since"
      : "the last frame computed no indirect light";
  }
  return this->Plan.Senders == vtkIndirectPlan::HEADLIGHT
    ? "a single headlight is read from the geometry buffer and has no map"
    : this->Plan.MapsSend ? "the frame has fewer lights"
                          : "the maps of lights that follow the camera hold depths alone";
}

//------------------------------------------------------------------------------
void vtkIndirectPipeline::ReleaseOwn(vtkWindow* window)
{
  this->Schedule.Forgive();
  this->Capture->ReleaseGraphicsResources(window);
  this->Maps.Release(window);
  this->DepthMaps.Release(window);
  this->SkyProjection = vtkIndirectSkyProjection();
  this->Spheres->ReleaseGraphicsResources(window);
  this->SphereMotion.Forget();
  this->PointSpheres.Forget();
  this->DefaultEstimator->ReleaseGraphicsResources(window);
  if (this->Estimator)
  {
    this->Estimator->ReleaseGraphicsResources(window);
  }
  this->Estimator = nullptr;
  this->HeldEstimator = nullptr;
  this->Timer.Release();
  for (Part& part : this->Parts)
  {
    part.Failed.Clear();
  }
  this->Forget("its resources have been released");
}
