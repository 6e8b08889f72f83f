// SPDX-License-Identifier: BSD-3-Clause
// Refinement of a still picture: while nothing changes, frames sum its indirect light anew, of four
// times as many virtual lights each time, in batches.
#include "OpenGL/vtkIndirectGL.h"

#include "Pipeline/vtkIndirectPipeline.h"

#include "Capture/vtkIndirectDarkLight.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "Sums/vtkIndirectSum.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

namespace
{
constexpr int LightsOfPicture = 512; // about as many as a picture has at first
constexpr int LightsOfBatch = 64;

int CountLights(int refinement)
{
  return LightsOfPicture << (2 * (refinement + 1));
}

int CountBatches(int refinement)
{
  return CountLights(refinement) / LightsOfBatch;
}
}

//------------------------------------------------------------------------------
// Adds a batch to a picture that stands, or refines one that is to be finished at once.
void vtkIndirectPipeline::Refine(const vtkIndirectFrameLight::Input& input)
{
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
    this->Refinement = this->NumberOfBatches = 0;
  }
  bool adds = stands && (this->Plan.FinishesAtOnce || !isNew) && !this->RefinementIsRefused;
  while (adds && this->Refinement < this->Plan.Refinements)
  {
    this->RefinementIsRefused = !this->AddBatch();
    adds = this->Plan.FinishesAtOnce && !this->RefinementIsRefused;
  }
  const bool ended = this->RefinementIsRefused || this->Refinement >= this->Plan.Refinements;
  if (ended && !this->Plan.Interactive && this->Accumulation.GetBytes() > 0)
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
  input.Batch = { this->NumberOfBatches, CountBatches(this->Refinement) };
  vtkVirtualLightSampler* const sampler = this->FinerSamplers.Default;
  sampler->SetNumberOfLights(CountLights(this->Refinement));
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
  const vtkIndirectAccumulation::Contributions& picture = part.Result.Contributions;
  const bool first = this->NumberOfBatches == 0;
  done = done && (!first || this->Accumulation.Keep(this->Frame, picture));
  const vtkIndirectEstimate batch =
    done ? this->FinerBounce.MakeEstimate(input) : vtkIndirectEstimate();
  done = batch.State != vtkIndirectEstimate::FAILED &&
    this->Accumulation.Add(this->Frame, batch.Contributions, first);
  if (done && ++this->NumberOfBatches == input.Batch.Count)
  {
    this->Accumulation.Finish();
    this->NumberOfBatches = 0;
    ++this->Refinement;
  }
  done = done && this->Accumulation.Show(this->Frame, picture);
  part.IsThere = done;
  part.Time = part.Light->GetEstimateTime();
  if (!done)
  {
    part.Key.Clear(); // the next frame makes the picture anew
  }
  return done;
}

//------------------------------------------------------------------------------
long long vtkIndirectPipeline::CountBatchesLeft() const
{
  long long left = -this->NumberOfBatches;
  for (int i = this->Refinement; i < this->Plan.Refinements; ++i)
  {
    left += CountBatches(i);
  }
  return this->BuffersAreThere && !this->RefinementIsRefused ? left : 0;
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
