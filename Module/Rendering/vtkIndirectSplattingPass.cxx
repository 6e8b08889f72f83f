// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkIndirectSplattingPass.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Frame/vtkIndirectEstimate.h"
#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectReport.h"
#include "Frame/vtkIndirectStageTimer.h"
#include "Gather/vtkIndirectGlossyGather.h"
#include "Gather/vtkIndirectLobeGather.h"
#include "OpenGL/vtkIndirectFullScreenProgram.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Splatting/vtkIndirectFarField.h"
#include "Splatting/vtkIndirectSplatTable.h"
#include "Splatting/vtkIndirectSplats.h"
#include "VirtualLights/vtkIndirectVirtualLights.h"
#include "vtkObjectFactory.h"
#include "vtkWeakPointer.h"

#include <cmath>
#include <string>

vtkStandardNewMacro(vtkIndirectSplattingPass);

namespace
{
const char* const Overdraw = "splat.overdraw";
// Pixels between those at which it is measured what is cut off, where it is not given back.
constexpr int StepOfMeasure = 16;
}

//------------------------------------------------------------------------------
struct vtkIndirectSplattingPass::Internals
{
  vtkIndirectSplatTable Table;
  vtkIndirectSplats Splats;
  vtkIndirectFarField FarField;
  vtkIndirectGlossyGather Glossy;
  vtkIndirectLobeGather Lobes;
  vtkIndirectFullScreenProgram OverdrawView{ "vtkIndirectOverdrawFS.glsl" };
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the last frame

  bool SumGlossy(const vtkIndirectEstimateInput& input, vtkIndirectTarget& glossy)
  {
    if (vtkIndirectSplats::UsesTiles())
    {
      return this->Splats.SumGlossy(input, this->Table, glossy);
    }
    vtkOpenGLState::ScopedglBlendFuncSeparate blendFunc(input.Frame.Window->GetState());
    return this->Glossy.Sum(input, glossy, 1.0, {}) && this->Lobes.AddToGlossy(input, glossy);
  }
};

//------------------------------------------------------------------------------
vtkIndirectSplattingPass::vtkIndirectSplattingPass()
  : Internal(new Internals)
{
}

vtkIndirectSplattingPass::~vtkIndirectSplattingPass() = default;

//------------------------------------------------------------------------------
void vtkIndirectSplattingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IntensityThreshold: " << this->Settings.IntensityThreshold << "\n";
  os << indent
     << "SplatShape: " << (this->Settings.SplatShape == ELLIPSOIDS ? "Ellipsoids" : "ScreenQuads")
     << "\n";
  os << indent << "FarField: " << (this->Settings.FarField ? "On" : "Off") << "\n";
  os << indent << "FarFieldStep: " << this->Settings.FarFieldStep << "\n";
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkIndirectSplattingPass::Estimate(const Input& input)
{
  return this->Sum(input) ? this->MakeResult() : vtkIndirectEstimate();
}

//------------------------------------------------------------------------------
bool vtkIndirectSplattingPass::Sum(const Input& input)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  vtkIndirectStageTimer& timer = input.Timer;
  in.Window = frame.Window;
  const vtkIndirectTarget* depth =
    vtkIndirectSplats::UsesTiles() ? nullptr : &input.Geometry.GetTarget();
  if (!this->Irradiance->Resize(frame.Window, frame.Size[0], frame.Size[1], depth) ||
    !this->ResizeGlossy(input))
  {
    return false;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkIndirectFullScreenState kernelState(frame.Window);

  const bool cuts = this->Settings.IntensityThreshold > 0.0;
  const bool fades = cuts && this->Settings.FarField;
  const int step = this->Settings.FarField ? this->Settings.FarFieldStep : StepOfMeasure;
  timer.Begin(vtkIndirectStageTimer::Estimate);
  bool done = in.Table.Update(input, this->Settings.IntensityThreshold, fades) &&
    in.Splats.Sum(input, in.Table, *this->Irradiance, this->Settings.SplatShape == SCREEN_QUADS) &&
    (!this->HasGlossy || in.SumGlossy(input, *this->Glossy));
  timer.End(vtkIndirectStageTimer::Estimate);
  if (!cuts)
  {
    in.FarField.ReleaseSum(frame.Window);
    return done;
  }
  timer.Begin(vtkIndirectStageTimer::Upsample);
  done = done && in.FarField.Sum(input, in.Table, step) &&
    (!this->Settings.FarField || in.FarField.AddTo(input, in.Table, step, *this->Irradiance));
  timer.End(vtkIndirectStageTimer::Upsample);
  return done;
}

//------------------------------------------------------------------------------
double vtkIndirectSplattingPass::GetCutOffShare() const
{
  const Internals& in = *this->Internal;
  if (!in.Window || in.FarField.GetBytes() == 0)
  {
    return 0.0;
  }
  in.Window->MakeCurrent();
  return in.FarField.FindShare();
}

//------------------------------------------------------------------------------
size_t vtkIndirectSplattingPass::GetBytes() const
{
  const Internals& in = *this->Internal;
  return this->Superclass::GetBytes() + in.Table.GetBytes() + in.Splats.GetBytes() +
    in.FarField.GetBytes() + in.Lobes.GetBytes();
}

//------------------------------------------------------------------------------
void vtkIndirectSplattingPass::AddToReport(vtkIndirectReport& report) const
{
  this->Superclass::AddToReport(report);
  const double threshold = this->Settings.IntensityThreshold;
  if (!(threshold > 0.0))
  {
    return;
  }
  const std::string share =
    vtkIndirectReport::Number(100.0 * this->GetCutOffShare(), 3) + " % of the irradiance";
  const std::string bounds = "the mean light's reaches " +
    vtkIndirectReport::Number(vtkIndirectKernels::VTKI_SPLAT_LENGTH / std::sqrt(threshold), 3) +
    " of the scene's diagonal";
  if (this->Settings.FarField)
  {
    report.Modelled.emplace_back("light beyond the bounds of splats",
      share + ", interpolated from every " + std::to_string(this->Settings.FarFieldStep) +
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
      vtkIndirectSplats::UsesTiles() ? "virtual lights of lists by tiles"
                                     : "all virtual lights at every specular pixel");
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkIndirectSplattingPass::GetChannelNames() const
{
  return { Overdraw };
}

//------------------------------------------------------------------------------
int vtkIndirectSplattingPass::DrawChannel(
  const std::string& name, const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer&)
{
  vtkIndirectFullScreenProgram& view = this->Internal->OverdrawView;
  vtkShaderProgram* program = name == Overdraw ? view.Use(frame.Window) : nullptr;
  if (!program)
  {
    return 0;
  }
  this->Irradiance->Activate(0, program);
  view.Draw();
  this->Irradiance->Deactivate();
  return 3;
}

//------------------------------------------------------------------------------
void vtkIndirectSplattingPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!this->CanBeOf(window))
  {
    return;
  }
  this->Superclass::ReleaseGraphicsResources(window);
  Internals& in = *this->Internal;
  in.Table.Release(window);
  in.Splats.Release();
  in.FarField.Release(window);
  in.Glossy.Release();
  in.Lobes.Release(window);
  in.OverdrawView.Release();
}
