// SPDX-License-Identifier: BSD-3-Clause
// Texels of maps that send light, read back from OpenGL.
#ifndef vtkIndirectSenderTexels_h
#define vtkIndirectSenderTexels_h

#include "VirtualLights/vtkIndirectAllTexelsSampler.h" // for members
#include "VirtualLights/vtkIndirectSenderClusters.h"   // for senders

#include <vector> // for lists

class vtkIndirectSenderTexels
{
public:
  /** Texels at most: of more, one of 2 x 2, 4 x 4, ... stands for these. */
  void SetMostTexels(size_t count) { this->Texels.SetMostLights(count); }

  /**
   * Those that send light, each once a map, with their light as the maps' lights have it; and the
   * places of all that the maps see. Returns false, after an error, when OpenGL refuses. Nothing is
   * held afterwards.
   */
  bool Read(const vtkIndirectSampler::Input& input,
    std::vector<vtkIndirectSenderClusters::Sender>& senders, std::vector<glm::vec3>& places);

  /** The lights as rows of a sampler's table. */
  static std::vector<vtkIndirectSampler::Row> MakeRows(
    const std::vector<vtkIndirectSenderClusters::Light>& lights);

  void Release(vtkWindow* window) { this->Texels.Release(window); }

private:
  vtkIndirectAllTexelsSampler Texels;
};

#endif
