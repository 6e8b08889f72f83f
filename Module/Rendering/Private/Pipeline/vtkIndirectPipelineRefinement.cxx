// SPDX-License-Identifier: BSD-3-Clause
// Refinement of a still picture: while nothing changes, frames sum its indirect light anew, of four
// times as many virtual lights each time, in batches.
#include "OpenGL/vtkIndirectGL.h"

#include "Pipeline/vtkIndirectPipeline.h"

#include "Capture/vtkIndirectDarkLight.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "Sums/vtkIndirectSum.h"
#include "vtkOpenGLRenderWindow.h"

namespace
{
// A refined picture's error is so many times its change from the picture before it, by the table of
// the guide ("A picture left alone"). Most of the first change is the error of the first picture,
// which has fewer lights, of a quarter of the texels.
constexpr double ErrorOverFirstChange = 0.5;
constexpr double ErrorOverChange = 1.0;
}

//------------------------------------------------------------------------------
// Adds a batch to a picture that stands, or refines one that is to be finished at once.
void vtkIndirectPipeline::Refine(const vtkIndirectFrameLight::Input& input)
{
  vtkIndirectRefinementSchedule& schedule = this->Schedule;
  schedule.SetLimits(
    { this->Plan.Refinements, this->Plan.RefinementSeconds, this->Plan.RefinementFades },
    this->FrameBegan);
  bool isNew = false;
  bool stands = this->Plan.Refinements > 0;
  for (const Part& part : this->Parts)
  {
    isNew = isNew || (part.IsAsked && part.IsNew);
    stands = stands &&
      (!part.IsAsked || (part.IsThere && part.Light->IsComplete() && !part.Light->HasMore(input)));
  }
  if (isNew || !stands)
  {
    schedule.Restart(this->FrameBegan);
  }
  if (stands && (this->Plan.FinishesAtOnce || !isNew))
  {
    const bool fades = schedule.GetShare() < 1.0;
    schedule.BeginFrame(vtkIndirectRefinementSchedule::ReadClock());
    if (fades && !schedule.HasBatch())
    {
      this->ShowRefinement();
    }
    for (bool adds = schedule.HasBatch(); adds;
         adds = this->Plan.FinishesAtOnce && schedule.HasBatch())
    {
      if (!this->AddBatch())
      {
        schedule.Refuse();
      }
    }
  }
  if (!this->Plan.Interactive && schedule.CountFramesLeft() == 0 &&
    this->Accumulation.GetBytes() > 0)
  {
    this->ReleaseRefinement();
  }
}

//------------------------------------------------------------------------------
// The finished picture is in the images of the first one.
void vtkIndirectPipeline::ReleaseRefinement()
{
  vtkIndirectResource* const all[] = { &this->FinerBounce, &this->FinerSamplers,
    &this->Accumulation };
  for (vtkIndirectResource* resource : all)
  {
    resource->Release(this->Frame.Window);
  }
}

//------------------------------------------------------------------------------
// Returns false, after an error, when OpenGL refuses.
bool vtkIndirectPipeline::AddBatch()
{
  Part& part = this->Parts[0];
  vtkIndirectFrameLight::Input input = this->MakeInput(this->FinerBounce.GetVisibility());
  input.Batch = this->Schedule.GetBatch();
  vtkVirtualLightSampler* const sampler = this->FinerSamplers.Default;
  sampler->SetNumberOfLights(this->Schedule.GetNumberOfLights());
  this->FinerSamplers.Choose(this->Frame, this->Plan,
    vtkIndirectSum::Get(this->Estimator)
      .ChooseSampler(vtkIndirectSampler::Get(sampler), this->Plan));
  this->FinerBounce.SetSources(this->Estimator, sampler);
  const vtkIndirectDarkLight dark(this->Frame);
  this->Capture->Attach(this->Frame);
  bool done = this->UpdateSenderMaps(this->FinerSamplers);
  this->Capture->Detach();
  done = done && this->FinerBounce.Update(input);
  if (done && this->DepthMaps.HasRequests())
  {
    this->Timer.Begin(vtkIndirectStageTimer::Visibility);
    done = this->DepthMaps.Draw(this->Frame, this->Capture);
    this->Timer.End(vtkIndirectStageTimer::Visibility);
  }
  // The estimator sums the batch in the picture's images.
  const bool first = input.Batch.Number == 0;
  if (first && (this->Schedule.GetRefinements() == 0 || this->Accumulation.GetBytes() == 0))
  {
    done = done && this->Accumulation.Keep(this->Frame, part.Result.Contributions);
  }
  const vtkIndirectEstimate batch =
    done ? this->FinerBounce.MakeEstimate(input) : vtkIndirectEstimate();
  done = batch.State != vtkIndirectEstimate::FAILED &&
    this->Accumulation.Add(this->Frame, batch.Contributions, first);
  if (done && this->Schedule.EndBatch(vtkIndirectRefinementSchedule::ReadClock()))
  {
    this->Accumulation.Finish();
    part.Result.Error = this->Accumulation.FindChange() *
      (this->Schedule.GetRefinements() == 1 ? ErrorOverFirstChange : ErrorOverChange);
    if (this->Plan.ErrorToleranceIsSet && part.Result.Error <= this->Plan.ErrorTolerance)
    {
      this->Schedule.End();
    }
  }
  done = done && this->ShowRefinement();
  part.IsThere = done;
  part.Time = part.Light->GetEstimateTime();
  if (!done)
  {
    part.Key.Clear(); // the next frame makes the picture anew
  }
  return done;
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::ShowRefinement()
{
  return this->Accumulation.Show(
    this->Frame, this->Parts[0].Result.Contributions, this->Schedule.GetShare());
}

//------------------------------------------------------------------------------
long long vtkIndirectPipeline::CountBatchesLeft() const
{
  return this->BuffersAreThere ? this->Schedule.CountFramesLeft() : 0;
}

//------------------------------------------------------------------------------
long long vtkIndirectPipeline::CountTilesLeft() const
{
  long long left = 0;
  for (const Part& part : this->Parts)
  {
    left += this->IsCurrent(part) || part.Waits ? part.Light->GetNumberOfTilesLeft() : 0;
  }
  return left;
}

//------------------------------------------------------------------------------
long long vtkIndirectPipeline::CountWorkLeft() const
{
  return this->BuffersAreThere && !this->Plan.Interactive
    ? this->CountTilesLeft() + this->CountBatchesLeft()
    : 0;
}
