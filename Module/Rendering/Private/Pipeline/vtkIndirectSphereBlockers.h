// SPDX-License-Identifier: BSD-3-Clause
// Spheres between senders and receivers, where segments are followed through voxels, and for rays
// that look for surfaces: what mappers draw as spheres, by the rule by which spheres take the place
// of the sky's maps (vtkIndirectProxyScene). They cast shadows as any other caster does.
#ifndef vtkIndirectSphereBlockers_h
#define vtkIndirectSphereBlockers_h

#include "Proxies/vtkIndirectProxyScene.h"         // for a member
#include "Visibility/vtkIndirectBlockingSpheres.h" // for a member

class vtkObject;
struct vtkIndirectFrame;

class vtkIndirectSphereBlockers
{
public:
  /**
   * Those of a frame; collected anew where something may have changed. The result is valid up to
   * the next call. caller: whose error it is when radii are negative or not finite.
   */
  const vtkIndirectBlockingSpheres* Update(const vtkIndirectFrame& frame, vtkObject* caller);
  /** Nobody needs them. */
  void Forget();

private:
  vtkIndirectProxyScene Scene{ vtkIndirectProxyScene::SEGMENTS };
  vtkIndirectBlockingSpheres Result;
};
#endif
