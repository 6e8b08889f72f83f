// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Splatting/vtkIndirectFarField.h"

#include "Frame/vtkIndirectFrame.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "Splatting/vtkIndirectSplatTable.h"
#include "VirtualLights/vtkIndirectVirtualLights.h"
#include "Visibility/vtkIndirectVisibility.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{
const vtkIndirectChannels CoarseChannels = {
  { "splats.far", "vtkiCoarse", "irradiance that splats cut off, luminance of all of it",
    GL_RGBA32F, "-", "VTK irradiance" },
  { "splats.vector", "vtkiCoarseVector", "luminance of the vector irradiance that splats cut off",
    GL_RGBA32F, "scene", "VTK irradiance" },
};

std::string GetDefinitions(
  const vtkIndirectEstimateInput& input, const vtkIndirectSplatTable& table, int step)
{
  const vtkIndirectVisibility& visibility = input.Visibility;
  const bool many = input.Lights->GetNumberOfLights() > visibility.GetMaximumNumberOfSenders();
  // Pixels without a nearby sample of their orientation are summed anew, or, with too many lights
  // for one draw, get no far field.
  return visibility.GetDefinitions() + input.Lights->GetDefinitions() +
    table.GetDefinitions(input.Lights->HasLobes()) + vtkIndirectReceiverGrid::DefineStep(step) +
    (many ? "#define VTKI_SPLAT_MANY\n" : "");
}
}

//------------------------------------------------------------------------------
vtkIndirectFarField::vtkIndirectFarField(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Coarse(this, CoarseChannels)
{
}

//------------------------------------------------------------------------------
bool vtkIndirectFarField::Sum(
  const vtkIndirectEstimateInput& input, const vtkIndirectSplatTable& table, int step)
{
  const vtkIndirectFrame& frame = input.Frame;
  this->ShareIsKnown = false;
  if (!this->Coarse.Resize(frame, step))
  {
    return false;
  }
  const int rows = input.Lights->GetNumberOfRows();
  const int rowsPerDraw =
    input.Visibility.GetMaximumNumberOfSenders() / vtkIndirectSampler::RowLength;
  const bool adds = rows > rowsPerDraw;
  this->SumCoarse.SetDefinitions(GetDefinitions(input, table, step));
  vtkIndirectProgram program = this->SumCoarse.Use(frame.Window);
  if (!program)
  {
    return false;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunc(state);
  this->Coarse.Begin();
  if (adds)
  {
    this->Coarse.Clear();
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFunc(GL_ONE, GL_ONE);
  }
  table.Activate(input, program);
  for (int row = 0; row < rows; row += rowsPerDraw)
  {
    const int block[2] = { row, std::min(row + rowsPerDraw, rows) };
    program->SetUniform2i("vtkiLightRows", block);
    this->SumCoarse.Draw();
  }
  state->vtkglDisable(GL_BLEND);
  this->Coarse.End();
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectFarField::AddTo(const vtkIndirectEstimateInput& input,
  const vtkIndirectSplatTable& table, int step, vtkIndirectTarget& irradiance)
{
  const vtkIndirectFrame& frame = input.Frame;
  this->Interpolate.SetDefinitions(GetDefinitions(input, table, step));
  vtkIndirectProgram program = this->Interpolate.Use(frame.Window);
  if (!program)
  {
    return false;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunc(state);
  irradiance.Begin();
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFunc(GL_ONE, GL_ONE);
  table.Activate(input, program);
  this->Coarse.ActivateAll(program);
  this->Interpolate.Draw();
  state->vtkglDisable(GL_BLEND);
  irradiance.End();
  return true;
}

//------------------------------------------------------------------------------
double vtkIndirectFarField::FindShare() const
{
  if (!this->ShareIsKnown && this->Coarse.GetWidth() > 0)
  {
    const std::vector<float> values = this->Coarse.ReadBack(0);
    double cut = 0.0;
    double all = 0.0;
    for (size_t i = 0; i < values.size(); i += 4)
    {
      cut += vtkIndirectKernels::vtkiLuminance({ values[i], values[i + 1], values[i + 2] });
      all += values[i + 3];
    }
    this->Share = all > 0.0 ? cut / all : 0.0;
    this->ShareIsKnown = true;
  }
  return this->Share;
}
