// SPDX-License-Identifier: BSD-3-Clause
// Pixels from one receiver of proxies to the next, by the picture's size and the spheres' size in
// it. Hysteresis keeps the step near a limit, so that the light does not flicker with a camera that
// oscillates there, between both eyes of a picture, or with swinging spheres.
#pragma once

#include "Proxies/vtkIndirectProxySphere.h" // for spheres

#include <vector> // for spheres

struct vtkIndirectFrame;

class vtkIndirectProxyStep
{
public:
  /** This is the largest step, independent of spheres. */
  static constexpr int Most = 8;
  /** Hysteresis: share of the radius by which it may pass the last step's limit, either way. */
  static constexpr double Margin = 0.15;

  /** Returns the step of a frame for the visible spheres. */
  int Find(const vtkIndirectFrame& frame, const std::vector<vtkIndirectProxySphere>& spheres);
  /**
   * Returns the step for a radius in pixels, which may be infinite. Another size forgets the last
   * step.
   */
  int Find(const int size[2], double radius);
  /** Finds the next step without hysteresis. */
  void Forget() { this->Last = 0; }

private:
  int Size[2] = { 0, 0 };
  int Last = 0; // 0: none
};
