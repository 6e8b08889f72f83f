// SPDX-License-Identifier: BSD-3-Clause
// The channels of the geometry buffer, shared by its owner and the pass that draws into it.
#pragma once

class vtkOpenGLState;

struct vtkIndirectGeometryChannels
{
  enum Channel
  {
    Lit,
    Surface,
    Albedo,
    Specular
  };

  /** Returns true if a buffer with this number of channels has the albedo in its lit texels. */
  static bool IsAlbedoInLit(int channels) { return channels == Albedo; }

  /**
   * Disables blending of the channels that hold bits or powers: all but the lit image, and that one
   * too if it holds the albedo. VTK may have enabled blending for all of them since.
   */
  static void DisableBlending(vtkOpenGLState* state, int channels);
};
