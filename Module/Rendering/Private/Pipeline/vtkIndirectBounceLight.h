// SPDX-License-Identifier: BSD-3-Clause
// The light that surfaces reflect: virtual lights of the frame's samplers, their visibility, and
// the estimator that sums them.
#pragma once

#include "Sums/vtkIndirectFrameLight.h"       // for the base class
#include "Visibility/vtkIndirectVisibility.h" // for a member

class vtkIndirectEstimatorPass;
class vtkIndirectFrameSamplers;
class vtkIndirectFrameSurfaces;
class vtkIndirectSum;
class vtkIndirectSurfaces;
class vtkVirtualLightSampler;

class vtkIndirectBounceLight : public vtkIndirectFrameLight
{
public:
  /**
   * client: of the depth maps; keepsSurfaces: surfaces stay, once this light has asked for them,
   * until this light is released.
   */
  vtkIndirectBounceLight(vtkIndirectResource* owner, vtkIndirectFrameSamplers& samplers,
    vtkIndirectFrameSurfaces& surfaces, vtkIndirectDepthMaps& maps,
    vtkIndirectDepthMaps::ClientType client, bool keepsSurfaces = false);

  /**
   * Sets the estimator, which must live as long as its result is read, and the user's sampler,
   * whose changes make lights stale.
   */
  void SetSources(vtkIndirectEstimatorPass* estimator, vtkVirtualLightSampler* users)
  {
    this->Estimator = estimator;
    this->Users = users;
  }

  void AppendTo(vtkIndirectKey& key, const Input& input) const override;
  bool Update(const Input& input) override;
  int GetNumberOfTilesLeft() const override
  {
    return this->Visibility.GetMaps().GetNumberOfTilesLeft();
  }
  bool HasMore(const Input& input) const override;
  vtkIndirectEstimate MakeEstimate(const Input& input) override;
  vtkMTimeType GetEstimateTime() const override;
  /** Releases depth maps, voxels and surfaces. */
  void Rest(const Input& input) override;
  size_t GetMainMemoryBytes() const override;
  void AddToReport(vtkIndirectReport& report) const override;

  /** Returns the scene's surfaces, up to date even if nothing else needs them. */
  const vtkIndirectSurfaces& GetSurfaces(const Input& input);

  const vtkIndirectVisibility& GetVisibility() const { return this->Visibility; }

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  vtkIndirectSum& GetSum() const;
  const vtkIndirectBlockingSpheres* UpdateSurfaces(
    const Input& input, const vtkIndirectVisibilityNeeds& needs);

  vtkIndirectFrameSamplers& Samplers;
  vtkIndirectFrameSurfaces& Surfaces;
  const bool KeepsSurfaces;
  vtkIndirectVisibility Visibility;
  vtkIndirectEstimatorPass* Estimator = nullptr;
  vtkVirtualLightSampler* Users = nullptr; // valid while a frame is drawn
};
