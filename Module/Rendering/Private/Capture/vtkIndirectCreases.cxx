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
  const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry)
{
  if (this->AreFound)
  {
    return true;
  }
  if (!this->Target.Resize(frame.Window, frame.Size[0], frame.Size[1], &geometry.GetTarget()))
  {
    return false;
  }
  vtkIndirectFullScreenState kernelState(frame.Window);
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
    this->AreFound = this->Kernel.RunOnSurfaces(frame.Window, this->Target,
      [&](const vtkIndirectProgram& program) { geometry.ActivateReceivers(program, frame); });
  }
  return this->AreFound;
}

//------------------------------------------------------------------------------
void vtkIndirectCreases::ReleaseOwn(vtkWindow*)
{
  this->AreFound = false;
}
