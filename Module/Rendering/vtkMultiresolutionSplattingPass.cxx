// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectGL.h"

#include "vtkMultiresolutionSplattingPass.h"

#include "vtkIndirectClearance.h"
#include "vtkIndirectGlossyGather.h"
#include "vtkIndirectGlossySubsplats.h"
#include "vtkIndirectLightBlock.h"
#include "vtkIndirectOccupancyVolume.h"
#include "vtkIndirectReport.h"
#include "vtkIndirectStageTimer.h"
#include "vtkIndirectSubsplatIllumination.h"
#include "vtkIndirectSubsplatView.h"
#include "vtkIndirectUniforms.h"
#include "vtkObjectFactory.h"
#include "vtkVirtualLightSampler.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkMultiresolutionSplattingPass);

//------------------------------------------------------------------------------
struct vtkMultiresolutionSplattingPass::Internals
{
  vtkIndirectLightBlock Lights;
  vtkIndirectSubsplatPyramid Pyramid;
  vtkIndirectSubsplatIllumination Illumination;
  vtkIndirectSubsplatView View;
  vtkIndirectGlossySubsplats Glossy;
  vtkIndirectGlossyGather GlossyGather;

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
// Irradiance that a half float's one stands for: what the strongest light gives a surface that
// faces it in the middle of the scene, so that 1e-7 to 65504 times that can be stored.
double MakeUnit(const vtkIndirectFrame& frame)
{
  double unit = 0.0;
  for (const vtkIndirectLight& light : frame.Lights)
  {
    const double color = std::max({ light.Color.x, light.Color.y, light.Color.z });
    double attenuation = 1.0;
    if (light.Positional)
    {
      const double d =
        std::max(glm::length(light.PositionWC - frame.SceneCenter), 0.1 / frame.SceneScale);
      const double denominator =
        light.Attenuation.x + d * (light.Attenuation.y + d * light.Attenuation.z);
      attenuation = denominator > 0.0 ? 1.0 / denominator : 1.0;
    }
    unit = std::max(unit, color * attenuation);
  }
  // A power of two: storing loses nothing but the bits that half floats lack.
  return unit > 0.0 && std::isfinite(unit) ? std::exp2(std::ceil(std::log2(unit))) : 1.0;
}

// A threshold that the user has not set goes with the tolerance.
void Scale(double& threshold, double standard, double share, double most)
{
  threshold = threshold == standard ? std::min(standard * share, most) : threshold;
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
    in.Illumination.GetBytes() + in.Glossy.GetBytes();
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
bool vtkMultiresolutionSplattingPass::Estimate(const Input& input, vtkIndirectStageTimer& timer)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  vtkOpenGLRenderWindow* window = frame.Window;
  const bool hasCompute = vtkIndirectComputeProgram::IsSupported();
  if (this->Renderer == LEAF_COMPUTE && !hasCompute)
  {
    vtkErrorMacro("Renderer LEAF_COMPUTE needs OpenGL 4.3; this context is older. Use AUTOMATIC.");
    return false;
  }
  vtkIndirectSubsplatIllumination::Renderer renderer = vtkIndirectSubsplatIllumination::Fragments;
  if (this->Renderer == POINT_SPLATS)
  {
    renderer = vtkIndirectSubsplatIllumination::Points;
  }
  else if (hasCompute && this->Renderer != LEAF_FRAGMENTS)
  {
    renderer = vtkIndirectSubsplatIllumination::Compute;
  }

  const double unit = this->Storage == HALF_FLOAT ? MakeUnit(frame) : 1.0;
  vtkIndirectSubsplatSettings settings;
  settings.CoarsestResolution = this->CoarsestResolution;
  settings.HalfResolution = this->FinestLevel == HALF_RESOLUTION;
  settings.DepthRange = this->Refinement == DEPTH_RANGE;
  settings.PlaneThreshold = this->PlaneThreshold;
  settings.DepthThreshold = this->DepthThreshold;
  settings.NormalThreshold = this->NormalThreshold;
  settings.LightingThreshold = this->LightingThreshold;
  const double tolerance = this->FindErrorTolerance(input.ErrorTolerance);
  if (tolerance > 0.0)
  {
    // The defaults give an error of 0.02 on a hard scene, and the error goes with the thresholds.
    const double share = tolerance / 0.02;
    Scale(settings.PlaneThreshold, StandardPlaneThreshold, share, 100.0);
    Scale(settings.DepthThreshold, StandardDepthThreshold, share, 1.0);
    Scale(settings.NormalThreshold, StandardNormalThreshold, share, 2.0);
    Scale(settings.LightingThreshold, StandardLightingThreshold, share, 1.0);
  }
  settings.Balance = this->Balance;
  settings.NormalCorrection = this->NormalCorrection;
  settings.SurfaceDetail = this->SurfaceDetail;
  settings.HalfFloats = this->Storage == HALF_FLOAT;
  settings.StorageScale = 1.0 / unit;
  settings.HasCompute = hasCompute && renderer != vtkIndirectSubsplatIllumination::Fragments;
  settings.ReportsError = tolerance > 0.0;

  this->SetIrradianceStorage(window, settings.HalfFloats, unit, true);
  if (!this->Irradiance->Resize(window, frame.Size[0], frame.Size[1]) ||
    !this->ResizeGlossy(input) || !in.Pyramid.Resize(window, frame.Size, settings) ||
    !in.Illumination.Resize(window, in.Pyramid, *this->Irradiance, settings.HalfFloats))
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglDepthFunc depthFunc(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunc(state);
  vtkIndirectKernelState kernelState(window);

  this->UpdateSight(input, timer);
  if (this->IsBlocked() && input.Sampler->GetActualNumberOfLights() > MaximumNumberOfSegments)
  {
    vtkErrorMacro("Occupancy takes at most " << MaximumNumberOfSegments
                                             << " virtual lights here; use fewer, or the gather.");
    return false;
  }
  in.Lights.SetVoxels(this->IsBlocked() ? input.Voxels.get() : nullptr);
  timer.Begin(vtkIndirectStageTimer::Estimate);
  in.Lights.Update(window, *input.Sampler);
  bool done = in.Pyramid.Build(input, settings, in.Lights);
  if (done && renderer == vtkIndirectSubsplatIllumination::Points && !settings.HasCompute)
  {
    in.Pyramid.FillLists(window);
  }
  done = done && in.Illumination.FillLevels(input, settings, renderer, in.Pyramid, in.Lights);
  timer.End(vtkIndirectStageTimer::Estimate);
  timer.Begin(vtkIndirectStageTimer::Upsample);
  done = done &&
    in.Illumination.FillPixels(input, settings, renderer, in.Pyramid, in.Lights, *this->Irradiance);
  done = done && this->FillGlossy(input, settings);
  timer.End(vtkIndirectStageTimer::Upsample);
  if (this->IsBlocked())
  {
    input.Voxels->GetClearance().Deactivate();
  }
  in.Lights.SetVoxels(nullptr);

  static const char* const renderers[] = { "points", "fragments", "compute" };
  in.Renderer = renderers[renderer];
  in.NumberOfLights = input.Sampler->GetActualNumberOfLights();
  in.Tolerance = tolerance;
  in.SamplingError = -1.0;
  in.Evaluations = -1;
  if (done && tolerance > 0.0)
  {
    in.SamplingError = in.Pyramid.EstimateSamplingError();
    in.Evaluations = 0;
    for (size_t i = 0; settings.HasCompute && i < in.Pyramid.GetNumberOfLevels(); ++i)
    {
      in.Evaluations += 4 * in.Pyramid.GetLists().Count(i);
    }
  }
  return done;
}

//------------------------------------------------------------------------------
bool vtkMultiresolutionSplattingPass::FillGlossy(
  const Input& input, const vtkIndirectSubsplatSettings& settings)
{
  Internals& in = *this->Internal;
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  double threshold = this->GlossyThreshold;
  if (input.ErrorTolerance > 0.0)
  {
    Scale(threshold, StandardGlossyThreshold, input.ErrorTolerance / 0.02, 1.0);
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
    else if (this->IsBlocked())
    {
      in.WhyGlossyIsGathered = "Occupancy is on, and lists do not look what stands between";
    }
    else if (!vtkIndirectGlossySubsplats::Fits(
               in.Pyramid, input.Sampler->GetActualNumberOfLights()))
    {
      in.WhyGlossyIsGathered = "lists for so many pixels and lights are too long";
    }
  }
  in.GlossyIsListed = this->HasGlossy && in.WhyGlossyIsGathered.empty();
  if (!in.GlossyIsListed)
  {
    in.Glossy.Release(window);
    return !this->HasGlossy ||
      in.GlossyGather.Sum(input, *this->Glossy, this->GetIrradianceUnit(),
        this->IsBlocked() ? input.Voxels.get() : nullptr, {});
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
  report.EstimatedError = in.SamplingError;
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
  const std::string& name, const vtkIndirectFrame& frame, const vtkGeometryBufferPass& geometry)
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
}
