// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Capture/vtkIndirectGeometryChannels.h"

#include "vtkOpenGLState.h"

//------------------------------------------------------------------------------
void vtkIndirectGeometryChannels::DisableBlending(vtkOpenGLState* state, int channels)
{
  if (IsAlbedoInLit(channels))
  {
    state->vtkglDisable(GL_BLEND);
    return;
  }
  // VTK's state has one switch for all draw buffers, which it compares with the first.
  for (int i = Surface; i < channels; ++i)
  {
    glDisablei(GL_BLEND, static_cast<unsigned int>(i));
  }
}
