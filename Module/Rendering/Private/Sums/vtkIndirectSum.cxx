// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Sums/vtkIndirectSum.h"

#include "Capture/vtkIndirectCreases.h"
#include "OpenGL/vtkIndirectContextGuard.h"
#include "OpenGL/vtkIndirectKey.h"
#include "Plan/vtkIndirectReport.h"
#include "Plan/vtkIndirectSettingList.h"
#include "Scene/vtkIndirectFrame.h"
#include "Visibility/vtkIndirectVisibility.h"
#include "vtkIndirectEstimatorPass.h"
#include "vtkOpenGLRenderWindow.h"

namespace
{
const vtkIndirectChannels Channels = {
  { "irradiance", "vtkiIrradiance", "indirect irradiance", GL_RGBA32F, "-", "VTK irradiance" },
};
const vtkIndirectChannels HalfChannels = {
  { "irradiance", "vtkiIrradiance", "indirect irradiance", GL_RGBA16F, "-",
    "VTK irradiance over the frame's unit" },
};
const vtkIndirectChannels GlossyChannels = {
  { "glossy", "vtkiGlossy", "indirect light in the specular lobe", GL_RGBA32F, "-",
    "VTK irradiance" },
};
const vtkIndirectChannels HalfGlossyChannels = {
  { "glossy", "vtkiGlossy", "indirect light in the specular lobe", GL_RGBA16F, "-",
    "VTK irradiance over the frame's unit" },
};
}

//------------------------------------------------------------------------------
vtkIndirectSum::vtkIndirectSum(vtkIndirectEstimatorPass& pass)
  : Pass(pass)
  , Irradiance(new vtkIndirectTarget(this, Channels, false))
  , Glossy(new vtkIndirectTarget(this, GlossyChannels, false))
  , Guard(vtkSmartPointer<vtkIndirectContextGuard>::New())
{
  this->Guard->Release = [this](vtkWindow* window) { this->Pass.ReleaseGraphicsResources(window); };
}

vtkIndirectSum::~vtkIndirectSum() = default;

//------------------------------------------------------------------------------
vtkIndirectSum& vtkIndirectSum::Get(const vtkIndirectEstimatorPass* pass)
{
  return *pass->Sum;
}

//------------------------------------------------------------------------------
void vtkIndirectSum::HoldContext(vtkOpenGLRenderWindow* window, vtkMTimeType user)
{
  // The pass that draws by this estimator has released its other resources, and is in the middle of
  // a frame.
  this->IsHolding = true;
  this->Guard->SetContext(window);
  if (user != this->User && this->User != 0)
  {
    this->EndContext(window);
  }
  this->User = user;
  this->IsHolding = false;
}

//------------------------------------------------------------------------------
bool vtkIndirectSum::EndContext(vtkWindow* window)
{
  if (!window || !this->Guard->CanBeOf(window))
  {
    return false;
  }
  this->EstimateTime.Modified();
  this->Release(window);
  this->HasGlossy = false;
  return !this->IsHolding;
}

//------------------------------------------------------------------------------
void vtkIndirectSum::AppendTo(vtkIndirectKey& key, const Input&) const
{
  key.Add("estimator", &this->Pass);
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkIndirectSum::MakeEstimate(const Input& input)
{
  this->EstimateTime.Modified();
  if (input.Visibility.LooksUpMaps() &&
    !input.Creases.Update(input.Frame, input.Geometry, this->FindReceiverStep(input.Plan)))
  {
    return {};
  }
  return this->Estimate(input);
}

//------------------------------------------------------------------------------
void vtkIndirectSum::AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan*) const
{
  using Choice = vtkIndirectSettingList::Choice;
  const bool paper = this->Pass.GetPreset() == vtkIndirectEstimatorPass::PAPER;
  list.Add("Preset", Choice{ paper ? "Paper" : "Robust" })
    .Add("SpecularTransport", this->Pass.GetSpecularTransport())
    .Add("OccupancyResolution", this->Pass.GetOccupancyResolution());
}

//------------------------------------------------------------------------------
vtkIndirectAbilities vtkIndirectSum::GetAbilities(double) const
{
  vtkIndirectAbilities abilities;
  abilities.Name = this->Pass.GetClassName();
  abilities.TakesSampler = true;
  abilities.SpecularTransport = this->Pass.GetSpecularTransport();
  abilities.IsOfPaper = this->Pass.GetPreset() == vtkIndirectEstimatorPass::PAPER;
  return abilities;
}

//------------------------------------------------------------------------------
vtkIndirectVisibilityNeeds vtkIndirectSum::GetVisibilityNeeds(const vtkIndirectPlan& plan) const
{
  vtkIndirectVisibilityNeeds needs;
  needs.Maps = plan.Visibility == vtkIndirectVisibilityMaps;
  needs.Senders = needs.Maps || plan.Visibility == vtkIndirectVisibilityVoxels;
  needs.Segments = needs.Senders && !needs.Maps;
  needs.Resolution = this->Pass.GetOccupancyResolution();
  return needs;
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkIndirectSum::MakeResult() const
{
  vtkIndirectEstimate result;
  result.State = vtkIndirectEstimate::CONVERGED;
  result.Contributions = { { vtkIndirectContribution::BOUNCE, this->Irradiance.get(), 0,
    this->IrradianceUnit } };
  if (this->HasGlossy)
  {
    result.Contributions.push_back(
      { vtkIndirectContribution::LOBE, this->Glossy.get(), 0, this->IrradianceUnit });
  }
  return result;
}

//------------------------------------------------------------------------------
bool vtkIndirectSum::SetIrradianceStorage(bool half, double unit, bool depth)
{
  this->IrradianceUnit = unit;
  if (half == this->IrradianceIsHalf && depth == this->IrradianceHasDepth)
  {
    return false;
  }
  this->IrradianceIsHalf = half;
  this->IrradianceHasDepth = depth;
  this->Irradiance = this->MakeIrradiance();
  this->Glossy =
    std::make_unique<vtkIndirectTarget>(this, half ? HalfGlossyChannels : GlossyChannels, false);
  return true;
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkIndirectTarget> vtkIndirectSum::MakeIrradiance()
{
  return std::make_unique<vtkIndirectTarget>(
    this, this->IrradianceIsHalf ? HalfChannels : Channels, this->IrradianceHasDepth, 16);
}

//------------------------------------------------------------------------------
bool vtkIndirectSum::ResizeGlossy(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  this->HasGlossy = input.Plan.Specular;
  if (!this->HasGlossy)
  {
    this->Glossy->Release(frame.Window);
    return true;
  }
  this->HasGlossy = this->Glossy->Resize(frame.Window, frame.Size[0], frame.Size[1]);
  return this->HasGlossy;
}

//------------------------------------------------------------------------------
void vtkIndirectSum::AddToReport(vtkIndirectReport& report) const
{
  report.Modelled.emplace_back("one diffuse bounce", this->Pass.GetClassName());
}
