// SPDX-License-Identifier: BSD-3-Clause
// The light that surfaces reflect: virtual lights of the frame's samplers, their visibility, and
// the estimator that sums them.
#pragma once

#include "Pipeline/vtkIndirectEstimatorLight.h" // for the base class
#include "Pipeline/vtkIndirectSphereBlockers.h" // for a member
#include "Visibility/vtkIndirectSurfaces.h"     // for a member
#include "Visibility/vtkIndirectVisibility.h"   // for a member

class vtkIndirectFrameSamplers;
class vtkVirtualLightSampler;

class vtkIndirectBounceLight : public vtkIndirectEstimatorLight
{
public:
  vtkIndirectBounceLight(
    vtkIndirectResource* owner, vtkIndirectFrameSamplers& samplers, vtkIndirectDepthMaps& maps);

  /** Sets the estimator, and the user's sampler, whose changes make lights stale. */
  void SetEstimator(vtkIndirectEstimatorPass* estimator, vtkVirtualLightSampler* users);

  const char* GetName() const override { return "indirect light"; }
  void AppendTo(vtkIndirectKey& key, const Input& input) const override;
  bool Update(const Input& input) override;
  int GetNumberOfTilesLeft() const override
  {
    return this->Visibility.GetMaps().GetNumberOfTilesLeft();
  }
  bool HasMore(const Input& input) const override;
  vtkIndirectEstimate Sum(const Input& input) override;
  /** Releases depth maps, voxels and surfaces. */
  void Rest(const Input& input) override;
  void AddToReport(vtkIndirectReport& report, const vtkIndirectPlan& plan) const override;

  const vtkIndirectVisibility& GetVisibility() const { return this->Visibility; }

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  const vtkIndirectBlockingSpheres* UpdateSurfaces(
    const Input& input, const vtkIndirectVisibilityNeeds& needs);

  vtkIndirectFrameSamplers& Samplers;
  vtkIndirectVisibility Visibility;
  vtkIndirectSphereBlockers Blockers;      // for visibility and surfaces
  vtkIndirectSurfaces Surfaces;            // for samplers and visibility
  vtkVirtualLightSampler* Users = nullptr; // valid while a frame is drawn
};
