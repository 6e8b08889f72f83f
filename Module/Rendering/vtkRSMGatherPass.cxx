// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkRSMGatherPass.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Gather/vtkIndirectGlossyGather.h"
#include "Gather/vtkIndirectLobeGather.h"
#include "Maps/vtkIndirectLightMaps.h"
#include "OpenGL/vtkIndirectFullScreenProgram.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Plan/vtkIndirectReport.h"
#include "Plan/vtkIndirectSettingList.h"
#include "Plan/vtkIndirectStageTimer.h"
#include "Senders/vtkIndirectAllTexelsSampler.h"
#include "Senders/vtkIndirectVirtualLights.h"
#include "Sums/vtkIndirectReceiverGrid.h"
#include "Sums/vtkIndirectSum.h"
#include "Visibility/vtkIndirectVisibility.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkRSMGatherPass);

namespace
{
const vtkIndirectChannels CoarseChannels = {
  { "gather.coarse", "vtkiCoarse", "irradiance at every InterpolationStep-th pixel", GL_RGBA32F,
    "-", "VTK irradiance" },
};

const char* const LightsFile = "vtkIndirectGatherVirtualLights.glsl";
const char* const NeighborhoodFile = "vtkIndirectGatherNeighborhood.glsl";

// Rows of 256 lights in one draw: long draws stall a desktop, and some drivers abort them.
constexpr int RowsPerDraw = 16;
// Sums along the picture's longer edge in the paper, and the largest step between sums.
constexpr int SamplesOfPaper = 64;
constexpr int MostStep = 32;
// The largest error of interpolated lobes, over their light.
constexpr double LobeTolerance = 0.05;

class GatherSum : public vtkIndirectSum
{
public:
  explicit GatherSum(vtkRSMGatherPass& pass)
    : vtkIndirectSum(pass)
    , Set(pass)
  {
  }
  void AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const override;
  vtkIndirectAbilities GetAbilities(double tolerance) const override;
  vtkIndirectSampler::Pointer ChooseSampler(
    const vtkIndirectSampler::Pointer& users, const vtkIndirectPlan& plan) override;
  void AddToReport(vtkIndirectReport& report) const override;

protected:
  vtkIndirectEstimate Estimate(const Input& input) override;
  void ReleaseOwn(vtkWindow* window) override { this->AllTexels->Release(window); }

private:
  void SetUniforms(const vtkIndirectProgram& program, const Input& input, bool neighborhood);
  bool Sum(const Input& input);
  int FindStep(const int* size) const;

  const vtkRSMGatherPass& Set;
  vtkIndirectReceiverGrid Coarse{ this, CoarseChannels };
  vtkIndirectFullScreenProgram Gather[2] = { { this, "vtkIndirectGatherFS.glsl", LightsFile },
    { this, "vtkIndirectGatherFS.glsl", NeighborhoodFile } };
  vtkIndirectFullScreenProgram Upsample[2] = { { this, "vtkIndirectUpsampleFS.glsl", LightsFile },
    { this, "vtkIndirectUpsampleFS.glsl", NeighborhoodFile } };
  vtkIndirectGlossyGather GlossyGather{ this };
  vtkIndirectLobeGather Lobes{ this };
  const std::shared_ptr<vtkIndirectAllTexelsSampler> AllTexels =
    std::make_shared<vtkIndirectAllTexelsSampler>();
  int Step = 1; // pixels between sums in the last frame
  std::string
    WhatDiskLeaves; // light outside of the last frame's disks, in words; empty if there is none
};
}

//------------------------------------------------------------------------------
vtkRSMGatherPass::vtkRSMGatherPass()
  : vtkIndirectEstimatorPass(std::make_unique<GatherSum>(*this))
{
}

//------------------------------------------------------------------------------
void GatherSum::AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const
{
  static const char* const names[] = { "AllTexels", "VirtualLights", "Neighborhood" };
  this->vtkIndirectSum::AddSettings(list, plan);
  list.Add("Mode", vtkIndirectSettingList::Choice{ names[this->Set.GetMode()] })
    .Add("NumberOfSamples", this->Set.GetNumberOfSamples())
    .Add("NeighborhoodRadius", this->Set.GetNeighborhoodRadius())
    .Add("Interpolation", plan ? this->Step > 1 : this->Set.GetInterpolation())
    .Add(
      "InterpolationStep", plan && this->Step > 1 ? this->Step : this->Set.GetInterpolationStep());
}

//------------------------------------------------------------------------------
void GatherSum::SetUniforms(
  const vtkIndirectProgram& program, const Input& input, bool neighborhood)
{
  input.Geometry.ActivateReceivers(program, input.Frame);
  input.Visibility.Activate(input.Frame.Window, program, input.Creases);
  if (neighborhood)
  {
    input.Maps.Activate(program);
    program->SetUniformi("vtkiSampleCount", this->Set.GetNumberOfSamples());
    program->SetUniformf("vtkiRadius", static_cast<float>(this->Set.GetNeighborhoodRadius()));
    program->SetUniformi("vtkiLayerCount", input.Maps.GetNumberOfLayers());
    return;
  }
  input.Lights->Activate(program);
}

//------------------------------------------------------------------------------
// The figures of the paper: 308 samples a pixel, and 64 x 64 sums in a picture of 512 x 512.
void vtkRSMGatherPass::ApplyPreset()
{
  this->Settings = SettingsType();
  if (this->GetPreset() == PAPER)
  {
    this->Settings.Mode = NEIGHBORHOOD;
    this->Settings.NumberOfSamples = 308;
    this->Settings.InterpolationStep = 0;
  }
}

//------------------------------------------------------------------------------
int GatherSum::FindStep(const int* size) const
{
  const int step = this->Set.GetInterpolationStep();
  return step > 0 ? step : std::clamp(std::max(size[0], size[1]) / SamplesOfPaper, 1, MostStep);
}

//------------------------------------------------------------------------------
vtkIndirectAbilities GatherSum::GetAbilities(double tolerance) const
{
  const int mode = this->Set.GetMode();
  vtkIndirectAbilities abilities = this->vtkIndirectSum::GetAbilities(tolerance);
  abilities.ComputesGlossy = true;
  abilities.SumsLobes = mode != vtkRSMGatherPass::NEIGHBORHOOD;
  abilities.TakesSampler = mode == vtkRSMGatherPass::VIRTUAL_LIGHTS;
  abilities.TakesLightMaps = abilities.TakesSampler;
  abilities.AutomaticVisibility =
    abilities.TakesLightMaps ? vtkIndirectVisibilityMaps : vtkIndirectVisibilityNone;
  abilities.ReadsMaps = mode == vtkRSMGatherPass::NEIGHBORHOOD;
  return abilities;
}

//------------------------------------------------------------------------------
void GatherSum::AddToReport(vtkIndirectReport& report) const
{
  this->vtkIndirectSum::AddToReport(report);
  if (!this->WhatDiskLeaves.empty())
  {
    report.LeftOut.emplace_back(
      "senders outside the disk about a receiver's place in a map", this->WhatDiskLeaves);
  }
}

//------------------------------------------------------------------------------
vtkIndirectSampler::Pointer GatherSum::ChooseSampler(
  const vtkIndirectSampler::Pointer& users, const vtkIndirectPlan&)
{
  switch (this->Set.GetMode())
  {
    case vtkRSMGatherPass::ALL_TEXELS:
      return this->AllTexels;
    case vtkRSMGatherPass::NEIGHBORHOOD:
      return nullptr;
    default:
      return users;
  }
}

//------------------------------------------------------------------------------
vtkIndirectEstimate GatherSum::Estimate(const Input& input)
{
  return this->Sum(input) ? this->MakeResult() : vtkIndirectEstimate();
}

//------------------------------------------------------------------------------
bool GatherSum::Sum(const Input& input)
{
  vtkIndirectStageTimer& timer = input.Timer;
  const vtkIndirectFrame& frame = input.Frame;
  const bool neighborhood = input.Lights == nullptr;
  // The frame's sampler counts its own bytes; no other stage counts those of AllTexels.
  if (this->Set.GetMode() != vtkRSMGatherPass::ALL_TEXELS)
  {
    this->AllTexels->Release(frame.Window);
  }
  if (neighborhood && input.Plan.Senders == vtkIndirectPlan::HEADLIGHT)
  {
    vtkErrorWithObjectMacro(&this->Pass,
      "Mode NEIGHBORHOOD needs a light with a map of its own; a single headlight has "
      "none. Use VIRTUAL_LIGHTS.");
    return false;
  }
  bool cubes = false;
  for (int i = 0; neighborhood && i < input.Maps.GetNumberOfMaps(); ++i)
  {
    cubes = cubes || input.Maps.GetMap(i).Projection == vtkIndirectKernels::VTKI_MAP_FACES;
  }
  this->WhatDiskLeaves = neighborhood && (cubes || this->Set.GetNeighborhoodRadius() < 1.5)
    ? "NeighborhoodRadius is " + vtkIndirectReport::Number(this->Set.GetNeighborhoodRadius()) +
      "; the result is too dark"
    : "";
  const bool walks = input.Visibility.WalksSegments();
  const int rows = neighborhood ? 1 : input.Lights->GetNumberOfRows();
  const int segments = input.Visibility.GetMaximumNumberOfSegments();
  const int rowsOfSegments = segments / vtkIndirectSampler::RowLength;
  const int rowsPerDraw = walks ? rowsOfSegments : RowsPerDraw;
  if (walks && neighborhood &&
    this->Set.GetNumberOfSamples() * input.Maps.GetNumberOfLayers() > segments)
  {
    vtkErrorWithObjectMacro(&this->Pass,
      "Mode NEIGHBORHOOD with voxels takes at most "
        << segments << " samples over all maps; lower NumberOfSamples.");
    return false;
  }
  // The pixels that cannot be interpolated are summed in one draw, which limits the number of rows.
  const int wanted = this->FindStep(frame.Size);
  const bool interpolate = this->Set.GetInterpolation() && wanted > 1 &&
    this->Set.GetMode() != vtkRSMGatherPass::ALL_TEXELS &&
    rows * vtkIndirectSampler::RowLength <= input.Visibility.GetMaximumNumberOfSenders();
  const int step = interpolate ? wanted : 1;
  this->Step = step;
  if (!this->Irradiance->Resize(frame.Window, frame.Size[0], frame.Size[1]) ||
    !this->ResizeGlossy(input) || (interpolate && !this->Coarse.Resize(frame, step)))
  {
    return false;
  }
  if (!interpolate)
  {
    this->Coarse.Release(frame.Window);
  }

  vtkIndirectFullScreenState kernelState(frame.Window);
  const std::string definitions = std::string(input.Visibility.GetDefinitions()) +
    (neighborhood ? "" : input.Lights->GetDefinitions());
  this->Gather[neighborhood].SetDefinitions(definitions);
  this->Upsample[neighborhood].SetDefinitions(definitions);

  // Sums at coarse samples, or at every pixel.
  timer.Begin(vtkIndirectStageTimer::Estimate);
  vtkIndirectTarget& sums = interpolate ? this->Coarse : *this->Irradiance;
  const bool summed = this->Gather[neighborhood].RunRows(frame.Window, sums, rows, rowsPerDraw,
    [&](const vtkIndirectProgram& program)
    {
      this->SetUniforms(program, input, neighborhood);
      program->SetUniformi("vtkiStep", step);
    });
  if (!summed ||
    (this->HasGlossy &&
      !this->GlossyGather.Sum(input, *this->Glossy, 1.0,
        { this->Set.GetNumberOfSamples(), this->Set.GetNeighborhoodRadius() })))
  {
    return false;
  }
  timer.End(vtkIndirectStageTimer::Estimate);
  auto addLobes = [&]()
  {
    timer.Begin(vtkIndirectStageTimer::Upsample);
    const bool added = this->Lobes.Add(input,
      { *this->Irradiance, this->HasGlossy ? this->Glossy.get() : nullptr, 1.0 }, step,
      LobeTolerance);
    timer.End(vtkIndirectStageTimer::Upsample);
    return added;
  };
  if (!interpolate)
  {
    return addLobes();
  }

  timer.Begin(vtkIndirectStageTimer::Upsample);
  const bool filled =
    this->Upsample[neighborhood].RunRows(frame.Window, *this->Irradiance, rows, rows,
      [&](const vtkIndirectProgram& program)
      {
        this->SetUniforms(program, input, neighborhood);
        this->Coarse.ActivateAll(program);
      });
  timer.End(vtkIndirectStageTimer::Upsample);
  return filled && addLobes();
}
