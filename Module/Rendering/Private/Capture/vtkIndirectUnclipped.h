// SPDX-License-Identifier: BSD-3-Clause
// Draws props that catch light beyond the near and the far plane, too: cameras fit these planes to
// the rest of the scene.
#pragma once

#include "OpenGL/vtkIndirectGL.h" // for OpenGL

class vtkIndirectUnclipped
{
public:
  /**
   * Sets OpenGL's state, unless it is set: without clipping by these planes depths are clamped, and
   * the greatest depth is below that of the background.
   */
  void Set(bool unclipped)
  {
    if (unclipped == this->Unclipped)
    {
      return;
    }
    constexpr double most = 1.0 - 1.0 / (1 << 22);
    this->Unclipped = unclipped;
    // VTK's state tracks neither, and assumes the defaults.
    glDepthRange(0.0, unclipped ? most : 1.0);
    if (unclipped)
    {
      glEnable(GL_DEPTH_CLAMP);
    }
    else
    {
      glDisable(GL_DEPTH_CLAMP);
    }
  }

private:
  bool Unclipped = false;
};
