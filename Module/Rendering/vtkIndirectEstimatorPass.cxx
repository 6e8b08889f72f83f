// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectGL.h"

#include "vtkIndirectEstimatorPass.h"

#include "vtkGeometryBufferPass.h"
#include "vtkIndirectContextGuard.h"
#include "vtkIndirectFrame.h"
#include "vtkIndirectOccupancyVolume.h"
#include "vtkIndirectReport.h"
#include "vtkIndirectStageTimer.h"
#include "vtkIndirectTarget.h"
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

vtkIndirectEstimatorPass::~vtkIndirectEstimatorPass() = default;

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::HoldContext(vtkOpenGLRenderWindow* window)
{
  this->Guard->SetContext(window);
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MethodName: " << this->GetMethodName() << "\n";
  os << indent << "SpecularTransport: " << (this->SpecularTransport ? "On" : "Off") << "\n";
  os << indent << "ComputesGlossy: " << (this->ComputesGlossy() ? "yes" : "no") << "\n";
  os << indent << "MaximumNumberOfBounces: " << this->GetMaximumNumberOfBounces() << "\n";
  os << indent << "Occupancy: " << (this->Occupancy ? "On" : "Off") << "\n";
  os << indent << "OccupancyResolution: " << this->OccupancyResolution << "\n";
  os << indent << "NumberOfVoxelUpdates: " << this->NumberOfVoxelUpdates << "\n";
  this->Irradiance->Print(os, indent);
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::Render(const vtkRenderState*)
{
  vtkErrorMacro("An estimator draws nothing by itself; give it to "
                "vtkIndirectIlluminationPass::SetEstimator.");
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
bool vtkIndirectEstimatorPass::WantsGlossy(const vtkIndirectFrame& frame) const
{
  return this->SpecularTransport && this->ComputesGlossy() && frame.Specular;
}

//------------------------------------------------------------------------------
bool vtkIndirectEstimatorPass::ResizeGlossy(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  this->HasGlossy = input.Geometry.HasSpecular() && this->WantsGlossy(frame);
  if (!this->HasGlossy)
  {
    this->Glossy->Release(frame.Window);
    return true;
  }
  this->HasGlossy = this->Glossy->Resize(frame.Window, frame.Size[0], frame.Size[1]);
  return this->HasGlossy;
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::ActivateIrradiance(vtkShaderProgram* program)
{
  this->Irradiance->Activate(0, program);
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::DeactivateIrradiance()
{
  this->Irradiance->Deactivate();
}

//------------------------------------------------------------------------------
size_t vtkIndirectEstimatorPass::GetBytes() const
{
  return this->Irradiance->GetBytes() + this->Glossy->GetBytes() +
    (this->Voxels ? this->Voxels->GetBytes() : 0);
}

//------------------------------------------------------------------------------
size_t vtkIndirectEstimatorPass::GetMainMemoryBytes() const
{
  return this->Voxels ? this->Voxels->GetMainMemoryBytes() : 0;
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::AddToReport(vtkIndirectReport& report) const
{
  report.Modelled.emplace_back("one diffuse bounce", this->GetClassName());
  this->AddVisibilityToReport(report);
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::AddVisibilityToReport(vtkIndirectReport& report) const
{
  const char* const name = "visibility between sender and receiver";
  if (!this->IsBlocked())
  {
    report.LeftOut.emplace_back(
      name, "Occupancy is off or nothing has polygons; the result is too bright");
    return;
  }
  report.Modelled.emplace_back(name,
    std::to_string(this->Voxels->GetNumberOfOccupiedVoxels()) + " occupied voxels of " +
      std::to_string(this->OccupancyResolution) + " along the longest edge");
  for (const auto& entry : this->Voxels->GetLeftOut())
  {
    report.LeftOut.push_back(entry);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectEstimatorPass::UpdateVoxels(const Input& input)
{
  if (!input.Caching)
  {
    input.Voxels->Forget();
  }
  this->NumberOfVoxelUpdates += input.Voxels->Update(input.Frame, this->OccupancyResolution);
  // Another estimator may have brought them up to date before.
  const bool changed =
    this->Voxels != input.Voxels || this->VoxelsSeen != input.Voxels->GetNumberOfUpdates();
  this->Voxels = input.Voxels;
  this->VoxelsSeen = input.Voxels->GetNumberOfUpdates();
  return changed;
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::UpdateSight(const Input& input, vtkIndirectStageTimer& timer)
{
  if (this->Occupancy)
  {
    timer.Begin(vtkIndirectStageTimer::Visibility);
    this->UpdateVoxels(input);
    if (this->IsBlocked())
    {
      this->Voxels->GetClearance();
    }
    timer.End(vtkIndirectStageTimer::Visibility);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectEstimatorPass::IsBlocked() const
{
  return this->Occupancy && this->Voxels && !this->Voxels->IsEmpty();
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::AddSpecularToReport(vtkIndirectReport& report) const
{
  if (this->HasGlossy)
  {
    report.Modelled.emplace_back(
      "specular indirect light", "receivers reflect it by the lobes of Phong's model");
    report.LeftOut.emplace_back("specular reflection of senders", "senders are taken as diffuse");
    return;
  }
  report.LeftOut.emplace_back("specular indirect light",
    !this->ComputesGlossy() ? std::string("senders are taken as diffuse, and ") +
        this->GetClassName() + " takes receivers as diffuse"
      : this->SpecularTransport ? "senders are taken as diffuse; no receiver is specular"
                                : "SpecularTransport is off");
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!window)
  {
    return;
  }
  this->Irradiance->Release(window);
  this->Glossy->Release(window);
  this->HasGlossy = false;
}
