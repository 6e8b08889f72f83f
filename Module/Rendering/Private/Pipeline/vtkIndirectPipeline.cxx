// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Pipeline/vtkIndirectPipeline.h"

#include "Capture/vtkIndirectDarkLight.h"
#include "Capture/vtkIndirectShadowMaps.h"
#include "Frame/vtkIndirectLightScope.h"
#include "Gather/vtkIndirectSum.h"
#include "OpenGL/vtkIndirectBackEndChoices.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "VirtualLights/vtkIndirectEmitterAccess.h"
#include "vtkAreaLight.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace
{
// Returns the irradiance of a surface that receives all of an environment's light at a right angle.
double SumIrradiance(vtkEnvironmentLight* environment)
{
  glm::dvec3 sum(0.0);
  for (const vtkIndirectEmitterAccess::Cell& cell : vtkIndirectEmitterAccess::GetCells(environment))
  {
    sum += glm::dvec3(cell.Light[0], cell.Light[1], cell.Light[2]);
  }
  return std::max({ sum.x, sum.y, sum.z }) / vtkMath::Pi();
}
}

//------------------------------------------------------------------------------
vtkIndirectPipeline::vtkIndirectPipeline()
{
  this->Identity.Modified();
}

//------------------------------------------------------------------------------
void vtkIndirectPipeline::Prepare(const vtkRenderState* s, const Request& request)
{
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
  circumstances.EnvironmentIrradiance = this->Environment ? SumIrradiance(this->Environment) : 0.0;
  circumstances.Environment = circumstances.EnvironmentIrradiance > 0.0;
  if (circumstances.Environment && request.Settings.Caching && request.Settings.SpheresInMotion)
  {
    this->SphereMotion.Update(this->Frame, this->Environment, interactive);
    circumstances.SpheresMove = this->SphereMotion.GetWhat();
    circumstances.SpheresFail = this->SphereMotion.GetWhyNot();
  }
  else
  {
    this->SphereMotion.Forget();
  }
  circumstances.ImageBasedLighting = this->Frame.Renderer->GetUseImageBasedLighting();
  const vtkIndirectAbilities abilities =
    vtkIndirectSum::Get(request.Estimator).GetAbilities(request.Settings.ErrorTolerance);
  circumstances.SamplerWalks =
    abilities.TakesSampler && vtkIndirectSampler::Get(request.Sampler)->GetAbilities().Walks;
  circumstances.OtherSamplerWalks = this->Samplers.HasOtherWalk();
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
  vtkIndirectEmitterAccess::SetLights(this->Samplers.Area, virtualAreaLights);
  // Old maps are released: they would show outdated shadows when the sky comes from maps again.
  const bool sky = circumstances.Environment && request.Settings.IndirectScale > 0.0;
  if (!sky || this->Plan.SkySource != vtkIndirectPlan::SKY_BY_MAPS)
  {
    this->ReleaseSkyMaps(this->Frame.Window);
  }
  if (!sky)
  {
    this->Parts[SKY].Key.Clear();
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
    this->Parts[AREA].Key.Clear();
  }
  if ((!circumstances.Environment && !circumstances.AreaLights) ||
    request.Settings.IndirectScale == 0.0)
  {
    this->Samplers.ReleaseSenderMaps(this->Frame.Window);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectPipeline::ReleaseSkyMaps(vtkWindow* window)
{
  this->SkyMaps.Release(window);
  this->SkyProjection = vtkIndirectSkyProjection();
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
  this->Maps.SetSpecular(this->Plan.SenderLobes);
  this->Capture->SetImageLight(!this->Plan.ReplacesImageLight);
  this->Capture->Attach(this->Frame);
  const vtkIndirectDarkLight dark(this->Frame);
  if (request.ReplacedLights)
  {
    vtkIndirectLightScope::Read(this->Frame.Renderer);
  }
  bool drawn = true;
  if (this->Plan.Senders != vtkIndirectPlan::HEADLIGHT)
  {
    this->Timer.Begin(vtkIndirectStageTimer::ReflectiveShadowMap);
    drawn =
      this->Maps.Update(this->Frame, this->Plan, this->Capture, this->MapsPass->GetResolution());
    if (drawn && this->Plan.Shadows)
    {
      drawn = this->Penumbra.Update(this->Frame, this->Maps, this->Capture);
    }
    this->Timer.End(vtkIndirectStageTimer::ReflectiveShadowMap);
  }
  drawn = drawn && this->UpdateSenderMaps();
  this->Timer.Begin(vtkIndirectStageTimer::Geometry);
  vtkIndirectShadowMaps shadows;
  const bool shadowed = drawn && this->Plan.Shadows;
  if (shadowed)
  {
    shadows = this->Maps.ActivateShadows(this->Frame.Window);
    this->Penumbra.Activate(shadows);
    drawn = shadows.Unit >= 0;
  }
  drawn = drawn &&
    this->Geometry.Update(s, this->Frame, this->Plan, this->Capture, shadowed ? &shadows : nullptr);
  if (shadowed)
  {
    this->Maps.DeactivateShadows();
    this->Penumbra.Deactivate();
  }
  drawn = drawn && !this->IsRedirected() &&
    this->VisibleLamps.Draw(this->Frame, this->UsableAreaLights, this->Geometry);
  this->TargetIsClear = request.DepthCleared;
  this->DepthIsDrawn = drawn && !this->IsRedirected() && request.DepthCleared &&
    request.DepthOfSamples && this->Plan.VisibleAreaLights == 0 &&
    this->Geometry.DrawDepthOfSamples(s, this->Frame, this->Capture);
  this->Timer.End(vtkIndirectStageTimer::Geometry);
  this->Capture->Detach();
  return drawn && !this->IsRedirected();
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::UpdateSenderMaps()
{
  if (!this->Plan.SkyBounces && !this->Plan.AreaLightsBounce)
  {
    this->Samplers.ReleaseSenderMaps(this->Frame.Window);
    return true;
  }
  this->Timer.Begin(vtkIndirectStageTimer::ReflectiveShadowMap);
  vtkEnvironmentLight* const sky = this->Plan.SkyBounces ? this->Environment : nullptr;
  vtkIndirectKey source;
  source.Add("sky", sky);
  if (this->Plan.AreaLightsBounce)
  {
    this->AppendAreaLights(source);
  }
  const auto makeEmitters = [&](bool inHaste)
  {
    vtkIndirectEmitters::List emitters;
    if (sky)
    {
      vtkIndirectEmitters::AddSky(emitters, this->SkyProjection, sky);
    }
    if (this->Plan.AreaLightsBounce)
    {
      vtkIndirectEmitters::AddAreaLights(emitters, this->UsableAreaLights, inHaste);
    }
    return emitters;
  };
  const bool drawn =
    this->Samplers.UpdateSenderMaps(this->Frame, this->Plan, this->Capture, source, makeEmitters);
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
  const vtkIndirectFrameLight::Input input = { this->Frame, this->Plan, this->Geometry,
    this->Creases, this->Maps, nullptr, this->Bounce.GetVisibility(), false, this->Timer,
    this->Environment, &this->SkyProjection, &this->ClosedAreaLights };
  for (Part& part : this->Parts)
  {
    if (part.IsAsked)
    {
      this->UpdatePart(part, input);
    }
    else
    {
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
  this->Timer.Begin(vtkIndirectStageTimer::Composite);
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
  this->Bounce.SetEstimator(this->Estimator, request.Sampler);
  vtkIndirectEstimatorPass* const estimator = this->GetSkyEstimator();
  this->EstimatorSky.SetEstimator(estimator, estimator == this->Estimator);
  if (this->Plan.Sky && estimator)
  {
    vtkIndirectSum::Get(estimator).HoldContext(this->Frame.Window, this->Identity.GetMTime());
  }
  if (this->Plan.SkySource == vtkIndirectPlan::SKY_BY_SPHERES)
  {
    this->Spheres->SetIndirectLight(this->Plan.SpheresBounceSky ? vtkProxyAccumulationPass::SHADOWED
                                                                : vtkProxyAccumulationPass::OFF);
  }
  vtkIndirectFrameLight* const sky =
    estimator ? static_cast<vtkIndirectFrameLight*>(&this->EstimatorSky) : &this->SkyMaps;
  vtkIndirectFrameLight* const lights[NUMBER_OF_PARTS] = { &this->Bounce, sky, &this->Area };
  const bool asked[NUMBER_OF_PARTS] = { this->Plan.Irradiance, this->Plan.Sky,
    this->Plan.AreaLights };
  for (int i = 0; i < NUMBER_OF_PARTS; ++i)
  {
    Part& part = this->Parts[i];
    if (part.Light != lights[i] || !lights[i]->IsCurrent())
    {
      part.Key.Clear();
    }
    part.Light = lights[i];
    part.IsAsked = asked[i];
  }
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
  part.IsStill = key == part.Key && !light.HasMore(input);
  part.IsThere = part.IsStill && this->Plan.Caching &&
    part.Result.State == vtkIndirectEstimate::CONVERGED && light.IsComplete();
  part.IsNew = !part.IsThere && key != part.Failed;
  if (part.IsThere)
  {
    return;
  }
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
  part.Result = mapsDrawn ? part.Light->Sum(own) : vtkIndirectEstimate();
  part.IsThere = part.Result.State != vtkIndirectEstimate::FAILED;
  if (part.IsThere)
  {
    part.Key = std::move(part.Failed);
    part.Failed.Clear();
    const bool estimates = part.Light == &this->Bounce ||
      (part.Light == &this->EstimatorSky && this->GetSkyEstimator() == this->Estimator);
    this->NumberOfEstimates += estimates ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
// Returns the estimator that computes the sky's light without maps; null if maps are looked up.
vtkIndirectEstimatorPass* vtkIndirectPipeline::GetSkyEstimator() const
{
  return this->Plan.SkySource == vtkIndirectPlan::SKY_BY_SPHERES ? this->Spheres
    : this->Plan.SkySource == vtkIndirectPlan::SKY_BY_ESTIMATOR  ? this->Estimator
                                                                 : nullptr;
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
// Returns a part of the last frame; null if the frame has none, or another pass has used its
// images.
const vtkIndirectPipeline::Part* vtkIndirectPipeline::GetPart(PartType type) const
{
  const Part& part = this->Parts[type];
  return part.IsThere && part.Light->IsCurrent() ? &part : nullptr;
}

//------------------------------------------------------------------------------
// Returns a bound of the irradiance. If all light comes from the sky, a receiver sees radiances of
// the sky and of surfaces. No surface reflects more than it receives, so none of these radiances
// exceeds the sky's greatest. Lamps have no radiance that bounds their irradiance.
glm::dvec3 vtkIndirectPipeline::FindGreatestIrradiance() const
{
  const std::vector<vtkIndirectLight>& lights = this->Frame.Lights;
  const bool lamps = this->Plan.AreaLights || this->Plan.VirtualAreaLights ||
    this->Plan.OtherSamplers ||
    std::any_of(lights.begin(), lights.end(),
      [](const vtkIndirectLight& light) { return light.Color != glm::dvec3(0.0); });
  glm::dvec3 greatest(1e30);
  // The bound fails for an unoccluded sky, which shines through surfaces and adds to their light.
  if (this->Parts[SKY].IsThere && this->Plan.SkyIsShadowed && this->Environment && !lamps)
  {
    vtkIndirectEmitterAccess::GetGreatestRadiance(this->Environment, &greatest[0]);
  }
  return greatest;
}

//------------------------------------------------------------------------------
vtkIndirectComposite::Input vtkIndirectPipeline::MakeCompositeInput() const
{
  const bool maps = this->Plan.Senders == vtkIndirectPlan::MAPS;
  const Part* const bounce = this->GetPart(BOUNCE);
  const Part* const skyPart = this->GetPart(SKY);
  const Part* const areaPart = this->GetPart(AREA);
  const vtkIndirectEstimate sky = skyPart ? skyPart->Result : vtkIndirectEstimate();
  const vtkIndirectEstimate area = areaPart ? areaPart->Result : vtkIndirectEstimate();
  return { this->Frame, this->Geometry, maps ? &this->Maps : nullptr,
    bounce ? &bounce->Result : nullptr, sky.Sky, sky.SkyBounce, sky.SkyBounceChannel, area.Area,
    area.AreaGlossy, this->FindGreatestIrradiance(), this->Plan.IndirectScale, this->TargetIsClear,
    this->DepthIsDrawn };
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::RenderChannel(const std::string& name)
{
  const vtkIndirectComposite::Input input = this->MakeCompositeInput();
  return this->Composite.RenderChannel(input, name) ||
    (this->GetPart(BOUNCE) &&
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
    return this->Parts[BOUNCE].IsThere ? this->Samplers.Copy(this->Frame, name, image)
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
    return this->Parts[BOUNCE].IsThere && !this->GetPart(BOUNCE)
      ? "another pass has used its estimator since"
      : "the last frame computed no indirect light";
  }
  return this->Plan.Senders == vtkIndirectPlan::HEADLIGHT
    ? "a single headlight is read from the geometry buffer and has no map"
    : "the frame has fewer lights";
}

//------------------------------------------------------------------------------
void vtkIndirectPipeline::ReleaseOwn(vtkWindow* window)
{
  this->Capture->ReleaseGraphicsResources(window);
  this->Maps.Release(window);
  this->SkyProjection = vtkIndirectSkyProjection();
  this->Spheres->ReleaseGraphicsResources(window);
  this->SphereMotion.Forget();
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
