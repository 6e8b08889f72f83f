// SPDX-License-Identifier: BSD-3-Clause
// Detects spheres that move in successive frames, so that depth maps of the sky would have to be
// drawn again each time, and whether spheres can replace the maps in this scene.
//
// Motion begins with the second successive frame whose spheres are elsewhere than in the frame
// before. It ends with the first unmoved frame that is not interactive (see
// vtkIndirectPlan::Interactive), otherwise with the ninth unmoved frame in succession: data often
// come more slowly than a camera turns, and the picture must not change in between. Eyes and tiles
// of one picture have the same result.
#pragma once

#include "OpenGL/vtkIndirectKey.h"          // for a member
#include "Proxies/vtkIndirectProxyShapes.h" // for a member

#include <string>        // for reasons
#include <unordered_map> // for props of the last frame

class vtkProp;
struct vtkIndirectFrame;

class vtkIndirectSphereMotion
{
public:
  /** Updates the detection; to be called once a frame. hasSun: some of the sky's light is strong.
   */
  void Update(const vtkIndirectFrame& frame, bool hasSun, bool interactive);

  /** Returns the moving spheres, in words; empty if there are none. */
  const std::string& GetWhat() const { return this->What; }
  /**
   * Returns the reason why spheres cannot represent everything that hides the sky; empty if they
   * can, or without motion.
   */
  const std::string& GetWhyNot() const { return this->WhyNot; }
  /** Returns true if present spheres have moved once, and could be summed by spheres. */
  bool HasMoved() const { return this->Moved; }
  void Forget();

private:
  double FindMovedSpheres(const vtkIndirectFrame& frame);
  std::string FindWhyNot(const vtkIndirectFrame& frame);

  struct Before
  {
    vtkTypeUInt64 Revision = 0;
    vtkIndirectKey Places;
  };
  std::unordered_map<vtkProp*, Before> Props;
  vtkIndirectProxyShapes Shapes;
  int Changes = 0; // number of successive frames with motion
  int Idle = 0;    // number of successive frames without it, since then
  bool Moved = false;
  std::string What;
  std::string WhyNot;
};
