// SPDX-License-Identifier: BSD-3-Clause
// The light that surfaces reflect: virtual lights of the frame's samplers, their visibility, and
// the estimator that sums them.
#ifndef vtkIndirectBounceLight_h
#define vtkIndirectBounceLight_h

#include "Pipeline/vtkIndirectEstimatorLight.h" // for the base class
#include "Pipeline/vtkIndirectSphereBlockers.h" // for a member
#include "Visibility/vtkIndirectSurfaces.h"     // for a member
#include "Visibility/vtkIndirectVisibility.h"   // for a member

class vtkIndirectFrameSamplers;
class vtkVirtualLightSampler;

class vtkIndirectBounceLight : public vtkIndirectEstimatorLight
{
public:
  explicit vtkIndirectBounceLight(vtkIndirectFrameSamplers& samplers);

  /** Sets the estimator, and the user's sampler, whose changes make lights stale. */
  void SetEstimator(vtkIndirectEstimatorPass* estimator, vtkVirtualLightSampler* users);

  const char* GetName() const override { return "indirect light"; }
  void AppendTo(vtkIndirectKey& key, const Input& input) const override;
  /** This is the first light of a frame, so no earlier light leaves maps to it. */
  int CountMapsNeeded(const Input&) const override { return 0; }
  bool Update(const Input& input, int mostMaps) override;
  size_t GetNumberOfTilesDrawn() const override { return this->Visibility.GetNumberOfTilesDrawn(); }
  int GetNumberOfTilesLeft() const override { return this->Visibility.GetNumberOfTilesLeft(); }
  bool HasMore(const Input& input) const override;
  vtkIndirectEstimate Sum(const Input& input) override;
  /** Releases depth maps, voxels and surfaces. */
  void Rest(const Input& input) override;
  void AddToReport(vtkIndirectReport& report, const vtkIndirectPlan& plan) const override;
  void Release(vtkWindow* window) override;

  const vtkIndirectVisibility& GetVisibility() const { return this->Visibility; }

private:
  const vtkIndirectBlockingSpheres* UpdateSurfaces(
    const Input& input, const vtkIndirectVisibilityNeeds& needs);

  vtkIndirectFrameSamplers& Samplers;
  vtkIndirectVisibility Visibility;
  vtkIndirectSphereBlockers Blockers;      // for visibility and surfaces
  vtkIndirectSurfaces Surfaces;            // for samplers and visibility
  vtkVirtualLightSampler* Users = nullptr; // valid while a frame is drawn
};

#endif
