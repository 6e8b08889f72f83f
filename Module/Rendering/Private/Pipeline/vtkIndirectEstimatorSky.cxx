// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkIndirectEstimatorSky.h"

#include "Frame/vtkIndirectKey.h"
#include "Frame/vtkIndirectPlan.h"
#include "Frame/vtkIndirectReport.h"
#include "vtkEnvironmentLight.h"

//------------------------------------------------------------------------------
void vtkIndirectEstimatorSky::SetEstimator(vtkIndirectEstimatorPass* estimator, bool alone)
{
  if (estimator != this->Estimator)
  {
    this->EstimateTime = 0;
  }
  this->Estimator = estimator;
  this->Alone = alone;
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorSky::AppendTo(vtkIndirectKey& key, const Input& input) const
{
  key.Add("estimator", this->Estimator).Add("sky", input.Environment);
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkIndirectEstimatorSky::Sum(const Input& input)
{
  const vtkIndirectEstimate estimate = this->Estimator->MakeEstimate(input);
  this->EstimateTime = this->Estimator->GetEstimateTime();
  return estimate;
}

//------------------------------------------------------------------------------
// Another pass that uses the estimator replaces its images.
bool vtkIndirectEstimatorSky::IsCurrent() const
{
  return this->Estimator && this->Estimator->GetEstimateTime() == this->EstimateTime;
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorSky::AddToReport(
  vtkIndirectReport& report, const vtkIndirectPlan& plan) const
{
  if (report.Method == "off")
  {
    report.Method = this->Estimator->GetMethodName();
  }
  report.Bytes += this->Estimator->GetBytes();
  report.MainMemoryBytes += this->Estimator->GetMainMemoryBytes();
  this->Estimator->AddToReport(report);
  if (this->Alone)
  {
    report.Add(plan.EstimateModelled, plan.EstimateLeftOut);
  }
}
