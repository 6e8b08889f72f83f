// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectGL.h"

#include "vtkIndirectGlossyGather.h"

#include "vtkGeometryBufferPass.h"
#include "vtkIndirectClearance.h"
#include "vtkIndirectOccupancyVolume.h"
#include "vtkIndirectTarget.h"
#include "vtkIndirectUniforms.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkVirtualLightSampler.h"

#include <algorithm>

namespace
{
// Rows of 256 lights in one draw: long draws stall a desktop, and some drivers end them.
constexpr int RowsPerDraw = 16;
}

//------------------------------------------------------------------------------
bool vtkIndirectGlossyGather::Sum(const vtkIndirectEstimatorPass::Input& input,
  vtkIndirectTarget& glossy, double unit, vtkIndirectOccupancyVolume* voxels,
  const Neighborhood& neighborhood)
{
  const vtkIndirectFrame& frame = input.Frame;
  vtkIndirectKernelProgram& kernel = input.Sampler ? this->Lights : this->Around;
  kernel.SetDefinitions(voxels ? "#define VTKI_OCCUPANCY\n" : "");
  const int rowsPerDraw = voxels
    ? vtkIndirectEstimatorPass::MaximumNumberOfSegments / vtkVirtualLightSampler::RowLength
    : RowsPerDraw;
  const int count = input.Sampler ? input.Sampler->GetActualNumberOfLights() : 1;
  const int rows =
    (count + vtkVirtualLightSampler::RowLength - 1) / vtkVirtualLightSampler::RowLength;
  vtkShaderProgram* program = kernel.Use(frame.Window, glossy, rows > rowsPerDraw);
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
  geometry.Activate(vtkGeometryBufferPass::Surface, program);
  geometry.Activate(vtkGeometryBufferPass::Specular, program);
  if (voxels)
  {
    voxels->GetClearance().Activate(frame.Window, program);
  }
  if (input.Sampler)
  {
    for (int i = 0; i < 3; ++i)
    {
      input.Sampler->GetTarget().Activate(i, program);
    }
    program->SetUniformi("vtkiRowLength", vtkVirtualLightSampler::RowLength);
    program->SetUniformi("vtkiLightCount", count);
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
    if (input.Sampler)
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
  geometry.Deactivate();
  if (voxels)
  {
    voxels->GetClearance().Deactivate();
  }
  if (input.Sampler)
  {
    input.Sampler->GetTarget().Deactivate();
  }
  else
  {
    input.Maps.Deactivate();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectGlossyGather::Release()
{
  this->Lights.Release();
  this->Around.Release();
}
