// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkMultiresolutionSplattingPass.h"

#include "Frame/vtkIndirectEstimate.h"
#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectPlan.h"
#include "Frame/vtkIndirectReport.h"
#include "Frame/vtkIndirectStageTimer.h"
#include "Gather/vtkIndirectGlossyGather.h"
#include "Multiresolution/vtkIndirectGlossySubsplats.h"
#include "Multiresolution/vtkIndirectSubsplatIllumination.h"
#include "Multiresolution/vtkIndirectSubsplatView.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "VirtualLights/vtkIndirectLightBlock.h"
#include "VirtualLights/vtkIndirectVirtualLights.h"
#include "Visibility/vtkIndirectVisibility.h"
#include "vtkObjectFactory.h"
#include "vtkVirtualLightSampler.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkMultiresolutionSplattingPass);

namespace
{
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
  vtkIndirectLightBlock Lights;
  vtkIndirectSubsplatPyramid Pyramid;
  vtkIndirectSubsplatIllumination Illumination;
  vtkIndirectSubsplatView View;
  vtkIndirectGlossySubsplats Glossy;
  vtkIndirectGlossyGather GlossyGather;
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

namespace
{
// A threshold that the user has not set goes with the tolerance.
void Scale(double& threshold, double standard, double tolerance, double most)
{
  threshold =
    threshold == standard ? vtkIndirectPlan::ScaleThreshold(standard, tolerance, most) : threshold;
}
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
  static const char* const renderers[] = { "Automatic", "PointSplats", "LeafFragments",
    "LeafCompute" };
  os << indent << "CoarsestResolution: " << this->CoarsestResolution << "\n";
  os << indent << "FinestLevel: "
     << (this->FinestLevel == FULL_RESOLUTION ? "FullResolution" : "HalfResolution") << "\n";
  os << indent
     << "Refinement: " << (this->Refinement == DEPTH_RANGE ? "DepthRange" : "PlaneDeviation")
     << "\n";
  os << indent << "PlaneThreshold: " << this->PlaneThreshold << "\n";
  os << indent << "DepthThreshold: " << this->DepthThreshold << "\n";
  os << indent << "NormalThreshold: " << this->NormalThreshold << "\n";
  os << indent << "LightingThreshold: " << this->LightingThreshold << "\n";
  os << indent << "Balance: " << (this->Balance ? "On" : "Off") << "\n";
  os << indent << "NormalCorrection: " << (this->NormalCorrection ? "On" : "Off") << "\n";
  os << indent << "GlossyThreshold: " << this->GlossyThreshold << "\n";
  os << indent << "SurfaceDetail: " << this->SurfaceDetail << "\n";
  os << indent << "Renderer: " << renderers[this->Renderer] << "\n";
  os << indent << "Storage: " << (this->Storage == HALF_FLOAT ? "HalfFloat" : "Float") << "\n";
}

//------------------------------------------------------------------------------
size_t vtkMultiresolutionSplattingPass::GetBytes() const
{
  const Internals& in = *this->Internal;
  return this->Superclass::GetBytes() + in.Lights.GetBytes() + in.Pyramid.GetBytes() +
    in.Illumination.GetBytes() + in.Glossy.GetBytes() + (in.Batch ? in.Batch->GetBytes() : 0);
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkMultiresolutionSplattingPass::FindOwnThresholds() const
{
  std::vector<std::string> names;
  if (this->Refinement == DEPTH_RANGE && this->DepthThreshold != StandardDepthThreshold)
  {
    names.emplace_back("DepthThreshold");
  }
  if (this->Refinement != DEPTH_RANGE && this->PlaneThreshold != StandardPlaneThreshold)
  {
    names.emplace_back("PlaneThreshold");
  }
  if (this->NormalThreshold != StandardNormalThreshold)
  {
    names.emplace_back("NormalThreshold");
  }
  if (this->LightingThreshold != StandardLightingThreshold)
  {
    names.emplace_back("LightingThreshold");
  }
  return names;
}

//------------------------------------------------------------------------------
double vtkMultiresolutionSplattingPass::FindErrorTolerance(double asked) const
{
  return this->FindOwnThresholds().size() < NumberOfThresholds ? asked : 0.0;
}

//------------------------------------------------------------------------------
bool vtkMultiresolutionSplattingPass::MakeSettings(
  const Input& input, vtkIndirectSubsplatSettings& settings, int& renderer)
{
  const bool hasCompute = vtkIndirectComputeProgram::IsSupported();
  if (this->Renderer == LEAF_COMPUTE && !hasCompute)
  {
    vtkErrorMacro("Renderer LEAF_COMPUTE needs OpenGL 4.3; this context is older. Use AUTOMATIC.");
    return false;
  }
  renderer = this->Renderer == POINT_SPLATS          ? vtkIndirectSubsplatIllumination::Points
    : hasCompute && this->Renderer != LEAF_FRAGMENTS ? vtkIndirectSubsplatIllumination::Compute
                                                     : vtkIndirectSubsplatIllumination::Fragments;
  settings.CoarsestResolution = this->CoarsestResolution;
  settings.HalfResolution = this->FinestLevel == HALF_RESOLUTION;
  settings.DepthRange = this->Refinement == DEPTH_RANGE;
  settings.PlaneThreshold = this->PlaneThreshold;
  settings.DepthThreshold = this->DepthThreshold;
  settings.NormalThreshold = this->NormalThreshold;
  settings.LightingThreshold = this->LightingThreshold;
  const double tolerance = this->FindErrorTolerance(input.Plan.ErrorTolerance);
  if (tolerance > 0.0)
  {
    Scale(settings.PlaneThreshold, StandardPlaneThreshold, tolerance, 100.0);
    Scale(settings.DepthThreshold, StandardDepthThreshold, tolerance, 1.0);
    Scale(settings.NormalThreshold, StandardNormalThreshold, tolerance, 2.0);
    Scale(settings.LightingThreshold, StandardLightingThreshold, tolerance, 1.0);
  }
  settings.Balance = this->Balance;
  settings.NormalCorrection = this->NormalCorrection;
  settings.SurfaceDetail = this->SurfaceDetail;
  settings.HalfFloats = this->Storage == HALF_FLOAT;
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
  const bool batches = input.Visibility.HidesSenders() &&
    in.NumberOfLights > vtkIndirectVisibility::MaximumNumberOfSegments;
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
    in.Batch->ShareDepth(*this->Irradiance);
  }
  if (!in.Batch->Resize(window, input.Frame.Size[0], input.Frame.Size[1]))
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
  double threshold = this->GlossyThreshold;
  if (input.Plan.ErrorTolerance > 0.0)
  {
    Scale(threshold, StandardGlossyThreshold, input.Plan.ErrorTolerance, 1.0);
  }
  in.WhyGlossyIsGathered.clear();
  if (this->HasGlossy)
  {
    if (!vtkIndirectComputeProgram::IsSupported())
    {
      in.WhyGlossyIsGathered = "this context has no OpenGL 4.3";
    }
    else if (this->Renderer == LEAF_FRAGMENTS)
    {
      in.WhyGlossyIsGathered = "Renderer is LEAF_FRAGMENTS";
    }
    else if (!(this->GlossyThreshold > 0.0))
    {
      in.WhyGlossyIsGathered = "GlossyThreshold is 0";
    }
    else if (input.Visibility.HidesSenders())
    {
      in.WhyGlossyIsGathered = "Occupancy is on, and lists do not look what stands between";
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
    in.Glossy.Fill(
      input, settings, threshold, in.Pyramid, in.Lights, *this->Irradiance, *this->Glossy);
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
  if (!window)
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
  if (in.Batch)
  {
    in.Batch->Release(window);
  }
  in.AddBatch.Release();
}
