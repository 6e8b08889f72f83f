// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Splatting/vtkIndirectFarField.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"
#include "Senders/vtkIndirectVirtualLights.h"
#include "Splatting/vtkIndirectSplatTable.h"
#include "Visibility/vtkIndirectVisibility.h"

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
  this->SumCoarse.SetDefinitions(GetDefinitions(input, table, step));
  return this->SumCoarse.RunRows(frame.Window, this->Coarse, rows, rowsPerDraw,
    [&](const vtkIndirectProgram& program) { table.Activate(input, program); });
}

//------------------------------------------------------------------------------
bool vtkIndirectFarField::AddTo(const vtkIndirectEstimateInput& input,
  const vtkIndirectSplatTable& table, int step, vtkIndirectTarget& irradiance)
{
  const vtkIndirectFrame& frame = input.Frame;
  this->Interpolate.SetDefinitions(GetDefinitions(input, table, step));
  const vtkIndirectAddition addition(frame.Window);
  return this->Interpolate.Run(frame.Window, irradiance,
    [&](const vtkIndirectProgram& program)
    {
      table.Activate(input, program);
      this->Coarse.ActivateAll(program);
    });
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
