// SPDX-License-Identifier: BSD-3-Clause
// The scene's surfaces and spheres on the processor, for all lights of a pipeline: samplers,
// visibility, and the paths that judge and correct a picture share one tree.
#pragma once

#include "Pipeline/vtkIndirectSphereBlockers.h" // for a member
#include "Plan/vtkIndirectEstimate.h"           // for needs
#include "Scene/vtkIndirectSurfaces.h"          // for a member

class vtkObject;

class vtkIndirectFrameSurfaces
{
public:
  /**
   * Brings the surfaces up to date if rays of samplers (walked) or of the needs meet them; else
   * releases them, unless they are kept. caller: the object that reports errors of spheres. Returns
   * the spheres that mappers draw; null if no stage needs spheres.
   */
  const vtkIndirectBlockingSpheres* Update(const vtkIndirectEstimateInput& input,
    const vtkIndirectVisibilityNeeds& needs, bool walked, vtkObject* caller);

  /** Keeps the surfaces while a light that is not asked in each frame needs them. */
  void SetIsKept(bool isKept) { this->IsKept = isKept; }
  /** Releases the surfaces, unless they are kept. */
  void Rest();
  void Clear();

  const vtkIndirectSurfaces& Get() const { return this->Surfaces; }

private:
  vtkIndirectSphereBlockers Blockers;
  vtkIndirectSurfaces Surfaces;
  bool IsKept = false;
};
