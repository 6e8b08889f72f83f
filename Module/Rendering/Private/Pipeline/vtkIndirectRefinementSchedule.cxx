// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkIndirectRefinementSchedule.h"

#include <algorithm>
#include <chrono>

namespace
{
// Batches that measure the time of one: the first one builds shaders and chooses the lights.
constexpr int MeasuredBatches = 2;
// A refinement of fewer lights is not nearer to the truth than the picture.
constexpr int FewestLights = 2 * vtkIndirectRefinementSchedule::LightsOfFirst;
// A refinement of so many times the lights is worth summing its first batches once more.
constexpr double WorthAnew = 1.25;
}

//------------------------------------------------------------------------------
double vtkIndirectRefinementSchedule::ReadClock()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

//------------------------------------------------------------------------------
// With other seconds, or with paths, the batches that are there are of another number of lights.
void vtkIndirectRefinementSchedule::SetLimits(const LimitType& limits, double now)
{
  const bool differ = limits.Seconds != this->Limits.Seconds || limits.Grows != this->Limits.Grows;
  this->Limits = limits;
  if (differ)
  {
    this->Begin(now);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectRefinementSchedule::Restart(double now)
{
  this->Refinement = this->Finished = 0;
  this->Fade = StepsOfFade;
  this->Begin(now);
}

//------------------------------------------------------------------------------
// Begins the next refinement.
void vtkIndirectRefinementSchedule::Begin(double now)
{
  this->Batches = 0;
  this->Lights = 4 * LightsOfFirst;
  this->Rounds = 1;
  this->IsMeasured = this->HasEnded = false;
  this->Began = this->LastEnd = this->RoundBegan = now;
}

//------------------------------------------------------------------------------
void vtkIndirectRefinementSchedule::BeginFrame(double now)
{
  this->Fade = std::min(this->Fade + 1, StepsOfFade);
  this->HasEnded = this->HasEnded ||
    (this->Limits.Seconds > 0.0 && this->Batches == 0 && now >= this->Began + this->Limits.Seconds);
}

//------------------------------------------------------------------------------
bool vtkIndirectRefinementSchedule::HasBatch() const
{
  const int most =
    this->Limits.Seconds > 0.0 ? std::min(this->Limits.Refinements, 1) : this->Limits.Refinements;
  return this->Refinement < most && !this->IsRefused && !this->HasEnded;
}

//------------------------------------------------------------------------------
int vtkIndirectRefinementSchedule::GetNumberOfLights() const
{
  const int lights =
    this->Limits.Seconds > 0.0 ? this->Lights : LightsOfFirst << (2 * (this->Refinement + 1));
  return this->Limits.Grows ? lights : std::min(lights, MostLightsWithPaths);
}

//------------------------------------------------------------------------------
// Returns the number of batches of the refinement. A round of paths is as many as all lights are.
int vtkIndirectRefinementSchedule::CountBatches() const
{
  const int batches = this->GetNumberOfLights() / LightsOfBatch;
  return this->Limits.Grows      ? batches
    : this->Limits.Seconds > 0.0 ? batches * this->Rounds
                                 : batches << (2 * this->Refinement);
}

//------------------------------------------------------------------------------
vtkIndirectLightBatch vtkIndirectRefinementSchedule::GetBatch() const
{
  const int count = this->GetNumberOfLights() / LightsOfBatch;
  return { this->Batches % count, count };
}

//------------------------------------------------------------------------------
vtkIndirectLightBatch vtkIndirectRefinementSchedule::GetPart() const
{
  const int count = std::min(this->GetNumberOfLights(), MostLightsWithPaths) / LightsOfBatch;
  return { this->Batches % count, count };
}

//------------------------------------------------------------------------------
bool vtkIndirectRefinementSchedule::SumsLights() const
{
  return this->IsOfLights() && this->Batches < this->GetNumberOfLights() / LightsOfBatch;
}

//------------------------------------------------------------------------------
bool vtkIndirectRefinementSchedule::EndBatch(double now)
{
  ++this->Batches;
  if (this->Limits.Seconds > 0.0 && !this->IsMeasured && this->Batches == MeasuredBatches)
  {
    this->Measure(now);
  }
  this->LastEnd = now;
  if (this->Batches < this->CountBatches() || this->AddsRound(now))
  {
    return false;
  }
  this->Batches = 0;
  this->Finished = this->GetNumberOfLights();
  ++this->Refinement;
  this->Fade = this->Limits.Fades ? 1 : StepsOfFade;
  return true;
}

//------------------------------------------------------------------------------
// Adds a round of paths if there is time for one that takes as long as the last one.
bool vtkIndirectRefinementSchedule::AddsRound(double now)
{
  const bool adds = !this->Limits.Grows && this->Limits.Seconds > 0.0 && !this->HasEnded &&
    this->Rounds < 1 << (2 * (this->Limits.Refinements - 1)) &&
    now + (now - this->RoundBegan) <= this->Began + this->Limits.Seconds;
  this->Rounds += adds ? 1 : 0;
  this->RoundBegan = now;
  return adds;
}

//------------------------------------------------------------------------------
// Chooses the number of lights by the time of the last batch.
void vtkIndirectRefinementSchedule::Measure(double now)
{
  this->IsMeasured = true;
  const double left = this->Began + this->Limits.Seconds - now;
  const int most =
    this->Limits.Grows ? LightsOfFirst << (2 * this->Limits.Refinements) : MostLightsWithPaths;
  const double batches = left / std::max(now - this->LastEnd, 1.0e-6);
  const int anew =
    static_cast<int>(std::clamp(batches, 0.0, 1.0 * most / LightsOfBatch)) * LightsOfBatch;
  const bool goesOn = batches >= this->CountBatches() - this->Batches;
  if (anew >= FewestLights && (!goesOn || anew > WorthAnew * this->Lights))
  {
    this->Lights = anew;
    this->Batches = 0;
    this->RoundBegan = now;
  }
  else
  {
    this->HasEnded = !goesOn;
  }
}

//------------------------------------------------------------------------------
double vtkIndirectRefinementSchedule::GetShare() const
{
  return static_cast<double>(this->Fade) / StepsOfFade;
}

//------------------------------------------------------------------------------
long long vtkIndirectRefinementSchedule::CountFramesLeft() const
{
  long long batches = 0;
  vtkIndirectRefinementSchedule ahead = *this;
  for (; ahead.HasBatch(); ++ahead.Refinement)
  {
    batches += ahead.CountBatches();
  }
  const long long fade = StepsOfFade - this->Fade;
  return std::max(batches - this->Batches, fade) +
    (batches > 0 && this->Limits.Fades ? StepsOfFade - 1 : 0);
}
