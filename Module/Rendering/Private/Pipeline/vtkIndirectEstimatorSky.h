// SPDX-License-Identifier: BSD-3-Clause
// The light from the sky if an estimator computes it, without depth maps: the frame's own
// estimator, or spheres that represent moving props beside it.
#ifndef vtkIndirectEstimatorSky_h
#define vtkIndirectEstimatorSky_h

#include "Frame/vtkIndirectFrameLight.h" // for the base class
#include "vtkIndirectEstimatorPass.h"    // for a member
#include "vtkWeakPointer.h"              // for a member

class vtkIndirectEstimatorSky : public vtkIndirectFrameLight
{
public:
  /** Sets the estimator; alone: it is the frame's estimator, and gives no other light. */
  void SetEstimator(vtkIndirectEstimatorPass* estimator, bool alone);

  const char* GetName() const override { return "light from the sky"; }
  void AppendTo(vtkIndirectKey& key, const Input& input) const override;
  int CountMapsNeeded(const Input&) const override { return 0; }
  bool Update(const Input&, int) override { return true; }
  size_t GetNumberOfTilesDrawn() const override { return 0; }
  int GetNumberOfTilesLeft() const override { return 0; }
  vtkIndirectEstimate Sum(const Input& input) override;
  bool IsCurrent() const override;
  void AddToReport(vtkIndirectReport& report, const vtkIndirectPlan& plan) const override;
  void Release(vtkWindow*) override { this->Estimator = nullptr; }

private:
  vtkWeakPointer<vtkIndirectEstimatorPass> Estimator;
  bool Alone = false;
  vtkMTimeType EstimateTime = 0; // time of the estimator, after the last sum
};

#endif
