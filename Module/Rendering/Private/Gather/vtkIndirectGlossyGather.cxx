// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Gather/vtkIndirectGlossyGather.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Maps/vtkIndirectLightMaps.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Senders/vtkIndirectSampler.h"
#include "Senders/vtkIndirectVirtualLights.h"
#include "Visibility/vtkIndirectVisibility.h"

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
  return kernel.RunRows(frame.Window, glossy, rows, rowsPerDraw,
    [&](const vtkIndirectProgram& program)
    {
      input.Geometry.ActivateReceivers(program, frame);
      program->SetUniformf("vtkiStorageScale", static_cast<float>(1.0 / unit));
      input.Geometry.GetTarget().Activate(vtkIndirectGeometryBuffer::Specular, program);
      visibility.Activate(frame.Window, program, input.Creases);
      if (input.Lights)
      {
        input.Lights->Activate(program);
        return;
      }
      input.Maps.Activate(program);
      program->SetUniformi("vtkiSampleCount", neighborhood.NumberOfSamples);
      program->SetUniformf("vtkiRadius", static_cast<float>(neighborhood.Radius));
      program->SetUniformi("vtkiLayerCount", input.Maps.GetNumberOfLayers());
    });
}
