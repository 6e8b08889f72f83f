// SPDX-License-Identifier: BSD-3-Clause
// Refinement of a still picture: while nothing changes, frames sum its indirect light anew, of four
// times as many virtual lights and directions of the sky each time, in batches.
#include "OpenGL/vtkIndirectGL.h"

#include "Pipeline/vtkIndirectPipeline.h"

#include "Capture/vtkIndirectDarkLight.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "Sums/vtkIndirectSum.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Directions of the sky of a batch of lights, and texels of their maps over those of the first
// picture.
constexpr int SkyOfBatch = 64;
constexpr int FinerTexels = 2;
// Directions of a batch where an opening needs many, and the edge of the blocks of pixels that
// share them: a pixel asks a quarter.
constexpr int SkyOfOpening = 256;
constexpr int BlockOfOpening = 2;
}

//------------------------------------------------------------------------------
// Adds a batch to a picture that stands, or refines one that is to be finished at once.
void vtkIndirectPipeline::Refine(const vtkIndirectFrameLight::Input& input)
{
  Part& sky = this->Parts[1];
  if (sky.IsNew)
  {
    const bool sums = this->Plan.FinishesAtOnce && this->Plan.Refinements == 0 &&
      this->RefinesSky() && sky.IsThere && sky.Light->IsComplete();
    this->DirectionsOfOpening = 0;
    sky.IsThere = sky.IsThere && (!sums || this->SumOpening());
  }
  vtkIndirectRefinementSchedule& schedule = this->Schedule;
  this->LimitRefinement();
  bool isNew = false;
  bool stands = this->Plan.Refinements > 0;
  for (const Part& part : this->Parts)
  {
    isNew = isNew || (part.IsAsked && part.IsNew);
    stands = stands &&
      (!part.IsAsked || (part.IsThere && part.Light->IsComplete() && !part.Light->HasMore(input)));
  }
  if (isNew && !this->Plan.Interactive)
  {
    this->KeepCasters();
  }
  if (isNew || !stands)
  {
    schedule.Restart(this->FrameBegan);
  }
  stands = stands && (!this->Plan.FinishesAtOnce || this->SumFurtherPoints(input));
  if (stands && (this->Plan.FinishesAtOnce || !isNew))
  {
    const bool fades = schedule.GetShare() < 1.0;
    schedule.BeginFrame(vtkIndirectRefinementSchedule::ReadClock());
    if (fades && !schedule.HasBatch())
    {
      this->ShowRefinement();
    }
    if (schedule.IsAtFirst() && this->MeetsTolerance())
    {
      schedule.End();
    }
    for (bool adds = schedule.HasBatch(); adds;
         adds = (this->Plan.FinishesAtOnce || this->HasTime()) && schedule.HasBatch())
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
// Paths find small openings to the sky by chance: there more directions of the sky are better.
void vtkIndirectPipeline::LimitRefinement()
{
  this->Schedule.SetLimits(
    { this->Plan.Refinements, this->Plan.RefinementSeconds, this->Plan.RefinementFades,
      !this->TracesPaths() || this->RefinesSky() },
    this->FrameBegan);
}

//------------------------------------------------------------------------------
// A frame that a timer draws adds batches while nobody waits, because it draws the surfaces and the
// picture anew for the first of them: these are 57 % of a frame of one batch on a surface of
// 719,000 triangles.
bool vtkIndirectPipeline::HasTime() const
{
  constexpr double seconds = 0.4;
  return this->Plan.AddsBatches && !this->Frame.Window->GetEventPending() &&
    vtkIndirectRefinementSchedule::ReadClock() < this->FrameBegan + seconds;
}

//------------------------------------------------------------------------------
// The finished picture is in the images of the first one.
void vtkIndirectPipeline::ReleaseRefinement()
{
  vtkIndirectResource* const all[] = { &this->FinerBounce, &this->FinerSamplers, &this->FinerSky,
    &this->Accumulation };
  for (vtkIndirectResource* resource : all)
  {
    resource->Release(this->Frame.Window);
  }
  this->Paths.Clear();
}

//------------------------------------------------------------------------------
// Returns true if depth maps tell what hides the sky.
bool vtkIndirectPipeline::RefinesSky() const
{
  const Part& sky = this->Parts[1];
  return sky.IsAsked && sky.Light == &this->SkyMaps && this->Plan.SkyIsShadowed;
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::Refines(const Part& part) const
{
  return (this->Plan.RefinesLights && &part == &this->Parts[0]) ||
    (this->RefinesSky() && &part == &this->Parts[1]);
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::DrawMapsOfBatch()
{
  if (!this->DepthMaps.HasRequests())
  {
    return true;
  }
  this->Timer.Begin(vtkIndirectStageTimer::Visibility);
  const bool drawn = this->DepthMaps.Draw(this->Frame, this->Capture);
  this->Timer.End(vtkIndirectStageTimer::Visibility);
  return drawn;
}

//------------------------------------------------------------------------------
// Sums the sky anew where pixels see it through openings that few directions pass, in a picture
// that is to be finished at once. Returns false, after an error, when OpenGL refuses.
bool vtkIndirectPipeline::SumOpening()
{
  this->ShareOfOpening = this->SkyMaps.FindMedianShare();
  this->DirectionsOfOpening = this->Plan.FindDirectionsOfOpening(this->ShareOfOpening);
  if (this->DirectionsOfOpening == 0)
  {
    return true;
  }
  const int batch = std::min(SkyOfOpening, this->DirectionsOfOpening);
  this->FinerSky.SetBatches(batch, this->Plan.SkyTileTexels, BlockOfOpening);
  vtkIndirectFrameLight::Input input = this->MakeInput(this->Bounce.GetVisibility());
  input.Batch.Count = this->DirectionsOfOpening / batch;
  bool done = true;
  vtkIndirectEstimate light;
  for (; done && input.Batch.Number < input.Batch.Count; ++input.Batch.Number)
  {
    done = this->FinerSky.Update(input) && this->DrawMapsOfBatch();
    light = done ? this->FinerSky.MakeEstimate(input) : vtkIndirectEstimate();
    done = light.State != vtkIndirectEstimate::FAILED;
  }
  done = done && this->SkyMaps.TakeShares(input, this->FinerSky) &&
    this->Accumulation.Keep(this->Frame, light.Contributions) &&
    this->Accumulation.Show(this->Frame, this->Parts[1].Result.Contributions, 1.0);
  this->ReleaseRefinement();
  return done;
}

//------------------------------------------------------------------------------
// Sums the light of further points of rectangles, as further frames do, in half of the seconds that
// the picture may take. Returns false, after an error, when OpenGL refuses.
bool vtkIndirectPipeline::SumFurtherPoints(const vtkIndirectFrameLight::Input& input)
{
  Part& part = this->Parts[2];
  const double seconds = this->Plan.RefinementSeconds;
  // Maps that OpenGL has no room for are never there.
  int left = std::numeric_limits<int>::max();
  while (part.IsAsked && part.Result.State == vtkIndirectEstimate::REFINING &&
    part.Light->GetNumberOfTilesLeft() < left &&
    (seconds == 0.0 ||
      vtkIndirectRefinementSchedule::ReadClock() < this->FrameBegan + 0.5 * seconds))
  {
    left = part.Light->GetNumberOfTilesLeft();
    this->UpdatePart(part, input);
    this->SumPart(part, input, part.IsNew && this->DrawMapsOfBatch());
  }
  return !part.IsAsked || part.IsThere;
}

//------------------------------------------------------------------------------
// Returns the picture's contributions that are refined: indirect light, then light from the sky.
std::vector<vtkIndirectContribution> vtkIndirectPipeline::GetRefined() const
{
  std::vector<vtkIndirectContribution> refined;
  for (const Part& part : this->Parts)
  {
    if (this->Refines(part))
    {
      const auto& lights = part.Result.Contributions;
      refined.insert(refined.end(), lights.begin(), lights.end());
    }
  }
  return refined;
}

//------------------------------------------------------------------------------
// Chooses the virtual lights of a batch, and asks for their maps. Returns false, after an error,
// when OpenGL refuses; so do the following functions.
bool vtkIndirectPipeline::UpdateLightsOfBatch(const vtkIndirectFrameLight::Input& input)
{
  vtkVirtualLightSampler* const sampler = this->FinerSamplers.Default;
  const int lights = this->Schedule.GetNumberOfLights();
  sampler->SetNumberOfLights(lights);
  // As many texels for each light as the first picture has.
  this->FinerSamplers.SetFinenessOfSenders(
    std::sqrt(static_cast<double>(lights) / vtkIndirectRefinementSchedule::LightsOfFirst));
  this->FinerSamplers.Choose(this->Frame, this->Plan,
    vtkIndirectSum::Get(this->Estimator)
      .ChooseSampler(vtkIndirectSampler::Get(sampler), this->Plan));
  this->FinerBounce.SetSources(this->Estimator, sampler);
  const vtkIndirectDarkLight dark(this->Frame);
  this->Capture->Attach(this->Frame);
  const bool done = this->UpdateSenderMaps(this->FinerSamplers);
  this->Capture->Detach();
  return done && this->FinerBounce.Update(input);
}

//------------------------------------------------------------------------------
// Sums a batch, and adds the sum to those of the batches before.
bool vtkIndirectPipeline::SumBatch(const vtkIndirectFrameLight::Input& input)
{
  size_t number = 0;
  bool done = true;
  if (this->Plan.RefinesLights)
  {
    // The estimator sums the batch in the picture's images.
    const vtkIndirectEstimate batch = this->FinerBounce.MakeEstimate(input);
    done = batch.State != vtkIndirectEstimate::FAILED;
    for (const vtkIndirectContribution& light : batch.Contributions)
    {
      done = done && this->Accumulation.Add(this->Frame, number++, light, input.Batch.Number == 0);
    }
  }
  if (done && this->RefinesSky())
  {
    const vtkIndirectEstimate light = this->FinerSky.MakeEstimate(input);
    done = light.State != vtkIndirectEstimate::FAILED &&
      (light.State == vtkIndirectEstimate::REFINING ||
        (this->SkyMaps.TakeShares(input, this->FinerSky) &&
          this->Accumulation.Add(this->Frame, number, light.Contributions.front(), true)));
  }
  return done;
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::AddBatch()
{
  Part& part = this->Parts[this->Plan.RefinesLights ? 0 : 1];
  vtkIndirectFrameLight::Input input = this->MakeInput(this->FinerBounce.GetVisibility());
  input.Batch = this->Schedule.GetBatch();
  bool done = true;
  if (this->Schedule.IsAtBegin() &&
    (this->Schedule.GetRefinements() == 0 || this->Accumulation.GetBytes() == 0))
  {
    this->Paths.Clear();
    done = this->Accumulation.Keep(this->Frame, this->GetRefined());
  }
  if (this->Schedule.SumsLights())
  {
    this->FinerSky.SetBatches(SkyOfBatch, FinerTexels * this->Plan.SkyTileTexels, 1);
    done = done && (!this->Plan.RefinesLights || this->UpdateLightsOfBatch(input)) &&
      (!this->RefinesSky() || this->FinerSky.Update(input)) && this->DrawMapsOfBatch() &&
      this->SumBatch(input);
  }
  else if (this->Schedule.IsAtBegin())
  {
    done = done && this->Accumulation.Repeat(this->Frame);
  }
  done = done && (!this->TracesPaths() || this->TracePaths(input));
  const bool isOfLights = this->Schedule.IsOfLights();
  const bool isFiner = done && this->Schedule.EndBatch(vtkIndirectRefinementSchedule::ReadClock());
  part.Time = part.Light->GetEstimateTime();
  if (isFiner)
  {
    this->Accumulation.Finish();
    part.IsThere = this->Accumulation.Show(this->Frame, this->GetRefined(), 1.0);
    done = part.IsThere &&
      (!this->TracesPaths() ||
        (this->CorrectByPaths(isOfLights) &&
          this->Accumulation.Show(this->Frame, this->GetRefined(), 1.0)));
  }
  part.IsThere = done;
  if (done && isFiner && this->MeetsTolerance())
  {
    this->Schedule.End();
  }
  done = done && this->ShowRefinement();
  part.IsThere = done;
  if (!done)
  {
    part.Key.Clear(); // the next frame makes the picture anew
  }
  return done;
}

//------------------------------------------------------------------------------
bool vtkIndirectPipeline::ShowRefinement()
{
  return this->Accumulation.Show(this->Frame, this->GetRefined(), this->Schedule.GetShare());
}

//------------------------------------------------------------------------------
void vtkIndirectPipeline::AddRefinementToReport(vtkIndirectReport& report) const
{
  if (this->DirectionsOfOpening > 0)
  {
    report.Modelled.emplace_back("light from the sky through openings",
      std::to_string(this->DirectionsOfOpening) + " directions, a pixel of " +
        std::to_string(BlockOfOpening * BlockOfOpening) +
        " asks each: half of the pixels see less than " +
        vtkIndirectReport::Number(this->ShareOfOpening, 2) + " of the sky");
  }
  report.MainMemoryBytes += this->Paths.GetBytes();
  if (!this->WhyNoPaths.empty())
  {
    report.LeftOut.emplace_back("correction by path tracing", this->WhyNoPaths);
  }
  const int lights = this->Schedule.GetLightsOfPicture();
  if (lights > 0)
  {
    const int directions = lights / vtkIndirectRefinementSchedule::LightsOfBatch * SkyOfBatch;
    std::string what = this->Plan.RefinesLights ? std::to_string(lights) + " virtual lights" : "";
    what += this->Plan.RefinesLights && this->Plan.LightsTurn
      ? ", each light that follows the camera from its own direction"
      : "";
    if (this->RefinesSky())
    {
      what +=
        (what.empty() ? "" : ", and ") + std::to_string(directions) + " directions of the sky";
    }
    what += this->PathsOfPicture > 0
      ? ", corrected by " + std::to_string(this->PathsOfPicture) + " traced paths"
      : "";
    report.Modelled.emplace_back("refined picture", what);
  }
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
