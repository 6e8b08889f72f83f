// SPDX-License-Identifier: BSD-3-Clause
// The channels of the geometry buffer, for what draws into it and what owns it.
#ifndef vtkIndirectGeometryChannels_h
#define vtkIndirectGeometryChannels_h

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

  /** Whether a buffer of so many channels has the albedo in its lit texels. */
  static bool IsAlbedoInLit(int channels) { return channels == Albedo; }

  /**
   * Keeps the channels that hold bits or powers from being blended: all but the lit image, and that
   * too where it holds the albedo. VTK may have switched blending for all of them since.
   */
  static void DisableBlending(vtkOpenGLState* state, int channels);
};

#endif
