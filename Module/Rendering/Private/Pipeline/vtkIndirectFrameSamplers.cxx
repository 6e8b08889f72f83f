// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Pipeline/vtkIndirectFrameSamplers.h"

#include "Plan/vtkIndirectEstimate.h"
#include "Plan/vtkIndirectPlan.h"
#include "Plan/vtkIndirectReport.h"
#include "Scene/vtkIndirectFrame.h"
#include "Senders/vtkIndirectMapSampler.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

namespace
{
// Later bounces are made of this many vertices and lights. See
// Documentation/methods/random-walk.md.
constexpr int VerticesOfLaterBounces = 65536;
constexpr int LightsOfLaterBounces = 64;
}

//------------------------------------------------------------------------------
vtkIndirectFrameSamplers::vtkIndirectFrameSamplers(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
{
  this->LaterBounces->SetFirstBounce(2);
  this->LaterBounces->SetNumberOfLights(LightsOfLaterBounces);
}

//------------------------------------------------------------------------------
bool vtkIndirectFrameSamplers::HasOtherWalk() const
{
  return std::any_of(this->Others.begin(), this->Others.end(),
    [](const auto& other) { return vtkIndirectSampler::Get(other)->GetAbilities().Walks; });
}

//------------------------------------------------------------------------------
bool vtkIndirectFrameSamplers::UpdateSenderMaps(const vtkIndirectFrame& frame,
  const vtkIndirectPlan& plan, vtkSurfaceCapturePass* capture, const vtkIndirectKey& source,
  const std::function<vtkIndirectEmitters::List(bool inHaste)>& makeEmitters)
{
  this->Senders->BeginFrame(frame, plan);
  const bool inHaste = plan.AreaLightsBounce && this->Senders->IsHasty();
  vtkIndirectKey key = source;
  key.Add("haste", inHaste);
  if (!this->Senders->Knows(key))
  {
    this->Senders->SetEmitters(makeEmitters(inHaste), key);
  }
  return this->Senders->DrawMaps(frame, plan, capture);
}

//------------------------------------------------------------------------------
void vtkIndirectFrameSamplers::Choose(const vtkIndirectFrame& frame, const vtkIndirectPlan& plan,
  const vtkIndirectSampler::Pointer& own)
{
  this->Samplers.clear();
  // The lights of the user's samplers may belong to another window.
  if (own)
  {
    own->HoldContext(frame.Window);
  }
  std::vector<vtkIndirectSampler::Pointer> others;
  for (const auto& other : this->Others)
  {
    others.push_back(vtkIndirectSampler::Get(other));
    others.back()->HoldContext(frame.Window);
  }
  const vtkIndirectSamplerAbilities abilities =
    own ? own->GetAbilities() : vtkIndirectSamplerAbilities();
  this->Senders->Follow(abilities, plan.LightsTurn);
  this->LaterBounces->SetNumberOfVertices(
    VerticesOfLaterBounces * vtkIndirectSamplerAbilities::FindDetail(abilities.NumberOfLights));
  vtkIndirectSampler::Pointer sampler = own;
  if (sampler && plan.Senders == vtkIndirectPlan::HEADLIGHT)
  {
    vtkIndirectMapSampler* pattern = sampler->GetHeadlightPattern();
    this->Headlight->SetPattern(
      pattern ? pattern : vtkIndirectSampler::Get(this->Default)->GetHeadlightPattern());
    sampler = this->Headlight;
  }
  if (sampler && plan.Senders != vtkIndirectPlan::NO_SENDERS && !plan.LightsTurn)
  {
    this->Samplers.emplace_back(sampler);
  }
  if (plan.HasSenderMaps())
  {
    this->Samplers.emplace_back(this->Senders);
  }
  if (plan.VirtualAreaLights)
  {
    this->Area->SetNumberOfLights(abilities.NumberOfLights);
    this->Area->SetClustering(
      plan.MinMaxAreaLights ? vtkAreaLightSampler::MIN_MAX : vtkAreaLightSampler::VARIANCE);
    this->Samplers.emplace_back(vtkIndirectSampler::Get(this->Area));
  }
  else
  {
    this->Area->ReleaseGraphicsResources(frame.Window);
  }
  if (plan.Refraction)
  {
    this->Refraction->SetNumberOfLights(abilities.NumberOfLights);
    this->Samplers.emplace_back(this->Refraction);
  }
  else
  {
    this->Refraction->Release(frame.Window);
  }
  this->SendersAreWalked = plan.WalkedBounces > 0 &&
    std::any_of(this->Samplers.begin(), this->Samplers.end(),
      [](const auto& one) { return one->GetAbilities().TakesSenders; });
  if (plan.WalkedBounces == 0)
  {
    this->LaterBounces->ReleaseGraphicsResources(frame.Window);
  }
  else if (!this->SendersAreWalked)
  {
    this->Samplers.emplace_back(vtkIndirectSampler::Get(this->LaterBounces));
  }
  if (plan.OtherSamplers)
  {
    this->Samplers.insert(this->Samplers.end(), others.begin(), others.end());
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectFrameSamplers::Walk() const
{
  return this->SendersAreWalked ||
    std::any_of(this->Samplers.begin(), this->Samplers.end(),
      [](const auto& sampler) { return sampler->GetAbilities().Walks; });
}

//------------------------------------------------------------------------------
bool vtkIndirectFrameSamplers::Update(
  const vtkIndirectEstimateInput& frame, const vtkIndirectSurfaces& surfaces)
{
  const vtkIndirectPlan& plan = frame.Plan;
  vtkIndirectSampler::Input input = { frame.Frame, frame.Maps, frame.Geometry, plan.ErrorTolerance,
    plan.SampledBounces, plan.Interactive, frame.Batch,
    plan.HasSenderMaps() ? &this->Senders->GetEmitters() : nullptr };
  input.LightsTurn = plan.LightsTurn;
  input.Surfaces = &surfaces;
  input.Further = this->SendersAreWalked
    ? vtkIndirectSampler::Get(this->LaterBounces)->UpdateSenders(input)
    : nullptr;
  // In the living room and the Cornell box a moving frame takes 8 to 13 % longer with whole child
  // distances. The key of the irradiance tells moving frames from still ones where maps are looked
  // up.
  constexpr double scaleOfMoving = 0.55;
  const bool hasty = plan.Interactive && plan.Visibility == vtkIndirectVisibilityMaps;
  this->Lights.SetChildDistanceScale(hasty ? scaleOfMoving : 1.0);
  return this->Samplers.empty() || this->Lights.Update(input, this->Samplers);
}

//------------------------------------------------------------------------------
bool vtkIndirectFrameSamplers::HasMore() const
{
  return (this->SendersAreWalked &&
           vtkIndirectSampler::Get(this->LaterBounces)->GetAbilities().HasMore) ||
    std::any_of(this->Samplers.begin(), this->Samplers.end(),
      [](const auto& sampler) { return sampler->GetAbilities().HasMore; });
}

//------------------------------------------------------------------------------
void vtkIndirectFrameSamplers::AppendTo(vtkIndirectKey& key) const
{
  for (const auto& sampler : this->Others)
  {
    key.Add("sampler", sampler);
  }
  if (this->Area->GetNumberOfAreaLights() > 0)
  {
    key.Add("sampler", this->Area);
  }
  key.Add("senders", this->Senders->GetSourceTime());
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
    vtkIndirectSampler::Get(this->LaterBounces)->AddToReport(report);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectFrameSamplers::ReleaseOwn(vtkWindow* window)
{
  this->Default->ReleaseGraphicsResources(window);
  this->Headlight->Release(window);
  this->Senders->Release(window);
  this->Refraction->Release(window);
  this->LaterBounces->ReleaseGraphicsResources(window);
  this->Area->ReleaseGraphicsResources(window);
  for (const auto& sampler : this->Others)
  {
    sampler->ReleaseGraphicsResources(window);
  }
  for (const auto& sampler : this->Samplers)
  {
    sampler->Release(window);
  }
  this->Samplers.clear();
}
