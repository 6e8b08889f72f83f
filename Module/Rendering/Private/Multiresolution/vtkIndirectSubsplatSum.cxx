// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Multiresolution/vtkIndirectSubsplatSum.h"

#include "OpenGL/vtkIndirectKey.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Plan/vtkIndirectReport.h"
#include "Plan/vtkIndirectSettingList.h"
#include "Plan/vtkIndirectStageTimer.h"
#include "Scene/vtkIndirectFrame.h"
#include "Senders/vtkIndirectVirtualLights.h"
#include "Visibility/vtkIndirectVisibility.h"

#include <algorithm>

namespace
{
// Lobes of senders are summed at every so many pixels, and interpolated where this changes no more
// than this share of their light.
constexpr int LobeStep = 4;
constexpr double LobeTolerance = 0.05;

// The names of vtkMultiresolutionSplattingPass::FinestLevelType.
const char* const FinestLevels[] = { "FullResolution", "HalfResolution", "QuarterResolution",
  "EighthResolution" };

// The names of vtkMultiresolutionSplattingPass::FormFactorType.
const char* const FormFactors[] = { "Patch", "Point" };

const vtkIndirectChannels BatchChannels = {
  { "subsplat.batch", "vtkiBatch", "irradiance from some of the lights", GL_RGBA32F, "-",
    "VTK irradiance" },
};
const vtkIndirectChannels HalfBatchChannels = {
  { "subsplat.batch", "vtkiBatch", "irradiance from some of the lights", GL_RGBA16F, "-",
    "VTK irradiance over the frame's unit" },
};
}

//------------------------------------------------------------------------------
double vtkMultiresolutionSplattingPass::Threshold::Scale(double tolerance) const
{
  return this->IsSet || !(tolerance > 0.0)
    ? this->Value
    : vtkIndirectPlan::ScaleThreshold(this->Value, tolerance, this->Most);
}

//------------------------------------------------------------------------------
vtkIndirectSubsplatSum::vtkIndirectSubsplatSum(vtkMultiresolutionSplattingPass& pass)
  : vtkIndirectSum(pass)
  , Set(pass)
{
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatSum::AddSettings(
  vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const
{
  using Choice = vtkIndirectSettingList::Choice;
  const auto& set = this->Set.Settings;
  const double tolerance = plan ? plan->EstimatorErrorTolerance : 0.0;
  this->vtkIndirectSum::AddSettings(list, plan);
  list.Add("FinestLevel", Choice{ FinestLevels[this->FindFinestLevel(plan)] })
    .Add("FormFactor", Choice{ FormFactors[set.FormFactor] })
    .Add("DepthThreshold", set.DepthThreshold.Scale(tolerance))
    .Add("PlaneThreshold", set.PlaneThreshold.Scale(tolerance))
    .Add("NormalThreshold", set.NormalThreshold.Scale(tolerance))
    .Add("SurfaceDetail", set.SurfaceDetail);
}

//------------------------------------------------------------------------------
vtkIndirectAbilities vtkIndirectSubsplatSum::GetAbilities(double tolerance) const
{
  vtkIndirectAbilities abilities = this->vtkIndirectSum::GetAbilities(tolerance);
  abilities.ComputesGlossy = true;
  abilities.SumsLobes = true;
  abilities.TakesLightMaps = true;
  abilities.Refines = true;
  abilities.AutomaticVisibility = vtkIndirectVisibilityMaps;
  abilities.ErrorTolerance = this->FindErrorTolerance(tolerance);
  return abilities;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkIndirectSubsplatSum::FindOwnThresholds() const
{
  const auto& set = this->Set.Settings;
  const bool depthRange = this->Set.Details->DepthRange;
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
double vtkIndirectSubsplatSum::FindErrorTolerance(double asked) const
{
  // The threshold of the lighting is the plan's.
  return this->Set.Details->LightingThreshold > 0.0 || this->FindOwnThresholds().size() < 2 ? asked
                                                                                            : 0.0;
}

//------------------------------------------------------------------------------
// Reflected light of lights that turn with the camera is a mild part of all light. On six scenes
// blocks of 4 x 4 pixels raise the difference of a still picture to one of more lights from
// 1.02 to 1.13 grey levels RMS of 256; blocks of 8 x 8 change moving pictures of larger surfaces by
// less than 0.05. Orbits take 0.35 to 0.8 of the time, moving frames 0.4 to 0.6. Where lights
// stand, blocks of 4 x 4 pixels make moving frames of rooms and of a frog's organs 0.45 to 0.9 as
// long; their relMSE to frames without such blocks is 0.001 to 0.013 at the best 99 % of the
// pixels. The same blocks bound the light in specular lobes: frames of stream tubes that reflect
// take 0.4 of the time, and 0.02 % of their pixels change by more than 4 grey levels.
bool vtkIndirectSubsplatSum::IsCoarse(const vtkIndirectPlan* plan) const
{
  return plan && (plan->LightsTurn || plan->Interactive) && !this->Set.Details->DepthRange;
}

//------------------------------------------------------------------------------
int vtkIndirectSubsplatSum::FindFinestLevel(const vtkIndirectPlan* plan) const
{
  const int coarse = !this->IsCoarse(plan)  ? vtkMultiresolutionSplattingPass::FULL_RESOLUTION
    : plan->LightsTurn && plan->Interactive ? vtkMultiresolutionSplattingPass::EIGHTH_RESOLUTION
                                            : vtkMultiresolutionSplattingPass::QUARTER_RESOLUTION;
  return std::max(this->Set.Settings.FinestLevel, coarse);
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatSum::AppendTo(vtkIndirectKey& key, const Input& input) const
{
  this->vtkIndirectSum::AppendTo(key, input);
  // A still frame after moving frames sums light at every pixel.
  key.Add("finest level", this->FindFinestLevel(&input.Plan));
}

//------------------------------------------------------------------------------
vtkIndirectSubsplatSettings vtkIndirectSubsplatSum::MakeSettings(const Input& input) const
{
  const vtkIndirectSubsplatDetails& details = *this->Set.Details;
  vtkIndirectSubsplatSettings settings;
  static_cast<vtkIndirectSubsplatDetails&>(settings) = details;
  settings.TakesNearest = this->IsCoarse(&input.Plan);
  settings.FinestLevel = this->FindFinestLevel(&input.Plan);
  settings.PointFormFactor =
    this->Set.Settings.FormFactor == vtkMultiresolutionSplattingPass::POINT;
  settings.SurfaceDetail = this->Set.Settings.SurfaceDetail;
  const double tolerance = input.Plan.EstimatorErrorTolerance;
  settings.PlaneThreshold = this->Set.Settings.PlaneThreshold.Scale(tolerance);
  settings.DepthThreshold = this->Set.Settings.DepthThreshold.Scale(tolerance);
  settings.NormalThreshold = this->Set.Settings.NormalThreshold.Scale(tolerance);
  settings.LightingThreshold =
    vtkMultiresolutionSplattingPass::Threshold{ details.LightingThreshold, 1.0 }.Scale(tolerance);
  settings.GlossyThreshold =
    vtkMultiresolutionSplattingPass::Threshold{ details.GlossyThreshold, 1.0 }.Scale(
      input.Plan.ErrorTolerance);
  settings.StorageScale = settings.HalfFloats ? 1.0 / input.Plan.IrradianceUnit : 1.0;
  settings.HasCompute = vtkIndirectComputeProgram::IsSupported();
  return settings;
}

//------------------------------------------------------------------------------
// The guess of SurfaceDetail depends on the eye, and each batch of lights fills an image of its
// own. The first moving frame finds the irradiance of the still picture.
bool vtkIndirectSubsplatSum::CanReproject(const Input& input) const
{
  return input.Plan.Caching && !this->Set.Details->DepthRange &&
    this->Set.Settings.SurfaceDetail == 0.0 &&
    input.Lights->GetNumberOfLights() <= input.Visibility.GetMaximumNumberOfSenders();
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkIndirectSubsplatSum::Estimate(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  vtkOpenGLRenderWindow* window = frame.Window;
  vtkIndirectSubsplatSettings settings = this->MakeSettings(input);
  const double unit = 1.0 / settings.StorageScale;
  if (this->SetIrradianceStorage(settings.HalfFloats, unit, true))
  {
    this->Reprojection.Release(window);
    this->Reprojection.Drop();
  }
  this->IsReprojected = input.EyeMoved && this->IsCoarse(&input.Plan) &&
    this->CanReproject(input) && this->Reprojection.Has(frame, unit);
  if (this->IsReprojected)
  {
    this->Reprojection.Exchange(this->Irradiance);
    if (!this->Irradiance)
    {
      this->Irradiance = this->MakeIrradiance();
    }
  }
  else
  {
    this->Reprojection.ForgetKey();
  }
  if (!this->Irradiance->Resize(window, frame.Size[0], frame.Size[1]) ||
    !this->ResizeGlossy(input) || !this->Pyramid.Resize(window, frame.Size, settings) ||
    !this->Illumination.Resize(window, this->Pyramid, settings.HalfFloats))
  {
    return {};
  }
  vtkIndirectFullScreenState fullScreenState(window);
  if (this->IsReprojected)
  {
    input.Timer.Begin(vtkIndirectStageTimer::Estimate);
    settings.Reprojected = this->Irradiance.get();
    const bool drawn = this->Reprojection.Draw(frame, input.Geometry, *this->Irradiance);
    input.Timer.End(vtkIndirectStageTimer::Estimate);
    if (!drawn)
    {
      return {};
    }
  }

  this->NumberOfLights = input.Lights->GetNumberOfLights();
  const bool batches = this->NumberOfLights > input.Visibility.GetMaximumNumberOfSenders();
  bool done = false;
  if (batches)
  {
    done = this->FillInBatches(input, settings);
  }
  else
  {
    this->Batch.reset();
    this->Lights.Update(window, *input.Lights);
    done = this->Fill(input, settings, *this->Irradiance);
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
      this->Lobes.Add(input,
        { *this->Irradiance, this->HasGlossy ? this->Glossy.get() : nullptr, unit,
          this->IsReprojected },
        settings.PlaneThreshold > 0.0 ? LobeStep : 1, LobeTolerance);
    input.Timer.End(vtkIndirectStageTimer::Upsample);
  }

  this->Renderer = settings.HasCompute ? "compute" : "fragments";
  this->Tolerance = input.Plan.EstimatorErrorTolerance;
  this->Evaluations = -1;
  if (!done)
  {
    return {};
  }
  if (!this->CanReproject(input))
  {
    this->Reprojection.Release(window);
    this->Reprojection.Drop();
  }
  else if (!this->Reprojection.Keep(frame, input.Geometry, unit))
  {
    return {};
  }
  if (this->Tolerance > 0.0 && !batches && settings.HasCompute)
  {
    this->Evaluations = 0;
    for (size_t i = 0; i < this->Pyramid.GetNumberOfLevels(); ++i)
    {
      this->Evaluations += 4 * this->Pyramid.GetLists().Count(i);
    }
  }
  return this->MakeResult();
}

//------------------------------------------------------------------------------
bool vtkIndirectSubsplatSum::Fill(
  const Input& input, const vtkIndirectSubsplatSettings& settings, vtkIndirectTarget& pixels)
{
  input.Timer.Begin(vtkIndirectStageTimer::Estimate);
  bool done = this->Pyramid.Build(input, settings, this->Lights);
  done = done && this->Illumination.FillLevels(input, settings, this->Pyramid, this->Lights);
  input.Timer.End(vtkIndirectStageTimer::Estimate);
  input.Timer.Begin(vtkIndirectStageTimer::Upsample);
  done =
    done && this->Illumination.FillPixels(input, settings, this->Pyramid, this->Lights, pixels);
  input.Timer.End(vtkIndirectStageTimer::Upsample);
  return done;
}

//------------------------------------------------------------------------------
// Some drivers end a shader's loops before it has looked for so many lights from one place. Light
// adds up: each batch of them has subsplats of its own, and their images are summed.
bool vtkIndirectSubsplatSum::FillInBatches(
  const Input& input, const vtkIndirectSubsplatSettings& settings)
{
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  vtkOpenGLState* state = window->GetState();
  const int batch = this->Lights.GetCapacity(window);
  if (!this->Batch || this->BatchIsHalf != settings.HalfFloats)
  {
    this->BatchIsHalf = settings.HalfFloats;
    this->Batch = std::make_unique<vtkIndirectTarget>(
      this, settings.HalfFloats ? HalfBatchChannels : BatchChannels, false);
  }
  if (!this->Batch->Resize(
        window, input.Frame.Size[0], input.Frame.Size[1], this->Irradiance.get()))
  {
    return false;
  }
  for (int first = 0; first < this->NumberOfLights; first += batch)
  {
    this->Lights.Update(
      window, *input.Lights, first, std::min(batch, this->NumberOfLights - first));
    const bool only = first == 0;
    if (!this->Fill(input, settings, only ? *this->Irradiance : *this->Batch))
    {
      return false;
    }
    if (only)
    {
      continue;
    }
    const bool added = this->AddBatch.Run(window, *this->Irradiance,
      [&](const vtkIndirectProgram& program)
      {
        this->Batch->Activate(0, program);
        state->vtkglEnable(GL_BLEND);
        state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
      });
    state->vtkglDisable(GL_BLEND);
    if (!added)
    {
      return false;
    }
  }
  // The lists for specular receivers are found from all lights.
  this->Lights.Update(window, *input.Lights);
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectSubsplatSum::FillGlossy(
  const Input& input, const vtkIndirectSubsplatSettings& settings)
{
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  this->WhyGlossyIsGathered.clear();
  if (this->HasGlossy)
  {
    if (!settings.HasCompute)
    {
      this->WhyGlossyIsGathered = "lists need compute shaders, OpenGL 4.3";
    }
    else if (settings.GlossyThreshold == 0.0)
    {
      this->WhyGlossyIsGathered = "lists are off";
    }
    else if (input.Visibility.WalksSegments())
    {
      this->WhyGlossyIsGathered = "lists do not follow segments";
    }
    else if (input.Lights->HasDirections())
    {
      this->WhyGlossyIsGathered = "light comes from directions, which lists do not hold";
    }
    else if (!vtkIndirectGlossySubsplats::Fits(this->Pyramid, this->NumberOfLights))
    {
      this->WhyGlossyIsGathered = "lists for so many pixels and lights are too long";
    }
  }
  this->GlossyIsListed = this->HasGlossy && this->WhyGlossyIsGathered.empty();
  if (!this->GlossyIsListed)
  {
    this->GlossySubsplats.Release(window);
    return !this->HasGlossy ||
      this->GlossyGather.Sum(input, *this->Glossy, 1.0 / settings.StorageScale, {});
  }
  return this->GlossySubsplats.Resize(window, this->Pyramid, settings.HalfFloats) &&
    this->GlossySubsplats.Fill(
      input, settings, this->Pyramid, this->Lights, *this->Irradiance, *this->Glossy);
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatSum::AddToReport(vtkIndirectReport& report) const
{
  this->vtkIndirectSum::AddToReport(report);
  report.Modelled.emplace_back("subsplats",
    std::to_string(this->Pyramid.GetNumberOfLevels()) + " levels, by " + this->Renderer);
  if (this->IsReprojected)
  {
    report.Modelled.emplace_back("reprojection", this->Reprojection.GetMeaning());
  }
  if (this->HasGlossy)
  {
    const double pairs = static_cast<double>(report.Size[0]) * report.Size[1] *
      static_cast<double>(this->NumberOfLights);
    const double share =
      this->GlossyIsListed ? this->GlossySubsplats.CountEvaluations() / std::max(pairs, 1.0) : 1.0;
    report.Modelled.emplace_back("lists of specular subsplats",
      this->GlossyIsListed
        ? std::string("a set of lights for each; evaluations over pixels times lights: ") +
          vtkIndirectReport::Number(share, 3)
        : "every specular pixel sums all lights, because " + this->WhyGlossyIsGathered);
  }
  if (this->Tolerance <= 0.0)
  {
    return;
  }
  const std::string name = "ErrorTolerance " + vtkIndirectReport::Number(this->Tolerance);
  report.Modelled.emplace_back(name,
    "thresholds of the subsplats chosen for it; " +
      (this->Evaluations >= 0 ? "at most " + std::to_string(this->Evaluations) + " of them summed "
                              : std::string("they summed ")) +
      std::to_string(this->NumberOfLights) + " virtual lights each");
  for (const std::string& threshold : this->FindOwnThresholds())
  {
    report.LeftOut.emplace_back(name, threshold + " is the user's and stays as it is");
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkIndirectSubsplatSum::GetChannelNames() const
{
  const size_t levels = this->Pyramid.GetNumberOfLevels();
  return levels > 0 ? vtkIndirectSubsplatView::GetNames(levels) : std::vector<std::string>();
}

//------------------------------------------------------------------------------
int vtkIndirectSubsplatSum::DrawChannel(
  const std::string& name, const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry)
{
  return this->View.Draw(name, frame, geometry, this->Pyramid, this->Illumination,
    *this->Irradiance, this->GetIrradianceUnit());
}
