// SPDX-License-Identifier: BSD-3-Clause
// Texels of maps that send light, read back from OpenGL.
#pragma once

#include "Senders/vtkIndirectAllTexelsSampler.h" // for members
#include "Senders/vtkIndirectSenderClusters.h"   // for senders

#include <vector> // for lists

class vtkIndirectSenderTexels
{
public:
  vtkIndirectSenderTexels() { this->Texels.SetWindows(true); }

  /**
   * Sets the largest number of texels: with more texels, one represents 2 x 2, 4 x 4, ... of them.
   */
  void SetMostTexels(size_t count) { this->Texels.SetMostLights(count); }

  /**
   * Reads the texels that send light, each once for a map, with the light of the maps' lights; and
   * the places of all surfaces that the maps see. Returns false, after an error, when OpenGL
   * refuses. Holds no resources afterwards.
   */
  bool Read(const vtkIndirectSampler::Input& input,
    std::vector<vtkIndirectSenderClusters::Sender>& senders, std::vector<glm::vec3>& places);

  /**
   * Leaves out the senders that no surface can face: those on the outside of the convex hull of all
   * places, such as the underside of a ground.
   */
  static void RemoveOutermost(
    std::vector<vtkIndirectSenderClusters::Sender>& senders, const std::vector<glm::vec3>& places);

  /** Converts the lights to rows of a sampler's table. */
  static std::vector<vtkIndirectSampler::Row> MakeRows(
    const std::vector<vtkIndirectSenderClusters::Light>& lights);

  void Release(vtkWindow* window) { this->Texels.Release(window); }

private:
  vtkIndirectAllTexelsSampler Texels;
};
