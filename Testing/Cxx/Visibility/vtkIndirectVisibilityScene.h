// SPDX-License-Identifier: BSD-3-Clause
// A scene whose estimators sum the same virtual lights at every pixel, so that pictures differ only
// by the visibility of senders.
#ifndef vtkIndirectVisibilityScene_h
#define vtkIndirectVisibilityScene_h

#include "vtkIndirectTestUtilities.h"

#include "vtkIndirectDetails.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRSMReferencePass.h"
#include "vtkUniformLightSampler.h"

#include <cmath>

namespace vtkIndirectTest
{
struct VisibilityScene : Scene
{
  vtkNew<vtkMultiresolutionSplattingPass> Splatting;
  vtkNew<vtkRSMReferencePass> Reference;

  VisibilityScene(int width, int height)
    : Scene(width, height)
  {
    this->Gather->SetModeToVirtualLights();
    this->Gather->InterpolationOff();
    this->Splatting->SetPlaneThreshold(0.0); // every pixel has its own sample
    SET_DETAIL(this->Splatting, HalfFloats, false);
    this->Reference->SetModeToVirtualLights();
    this->Sampler->SetNumberOfLights(256);
    this->Pass->SetReflectiveShadowMapResolution(128);
  }
  ~VisibilityScene() { this->Pass->SetEstimator(nullptr); }

  Image Measure(vtkIndirectEstimatorPass* estimator, int visibility)
  {
    this->Pass->SetEstimator(estimator);
    this->Pass->SetVisibility(visibility);
    this->Render();
    return this->Copy("irradiance");
  }
};

/** Root mean square of the difference, over the mean of b. */
inline double RootMeanSquare(const Image& a, const Image& b)
{
  double sum = 0.0;
  for (size_t i = 0; i < a.Values.size(); ++i)
  {
    sum += std::pow(double(a.Values[i]) - b.Values[i], 2.0);
  }
  return std::sqrt(sum / a.Values.size()) / b.Mean();
}
}

#endif
