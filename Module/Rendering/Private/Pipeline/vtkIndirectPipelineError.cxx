// SPDX-License-Identifier: BSD-3-Clause
// The estimated error of a picture, for the report and for refinement that ends at a tolerance.
#include "OpenGL/vtkIndirectGL.h"

#include "Pipeline/vtkIndirectPipeline.h"

#include "Error/vtkIndirectPathTracer.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <iterator>

//------------------------------------------------------------------------------
double vtkIndirectPipeline::EstimateError()
{
  const bool isWhole = std::all_of(std::begin(this->Parts), std::end(this->Parts),
    [this](const Part& part)
    { return !part.IsAsked || (this->IsCurrent(part) && part.Light->IsComplete()); });
  if (this->ErrorIsEstimated || !this->BuffersAreThere || !this->IsInWindow() || !isWhole ||
    this->Plan.Interactive)
  {
    return this->EstimatedError;
  }
  this->ErrorIsEstimated = true;
  this->Frame.Window->MakeCurrent();
  vtkNew<vtkImageData> images[3];
  const char* const names[] = { "irradiance", "normal", "depth" };
  for (int i = 0; i < 3; ++i)
  {
    if (!this->RenderChannel(names[i]))
    {
      return this->EstimatedError;
    }
    this->Composite.CopyImage(images[i]);
  }
  const vtkIndirectFrameLight::Input input = this->MakeInput(this->Bounce.GetVisibility());
  vtkIndirectKey key = this->FrameKey;
  for (const Part& part : this->Parts)
  {
    if (part.IsAsked)
    {
      part.Light->AppendTo(key, input);
    }
  }
  this->ErrorProbe.Begin(key);
  const vtkIndirectPathTracer tracer(this->Frame, this->Bounce.GetSurfaces(input),
    this->Plan.Sky ? this->Environment : nullptr, this->UsableAreaLights, this->Plan.AskedBounces);
  this->EstimatedError =
    this->ErrorProbe.Estimate(this->Frame, tracer, { images[0], images[1], images[2] });
  return this->EstimatedError;
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::MeetsTolerance()
{
  this->ErrorIsEstimated = false;
  const double error = this->Plan.ErrorToleranceIsSet ? this->EstimateError() : -1.0;
  return error >= 0.0 && error <= this->Plan.ErrorTolerance;
}
