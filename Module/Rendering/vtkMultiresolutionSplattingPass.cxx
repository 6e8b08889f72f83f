// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkMultiresolutionSplattingPass.h"

#include "Multiresolution/vtkIndirectSubsplatSum.h"
#include "vtkObjectFactory.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>

vtkStandardNewMacro(vtkMultiresolutionSplattingPass);

//------------------------------------------------------------------------------
vtkMultiresolutionSplattingPass::vtkMultiresolutionSplattingPass()
  : vtkMultiresolutionSplattingPass(std::make_unique<vtkIndirectSubsplatSum>(*this))
{
}

vtkMultiresolutionSplattingPass::vtkMultiresolutionSplattingPass(
  std::unique_ptr<vtkIndirectSum> sum)
  : vtkIndirectEstimatorPass(std::move(sum))
  , Details(new vtkIndirectSubsplatDetails)
{
}

vtkMultiresolutionSplattingPass::~vtkMultiresolutionSplattingPass() = default;

//------------------------------------------------------------------------------
void vtkMultiresolutionSplattingPass::ApplyPreset()
{
  this->Settings = SettingsType();
  *this->Details = this->GetPreset() == PAPER ? vtkIndirectSubsplatDetails::OfPaper()
                                              : vtkIndirectSubsplatDetails();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVirtualLightSampler> vtkMultiresolutionSplattingPass::MakeSamplerOfPaper() const
{
  auto sampler = vtkSmartPointer<vtkUniformLightSampler>::New();
  sampler->SetPatternToGrid();
  sampler->SetLitTexels(false);
  return sampler;
}

//------------------------------------------------------------------------------
void vtkMultiresolutionSplattingPass::SetThreshold(Threshold& threshold, double value)
{
  value = value >= 0.0 ? std::min(value, threshold.Most) : 0.0;
  if (!threshold.IsSet || threshold.Value != value)
  {
    threshold.IsSet = true;
    threshold.Value = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMultiresolutionSplattingPass::SetDepthThreshold(double threshold)
{
  this->SetThreshold(this->Settings.DepthThreshold, threshold);
}

//------------------------------------------------------------------------------
void vtkMultiresolutionSplattingPass::SetPlaneThreshold(double threshold)
{
  this->SetThreshold(this->Settings.PlaneThreshold, threshold);
}

//------------------------------------------------------------------------------
void vtkMultiresolutionSplattingPass::SetNormalThreshold(double threshold)
{
  this->SetThreshold(this->Settings.NormalThreshold, threshold);
}
