// SPDX-License-Identifier: BSD-3-Clause
// Places that the eye sees, at the pixels of a small depth map of its view. A scene that reaches
// far beyond the picture has such places (vtkIndirectSeen); any other scene needs none, because the
// picture shows all that maps show.
#pragma once

#include "Maps/vtkIndirectDepthMaps.h" // for the view's map
#include "OpenGL/vtkIndirectKey.h"     // for a key
#include "Scene/vtkIndirectSeen.h"     // for boxes

#include <cstddef> // for size_t
#include <vector>  // for depths

class vtkSurfaceCapturePass;
struct vtkIndirectFrame;

class vtkIndirectViewSamples
{
public:
  explicit vtkIndirectViewSamples(vtkIndirectDepthMaps& maps);

  /**
   * Finds the frame's places and the boxes around these. A moving frame has the boxes of the last
   * still one while they hold what the eye sees, since other boxes need other maps: a camera that
   * comes nearer would lose all of them. The capture stays attached. Returns false, after an error,
   * when OpenGL refuses.
   */
  bool Update(vtkIndirectFrame& frame, bool moving, vtkSurfaceCapturePass* capture);

  /** Returns the eye's view as a depth tile. */
  static vtkIndirectDepthTile FindView(const vtkIndirectFrame& frame);
  /** Returns true if the casters reach far beyond the picture. */
  static bool ReachesBeyond(const vtkIndirectFrame& frame, const vtkIndirectDepthTile& view);

private:
  bool FollowsStillFrame(const vtkIndirectFrame& frame, bool moving);
  bool HoldsMost(const std::vector<vtkIndirectSeen::Place>& places) const;

  vtkIndirectDepthMaps& DepthMaps;
  std::vector<float> Depths; // of the last map, 1: nothing is there
  size_t Drawn = 0;          // number of maps drawn by then
  vtkIndirectKey Units;      // of the boxes
  vtkIndirectSeenBox Box;    // of the last frame
  vtkIndirectSeenBox Near;
  bool AreOfStillFrame = false; // the boxes
};
