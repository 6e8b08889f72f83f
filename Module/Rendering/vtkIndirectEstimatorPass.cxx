// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkIndirectEstimatorPass.h"

#include "Plan/vtkIndirectSettingList.h"
#include "Sums/vtkIndirectSum.h"
#include "vtkIndirectIlluminationPass.h"
#include "vtkVirtualLightSampler.h"

//------------------------------------------------------------------------------
vtkIndirectEstimatorPass::vtkIndirectEstimatorPass(std::unique_ptr<vtkIndirectSum> sum)
  : Sum(std::move(sum))
{
}

vtkIndirectEstimatorPass::~vtkIndirectEstimatorPass()
{
  if (this->Whole)
  {
    this->Whole->BorrowEstimator(nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MethodName: " << this->GetMethodName() << "\n";
  vtkIndirectSettingList settings;
  this->Sum->AddSettings(settings, nullptr);
  settings.Print(os, indent);
  this->Sum->GetIrradiance().Print(os, indent);
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::SetPreset(int preset)
{
  preset = preset == PAPER ? PAPER : ROBUST;
  if (preset == this->Preset)
  {
    return;
  }
  this->Preset = preset;
  this->SamplerOfPreset = this->Preset == PAPER ? this->MakeSamplerOfPaper() : nullptr;
  this->ApplyPreset();
  this->Modified();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVirtualLightSampler> vtkIndirectEstimatorPass::MakeSamplerOfPaper() const
{
  return nullptr;
}

//------------------------------------------------------------------------------
vtkVirtualLightSampler* vtkIndirectEstimatorPass::GetSamplerOfPreset() const
{
  return this->SamplerOfPreset;
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
void vtkIndirectEstimatorPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->SamplerOfPreset)
  {
    this->SamplerOfPreset->ReleaseGraphicsResources(window);
  }
  // The illumination pass releases its estimator, this one, in its turn.
  if (this->Sum->EndContext(window) && this->Whole && !this->IsReleasing)
  {
    this->IsReleasing = true;
    this->Whole->ReleaseGraphicsResources(window);
    this->IsReleasing = false;
  }
}
