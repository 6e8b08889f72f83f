// SPDX-License-Identifier: BSD-3-Clause
// The light from the sky if an estimator computes it, without depth maps: the frame's own
// estimator, or spheres that represent moving props beside it.
#pragma once

#include "Pipeline/vtkIndirectEstimatorLight.h" // for the base class

class vtkIndirectEstimatorSky : public vtkIndirectEstimatorLight
{
public:
  using vtkIndirectEstimatorLight::vtkIndirectEstimatorLight;

  /** Sets the estimator; alone: it is the frame's estimator, and gives no other light. */
  void SetEstimator(vtkIndirectEstimatorPass* estimator, bool alone);

  const char* GetName() const override { return "light from the sky"; }
  void AppendTo(vtkIndirectKey& key, const Input& input) const override;
  bool Update(const Input&) override { return true; }
  void AddToReport(vtkIndirectReport& report, const vtkIndirectPlan& plan) const override;

private:
  bool Alone = false;
};
