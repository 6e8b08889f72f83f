// SPDX-License-Identifier: BSD-3-Clause
// The estimated error of a picture, for the report and for refinement that ends at a tolerance.
#include "OpenGL/vtkIndirectGL.h"

#include "Pipeline/vtkIndirectPipeline.h"

#include "Error/vtkIndirectPathTracer.h"
#include "Scene/vtkIndirectRevision.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"

#include <algorithm>
#include <iterator>

//------------------------------------------------------------------------------
double vtkIndirectPipeline::EstimateError()
{
  const bool isWhole = std::all_of(std::begin(this->Parts), std::end(this->Parts),
    [this](const Part& part)
    { return !part.IsAsked || (this->IsCurrent(part) && part.Light->IsComplete()); });
  if (this->EstimatedError || !this->BuffersAreThere || !this->IsInWindow() || !isWhole ||
    this->Plan.Interactive || !this->Estimator || !this->CastersAreThere())
  {
    return this->EstimatedError.value_or(-1.0);
  }
  this->Frame.Window->MakeCurrent();
  vtkNew<vtkImageData> images[3];
  if (!this->CopyImage("irradiance", images[0]) || !this->CopyImage("normal", images[1]) ||
    !this->CopyImage("depth", images[2]))
  {
    return -1.0;
  }
  const vtkIndirectFrameLight::Input input = this->MakeInput(this->Bounce.GetVisibility());
  const vtkIndirectPathTracer tracer = this->MakePathTracer(this->Bounce.GetSurfaces(input));
  this->EstimatedError =
    this->ErrorProbe.Estimate(this->Frame, tracer, { images[0], images[1], images[2] });
  return *this->EstimatedError;
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::CopyImage(const char* name, vtkImageData* image)
{
  const bool copied = this->RenderChannel(name);
  if (copied)
  {
    this->Composite.CopyImage(image);
  }
  return copied;
}

//------------------------------------------------------------------------------
vtkIndirectPathTracer vtkIndirectPipeline::MakePathTracer(const vtkIndirectSurfaces& surfaces) const
{
  return { this->Frame, surfaces, this->Plan.Sky ? this->Environment : nullptr,
    this->UsableAreaLights, this->Plan.AskedBounces };
}

//------------------------------------------------------------------------------
// Traces a batch of the paths that correct a refined picture, or finds that paths do not meet what
// the picture shows. Returns false, after an error, when OpenGL refuses; so does the next function.
bool vtkIndirectPipeline::TracePaths(const vtkIndirectFrameLight::Input& input)
{
  if (this->Paths.IsEmpty())
  {
    const vtkIndirectSurfaces& surfaces = this->FinerBounce.GetSurfaces(input);
    if (!surfaces.GetLeftOut().empty())
    {
      const auto& [what, why] = surfaces.GetLeftOut().front();
      this->WhyNoPaths = what;
      this->WhyNoPaths += ": " + why;
      this->LimitRefinement();
      return true;
    }
    if (!this->CopyImage("normal", this->Paths.GetNormal()) ||
      !this->CopyImage("depth", this->Paths.GetDepth()))
    {
      return false;
    }
    this->Paths.Begin(this->Frame, this->MakePathTracer(surfaces));
  }
  const vtkIndirectLightBatch part = this->Schedule.GetPart();
  this->Paths.AddPaths(this->Frame, part.Number, part.Count);
  return true;
}

//------------------------------------------------------------------------------
// Corrects the picture that is shown. anew: its light has been summed anew; else the correction
// replaces the one before.
bool vtkIndirectPipeline::CorrectByPaths(bool anew)
{
  this->PathsOfPicture = this->Paths.CountPaths();
  if (anew || this->Paths.GetIrradiance()->GetNumberOfPoints() == 0)
  {
    this->Paths.ForgetCorrection();
    if (!this->CopyImage("irradiance", this->Paths.GetIrradiance()))
    {
      return false;
    }
  }
  return this->Accumulation.Correct(this->Frame, this->Paths.ChangeCorrection(this->Frame));
}

//------------------------------------------------------------------------------
// Keeps the props of a new picture: between frames they may change, or be deleted.
void vtkIndirectPipeline::KeepCasters()
{
  this->ErrorProbe.Clear();
  this->Paths.Clear();
  this->PathsOfPicture = 0;
  this->WhyNoPaths.clear();
  this->CastersOfPicture.clear();
  for (const vtkIndirectCaster& caster : this->Frame.Casters)
  {
    this->CastersOfPicture.emplace_back(caster.Prop);
  }
}

//------------------------------------------------------------------------------
// Returns true if the frame's casters are still there, as the picture shows them.
bool vtkIndirectPipeline::CastersAreThere() const
{
  return this->CastersOfPicture.size() == this->Frame.Casters.size() &&
    std::equal(this->CastersOfPicture.begin(), this->CastersOfPicture.end(),
      this->Frame.Casters.begin(),
      [](const vtkWeakPointer<vtkProp>& prop, const vtkIndirectCaster& caster) {
        return prop && prop == caster.Prop && vtkIndirectRevision::Find(prop) == caster.Revision;
      });
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::MeetsTolerance()
{
  this->EstimatedError.reset();
  const double error = this->Plan.ErrorToleranceIsSet ? this->EstimateError() : -1.0;
  return error >= 0.0 && error <= this->Plan.ErrorTolerance;
}
