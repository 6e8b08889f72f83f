// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkIndirectFrameSurfaces.h"

#include "Plan/vtkIndirectPlan.h"

//------------------------------------------------------------------------------
const vtkIndirectBlockingSpheres* vtkIndirectFrameSurfaces::Update(
  const vtkIndirectEstimateInput& input, const vtkIndirectVisibilityNeeds& needs, bool walked,
  vtkObject* caller)
{
  const bool traced = walked || needs.HasSurfaces();
  const bool listed = traced || needs.HasSphereLists();
  if (!(listed || this->IsKept) || !input.Plan.Caching)
  {
    this->Blockers.Forget();
  }
  if (needs.HasSurfaces() && !input.Plan.Caching)
  {
    this->Surfaces.Forget();
  }
  const vtkIndirectBlockingSpheres* const spheres =
    listed ? this->Blockers.Update(input.Frame, caller) : nullptr;
  if (traced)
  {
    this->Surfaces.Update(input.Frame, spheres);
  }
  else
  {
    this->Rest();
  }
  return spheres;
}

//------------------------------------------------------------------------------
void vtkIndirectFrameSurfaces::Rest()
{
  if (!this->IsKept)
  {
    this->Surfaces.Clear();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectFrameSurfaces::Clear()
{
  this->Surfaces.Clear();
  this->Blockers.Forget();
  this->IsKept = false;
}
