// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkMultiresolutionSplattingPass.h"

#include "Multiresolution/vtkIndirectSubsplatSum.h"
#include "vtkObjectFactory.h"

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
void vtkMultiresolutionSplattingPass::SetPreset(int preset)
{
  preset = preset == PAPER ? PAPER : ROBUST;
  if (preset != this->Settings.Preset)
  {
    this->Settings.Preset = preset;
    *this->Details =
      preset == PAPER ? vtkIndirectSubsplatDetails::OfPaper() : vtkIndirectSubsplatDetails();
    this->Modified();
  }
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
