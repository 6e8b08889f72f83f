// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Sums/vtkIndirectReceiverGrid.h"

#include "Scene/vtkIndirectFrame.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
bool vtkIndirectReceiverGrid::Resize(const vtkIndirectFrame& frame, int step)
{
  this->Step = step;
  return this->vtkIndirectTarget::Resize(
    frame.Window, Count(frame.Size[0], step), Count(frame.Size[1], step));
}

//------------------------------------------------------------------------------
void vtkIndirectReceiverGrid::SetUniforms(const vtkIndirectProgram& program) const
{
  const int size[2] = { this->GetWidth(), this->GetHeight() };
  program->SetUniformi("vtkiStep", this->Step);
  program->SetUniform2i("vtkiCoarseSize", size);
}

//------------------------------------------------------------------------------
void vtkIndirectReceiverGrid::ActivateAll(const vtkIndirectProgram& program) const
{
  for (int channel = 0; channel < this->GetNumberOfChannels(); ++channel)
  {
    this->Activate(channel, program);
  }
  this->SetUniforms(program);
}
