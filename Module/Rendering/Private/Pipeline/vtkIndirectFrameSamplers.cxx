// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Pipeline/vtkIndirectFrameSamplers.h"

#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectPlan.h"
#include "Frame/vtkIndirectReport.h"
#include "Frame/vtkIndirectRevision.h"
#include "vtkImageData.h"
#include "vtkMapLightSampler.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

namespace
{
// What later bounces are made of. See Documentation/methods/random-walk.md.
constexpr int VerticesOfLaterBounces = 32768;
constexpr int LightsOfLaterBounces = 64;
}

//------------------------------------------------------------------------------
vtkIndirectFrameSamplers::vtkIndirectFrameSamplers()
{
  this->LaterBounces->SetFirstBounce(2);
  this->LaterBounces->SetNumberOfVertices(VerticesOfLaterBounces);
  this->LaterBounces->SetNumberOfLights(LightsOfLaterBounces);
}

//------------------------------------------------------------------------------
bool vtkIndirectFrameSamplers::HasOtherWalk() const
{
  return std::any_of(
    this->Others.begin(), this->Others.end(), [](const auto& sampler) { return sampler->Walks(); });
}

//------------------------------------------------------------------------------
bool vtkIndirectFrameSamplers::UpdateSenderMaps(const vtkIndirectFrame& frame,
  const vtkIndirectPlan& plan, vtkSurfaceCapturePass* capture, const std::vector<double>& source,
  const std::function<vtkIndirectEmitters::List()>& makeEmitters)
{
  if (!this->Senders->Knows(source))
  {
    this->Senders->SetEmitters(makeEmitters(), source);
  }
  return this->Senders->DrawMaps(frame, plan, capture);
}

//------------------------------------------------------------------------------
void vtkIndirectFrameSamplers::Choose(
  const vtkIndirectFrame& frame, const vtkIndirectPlan& plan, vtkVirtualLightSampler* own)
{
  this->Samplers.clear();
  // Others may have had those of users in another window.
  if (own)
  {
    own->HoldContext(frame.Window);
  }
  for (const auto& other : this->Others)
  {
    other->HoldContext(frame.Window);
  }
  vtkVirtualLightSampler* sampler = own;
  this->Senders->SetNumberOfLightsOf(sampler);
  if (sampler && plan.Senders == vtkIndirectPlan::EYE)
  {
    vtkMapLightSampler* pattern = sampler->GetViewPattern();
    this->Headlight->SetPattern(pattern ? pattern : this->Default->GetViewPattern());
    sampler = this->Headlight;
  }
  if (sampler && plan.Senders != vtkIndirectPlan::NO_SENDERS)
  {
    this->Samplers.emplace_back(sampler);
  }
  if (plan.SkyBounces || plan.AreaLightsBounce)
  {
    this->Samplers.emplace_back(this->Senders.Get());
  }
  if (plan.Refraction)
  {
    this->Refraction->SetNumberOfLightsOf(own);
    this->Samplers.emplace_back(this->Refraction.Get());
  }
  else
  {
    this->Refraction->ReleaseGraphicsResources(frame.Window);
  }
  this->SendersAreWalked = plan.WalkedBounces > 0 &&
    std::any_of(this->Samplers.begin(), this->Samplers.end(),
      [](const auto& one) { return one->TakesSenders(); });
  if (plan.WalkedBounces == 0)
  {
    this->LaterBounces->ReleaseGraphicsResources(frame.Window);
  }
  else if (!this->SendersAreWalked)
  {
    this->Samplers.emplace_back(this->LaterBounces.Get());
  }
  if (plan.OtherSamplers)
  {
    this->Samplers.insert(this->Samplers.end(), this->Others.begin(), this->Others.end());
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectFrameSamplers::Walk() const
{
  return this->SendersAreWalked ||
    std::any_of(this->Samplers.begin(), this->Samplers.end(),
      [](const auto& sampler) { return sampler->Walks(); });
}

//------------------------------------------------------------------------------
bool vtkIndirectFrameSamplers::Update(const vtkIndirectFrame& frame, const vtkIndirectPlan& plan,
  const vtkReflectiveShadowMapPass& maps, const vtkIndirectGeometryBuffer& geometry,
  const vtkIndirectSurfaces& surfaces)
{
  vtkVirtualLightSampler::Input input = { frame, maps, geometry, plan.ErrorTolerance,
    plan.SampledBounces, plan.Interactive,
    plan.SkyBounces || plan.AreaLightsBounce ? &this->Senders->GetEmitters() : nullptr };
  input.Surfaces = &surfaces;
  input.Further = this->SendersAreWalked ? &this->LaterBounces->UpdateSenders(input) : nullptr;
  return this->Samplers.empty() ||
    this->Lights.Update(input, { this->Samplers.begin(), this->Samplers.end() });
}

//------------------------------------------------------------------------------
bool vtkIndirectFrameSamplers::HasMore() const
{
  return (this->SendersAreWalked && this->LaterBounces->HasMore()) ||
    std::any_of(this->Samplers.begin(), this->Samplers.end(),
      [](const auto& sampler) { return sampler->HasMore(); });
}

//------------------------------------------------------------------------------
void vtkIndirectFrameSamplers::AppendTo(std::vector<double>& key) const
{
  for (const auto& sampler : this->Others)
  {
    vtkIndirectRevision::AppendTo(key, sampler);
  }
  key.push_back(static_cast<double>(this->Senders->GetSourceTime()));
}

//------------------------------------------------------------------------------
bool vtkIndirectFrameSamplers::IsTable(const std::string& name)
{
  return name == "lights" || name == "branches" || name == "lobes";
}

//------------------------------------------------------------------------------
std::string vtkIndirectFrameSamplers::Copy(
  const vtkIndirectFrame& frame, const std::string& name, vtkImageData* image)
{
  if (!this->Samplers.empty() && !this->Lights.AreThere())
  {
    return "another pass has used a sampler of the last frame since";
  }
  const bool lights = name == "lights";
  const bool branches = name == "branches";
  if (this->Samplers.empty() ||
    !(lights || (branches ? this->Lights.HasBranches() : this->Lights.HasLobes())))
  {
    return lights ? "the last frame used no virtual lights"
                  : "no virtual light of the last frame has any";
  }
  if (lights)
  {
    this->Lights.CopyLights(frame, image);
  }
  else if (branches)
  {
    this->Lights.CopyBranches(frame, image);
  }
  else
  {
    this->Lights.CopyLobes(frame, image);
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkIndirectFrameSamplers::AddToReport(vtkIndirectReport& report) const
{
  report.VirtualLights = this->Samplers.empty() ? 0 : this->Lights.GetNumberOfLights();
  report.Bytes += this->Lights.GetBytes();
  for (const auto& sampler : this->Samplers)
  {
    report.Bytes += sampler->GetBytes();
    sampler->AddToReport(report);
  }
  if (this->SendersAreWalked)
  {
    this->LaterBounces->AddToReport(report);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectFrameSamplers::Release(vtkWindow* window)
{
  this->Default->ReleaseGraphicsResources(window);
  this->Headlight->ReleaseGraphicsResources(window);
  this->Senders->ReleaseGraphicsResources(window);
  this->Refraction->ReleaseGraphicsResources(window);
  this->LaterBounces->ReleaseGraphicsResources(window);
  for (const auto& sampler : this->Others)
  {
    sampler->ReleaseGraphicsResources(window);
  }
  for (const auto& sampler : this->Samplers)
  {
    sampler->ReleaseGraphicsResources(window);
  }
  this->Samplers.clear();
  this->Lights.Release(window);
}
