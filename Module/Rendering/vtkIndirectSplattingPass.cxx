// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkIndirectSplattingPass.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Gather/vtkIndirectGlossyGather.h"
#include "Gather/vtkIndirectLobeGather.h"
#include "OpenGL/vtkIndirectFullScreenProgram.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Plan/vtkIndirectReport.h"
#include "Plan/vtkIndirectSettingList.h"
#include "Plan/vtkIndirectStageTimer.h"
#include "Scene/vtkIndirectFrame.h"
#include "Senders/vtkIndirectVirtualLights.h"
#include "Splatting/vtkIndirectFarField.h"
#include "Splatting/vtkIndirectSplatTable.h"
#include "Splatting/vtkIndirectSplats.h"
#include "Sums/vtkIndirectSum.h"
#include "vtkImportanceLightSampler.h"
#include "vtkObjectFactory.h"
#include "vtkWeakPointer.h"

#include <cmath>
#include <string>

vtkStandardNewMacro(vtkIndirectSplattingPass);

namespace
{
const char* const Overdraw = "splat.overdraw";
// Pixels between the samples that measure the light that is cut off, if it is not restored.
constexpr int StepOfMeasure = 16;

class SplatSum : public vtkIndirectSum
{
public:
  explicit SplatSum(vtkIndirectSplattingPass& pass)
    : vtkIndirectSum(pass)
    , Set(pass)
  {
  }
  void AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const override;
  vtkIndirectAbilities GetAbilities(double tolerance) const override;
  void AddToReport(vtkIndirectReport& report) const override;
  std::vector<std::string> GetChannelNames() const override { return { Overdraw }; }
  int DrawChannel(const std::string& name, const vtkIndirectFrame& frame,
    const vtkIndirectGeometryBuffer& geometry) override;

protected:
  vtkIndirectEstimate Estimate(const Input& input) override;

private:
  bool Sum(const Input& input);
  bool SumGlossy(const Input& input);

  const vtkIndirectSplattingPass& Set;
  vtkIndirectSplatTable Table{ this };
  vtkIndirectSplats Splats{ this };
  vtkIndirectFarField FarField{ this };
  vtkIndirectGlossyGather GlossyGather{ this };
  vtkIndirectLobeGather Lobes{ this };
  vtkIndirectFullScreenProgram OverdrawView{ this, "vtkIndirectOverdrawFS.glsl" };
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // window of the last frame
};
}

//------------------------------------------------------------------------------
vtkIndirectSplattingPass::vtkIndirectSplattingPass()
  : vtkIndirectEstimatorPass(std::make_unique<SplatSum>(*this))
{
}

//------------------------------------------------------------------------------
// Colour plate 3 of the paper: 768 lights at 5 %.
void vtkIndirectSplattingPass::ApplyPreset()
{
  this->Settings = SettingsType();
  if (this->GetPreset() == PAPER)
  {
    this->Settings.IntensityThreshold = 0.05;
    this->Settings.FarField = false;
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVirtualLightSampler> vtkIndirectSplattingPass::MakeSamplerOfPaper() const
{
  auto sampler = vtkSmartPointer<vtkImportanceLightSampler>::New();
  sampler->SetNumberOfLights(768);
  sampler->SetLevels(4);
  sampler->SetEvenness(0.0);
  sampler->SetOcclusion(1.0);
  return sampler;
}

//------------------------------------------------------------------------------
void SplatSum::AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const
{
  this->vtkIndirectSum::AddSettings(list, plan);
  list.Add("IntensityThreshold", this->Set.GetIntensityThreshold())
    .Add("FarField", this->Set.GetFarField())
    .Add("FarFieldStep", this->Set.GetFarFieldStep());
}

//------------------------------------------------------------------------------
vtkIndirectAbilities SplatSum::GetAbilities(double tolerance) const
{
  vtkIndirectAbilities abilities = this->vtkIndirectSum::GetAbilities(tolerance);
  abilities.ComputesGlossy = true;
  abilities.SumsLobes = true;
  abilities.TakesLightMaps = true;
  abilities.AutomaticVisibility = vtkIndirectVisibilityMaps;
  return abilities;
}

//------------------------------------------------------------------------------
bool SplatSum::SumGlossy(const Input& input)
{
  if (vtkIndirectComputeProgram::IsSupported())
  {
    return this->Splats.SumGlossy(input, this->Table, *this->Glossy);
  }
  return this->GlossyGather.Sum(input, *this->Glossy, 1.0, {}) &&
    this->Lobes.AddToGlossy(input, *this->Glossy);
}

//------------------------------------------------------------------------------
vtkIndirectEstimate SplatSum::Estimate(const Input& input)
{
  return this->Sum(input) ? this->MakeResult() : vtkIndirectEstimate();
}

//------------------------------------------------------------------------------
bool SplatSum::Sum(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  vtkIndirectStageTimer& timer = input.Timer;
  this->Window = frame.Window;
  const vtkIndirectTarget* depth =
    vtkIndirectComputeProgram::IsSupported() ? nullptr : &input.Geometry.GetTarget();
  if (!this->Irradiance->Resize(frame.Window, frame.Size[0], frame.Size[1], depth) ||
    !this->ResizeGlossy(input))
  {
    return false;
  }
  vtkIndirectFullScreenState kernelState(frame.Window);

  const bool cuts = this->Set.GetIntensityThreshold() > 0.0;
  const bool fades = cuts && this->Set.GetFarField();
  const int step = this->Set.GetFarField() ? this->Set.GetFarFieldStep() : StepOfMeasure;
  timer.Begin(vtkIndirectStageTimer::Estimate);
  bool done = this->Table.Update(input, this->Set.GetIntensityThreshold(), fades) &&
    this->Splats.Sum(input, this->Table, *this->Irradiance) &&
    (!this->HasGlossy || this->SumGlossy(input));
  timer.End(vtkIndirectStageTimer::Estimate);
  if (!cuts)
  {
    this->FarField.Release(frame.Window);
    return done;
  }
  timer.Begin(vtkIndirectStageTimer::Upsample);
  done = done && this->FarField.Sum(input, this->Table, step) &&
    (!this->Set.GetFarField() || this->FarField.AddTo(input, this->Table, step, *this->Irradiance));
  timer.End(vtkIndirectStageTimer::Upsample);
  return done;
}

//------------------------------------------------------------------------------
void SplatSum::AddToReport(vtkIndirectReport& report) const
{
  this->vtkIndirectSum::AddToReport(report);
  const double threshold = this->Set.GetIntensityThreshold();
  if (!(threshold > 0.0) || !this->Window || this->FarField.GetBytes() == 0)
  {
    return;
  }
  this->Window->MakeCurrent();
  const std::string share =
    vtkIndirectReport::Number(100.0 * this->FarField.FindShare(), 3) + " % of the irradiance";
  const std::string bounds = "the mean light's reaches " +
    vtkIndirectReport::Number(vtkIndirectKernels::VTKI_SPLAT_LENGTH / std::sqrt(threshold), 3) +
    " of the scene's diagonal";
  if (this->Set.GetFarField())
  {
    report.Modelled.emplace_back("light beyond the bounds of splats",
      share + ", interpolated from every " + std::to_string(this->Set.GetFarFieldStep()) +
        "th pixel; " + bounds);
  }
  else
  {
    report.LeftOut.emplace_back("light beyond the bounds of splats",
      share + "; " + bounds + ", and FarField is off: the result is too dark");
  }
  if (this->HasGlossy)
  {
    report.Modelled.emplace_back("light in specular lobes",
      vtkIndirectComputeProgram::IsSupported() ? "virtual lights of lists by tiles"
                                               : "all virtual lights at every specular pixel");
  }
}

//------------------------------------------------------------------------------
int SplatSum::DrawChannel(
  const std::string& name, const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer&)
{
  vtkIndirectFullScreenProgram& view = this->OverdrawView;
  vtkIndirectProgram program = name == Overdraw ? view.Use(frame.Window) : nullptr;
  if (!program)
  {
    return 0;
  }
  this->Irradiance->Activate(0, program);
  view.Draw();
  return 3;
}
