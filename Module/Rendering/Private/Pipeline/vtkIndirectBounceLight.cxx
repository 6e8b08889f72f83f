// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkIndirectBounceLight.h"

#include "Maps/vtkIndirectLightMaps.h"
#include "OpenGL/vtkIndirectKey.h"
#include "Pipeline/vtkIndirectFrameSamplers.h"
#include "Pipeline/vtkIndirectFrameSurfaces.h"
#include "Plan/vtkIndirectPlan.h"
#include "Plan/vtkIndirectReport.h"
#include "Plan/vtkIndirectStageTimer.h"
#include "Sums/vtkIndirectSum.h"
#include "vtkIndirectEstimatorPass.h"

//------------------------------------------------------------------------------
vtkIndirectBounceLight::vtkIndirectBounceLight(vtkIndirectResource* owner,
  vtkIndirectFrameSamplers& samplers, vtkIndirectFrameSurfaces& surfaces,
  vtkIndirectDepthMaps& maps, vtkIndirectDepthMaps::ClientType client, bool keepsSurfaces)
  : vtkIndirectFrameLight(owner)
  , Samplers(samplers)
  , Surfaces(surfaces)
  , KeepsSurfaces(keepsSurfaces)
  , Visibility(this, maps, client)
{
}

//------------------------------------------------------------------------------
vtkIndirectSum& vtkIndirectBounceLight::GetSum() const
{
  return vtkIndirectSum::Get(this->Estimator);
}

//------------------------------------------------------------------------------
void vtkIndirectBounceLight::AppendTo(vtkIndirectKey& key, const Input& input) const
{
  this->GetSum().AppendTo(key, input);
  key.Add("sampler", this->Users);
  this->Samplers.AppendTo(key);
  const bool maps = input.Plan.Senders == vtkIndirectPlan::MAPS;
  key.Add("light maps", maps ? input.Maps.GetContentTime() : 0);
  key.Add("windows of light maps", maps ? input.Maps.GetWindowTime() : 0);
}

//------------------------------------------------------------------------------
bool vtkIndirectBounceLight::HasMore(const Input& input) const
{
  return !input.Plan.Interactive && this->Samplers.HasMore();
}

//------------------------------------------------------------------------------
// Returns the spheres that mappers draw; null if no stage needs spheres.
const vtkIndirectBlockingSpheres* vtkIndirectBounceLight::UpdateSurfaces(
  const Input& input, const vtkIndirectVisibilityNeeds& needs)
{
  if (this->KeepsSurfaces)
  {
    this->Surfaces.SetIsKept(true);
  }
  return this->Surfaces.Update(input, needs, this->Samplers.Walk(), this->Estimator);
}

//------------------------------------------------------------------------------
const vtkIndirectSurfaces& vtkIndirectBounceLight::GetSurfaces(const Input& input)
{
  vtkIndirectVisibilityNeeds needs;
  needs.Surfaces = true;
  this->UpdateSurfaces(input, needs);
  return this->Surfaces.Get();
}

//------------------------------------------------------------------------------
bool vtkIndirectBounceLight::Update(const Input& input)
{
  const vtkIndirectVisibilityNeeds needs = this->GetSum().GetVisibilityNeeds(input.Plan);
  input.Timer.Begin(vtkIndirectStageTimer::Lights);
  const vtkIndirectBlockingSpheres* const spheres = this->UpdateSurfaces(input, needs);
  const bool sampled = this->Samplers.Update(input, this->Surfaces.Get());
  // With depth maps the visibility only reads the lights and asks for their maps.
  const bool walks = needs.IsAny() && !needs.Maps;
  if (walks)
  {
    input.Timer.End(vtkIndirectStageTimer::Lights);
    input.Timer.Begin(vtkIndirectStageTimer::Visibility);
  }
  this->Visibility.Update(
    { input.Frame, this->Samplers.GetLights(), input.Plan.Caching, this->Surfaces.Get(), spheres },
    needs);
  input.Timer.End(walks ? vtkIndirectStageTimer::Visibility : vtkIndirectStageTimer::Lights);
  return sampled;
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkIndirectBounceLight::MakeEstimate(const Input& input)
{
  this->Visibility.UpdateSharing(input.Frame);
  Input own = input;
  own.Still = input.Still && !this->Visibility.GetMaps().HasChanged();
  own.Lights = this->Samplers.GetLights();
  return this->GetSum().MakeEstimate(own);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkIndirectBounceLight::GetEstimateTime() const
{
  return this->GetSum().GetEstimateTime();
}

//------------------------------------------------------------------------------
void vtkIndirectBounceLight::Rest(const Input& input)
{
  this->Visibility.Update({ input.Frame, nullptr, false, this->Surfaces.Get() }, {});
  this->Surfaces.Rest();
}

//------------------------------------------------------------------------------
size_t vtkIndirectBounceLight::GetMainMemoryBytes() const
{
  return this->Surfaces.Get().GetBytes() + this->GetSum().GetMainMemoryBytes();
}

//------------------------------------------------------------------------------
void vtkIndirectBounceLight::AddToReport(vtkIndirectReport& report) const
{
  report.Method = this->Estimator->GetMethodName();
  report.Bytes += this->GetSum().GetBytes();
  this->GetSum().AddToReport(report);
  this->Visibility.AddToReport(report);
  this->Samplers.AddToReport(report);
}

//------------------------------------------------------------------------------
void vtkIndirectBounceLight::ReleaseOwn(vtkWindow*)
{
  this->Surfaces.SetIsKept(false);
  if (!this->KeepsSurfaces)
  {
    this->Surfaces.Clear();
  }
}
