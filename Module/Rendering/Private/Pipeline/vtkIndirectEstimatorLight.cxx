// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkIndirectEstimatorLight.h"

#include "Frame/vtkIndirectReport.h"
#include "Gather/vtkIndirectSum.h"

//------------------------------------------------------------------------------
void vtkIndirectEstimatorLight::SetEstimator(vtkIndirectEstimatorPass* estimator)
{
  if (estimator != this->Estimator)
  {
    this->EstimateTime = 0;
  }
  this->Estimator = estimator;
}

//------------------------------------------------------------------------------
vtkIndirectSum& vtkIndirectEstimatorLight::GetSum() const
{
  return vtkIndirectSum::Get(this->Estimator);
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkIndirectEstimatorLight::Sum(const Input& input)
{
  const vtkIndirectEstimate estimate = this->GetSum().MakeEstimate(input);
  this->EstimateTime = this->GetSum().GetEstimateTime();
  return estimate;
}

//------------------------------------------------------------------------------
// Another pass that uses the estimator replaces its images.
bool vtkIndirectEstimatorLight::IsCurrent() const
{
  return this->Estimator && this->GetSum().GetEstimateTime() == this->EstimateTime;
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorLight::AddEstimatorTo(vtkIndirectReport& report) const
{
  report.Bytes += this->GetSum().GetBytes();
  report.MainMemoryBytes += this->GetSum().GetMainMemoryBytes();
  this->GetSum().AddToReport(report);
}
