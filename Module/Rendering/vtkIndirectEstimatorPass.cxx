// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkIndirectEstimatorPass.h"

#include "Frame/vtkIndirectEstimate.h"
#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectPlan.h"
#include "Frame/vtkIndirectReport.h"
#include "OpenGL/vtkIndirectContextGuard.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "vtkIndirectIlluminationPass.h"
#include "vtkOpenGLRenderWindow.h"

namespace
{
const vtkIndirectChannel Channels[] = {
  { "irradiance", "vtkiIrradiance", "indirect irradiance", GL_RGBA32F, "-", "VTK irradiance" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
const vtkIndirectChannel HalfChannels[] = {
  { "irradiance", "vtkiIrradiance", "indirect irradiance", GL_RGBA16F, "-",
    "VTK irradiance over the frame's unit" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
const vtkIndirectChannel GlossyChannels[] = {
  { "glossy", "vtkiGlossy", "indirect light in the specular lobe", GL_RGBA32F, "-",
    "VTK irradiance" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
const vtkIndirectChannel HalfGlossyChannels[] = {
  { "glossy", "vtkiGlossy", "indirect light in the specular lobe", GL_RGBA16F, "-",
    "VTK irradiance over the frame's unit" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
}

//------------------------------------------------------------------------------
vtkIndirectEstimatorPass::vtkIndirectEstimatorPass()
  : Guard(vtkSmartPointer<vtkIndirectContextGuard>::New())
  , Irradiance(new vtkIndirectTarget(Channels, false))
  , Glossy(new vtkIndirectTarget(GlossyChannels, false))
{
  this->Guard->Release = [this](vtkWindow* window) { this->ReleaseGraphicsResources(window); };
}

vtkIndirectEstimatorPass::~vtkIndirectEstimatorPass()
{
  if (this->Whole)
  {
    this->Whole->BorrowEstimator(nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::HoldContext(vtkOpenGLRenderWindow* window, vtkMTimeType user)
{
  // Its own pass has let go of the rest already, and is in the middle of a frame.
  const bool releasing = this->IsReleasing;
  this->IsReleasing = true;
  this->Guard->SetContext(window);
  if (user != this->User && this->User != 0)
  {
    this->ReleaseGraphicsResources(window);
  }
  this->User = user;
  this->IsReleasing = releasing;
}

//------------------------------------------------------------------------------
bool vtkIndirectEstimatorPass::CanBeOf(vtkWindow* window)
{
  return window && this->Guard->CanBeOf(window);
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkIndirectEstimatorPass::MakeEstimate(const Input& input)
{
  this->EstimateTime.Modified();
  return this->Estimate(input);
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MethodName: " << this->GetMethodName() << "\n";
  os << indent << "SpecularTransport: " << (this->SpecularTransport ? "On" : "Off") << "\n";
  os << indent << "ComputesGlossy: " << (this->ComputesGlossy() ? "yes" : "no") << "\n";
  os << indent << "SumsLobes: " << (this->SumsLobes() ? "yes" : "no") << "\n";
  os << indent << "MaximumNumberOfBounces: " << this->GetMaximumNumberOfBounces() << "\n";
  os << indent << "Occupancy: " << (this->Occupancy ? "On" : "Off") << "\n";
  os << indent << "OccupancyResolution: " << this->OccupancyResolution << "\n";
  this->Irradiance->Print(os, indent);
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::Render(const vtkRenderState* s)
{
  vtkIndirectIlluminationPass* pass = this->GetIlluminationPass();
  pass->Render(s);
  this->NumberOfRenderedProps = pass->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
vtkIndirectIlluminationPass* vtkIndirectEstimatorPass::GetIlluminationPass()
{
  if (!this->Whole)
  {
    this->Whole = vtkSmartPointer<vtkIndirectIlluminationPass>::New();
    this->Whole->BorrowEstimator(this);
  }
  return this->Whole;
}

//------------------------------------------------------------------------------
vtkIndirectAbilities vtkIndirectEstimatorPass::GetAbilities(double tolerance) const
{
  vtkIndirectAbilities abilities;
  abilities.Name = this->GetClassName();
  abilities.MaximumNumberOfBounces = this->GetMaximumNumberOfBounces();
  abilities.ComputesGlossy = this->ComputesGlossy();
  abilities.SumsLobes = this->SumsLobes();
  abilities.SpecularTransport = this->SpecularTransport;
  abilities.TakesSampler = this->TakesSampler();
  abilities.Occupancy = this->Occupancy;
  abilities.TakesLightMaps = this->TakesLightMaps();
  abilities.IgnoresVisibility = this->IgnoresVisibility();
  abilities.ReadsMaps = this->ReadsMaps();
  abilities.SumsSky = this->SumsSky();
  abilities.ErrorTolerance = this->FindErrorTolerance(tolerance);
  return abilities;
}

//------------------------------------------------------------------------------
vtkIndirectVisibilityNeeds vtkIndirectEstimatorPass::GetVisibilityNeeds(
  const vtkIndirectPlan& plan) const
{
  vtkIndirectVisibilityNeeds needs;
  needs.Maps = plan.Visibility == vtkIndirectVisibilityMaps;
  needs.Senders = needs.Maps || plan.Visibility == vtkIndirectVisibilityVoxels;
  needs.Segments = needs.Senders && !needs.Maps;
  needs.Resolution = this->OccupancyResolution;
  return needs;
}

//------------------------------------------------------------------------------
std::shared_ptr<vtkIndirectSampler> vtkIndirectEstimatorPass::ChooseSampler(
  const std::shared_ptr<vtkIndirectSampler>& users, const vtkIndirectPlan&)
{
  return users;
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkIndirectEstimatorPass::MakeResult() const
{
  vtkIndirectEstimate result;
  result.State = vtkIndirectEstimate::CONVERGED;
  result.Irradiance = this->Irradiance.get();
  result.Glossy = this->HasGlossy ? this->Glossy.get() : nullptr;
  result.Unit = this->IrradianceUnit;
  return result;
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::SetIrradianceStorage(
  vtkWindow* window, bool half, double unit, bool depth)
{
  this->IrradianceUnit = unit;
  if (half != this->IrradianceIsHalf || depth != this->IrradianceHasDepth)
  {
    this->Irradiance->Release(window);
    this->Irradiance =
      std::make_unique<vtkIndirectTarget>(half ? HalfChannels : Channels, depth, 16);
    this->Glossy->Release(window);
    this->Glossy =
      std::make_unique<vtkIndirectTarget>(half ? HalfGlossyChannels : GlossyChannels, false);
    this->IrradianceIsHalf = half;
    this->IrradianceHasDepth = depth;
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectEstimatorPass::ResizeGlossy(const Input& input)
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
size_t vtkIndirectEstimatorPass::GetBytes() const
{
  return this->Irradiance->GetBytes() + this->Glossy->GetBytes();
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::AddToReport(vtkIndirectReport& report) const
{
  report.Modelled.emplace_back("one diffuse bounce", this->GetClassName());
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!this->CanBeOf(window))
  {
    return;
  }
  this->EstimateTime.Modified();
  this->Irradiance->Release(window);
  this->Glossy->Release(window);
  this->HasGlossy = false;
  // That pass in its turn releases its estimator, which is this one.
  if (this->Whole && !this->IsReleasing)
  {
    this->IsReleasing = true;
    this->Whole->ReleaseGraphicsResources(window);
    this->IsReleasing = false;
  }
}
