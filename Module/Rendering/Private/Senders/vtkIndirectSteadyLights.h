// SPDX-License-Identifier: BSD-3-Clause
// Lights of senders whose strengths change from frame to frame, as those of directions in the world
// do while lights turn with the camera. The clusters, the places and the shapes of the lights are
// those under equal strengths, so that depth maps of the lights are kept. Each light and branch
// keeps what it sends of a unit of each map (precomputed transfer: Sloan, Kautz, Snyder 2002,
// "Precomputed radiance transfer for real-time rendering in dynamic, low-frequency lighting
// environments"), and a frame sums these over the strengths.
#pragma once

#include "Senders/vtkIndirectSenderClusters.h" // for lights

#include <cstdint> // for numbers of maps

class vtkIndirectSteadyLights
{
public:
  /** Makes the lights of the clusters' senders, under `maps` maps; see MakeLights. */
  void Make(vtkIndirectSenderClusters& clusters, size_t maps, int count, bool divides,
    double nearness, int least, int narrow);
  /**
   * Returns the lights under these strengths, one for each map. error: see
   * vtkIndirectSenderClusters::MakeLights.
   */
  const vtkIndirectSenderClusters::LightTree& Relight(const vtkIndirectSenderClusters& clusters,
    const std::vector<glm::dvec3>& strengths, double error);

  size_t GetBytes() const;

private:
  using Light = vtkIndirectSenderClusters::Light;
  struct Transfer
  {
    uint32_t Map;
    glm::vec3 DensityArea; // of a strength of one
  };
  using Transfers = std::vector<std::vector<Transfer>>; // of each light

  static Transfers FindTransfers(
    const vtkIndirectSenderClusters& clusters, size_t maps, const std::vector<Light>& lights);
  static void SetDensities(const Transfers& transfers, const std::vector<glm::dvec3>& strengths,
    std::vector<Light>& lights);
  static void SetChildDistances(double limit, std::vector<Light>& lights);

  vtkIndirectSenderClusters::LightTree Tree;
  Transfers OfLights;
  Transfers OfBranches;
};
