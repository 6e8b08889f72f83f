// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkIndirectEstimatorSky.h"

#include "Frame/vtkIndirectKey.h"
#include "Frame/vtkIndirectPlan.h"
#include "Frame/vtkIndirectReport.h"
#include "Gather/vtkIndirectSum.h"
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
  const vtkIndirectEstimate estimate = vtkIndirectSum::Get(this->Estimator).MakeEstimate(input);
  this->EstimateTime = vtkIndirectSum::Get(this->Estimator).GetEstimateTime();
  return estimate;
}

//------------------------------------------------------------------------------
// Another pass that uses the estimator replaces its images.
bool vtkIndirectEstimatorSky::IsCurrent() const
{
  return this->Estimator &&
    vtkIndirectSum::Get(this->Estimator).GetEstimateTime() == this->EstimateTime;
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorSky::AddToReport(
  vtkIndirectReport& report, const vtkIndirectPlan& plan) const
{
  if (report.Method == "off")
  {
    report.Method = this->Estimator->GetMethodName();
  }
  report.Bytes += vtkIndirectSum::Get(this->Estimator).GetBytes();
  report.MainMemoryBytes += vtkIndirectSum::Get(this->Estimator).GetMainMemoryBytes();
  vtkIndirectSum::Get(this->Estimator).AddToReport(report);
  if (this->Alone)
  {
    report.Add(plan.EstimateModelled, plan.EstimateLeftOut);
  }
}
