// SPDX-License-Identifier: BSD-3-Clause
// Pixels from one receiver of proxies to the next, by the picture's size and by how large spheres
// are in it. The step of the last frame is kept near a limit, so that a camera that moves to and
// fro there, both eyes of a picture, or spheres that swing do not have the light flicker.
#ifndef vtkIndirectProxyStep_h
#define vtkIndirectProxyStep_h

#include "Proxies/vtkIndirectProxySphere.h" // for spheres

#include <vector> // for spheres

struct vtkIndirectFrame;

class vtkIndirectProxyStep
{
public:
  /** Most of the step without regard to spheres. */
  static constexpr int Most = 8;
  /** Share of a radius by which it may pass the limit of the last step, either way. */
  static constexpr double Margin = 0.15;

  /** The step of a frame by what is in view. */
  int Find(const vtkIndirectFrame& frame, const std::vector<vtkIndirectProxySphere>& spheres);
  /** By a radius in pixels, which may be infinite. Another size forgets the last step. */
  int Find(const int size[2], double radius);
  /** The next step is found as if there had been none. */
  void Forget() { this->Last = 0; }

private:
  int Size[2] = { 0, 0 };
  int Last = 0; // 0: none
};
#endif
