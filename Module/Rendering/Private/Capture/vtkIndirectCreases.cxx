// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Capture/vtkIndirectCreases.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"

namespace
{
const vtkIndirectChannels CreaseChannels = {
  { "creases", "vtkiCreases",
    "the other surface in a crease: octahedral normal, place along the normal, extent squared",
    GL_RGBA32F, "world", "scene units" },
};
}

//------------------------------------------------------------------------------
vtkIndirectCreases::vtkIndirectCreases(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Target(this, CreaseChannels, false)
{
}

//------------------------------------------------------------------------------
bool vtkIndirectCreases::Update(
  const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry, int step)
{
  if (this->AreFound && this->Step <= step)
  {
    return true;
  }
  this->Step = step;
  const int size[2] = { (frame.Size[0] + step - 1) / step, (frame.Size[1] + step - 1) / step };
  if (!this->Target.Resize(
        frame.Window, size[0], size[1], step == 1 ? &geometry.GetTarget() : nullptr))
  {
    return false;
  }
  vtkIndirectFullScreenState kernelState(frame.Window);
  const auto set = [&](const vtkIndirectProgram& program)
  {
    geometry.ActivateReceivers(program, frame);
    program->SetUniformi("vtkiCreaseStep", step);
  };
  // The picture does not tell which receivers cast no shadows.
  if (frame.NumberOfOtherReceivers > 0)
  {
    this->Target.Begin();
    this->Target.Clear();
    this->Target.End();
    this->AreFound = true;
  }
  else
  {
    this->AreFound = step == 1 ? this->Kernel.RunOnSurfaces(frame.Window, this->Target, set)
                               : this->Kernel.Run(frame.Window, this->Target, set);
  }
  return this->AreFound;
}

//------------------------------------------------------------------------------
void vtkIndirectCreases::Activate(const vtkIndirectProgram& program) const
{
  this->Target.Activate(0, program);
  program->SetUniformi("vtkiCreaseStep", this->Step);
}

//------------------------------------------------------------------------------
void vtkIndirectCreases::ReleaseOwn(vtkWindow*)
{
  this->AreFound = false;
}
