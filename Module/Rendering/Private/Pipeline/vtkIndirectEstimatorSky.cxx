// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkIndirectEstimatorSky.h"

#include "Frame/vtkIndirectKey.h"
#include "Frame/vtkIndirectPlan.h"
#include "Frame/vtkIndirectReport.h"
#include "vtkEnvironmentLight.h"

//------------------------------------------------------------------------------
void vtkIndirectEstimatorSky::SetEstimator(vtkIndirectEstimatorPass* estimator, bool alone)
{
  this->vtkIndirectEstimatorLight::SetEstimator(estimator);
  this->Alone = alone;
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorSky::AppendTo(vtkIndirectKey& key, const Input& input) const
{
  key.Add("estimator", this->Estimator).Add("sky", input.Environment);
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorSky::AddToReport(
  vtkIndirectReport& report, const vtkIndirectPlan& plan) const
{
  if (report.Method == "off")
  {
    report.Method = this->Estimator->GetMethodName();
  }
  this->AddEstimatorTo(report);
  if (this->Alone)
  {
    report.Add(plan.EstimateModelled, plan.EstimateLeftOut);
  }
}
