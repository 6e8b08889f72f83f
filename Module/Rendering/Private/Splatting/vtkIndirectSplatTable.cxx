// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Splatting/vtkIndirectSplatTable.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"
#include "Senders/vtkIndirectVirtualLights.h"
#include "Visibility/vtkIndirectVisibility.h"

#include <string>

namespace
{
const vtkIndirectChannels ColumnsChannels = {
  { "splats.columns", "vtkiSplatColumns", "sum of intensities, number of lights", GL_RG32F, "-",
    "VTK radiance times scene units squared over pi, 1" },
};
const vtkIndirectChannels MeanChannels = {
  { "splats.mean", "vtkiSplatMean", "mean intensity, number of lights", GL_RG32F, "-",
    "VTK radiance times scene units squared over pi, 1" },
};
constexpr int ChannelsOfLobes = 2; // the last channels of the table
const vtkIndirectChannels BoundsChannels = {
  { "splats.center", "vtkiSplatCenter", "centre, half length", GL_RGBA32F, "scene", "scene units" },
  { "splats.axis", "vtkiSplatAxis", "axis, half width", GL_RGBA32F, "scene", "1, scene units" },
  { "splats.lobecenter", "vtkiLobeSplatCenter", "centre, half length of the lobe's", GL_RGBA32F,
    "scene", "scene units" },
  { "splats.lobeaxis", "vtkiLobeSplatAxis", "axis, half width of the lobe's", GL_RGBA32F, "scene",
    "1, scene units" },
};
}

//------------------------------------------------------------------------------
vtkIndirectSplatTable::vtkIndirectSplatTable(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Columns(this, ColumnsChannels, false)
  , Mean(this, MeanChannels, false)
  , Bounds(this, BoundsChannels, false)
{
}

//------------------------------------------------------------------------------
bool vtkIndirectSplatTable::Update(
  const vtkIndirectEstimateInput& input, double threshold, bool fades)
{
  const vtkIndirectVirtualLights& lights = *input.Lights;
  const bool lobes = lights.HasLobes();
  if (this->Bounds.GetWidth() > 0 && this->ContentTime == lights.GetContentTime() &&
    this->NumberOfLights == lights.GetNumberOfLights() && this->Threshold == threshold &&
    this->Fades == fades && this->Lobes == lobes)
  {
    return true;
  }
  this->NumberOfLights = -1;
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  this->Threshold = threshold;
  this->Fades = fades;
  if (this->Lobes != lobes)
  {
    this->Bounds.Release(window);
    this->Lobes = lobes;
  }
  this->Bounds.SetNumberOfChannels(lobes ? 2 + ChannelsOfLobes : 2);
  if (!this->Columns.Resize(window, vtkIndirectSampler::RowLength, 1) ||
    !this->Mean.Resize(window, 1, 1) ||
    !this->Bounds.Resize(window, vtkIndirectSampler::RowLength, lights.GetNumberOfRows()) ||
    !this->Draw(input))
  {
    return false;
  }
  this->ContentTime = lights.GetContentTime();
  this->NumberOfLights = lights.GetNumberOfLights();
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectSplatTable::Draw(const vtkIndirectEstimateInput& input)
{
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  const vtkIndirectVirtualLights& lights = *input.Lights;
  const std::string definitions = lights.GetDefinitions() + this->GetDefinitions(this->Lobes);
  this->SumColumns.SetDefinitions(definitions);
  this->SumAll.SetDefinitions(definitions + "#define VTKI_SPLAT_COLUMNS\n");
  this->MakeBounds.SetDefinitions(definitions);

  auto activate = [&](const vtkIndirectProgram& program)
  {
    lights.Activate(program);
    lights.ActivateLobes(program);
  };
  return this->SumColumns.Run(window, this->Columns, activate) &&
    this->SumAll.Run(window, this->Mean,
      [&](const vtkIndirectProgram& program) { this->Columns.Activate(0, program); }) &&
    this->MakeBounds.Run(window, this->Bounds,
      [&](const vtkIndirectProgram& program)
      {
        activate(program);
        this->Activate(program);
      });
}

//------------------------------------------------------------------------------
std::string vtkIndirectSplatTable::GetDefinitions(bool lobes) const
{
  return std::string(this->Fades ? "#define VTKI_SPLAT_FADES\n" : "") +
    (lobes ? "#define VTKI_SPLAT_LOBES\n" : "");
}

//------------------------------------------------------------------------------
void vtkIndirectSplatTable::Activate(const vtkIndirectProgram& program) const
{
  const double length = vtkIndirectKernels::VTKI_SPLAT_LENGTH;
  program->SetUniformf(
    "vtkiSplatThreshold", static_cast<float>(this->Threshold / (length * length)));
  this->Mean.Activate(0, program);
  for (int channel = 0; channel < this->Bounds.GetNumberOfChannels(); ++channel)
  {
    if (program->IsUniformUsed(BoundsChannels[channel].Uniform))
    {
      this->Bounds.Activate(channel, program);
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectSplatTable::Activate(
  const vtkIndirectEstimateInput& input, const vtkIndirectProgram& program) const
{
  input.Geometry.ActivateReceivers(program, input.Frame);
  input.Visibility.Activate(input.Frame.Window, program, input.Creases);
  input.Lights->Activate(program);
  input.Lights->ActivateLobes(program);
  this->Activate(program);
}
