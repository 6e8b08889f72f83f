// SPDX-License-Identifier: BSD-3-Clause
// Light of a frame that an estimator computes. Another pass may use the estimator, or delete it,
// between frames: the result is current until then.
#pragma once

#include "Frame/vtkIndirectFrameLight.h" // for the base class
#include "vtkIndirectEstimatorPass.h"    // for a member
#include "vtkWeakPointer.h"              // for a member

class vtkIndirectSum;

class vtkIndirectEstimatorLight : public vtkIndirectFrameLight
{
public:
  using vtkIndirectFrameLight::vtkIndirectFrameLight;

  vtkIndirectEstimate Sum(const Input& input) override;
  bool IsCurrent() const override;

protected:
  void ReleaseOwn(vtkWindow*) override { this->Estimator = nullptr; }
  void SetEstimator(vtkIndirectEstimatorPass* estimator);
  vtkIndirectSum& GetSum() const;
  /** Adds the estimator's memory, and what it modelled and left out. */
  void AddEstimatorTo(vtkIndirectReport& report) const;

  vtkWeakPointer<vtkIndirectEstimatorPass> Estimator;

private:
  vtkMTimeType EstimateTime = 0; // time of the estimator, after the last sum
};
