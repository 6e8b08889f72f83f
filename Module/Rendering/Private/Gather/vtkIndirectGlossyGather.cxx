// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Gather/vtkIndirectGlossyGather.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Frame/vtkIndirectEyeUniforms.h"
#include "LightMaps/vtkIndirectLightMaps.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "VirtualLights/vtkIndirectSampler.h"
#include "VirtualLights/vtkIndirectVirtualLights.h"
#include "Visibility/vtkIndirectVisibility.h"

#include <algorithm>

namespace
{
// Rows of 256 lights in one draw: long draws stall a desktop, and some drivers abort them.
constexpr int RowsPerDraw = 16;
}

//------------------------------------------------------------------------------
bool vtkIndirectGlossyGather::Sum(const vtkIndirectEstimateInput& input, vtkIndirectTarget& glossy,
  double unit, const Neighborhood& neighborhood)
{
  const vtkIndirectFrame& frame = input.Frame;
  const vtkIndirectVisibility& visibility = input.Visibility;
  vtkIndirectFullScreenProgram& kernel = input.Lights ? this->Lights : this->Neighbors;
  kernel.SetDefinitions(std::string(visibility.GetDefinitions()) +
    (input.Lights ? input.Lights->GetDefinitions() : ""));
  const int rowsPerDraw = visibility.WalksSegments()
    ? visibility.GetMaximumNumberOfSegments() / vtkIndirectSampler::RowLength
    : RowsPerDraw;
  const int rows = input.Lights ? input.Lights->GetNumberOfRows() : 1;
  vtkIndirectProgram program = kernel.Use(frame.Window);
  if (!program)
  {
    return false;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunc(state);
  vtkIndirectSetEyeUniforms(program, frame);
  program->SetUniform2i("vtkiSize", frame.Size);
  program->SetUniformf("vtkiStorageScale", static_cast<float>(1.0 / unit));
  const vtkIndirectTarget& geometry = input.Geometry.GetTarget();
  geometry.Activate(vtkIndirectGeometryBuffer::Surface, program);
  geometry.Activate(vtkIndirectGeometryBuffer::Specular, program);
  visibility.Activate(frame.Window, program);
  if (input.Lights)
  {
    input.Lights->Activate(program);
  }
  else
  {
    input.Maps.Activate(program);
    program->SetUniformi("vtkiSampleCount", neighborhood.NumberOfSamples);
    program->SetUniformf("vtkiRadius", static_cast<float>(neighborhood.Radius));
    program->SetUniformi("vtkiLayerCount", input.Maps.GetNumberOfLayers());
  }
  glossy.Begin();
  if (rows > rowsPerDraw)
  {
    glossy.Clear();
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFunc(GL_ONE, GL_ONE);
  }
  for (int row = 0; row < rows; row += rowsPerDraw)
  {
    if (input.Lights)
    {
      const int block[2] = { row, std::min(row + rowsPerDraw, rows) };
      program->SetUniform2i("vtkiLightRows", block);
    }
    kernel.Draw();
    if (rows > rowsPerDraw)
    {
      glFlush();
    }
  }
  state->vtkglDisable(GL_BLEND);
  glossy.End();
  return true;
}
