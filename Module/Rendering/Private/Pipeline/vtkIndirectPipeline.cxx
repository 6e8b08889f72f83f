// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Pipeline/vtkIndirectPipeline.h"

#include "Capture/vtkIndirectDarkLight.h"
#include "Capture/vtkIndirectShadowMaps.h"
#include "Frame/vtkIndirectLightScope.h"
#include "Frame/vtkIndirectRevision.h"
#include "OpenGL/vtkIndirectPaths.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "vtkAreaLight.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace
{
// What falls on a surface that all of an environment's light reaches at a right angle.
double SumIrradiance(vtkEnvironmentLight* environment)
{
  glm::dvec3 sum(0.0);
  for (const vtkEnvironmentLight::Cell& cell : environment->GetCells())
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
  this->BuffersAreThere = this->IrradianceIsThere = false;
  this->SkyIsThere = this->AreaIsThere = false;
  this->IrradianceWaits = this->SkyWaits = false;
  this->Estimator = request.Estimator;
  this->HeldEstimator = request.HoldEstimator ? request.Estimator : nullptr;
  this->Frame = vtkIndirectFrame();
  if (!request.Settings.Caching)
  {
    this->Room.Forget();
  }
  const bool interactive = vtkIndirectPlan::IsInteractive(request.Circumstances.UpdateRate);
  this->Frame.Build(s, &this->Room, interactive);
  this->Levels.Update(this->Frame);
  this->Frame.ReplacedLights = request.ReplacedLights;
  vtkIndirectCircumstances circumstances = request.Circumstances;
  circumstances.NumberOfOtherEmitters = static_cast<int>(this->Samplers.Others.size());
  this->UsableAreaLights.clear();
  for (const auto& light : this->AreaLights)
  {
    if (!light->GetSwitch() ||
      light->ShinesInto(glm::value_ptr(this->Frame.SceneCenter), 1.0 / this->Frame.SceneScale))
    {
      this->UsableAreaLights.push_back(light);
    }
  }
  circumstances.AreaLightIrradiance = vtkIndirectEmitters::FindIrradiance(
    this->UsableAreaLights, glm::value_ptr(this->Frame.SceneCenter));
  circumstances.AreaLights = circumstances.AreaLightIrradiance > 0.0;
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
  circumstances.TakesSampler =
    request.Estimator->ChooseSampler(request.Sampler, vtkIndirectPlan()) == request.Sampler;
  circumstances.SamplerWalks = circumstances.TakesSampler && request.Sampler->Walks();
  circumstances.OtherSamplerWalks = this->Samplers.HasOtherWalk();
  this->Plan = vtkIndirectPlan::Make(this->Frame, request.Settings,
    request.Estimator->GetAbilities(request.Settings.ErrorTolerance), circumstances);
  // Maps of the scene as it was would show shadows that are gone when the sky comes from them
  // again.
  const bool sky = circumstances.Environment && request.Settings.IndirectScale > 0.0;
  if (!sky || this->Plan.SkySource != vtkIndirectPlan::SKY_BY_MAPS)
  {
    this->ReleaseSkyMaps(this->Frame.Window);
  }
  if (!sky)
  {
    this->SkyKey.clear();
  }
  // What moves stops and goes on; programs for it take seconds to build.
  if (!sky || !this->SphereMotion.HasMoved())
  {
    this->Spheres->ReleaseGraphicsResources(this->Frame.Window);
  }
  if (!circumstances.AreaLights || request.Settings.IndirectScale == 0.0)
  {
    this->Area.Release(this->Frame.Window);
    this->AreaKey.clear();
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
  this->Sky.Release(window);
  this->SkyProjection = vtkIndirectSkyProjection();
}

//------------------------------------------------------------------------------
// The maps come first because visibility belongs to each light: it goes into VTK's own shading.
bool vtkIndirectPipeline::DrawSurfaces(const vtkRenderState* s, const Request& request)
{
  if (!this->Plan.Antialiasing)
  {
    this->Antialiasing.Release(this->Frame.Window);
  }
  if (!this->Plan.Shadows)
  {
    this->Penumbra.Clear(this->Frame);
  }
  this->Paths = vtkIndirectPaths::GetAll();
  this->Capture->SetDelegatePass(request.Delegate);
  this->Capture->SetShadows(this->Plan.Shadows);
  this->Capture->SetSpecular(this->Plan.SurfacesAreSpecular || this->Plan.SenderLobes);
  this->Maps->SetSpecular(this->Plan.SenderLobes);
  this->Capture->SetSpecularOfPBR(this->Plan.AreaSpecular && this->Frame.PhysicallyBased);
  this->Capture->SetImageLight(!this->Plan.ReplacesImageLight);
  this->Capture->Attach(this->Frame);
  const vtkIndirectDarkLight dark(this->Frame);
  if (request.ReplacedLights)
  {
    vtkIndirectLightScope::Read(this->Frame.Renderer);
  }
  bool drawn = true;
  if (this->Plan.Senders != vtkIndirectPlan::EYE)
  {
    this->Timer.Begin(vtkIndirectStageTimer::ReflectiveShadowMap);
    drawn = this->Maps->Update(this->Frame, this->Plan, this->Capture);
    if (drawn && this->Plan.Shadows)
    {
      drawn =
        this->Penumbra.Update(this->Frame, *this->Maps, this->Capture, request.Settings.Caching);
    }
    this->Timer.End(vtkIndirectStageTimer::ReflectiveShadowMap);
  }
  drawn = drawn && this->UpdateSenderMaps();
  this->Timer.Begin(vtkIndirectStageTimer::Geometry);
  vtkIndirectShadowMaps shadows;
  const bool shadowed = drawn && this->Plan.Shadows;
  if (shadowed)
  {
    shadows = this->Maps->ActivateShadows(this->Frame.Window);
    this->Penumbra.Activate(shadows);
    drawn = shadows.Unit >= 0;
  }
  drawn = drawn &&
    this->Geometry.Update(s, this->Frame, this->Plan, this->Capture, shadowed ? &shadows : nullptr);
  if (shadowed)
  {
    this->Maps->Deactivate();
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
  std::vector<double> source;
  vtkIndirectRevision::AppendTo(source, sky);
  if (this->Plan.AreaLightsBounce)
  {
    this->AppendAreaLights(source);
  }
  const auto makeEmitters = [&]
  {
    vtkIndirectEmitters::List emitters;
    if (sky)
    {
      vtkIndirectEmitters::AddSky(emitters, this->SkyProjection, sky);
    }
    if (this->Plan.AreaLightsBounce)
    {
      vtkIndirectEmitters::AddAreaLights(emitters, this->UsableAreaLights);
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
  this->FrameKey = this->MakeFrameKey();
  this->Estimator->HoldContext(this->Frame.Window, this->Identity.GetMTime());
  if (!this->IsEstimateThere())
  {
    this->EstimateKey.clear();
    this->SkyKey.clear();
  }
  this->Samplers.Choose(
    this->Frame, this->Plan, this->Estimator->ChooseSampler(request.Sampler, this->Plan));
  this->TilesLeft = this->Plan.TilesPerFrame;
  this->IrradianceIsThere = this->Plan.Irradiance && this->UpdateIrradiance(request);
  if (!this->Plan.Irradiance && this->GetSkySummer())
  {
    // No stage needs visibility: release what it holds.
    this->Visibility.Update({ this->Frame, nullptr, this->Capture, false, 0, this->Surfaces }, {});
    this->Surfaces.Clear();
  }
  this->SkyIsThere = this->Plan.Sky && this->UpdateSky(request);
  this->AreaIsThere = this->Plan.AreaLights && this->UpdateArea(request);
  this->EstimateTime = this->Estimator->GetEstimateTime();
  this->Timer.Begin(vtkIndirectStageTimer::Composite);
  const bool composed = this->Composite.Composite(this->MakeCompositeInput());
  if (composed && this->Plan.Antialiasing)
  {
    this->Antialiasing.Apply(this->Frame, this->Geometry);
  }
  this->Timer.End(vtkIndirectStageTimer::Composite);
}

//------------------------------------------------------------------------------
// What all light depends on.
std::vector<double> vtkIndirectPipeline::MakeFrameKey() const
{
  std::vector<double> key = this->Plan.MakeKey(this->Frame);
  this->Levels.AppendTo(key);
  // Receivers that a lamp hides get nothing.
  if (this->Plan.VisibleAreaLights > 0)
  {
    this->AppendAreaLights(key);
  }
  return key;
}

//------------------------------------------------------------------------------
// What the irradiance depends on.
std::vector<double> vtkIndirectPipeline::MakeKey(vtkVirtualLightSampler* users) const
{
  std::vector<double> key = this->FrameKey;
  vtkIndirectRevision::AppendTo(key, this->Estimator);
  vtkIndirectRevision::AppendTo(key, users);
  this->Samplers.AppendTo(key);
  key.push_back(static_cast<double>(
    this->Plan.Senders == vtkIndirectPlan::MAPS ? this->Maps->GetContentTime() : 0));
  for (size_t i = 0; this->Plan.Senders == vtkIndirectPlan::RAYS && i < this->Frame.Lights.size();
       ++i)
  {
    const vtkIndirectLight& light = this->Frame.Lights[i];
    key.insert(key.end(),
      { light.PositionWC.x, light.PositionWC.y, light.PositionWC.z, light.Attenuation.x,
        light.Attenuation.y, light.Attenuation.z, light.ConeAngle, light.Exponent });
  }
  return key;
}

//------------------------------------------------------------------------------
// Brings the surfaces up to date where rays of samplers or of the estimator look for them, and
// returns what mappers draw as spheres, null where no stage asks for it.
const vtkIndirectBlockingSpheres* vtkIndirectPipeline::UpdateSurfaces(
  const vtkIndirectVisibilityNeeds& needs, bool caching)
{
  const bool walks = this->Samplers.Walk();
  const bool traced = walks || needs.HasSurfaces();
  const bool listed = traced || needs.HasSphereLists();
  const auto stage = walks ? vtkIndirectStageTimer::Lights : vtkIndirectStageTimer::Visibility;
  if (listed)
  {
    this->Timer.Begin(stage);
  }
  if (!listed || !caching)
  {
    this->Blockers.Forget();
  }
  if (needs.HasSurfaces() && !caching)
  {
    this->Surfaces.Forget();
  }
  const vtkIndirectBlockingSpheres* const spheres =
    listed ? this->Blockers.Update(this->Frame, this->Estimator) : nullptr;
  if (traced)
  {
    this->Surfaces.Update(this->Frame, spheres);
  }
  else
  {
    this->Surfaces.Clear();
  }
  if (listed)
  {
    this->Timer.End(stage);
  }
  return spheres;
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::UpdateIrradiance(const Request& request)
{
  const std::vector<double> key = this->MakeKey(request.Sampler);
  const bool caching = request.Settings.Caching;
  const bool still = key == this->EstimateKey;
  const bool more = !this->Plan.Interactive && this->Samplers.HasMore();
  if (caching && still && !more && this->Estimate.State == vtkIndirectEstimate::CONVERGED &&
    this->Visibility.IsComplete())
  {
    return true;
  }
  this->EstimateKey.clear();
  if (key == this->FailedKey)
  {
    return false;
  }
  this->FailedKey.clear();

  const vtkIndirectVisibilityNeeds needs = this->Estimator->GetVisibilityNeeds(this->Plan);
  const vtkIndirectBlockingSpheres* const spheres = this->UpdateSurfaces(needs, caching);
  this->Timer.Begin(vtkIndirectStageTimer::Lights);
  const bool sampled =
    this->Samplers.Update(this->Frame, this->Plan, *this->Maps, this->Geometry, this->Surfaces);
  const vtkIndirectVirtualLights* const lights = this->Samplers.GetLights();
  this->Timer.End(vtkIndirectStageTimer::Lights);

  const bool timed = needs.IsAny();
  if (timed)
  {
    this->Timer.Begin(vtkIndirectStageTimer::Visibility);
  }
  const size_t tiles = this->Visibility.GetNumberOfTilesDrawn();
  // Maps of the sky and of area lights share the frame's work: they get what they may need, half at
  // most.
  const int most = this->Plan.TilesPerFrame;
  const bool skyNeeds = this->Plan.HasSkyMaps() && !this->Sky.IsComplete();
  const bool areaNeeds =
    this->Plan.AreaLights && this->Plan.AreaIsShadowed && !this->Area.IsComplete();
  // Beside its directions a sky may have a few suns.
  const int needed = areaNeeds ? most : skyNeeds ? this->Plan.NumberOfSkyDirections + 32 : 0;
  const bool visible =
    this->Visibility.Update({ this->Frame, lights, this->Capture, caching,
                              most - std::min(needed, most / 2), this->Surfaces, spheres },
      needs);
  this->TilesLeft = most - static_cast<int>(this->Visibility.GetNumberOfTilesDrawn() - tiles);
  if (timed)
  {
    this->Timer.End(vtkIndirectStageTimer::Visibility);
  }
  this->IrradianceWaits =
    visible && this->Plan.WaitsForMaps && this->Visibility.GetNumberOfTilesLeft() > 0;
  if (this->IrradianceWaits)
  {
    return false;
  }

  const vtkIndirectEstimateInput input = { this->Frame, this->Plan, this->Geometry, *this->Maps,
    lights, this->Visibility, still && !more && this->Visibility.GetNumberOfTilesDrawn() == tiles,
    this->Timer };
  this->Estimate =
    sampled && visible ? this->Estimator->MakeEstimate(input) : vtkIndirectEstimate();
  if (this->Estimate.State == vtkIndirectEstimate::FAILED)
  {
    this->FailedKey = key;
    return false;
  }
  this->EstimateKey = key;
  ++this->NumberOfEstimates;
  return true;
}

//------------------------------------------------------------------------------
// Who sums the sky without maps; null where they are looked up.
vtkIndirectEstimatorPass* vtkIndirectPipeline::GetSkySummer() const
{
  return this->Plan.SkySource == vtkIndirectPlan::SKY_BY_SPHERES ? this->Spheres
    : this->Plan.SkySource == vtkIndirectPlan::SKY_BY_ESTIMATOR  ? this->Estimator
                                                                 : nullptr;
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::UpdateSky(const Request& request)
{
  vtkIndirectEstimatorPass* const summer = this->GetSkySummer();
  if (!summer)
  {
    return this->UpdateSkyMaps(request);
  }
  if (summer == this->Spheres)
  {
    this->Spheres->SetIndirectLight(this->Plan.SpheresBounceSky ? vtkProxyAccumulationPass::SHADOWED
                                                                : vtkProxyAccumulationPass::OFF);
  }
  std::vector<double> key = this->FrameKey;
  vtkIndirectRevision::AppendTo(key, summer);
  vtkIndirectRevision::AppendTo(key, this->Environment);
  const bool failed = this->SkyEstimate.State == vtkIndirectEstimate::FAILED;
  if (key == this->SkyKey && (failed || request.Settings.Caching))
  {
    return !failed;
  }
  const vtkIndirectEstimateInput input = { this->Frame, this->Plan, this->Geometry, *this->Maps,
    nullptr, this->Visibility, false, this->Timer, this->Environment };
  summer->HoldContext(this->Frame.Window, this->Identity.GetMTime());
  this->SkyEstimate = summer->MakeEstimate(input);
  this->SkyKey = std::move(key);
  this->NumberOfEstimates += summer == this->Estimator ? 1 : 0;
  return this->SkyEstimate.State != vtkIndirectEstimate::FAILED;
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::UpdateSkyMaps(const Request& request)
{
  const vtkIndirectSkyGather::Input input = { this->Frame, this->Plan, this->Geometry,
    this->Capture, this->Environment, this->SkyProjection };
  this->Timer.Begin(vtkIndirectStageTimer::Visibility);
  const size_t tiles = this->Sky.GetNumberOfTilesDrawn();
  const bool visible = this->Sky.UpdateMaps(input, this->TilesLeft);
  this->TilesLeft -= static_cast<int>(this->Sky.GetNumberOfTilesDrawn() - tiles);
  this->Timer.End(vtkIndirectStageTimer::Visibility);
  std::vector<double> key = this->FrameKey;
  key.push_back(static_cast<double>(this->Sky.GetContentTime()));
  key.push_back(this->Plan.NumberOfSkyDirections);
  key.push_back(this->Plan.SkyBlock);
  key.push_back(this->Plan.SkyIsShadowed ? 1.0 : 0.0);
  if (request.Settings.Caching && key == this->SkyKey)
  {
    return true;
  }
  this->SkyKey.clear();
  this->SkyWaits = visible && this->Plan.WaitsForMaps && !this->Sky.IsComplete();
  if (this->SkyWaits)
  {
    return false;
  }
  this->Timer.Begin(vtkIndirectStageTimer::Sky);
  const bool summed = visible && this->Sky.Sum(input);
  this->Timer.End(vtkIndirectStageTimer::Sky);
  if (summed)
  {
    this->SkyKey = key;
  }
  return summed;
}

//------------------------------------------------------------------------------
void vtkIndirectPipeline::AppendAreaLights(std::vector<double>& key) const
{
  for (const auto& light : this->AreaLights)
  {
    vtkIndirectRevision::AppendTo(key, light);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::UpdateArea(const Request& request)
{
  const vtkIndirectAreaGather::Input input = { this->Frame, this->Plan, this->Geometry,
    this->Capture, this->UsableAreaLights };
  this->Timer.Begin(vtkIndirectStageTimer::Visibility);
  const bool updated = this->Area.Update(input, std::max(this->TilesLeft, 0));
  this->Timer.End(vtkIndirectStageTimer::Visibility);
  std::vector<double> key = this->FrameKey;
  key.push_back(static_cast<double>(this->Area.GetContentTime()));
  key.push_back(this->Plan.Interactive ? 1.0 : 0.0);
  const bool same = request.Settings.Caching && key == this->AreaKey;
  if (same && this->Area.IsFinished())
  {
    return true;
  }
  this->AreaKey.clear();
  this->Timer.Begin(vtkIndirectStageTimer::Area);
  const bool summed = updated && this->Area.Sum(input, same);
  this->Timer.End(vtkIndirectStageTimer::Area);
  if (summed)
  {
    this->AreaKey = key;
  }
  return summed;
}

//------------------------------------------------------------------------------
// Whether the estimator has done nothing else since the last frame.
bool vtkIndirectPipeline::IsEstimateThere() const
{
  return this->Estimator && this->Estimator->GetEstimateTime() == this->EstimateTime;
}

//------------------------------------------------------------------------------
// The last frame's, null where there is none.
const vtkIndirectEstimate* vtkIndirectPipeline::GetEstimate() const
{
  return this->IrradianceIsThere && this->IsEstimateThere() ? &this->Estimate : nullptr;
}

//------------------------------------------------------------------------------
// Where all light comes from the sky a receiver sees radiances of the sky and of surfaces, and as
// no surface reflects more than it gets none of these is greater than the sky's greatest. Lamps
// have no radiance that bounds what they give.
glm::dvec3 vtkIndirectPipeline::FindGreatestIrradiance() const
{
  const std::vector<vtkIndirectLight>& lights = this->Frame.Lights;
  const bool lamps = this->Plan.AreaLights || this->Plan.OtherSamplers ||
    std::any_of(lights.begin(), lights.end(),
      [](const vtkIndirectLight& light) { return light.Color != glm::dvec3(0.0); });
  glm::dvec3 greatest(1e30);
  // A sky that nothing hides is seen through surfaces: together there is more.
  if (this->SkyIsThere && this->Plan.SkyIsShadowed && this->Environment && !lamps)
  {
    this->Environment->GetGreatestRadiance(&greatest[0]);
  }
  return greatest;
}

//------------------------------------------------------------------------------
vtkIndirectComposite::Input vtkIndirectPipeline::MakeCompositeInput() const
{
  const bool maps = this->Plan.Senders == vtkIndirectPlan::MAPS;
  const vtkIndirectEstimate* const estimate = this->GetEstimate();
  const vtkIndirectEstimatorPass* const summer = this->GetSkySummer();
  const bool there = this->SkyIsThere && (summer != this->Estimator || this->IsEstimateThere());
  const bool summed = there && summer;
  const vtkIndirectTarget* const sky = summed ? this->SkyEstimate.Sky : &this->Sky.GetIrradiance();
  return { this->Frame, this->Geometry, maps ? this->Maps.Get() : nullptr, estimate,
    there ? sky : nullptr, summed ? this->SkyEstimate.SkyBounce : nullptr,
    this->SkyEstimate.SkyBounceChannel, this->AreaIsThere ? &this->Area.GetIrradiance() : nullptr,
    this->AreaIsThere ? this->Area.GetReflected() : nullptr, this->FindGreatestIrradiance(),
    this->Plan.IndirectScale, this->TargetIsClear, this->DepthIsDrawn };
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::RenderChannel(const std::string& name)
{
  const vtkIndirectComposite::Input input = this->MakeCompositeInput();
  return this->Composite.RenderChannel(input, name) ||
    (this->GetEstimate() &&
      this->Composite.RenderChannel(
        input, [&]() { return this->Estimator->DrawChannel(name, this->Frame, this->Geometry); }));
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
  this->BuffersAreThere = this->IrradianceIsThere = this->SkyIsThere = false;
  this->EstimateKey.clear();
  this->SkyKey.clear();
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
    return this->IrradianceIsThere ? this->Samplers.Copy(this->Frame, name, image)
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
    return this->IrradianceIsThere && !this->IsEstimateThere()
      ? "another pass has used its estimator since"
      : "the last frame computed no indirect light";
  }
  return this->Plan.Senders == vtkIndirectPlan::EYE
    ? "a single headlight is read from the geometry buffer and has no map"
    : "the frame has fewer lights";
}

//------------------------------------------------------------------------------
void vtkIndirectPipeline::Release(vtkWindow* window)
{
  this->Capture->ReleaseGraphicsResources(window);
  this->Levels.Release(window);
  this->Maps->ReleaseGraphicsResources(window);
  this->Penumbra.Release(window);
  this->Geometry.Release(window);
  this->Samplers.Release(window);
  this->ReleaseSkyMaps(window);
  this->Spheres->ReleaseGraphicsResources(window);
  this->SphereMotion.Forget();
  this->Area.Release(window);
  this->VisibleLamps.Release(window);
  this->Visibility.Release(window);
  this->Surfaces.Clear();
  this->Blockers.Forget();
  this->DefaultEstimator->ReleaseGraphicsResources(window);
  if (this->Estimator)
  {
    this->Estimator->ReleaseGraphicsResources(window);
  }
  this->Estimator = nullptr;
  this->HeldEstimator = nullptr;
  this->Composite.Release(window);
  this->Antialiasing.Release(window);
  this->Timer.Release();
  this->FailedKey.clear();
  this->Forget("its resources have been released");
}
