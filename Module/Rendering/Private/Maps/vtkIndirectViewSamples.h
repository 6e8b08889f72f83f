// SPDX-License-Identifier: BSD-3-Clause
// Places that the eye sees, at the pixels of a small depth map of its view. A scene that reaches
// far beyond the picture has such places (vtkIndirectSeen); any other scene needs none, because the
// picture shows all that maps show.
#pragma once

#include "Maps/vtkIndirectDepthMaps.h" // for the view's map

#include <cstddef> // for size_t
#include <vector>  // for depths

class vtkSurfaceCapturePass;
struct vtkIndirectFrame;

class vtkIndirectViewSamples
{
public:
  explicit vtkIndirectViewSamples(vtkIndirectDepthMaps& maps);

  /**
   * Finds the frame's places. The capture stays attached. Returns false, after an error, when
   * OpenGL refuses.
   */
  bool Update(vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture);

  /** Returns the eye's view as a depth tile. */
  static vtkIndirectDepthTile FindView(const vtkIndirectFrame& frame);
  /** Returns true if the casters reach far beyond the picture. */
  static bool ReachesBeyond(const vtkIndirectFrame& frame, const vtkIndirectDepthTile& view);

private:
  vtkIndirectDepthMaps& DepthMaps;
  std::vector<float> Depths; // of the last map, 1: nothing is there
  size_t Drawn = 0;          // number of maps drawn by then
};
