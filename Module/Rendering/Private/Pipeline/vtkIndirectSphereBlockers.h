// SPDX-License-Identifier: BSD-3-Clause
// The spheres that mappers draw, as blockers where segments walk through voxels, and as surfaces
// for rays. They are found by the rule by which spheres replace the sky's maps
// (vtkIndirectProxyScene), and cast shadows as any other caster does.
#pragma once

#include "Proxies/vtkIndirectProxyScene.h"    // for a member
#include "Scene/vtkIndirectBlockingSpheres.h" // for a member

class vtkObject;
struct vtkIndirectFrame;

class vtkIndirectSphereBlockers
{
public:
  /**
   * Returns the spheres of a frame, collected again if they may have changed. The result is valid
   * up to the next call. caller: the object that reports the error of negative or non-finite radii.
   */
  const vtkIndirectBlockingSpheres* Update(const vtkIndirectFrame& frame, vtkObject* caller);
  /** Drops the spheres; no stage needs them. */
  void Forget();

private:
  vtkIndirectProxyScene Scene{ vtkIndirectProxyScene::SEGMENTS };
  vtkIndirectBlockingSpheres Result;
};
