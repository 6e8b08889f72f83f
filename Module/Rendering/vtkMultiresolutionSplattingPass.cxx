// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkMultiresolutionSplattingPass.h"

#include "Frame/vtkIndirectEstimate.h"
#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectPlan.h"
#include "Frame/vtkIndirectReport.h"
#include "Frame/vtkIndirectStageTimer.h"
#include "Gather/vtkIndirectGlossyGather.h"
#include "Gather/vtkIndirectLobeGather.h"
#include "Multiresolution/vtkIndirectGlossySubsplats.h"
#include "Multiresolution/vtkIndirectSubsplatIllumination.h"
#include "Multiresolution/vtkIndirectSubsplatView.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "VirtualLights/vtkIndirectLightBlock.h"
#include "VirtualLights/vtkIndirectVirtualLights.h"
#include "Visibility/vtkIndirectVisibility.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkMultiresolutionSplattingPass);

namespace
{
// Lobes of senders: at every so many pixels, and what interpolation between them may change of
// them, over their light.
constexpr int LobeStep = 4;
constexpr double LobeTolerance = 0.05;

const vtkIndirectChannel BatchChannels[] = {
  { "subsplat.batch", "vtkiBatch", "irradiance from some of the lights", GL_RGBA32F, "-",
    "VTK irradiance" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
const vtkIndirectChannel HalfBatchChannels[] = {
  { "subsplat.batch", "vtkiBatch", "irradiance from some of the lights", GL_RGBA16F, "-",
    "VTK irradiance over the frame's unit" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
}

//------------------------------------------------------------------------------
struct vtkMultiresolutionSplattingPass::Internals
{
  vtkIndirectSubsplatDetails Details;
  vtkIndirectLightBlock Lights;
  vtkIndirectSubsplatPyramid Pyramid;
  vtkIndirectSubsplatIllumination Illumination;
  vtkIndirectSubsplatView View;
  vtkIndirectGlossySubsplats Glossy;
  vtkIndirectGlossyGather GlossyGather;
  vtkIndirectLobeGather Lobes;
  // The image of a batch of lights, where there are several.
  std::unique_ptr<vtkIndirectTarget> Batch;
  bool BatchIsHalf = false;
  vtkIndirectFullScreenProgram AddBatch{ "vtkIndirectSubsplatAddFS.glsl" };

  // The last frame, for the report.
  double Tolerance = 0.0;
  double SamplingError = -1.0;
  int Evaluations = -1;
  int NumberOfLights = 0;
  std::string Renderer;
  bool GlossyIsListed = false;
  std::string WhyGlossyIsGathered;
};

//------------------------------------------------------------------------------
double vtkMultiresolutionSplattingPass::Threshold::Scale(double tolerance) const
{
  return this->IsSet || !(tolerance > 0.0)
    ? this->Value
    : vtkIndirectPlan::ScaleThreshold(this->Value, tolerance, this->Most);
}

//------------------------------------------------------------------------------
vtkMultiresolutionSplattingPass::vtkMultiresolutionSplattingPass()
  : Internal(new Internals)
{
}

vtkMultiresolutionSplattingPass::~vtkMultiresolutionSplattingPass() = default;

//------------------------------------------------------------------------------
void vtkMultiresolutionSplattingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const SettingsType& set = this->Settings;
  os << indent << "Preset: " << (set.Preset == PAPER ? "Paper" : "Robust") << "\n";
  os << indent << "FinestLevel: "
     << (set.FinestLevel == FULL_RESOLUTION ? "FullResolution" : "HalfResolution") << "\n";
  os << indent << "DepthThreshold: " << set.DepthThreshold.Value << "\n";
  os << indent << "PlaneThreshold: " << set.PlaneThreshold.Value << "\n";
  os << indent << "NormalThreshold: " << set.NormalThreshold.Value << "\n";
  os << indent << "SurfaceDetail: " << set.SurfaceDetail << "\n";
}

//------------------------------------------------------------------------------
void vtkMultiresolutionSplattingPass::SetPreset(int preset)
{
  preset = preset == PAPER ? PAPER : ROBUST;
  if (preset != this->Settings.Preset)
  {
    this->Settings.Preset = preset;
    this->SetDetails(
      preset == PAPER ? vtkIndirectSubsplatDetails::OfPaper() : vtkIndirectSubsplatDetails());
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

//------------------------------------------------------------------------------
const vtkIndirectSubsplatDetails& vtkMultiresolutionSplattingPass::GetDetails() const
{
  return this->Internal->Details;
}

//------------------------------------------------------------------------------
void vtkMultiresolutionSplattingPass::SetDetails(const vtkIndirectSubsplatDetails& details)
{
  this->Internal->Details = details;
  this->Modified();
}

//------------------------------------------------------------------------------
size_t vtkMultiresolutionSplattingPass::GetBytes() const
{
  const Internals& in = *this->Internal;
  return this->Superclass::GetBytes() + in.Lights.GetBytes() + in.Pyramid.GetBytes() +
    in.Illumination.GetBytes() + in.Glossy.GetBytes() + in.Lobes.GetBytes() +
    (in.Batch ? in.Batch->GetBytes() : 0);
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkMultiresolutionSplattingPass::FindOwnThresholds() const
{
  const SettingsType& set = this->Settings;
  const bool depthRange = this->Internal->Details.DepthRange;
  std::vector<std::string> names;
  if (depthRange && set.DepthThreshold.IsSet)
  {
    names.emplace_back("DepthThreshold");
  }
  if (!depthRange && set.PlaneThreshold.IsSet)
  {
    names.emplace_back("PlaneThreshold");
  }
  if (set.NormalThreshold.IsSet)
  {
    names.emplace_back("NormalThreshold");
  }
  return names;
}

//------------------------------------------------------------------------------
double vtkMultiresolutionSplattingPass::FindErrorTolerance(double asked) const
{
  // The threshold of the lighting is the plan's.
  return this->Internal->Details.LightingThreshold > 0.0 || this->FindOwnThresholds().size() < 2
    ? asked
    : 0.0;
}

//------------------------------------------------------------------------------
bool vtkMultiresolutionSplattingPass::MakeSettings(
  const Input& input, vtkIndirectSubsplatSettings& settings, int& renderer)
{
  using Details = vtkIndirectSubsplatDetails;
  const Details& details = this->Internal->Details;
  const bool hasCompute = vtkIndirectComputeProgram::IsSupported();
  if (details.Renderer == Details::COMPUTE && !hasCompute)
  {
    vtkErrorMacro("Sums of compute shaders need OpenGL 4.3; this context is older.");
    return false;
  }
  renderer = details.Renderer == Details::POINTS ? vtkIndirectSubsplatIllumination::Points
    : hasCompute && details.Renderer != Details::FRAGMENTS
    ? vtkIndirectSubsplatIllumination::Compute
    : vtkIndirectSubsplatIllumination::Fragments;
  static_cast<Details&>(settings) = details;
  settings.HalfResolution = this->Settings.FinestLevel == HALF_RESOLUTION;
  settings.SurfaceDetail = this->Settings.SurfaceDetail;
  const double tolerance = this->FindErrorTolerance(input.Plan.ErrorTolerance);
  settings.PlaneThreshold = this->Settings.PlaneThreshold.Scale(tolerance);
  settings.DepthThreshold = this->Settings.DepthThreshold.Scale(tolerance);
  settings.NormalThreshold = this->Settings.NormalThreshold.Scale(tolerance);
  settings.LightingThreshold = Threshold{ details.LightingThreshold, 1.0 }.Scale(tolerance);
  settings.GlossyThreshold =
    Threshold{ details.GlossyThreshold, 1.0 }.Scale(input.Plan.ErrorTolerance);
  settings.StorageScale = settings.HalfFloats ? 1.0 / input.Plan.IrradianceUnit : 1.0;
  settings.HasCompute = hasCompute && renderer != vtkIndirectSubsplatIllumination::Fragments;
  settings.ReportsError = tolerance > 0.0;
  return true;
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkMultiresolutionSplattingPass::Estimate(const Input& input)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  vtkOpenGLRenderWindow* window = frame.Window;
  vtkIndirectSubsplatSettings settings;
  int renderer = 0;
  if (!this->MakeSettings(input, settings, renderer))
  {
    return {};
  }
  this->SetIrradianceStorage(window, settings.HalfFloats, 1.0 / settings.StorageScale, true);
  if (!this->Irradiance->Resize(window, frame.Size[0], frame.Size[1]) ||
    !this->ResizeGlossy(input) || !in.Pyramid.Resize(window, frame.Size, settings) ||
    !in.Illumination.Resize(window, in.Pyramid, *this->Irradiance, settings.HalfFloats))
  {
    return {};
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglDepthFunc depthFunc(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunc(state);
  vtkIndirectFullScreenState fullScreenState(window);

  in.NumberOfLights = input.Lights->GetNumberOfLights();
  const bool batches = in.NumberOfLights > input.Visibility.GetMaximumNumberOfSenders();
  bool done = false;
  if (batches)
  {
    done = this->FillInBatches(input, settings, renderer);
  }
  else
  {
    in.Batch.reset();
    in.Lights.Update(window, *input.Lights);
    done = this->Fill(input, settings, renderer, *this->Irradiance);
  }
  if (this->HasGlossy)
  {
    input.Timer.Begin(vtkIndirectStageTimer::Upsample);
  }
  done = done && this->FillGlossy(input, settings);
  if (this->HasGlossy)
  {
    input.Timer.End(vtkIndirectStageTimer::Upsample);
  }

  if (input.Lights->HasLobes())
  {
    input.Timer.Begin(vtkIndirectStageTimer::Upsample);
    done = done &&
      in.Lobes.Add(input,
        { *this->Irradiance, this->HasGlossy ? this->Glossy.get() : nullptr,
          1.0 / settings.StorageScale },
        settings.PlaneThreshold > 0.0 ? LobeStep : 1, LobeTolerance);
    input.Timer.End(vtkIndirectStageTimer::Upsample);
  }

  static const char* const renderers[] = { "points", "fragments", "compute" };
  in.Renderer = renderers[renderer];
  in.Tolerance = settings.ReportsError ? this->FindErrorTolerance(input.Plan.ErrorTolerance) : 0.0;
  in.SamplingError = -1.0;
  in.Evaluations = -1;
  if (!done)
  {
    return {};
  }
  if (settings.ReportsError && !batches)
  {
    in.SamplingError = in.Pyramid.EstimateSamplingError();
    in.Evaluations = 0;
    for (size_t i = 0; settings.HasCompute && i < in.Pyramid.GetNumberOfLevels(); ++i)
    {
      in.Evaluations += 4 * in.Pyramid.GetLists().Count(i);
    }
  }
  vtkIndirectEstimate result = this->MakeResult();
  result.Error = in.SamplingError;
  return result;
}

//------------------------------------------------------------------------------
bool vtkMultiresolutionSplattingPass::Fill(const Input& input,
  const vtkIndirectSubsplatSettings& settings, int renderer, vtkIndirectTarget& pixels)
{
  Internals& in = *this->Internal;
  const auto way = static_cast<vtkIndirectSubsplatIllumination::Renderer>(renderer);
  input.Timer.Begin(vtkIndirectStageTimer::Estimate);
  bool done = in.Pyramid.Build(input, settings, in.Lights);
  if (done && way == vtkIndirectSubsplatIllumination::Points && !settings.HasCompute)
  {
    in.Pyramid.FillLists(input.Frame.Window);
  }
  done = done && in.Illumination.FillLevels(input, settings, way, in.Pyramid, in.Lights);
  input.Timer.End(vtkIndirectStageTimer::Estimate);
  input.Timer.Begin(vtkIndirectStageTimer::Upsample);
  done = done && in.Illumination.FillPixels(input, settings, way, in.Pyramid, in.Lights, pixels);
  input.Timer.End(vtkIndirectStageTimer::Upsample);
  return done;
}

//------------------------------------------------------------------------------
// Some drivers end a shader's loops before it has looked for so many lights from one place. Light
// adds up: each batch of them has subsplats of its own, and their images are summed.
bool vtkMultiresolutionSplattingPass::FillInBatches(
  const Input& input, const vtkIndirectSubsplatSettings& settings, int renderer)
{
  Internals& in = *this->Internal;
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  vtkOpenGLState* state = window->GetState();
  const int batch = in.Lights.GetCapacity(window);
  if (!in.Batch || in.BatchIsHalf != settings.HalfFloats)
  {
    in.BatchIsHalf = settings.HalfFloats;
    in.Batch = std::make_unique<vtkIndirectTarget>(
      settings.HalfFloats ? HalfBatchChannels : BatchChannels, false);
  }
  if (!in.Batch->Resize(window, input.Frame.Size[0], input.Frame.Size[1], this->Irradiance.get()))
  {
    return false;
  }
  for (int first = 0; first < in.NumberOfLights; first += batch)
  {
    in.Lights.Update(window, *input.Lights, first, std::min(batch, in.NumberOfLights - first));
    const bool only = first == 0;
    if (!this->Fill(input, settings, renderer, only ? *this->Irradiance : *in.Batch))
    {
      return false;
    }
    if (only)
    {
      continue;
    }
    vtkShaderProgram* program = in.AddBatch.Use(window);
    if (!program)
    {
      return false;
    }
    this->Irradiance->Begin();
    in.Batch->Activate(0, program);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
    in.AddBatch.Draw();
    state->vtkglDisable(GL_BLEND);
    in.Batch->Deactivate();
    this->Irradiance->End();
  }
  // Those for specular receivers are found from all lights.
  in.Lights.Update(window, *input.Lights);
  return true;
}

//------------------------------------------------------------------------------
bool vtkMultiresolutionSplattingPass::FillGlossy(
  const Input& input, const vtkIndirectSubsplatSettings& settings)
{
  Internals& in = *this->Internal;
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  in.WhyGlossyIsGathered.clear();
  if (this->HasGlossy)
  {
    if (!vtkIndirectComputeProgram::IsSupported())
    {
      in.WhyGlossyIsGathered = "this context has no OpenGL 4.3";
    }
    else if (settings.Renderer == vtkIndirectSubsplatDetails::FRAGMENTS ||
      settings.GlossyThreshold == 0.0)
    {
      in.WhyGlossyIsGathered = "lists are off";
    }
    else if (input.Visibility.WalksSegments())
    {
      in.WhyGlossyIsGathered = "lists do not follow segments";
    }
    else if (input.Lights->HasDirections())
    {
      in.WhyGlossyIsGathered = "light comes from directions, which lists do not hold";
    }
    else if (!vtkIndirectGlossySubsplats::Fits(in.Pyramid, in.NumberOfLights))
    {
      in.WhyGlossyIsGathered = "lists for so many pixels and lights are too long";
    }
  }
  in.GlossyIsListed = this->HasGlossy && in.WhyGlossyIsGathered.empty();
  if (!in.GlossyIsListed)
  {
    in.Glossy.Release(window);
    return !this->HasGlossy ||
      in.GlossyGather.Sum(input, *this->Glossy, 1.0 / settings.StorageScale, {});
  }
  return in.Glossy.Resize(window, in.Pyramid, settings.HalfFloats) &&
    in.Glossy.Fill(input, settings, in.Pyramid, in.Lights, *this->Irradiance, *this->Glossy);
}

//------------------------------------------------------------------------------
void vtkMultiresolutionSplattingPass::AddToReport(vtkIndirectReport& report) const
{
  this->Superclass::AddToReport(report);
  const Internals& in = *this->Internal;
  report.Modelled.emplace_back(
    "subsplats", std::to_string(in.Pyramid.GetNumberOfLevels()) + " levels, by " + in.Renderer);
  if (this->HasGlossy)
  {
    const double pairs =
      static_cast<double>(report.Size[0]) * report.Size[1] * static_cast<double>(in.NumberOfLights);
    const double share =
      in.GlossyIsListed ? in.Glossy.CountEvaluations() / std::max(pairs, 1.0) : 1.0;
    report.Modelled.emplace_back("lists of specular subsplats",
      in.GlossyIsListed
        ? std::string("a set of lights for each; evaluations over pixels times lights: ") +
          vtkIndirectReport::Number(share, 3)
        : "every specular pixel sums all lights, because " + in.WhyGlossyIsGathered);
  }
  if (in.Tolerance <= 0.0)
  {
    return;
  }
  const std::string name = "ErrorTolerance " + vtkIndirectReport::Number(in.Tolerance);
  report.Modelled.emplace_back(name,
    "thresholds of the subsplats chosen for it; " +
      (in.Evaluations > 0 ? "at most " + std::to_string(in.Evaluations) + " of them summed "
                          : std::string("they summed ")) +
      std::to_string(in.NumberOfLights) + " virtual lights each");
  for (const std::string& threshold : this->FindOwnThresholds())
  {
    report.LeftOut.emplace_back(name, threshold + " is the user's and stays as it is");
  }
  if (in.SamplingError > in.Tolerance)
  {
    // The error of low-discrepancy lights falls at least as one over the root of their number.
    const double ratio = in.SamplingError / in.Tolerance;
    report.LeftOut.emplace_back(name,
      "two halves of the virtual lights differ by more, " +
        vtkIndirectReport::Number(in.SamplingError, 3) + "; about " +
        std::to_string(static_cast<int>(in.NumberOfLights * ratio * ratio) + 1) +
        " lights would meet it");
  }
  report.LeftOut.emplace_back(name,
    "the error of interpolating over what is narrower than a subsplat is not estimated, and nor is "
    "that of sampling beyond what halves of the lights differ by");
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkMultiresolutionSplattingPass::GetChannelNames() const
{
  const size_t levels = this->Internal->Pyramid.GetNumberOfLevels();
  return levels > 0 ? vtkIndirectSubsplatView::GetNames(levels) : std::vector<std::string>();
}

//------------------------------------------------------------------------------
int vtkMultiresolutionSplattingPass::DrawChannel(
  const std::string& name, const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry)
{
  Internals& in = *this->Internal;
  return in.View.Draw(name, frame, geometry, in.Pyramid, in.Illumination, *this->Irradiance,
    this->GetIrradianceUnit());
}

//------------------------------------------------------------------------------
void vtkMultiresolutionSplattingPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!this->CanBeOf(window))
  {
    return;
  }
  this->Superclass::ReleaseGraphicsResources(window);
  Internals& in = *this->Internal;
  in.Lights.Release();
  in.Pyramid.Release(window);
  in.Illumination.Release(window);
  in.View.Release();
  in.Glossy.Release(window);
  in.GlossyGather.Release();
  in.Lobes.Release(window);
  if (in.Batch)
  {
    in.Batch->Release(window);
  }
  in.AddBatch.Release();
}
