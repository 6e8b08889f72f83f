// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkRSMGatherPass.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Frame/vtkIndirectEstimate.h"
#include "Frame/vtkIndirectEyeUniforms.h"
#include "Frame/vtkIndirectPlan.h"
#include "Frame/vtkIndirectReport.h"
#include "Frame/vtkIndirectStageTimer.h"
#include "Gather/vtkIndirectGlossyGather.h"
#include "Gather/vtkIndirectLobeGather.h"
#include "LightMaps/vtkIndirectLightMap.h"
#include "OpenGL/vtkIndirectFullScreenProgram.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "VirtualLights/vtkIndirectAllTexelsSampler.h"
#include "VirtualLights/vtkIndirectVirtualLights.h"
#include "Visibility/vtkIndirectVisibility.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkRSMGatherPass);

namespace
{
const vtkIndirectChannel CoarseChannels[] = {
  { "gather.coarse", "vtkiCoarse", "irradiance at every InterpolationStep-th pixel", GL_RGBA32F,
    "-", "VTK irradiance" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};

const char* const LightsFile = "vtkIndirectGatherVirtualLights.glsl";
const char* const NeighborhoodFile = "vtkIndirectGatherNeighborhood.glsl";

// Rows of 256 lights in one draw: long draws stall a desktop, and some drivers end them.
constexpr int RowsPerDraw = 16;
// What interpolation may change of lobes, over their light.
constexpr double LobeTolerance = 0.05;
}

//------------------------------------------------------------------------------
struct vtkRSMGatherPass::Internals
{
  vtkIndirectTarget Coarse{ CoarseChannels, false };
  vtkIndirectFullScreenProgram Gather[2] = { { "vtkIndirectGatherFS.glsl", LightsFile },
    { "vtkIndirectGatherFS.glsl", NeighborhoodFile } };
  vtkIndirectFullScreenProgram Upsample[2] = { { "vtkIndirectUpsampleFS.glsl", LightsFile },
    { "vtkIndirectUpsampleFS.glsl", NeighborhoodFile } };
  vtkIndirectGlossyGather Glossy;
  vtkIndirectLobeGather Lobes;
  const std::shared_ptr<vtkIndirectAllTexelsSampler> AllTexels =
    std::make_shared<vtkIndirectAllTexelsSampler>();
  std::string WhatDiskLeaves; // of the last frame; empty where a disk leaves nothing

  void SetUniforms(
    vtkShaderProgram* program, const Input& input, const vtkRSMGatherPass* self, bool neighborhood);
};

//------------------------------------------------------------------------------
void vtkRSMGatherPass::Internals::SetUniforms(
  vtkShaderProgram* program, const Input& input, const vtkRSMGatherPass* self, bool neighborhood)
{
  vtkIndirectSetEyeUniforms(program, input.Frame);
  program->SetUniform2i("vtkiSize", input.Frame.Size);
  input.Geometry.GetTarget().Activate(vtkIndirectGeometryBuffer::Surface, program);
  input.Visibility.Activate(input.Frame.Window, program);
  if (neighborhood)
  {
    input.Maps.Activate(program);
    program->SetUniformi("vtkiSampleCount", self->Settings.NumberOfSamples);
    program->SetUniformf("vtkiRadius", static_cast<float>(self->Settings.NeighborhoodRadius));
    program->SetUniformi("vtkiLayerCount", input.Maps.GetNumberOfLayers());
    return;
  }
  input.Lights->Activate(program);
}

//------------------------------------------------------------------------------
vtkRSMGatherPass::vtkRSMGatherPass()
  : Internal(new Internals)
{
}

vtkRSMGatherPass::~vtkRSMGatherPass() = default;

//------------------------------------------------------------------------------
void vtkRSMGatherPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  static const char* const names[] = { "AllTexels", "VirtualLights", "Neighborhood" };
  os << indent << "Mode: " << names[this->Settings.Mode] << "\n";
  os << indent << "NumberOfSamples: " << this->Settings.NumberOfSamples << "\n";
  os << indent << "NeighborhoodRadius: " << this->Settings.NeighborhoodRadius << "\n";
  os << indent << "Interpolation: " << (this->Settings.Interpolation ? "On" : "Off") << "\n";
  os << indent << "InterpolationStep: " << this->Settings.InterpolationStep << "\n";
}

//------------------------------------------------------------------------------
size_t vtkRSMGatherPass::GetBytes() const
{
  return this->Superclass::GetBytes() + this->Internal->Coarse.GetBytes() +
    this->Internal->Lobes.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRSMGatherPass::AddToReport(vtkIndirectReport& report) const
{
  this->Superclass::AddToReport(report);
  if (!this->Internal->WhatDiskLeaves.empty())
  {
    report.LeftOut.emplace_back(
      "senders outside the disk about a receiver's place in a map", this->Internal->WhatDiskLeaves);
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<vtkIndirectSampler> vtkRSMGatherPass::ChooseSampler(
  const std::shared_ptr<vtkIndirectSampler>& users, const vtkIndirectPlan&)
{
  switch (this->Settings.Mode)
  {
    case ALL_TEXELS:
      return this->Internal->AllTexels;
    case NEIGHBORHOOD:
      return nullptr;
    default:
      return users;
  }
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkRSMGatherPass::Estimate(const Input& input)
{
  return this->Sum(input) ? this->MakeResult() : vtkIndirectEstimate();
}

//------------------------------------------------------------------------------
bool vtkRSMGatherPass::Sum(const Input& input)
{
  Internals& in = *this->Internal;
  vtkIndirectStageTimer& timer = input.Timer;
  const vtkIndirectFrame& frame = input.Frame;
  const bool neighborhood = input.Lights == nullptr;
  // The frame's sampler counts its own bytes; this one is no other's.
  if (this->Settings.Mode != ALL_TEXELS)
  {
    in.AllTexels->Release(frame.Window);
  }
  if (neighborhood && input.Plan.Senders == vtkIndirectPlan::EYE)
  {
    vtkErrorMacro("Mode NEIGHBORHOOD needs a light with a map of its own; a single headlight has "
                  "none. Use VIRTUAL_LIGHTS.");
    return false;
  }
  bool cubes = false;
  for (int i = 0; neighborhood && i < input.Maps.GetNumberOfMaps(); ++i)
  {
    cubes = cubes || input.Maps.GetMap(i).Projection == vtkIndirectKernels::VTKI_MAP_FACES;
  }
  in.WhatDiskLeaves = neighborhood && (cubes || this->Settings.NeighborhoodRadius < 1.5)
    ? "NeighborhoodRadius is " + vtkIndirectReport::Number(this->Settings.NeighborhoodRadius) +
      "; the result is too dark"
    : "";
  const bool walks = input.Visibility.WalksSegments();
  const int rows = neighborhood ? 1 : input.Lights->GetNumberOfRows();
  const int segments = input.Visibility.GetMaximumNumberOfSegments();
  const int rowsOfSegments = segments / vtkIndirectSampler::RowLength;
  const int rowsPerDraw = walks ? rowsOfSegments : RowsPerDraw;
  if (walks && neighborhood &&
    this->Settings.NumberOfSamples * input.Maps.GetNumberOfLayers() > segments)
  {
    vtkErrorMacro("Mode NEIGHBORHOOD with Occupancy takes at most "
      << segments << " samples over all maps; lower NumberOfSamples.");
    return false;
  }
  // Pixels that interpolation leaves are summed in one go, so more rows are taken everywhere.
  const bool interpolate = this->Settings.Interpolation && this->Settings.Mode != ALL_TEXELS &&
    rows * vtkIndirectSampler::RowLength <= input.Visibility.GetMaximumNumberOfSenders();
  const int step = interpolate ? this->Settings.InterpolationStep : 1;
  const int coarse[2] = { (frame.Size[0] + 2 * step - 2) / step,
    (frame.Size[1] + 2 * step - 2) / step };
  if (!this->Irradiance->Resize(frame.Window, frame.Size[0], frame.Size[1]) ||
    !this->ResizeGlossy(input) ||
    (interpolate && !in.Coarse.Resize(frame.Window, coarse[0], coarse[1])))
  {
    return false;
  }
  if (!interpolate)
  {
    in.Coarse.Release(frame.Window);
  }

  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunc(state);
  vtkIndirectFullScreenState kernelState(frame.Window);

  auto releaseTextures = [&]()
  {
    input.Geometry.GetTarget().Deactivate();
    input.Visibility.Deactivate();
    if (neighborhood)
    {
      input.Maps.Deactivate();
    }
    else
    {
      input.Lights->Deactivate();
    }
  };

  const std::string definitions = std::string(input.Visibility.GetDefinitions()) +
    (neighborhood ? "" : input.Lights->GetDefinitions());
  in.Gather[neighborhood].SetDefinitions(definitions);
  in.Upsample[neighborhood].SetDefinitions(definitions);

  // The sum at coarse samples, or at every pixel.
  timer.Begin(vtkIndirectStageTimer::Estimate);
  vtkIndirectTarget& sums = interpolate ? in.Coarse : *this->Irradiance;
  vtkShaderProgram* program = in.Gather[neighborhood].Use(frame.Window, sums, rows > rowsPerDraw);
  if (!program)
  {
    return false;
  }
  sums.Begin();
  if (rows > rowsPerDraw)
  {
    sums.Clear();
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFunc(GL_ONE, GL_ONE);
  }
  in.SetUniforms(program, input, this, neighborhood);
  program->SetUniformi("vtkiStep", step);
  for (int row = 0; row < rows; row += rowsPerDraw)
  {
    if (!neighborhood)
    {
      const int block[2] = { row, std::min(row + rowsPerDraw, rows) };
      program->SetUniform2i("vtkiLightRows", block);
    }
    in.Gather[neighborhood].Draw();
    if (rows > rowsPerDraw)
    {
      glFlush();
    }
  }
  state->vtkglDisable(GL_BLEND);
  sums.End();
  releaseTextures();
  if (this->HasGlossy &&
    !in.Glossy.Sum(input, *this->Glossy, 1.0,
      { this->Settings.NumberOfSamples, this->Settings.NeighborhoodRadius }))
  {
    return false;
  }
  timer.End(vtkIndirectStageTimer::Estimate);
  auto addLobes = [&]()
  {
    timer.Begin(vtkIndirectStageTimer::Upsample);
    const bool added = in.Lobes.Add(input,
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
  program = in.Upsample[neighborhood].Use(frame.Window, *this->Irradiance);
  if (!program)
  {
    return false;
  }
  this->Irradiance->Begin();
  in.SetUniforms(program, input, this, neighborhood);
  in.Coarse.Activate(0, program);
  program->SetUniformi("vtkiStep", step);
  program->SetUniform2i("vtkiCoarseSize", coarse);
  if (!neighborhood)
  {
    const int all[2] = { 0, rows };
    program->SetUniform2i("vtkiLightRows", all);
  }
  in.Upsample[neighborhood].Draw();
  in.Coarse.Deactivate();
  this->Irradiance->End();
  releaseTextures();
  timer.End(vtkIndirectStageTimer::Upsample);
  return addLobes();
}

//------------------------------------------------------------------------------
void vtkRSMGatherPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!this->CanBeOf(window))
  {
    return;
  }
  this->Superclass::ReleaseGraphicsResources(window);
  Internals& in = *this->Internal;
  in.Coarse.Release(window);
  in.Glossy.Release();
  in.Lobes.Release(window);
  in.AllTexels->Release(window);
  for (int i = 0; i < 2; ++i)
  {
    in.Gather[i].Release();
    in.Upsample[i].Release();
  }
}
