// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Senders/vtkIndirectHeadlightSampler.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"

//------------------------------------------------------------------------------
bool vtkIndirectHeadlightSampler::Update(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  vtkIndirectMapSampler::Source view;
  view.Size[0] = frame.Size[0];
  view.Size[1] = frame.Size[1];
  this->Texture.Update(frame.Window, *this->Pattern, { view });
  vtkIndirectFullScreenState fullScreen(frame.Window);
  if (!this->Resize(frame.Window, this->Texture.GetNumberOfSamples()))
  {
    return false;
  }
  vtkIndirectTarget& table = this->BeginChange();
  this->Program.SetDefinitions(input.Geometry.GetAlbedoDefinitions());
  const vtkIndirectLight& light = frame.Lights.front();
  return this->Program.Run(frame.Window, table,
    [&](const vtkIndirectProgram& program)
    {
      this->Texture.Activate(program);
      input.Geometry.ActivateAlbedo(program);
      input.Geometry.ActivateReceivers(program, frame);
      vtkIndirectSetUniform(program, "vtkiLightColor", glm::vec3(light.Color));
      vtkIndirectSetUniform(program, "vtkiToLight",
        glm::vec3(-glm::normalize(glm::dmat3(frame.WorldToView) * light.DirectionWC)));
      program->SetUniformi("vtkiParallel", frame.Parallel ? 1 : 0);
    });
}
