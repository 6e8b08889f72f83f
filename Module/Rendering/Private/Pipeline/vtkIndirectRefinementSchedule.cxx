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
// Batches that are there are of another number of lights when the seconds change.
void vtkIndirectRefinementSchedule::SetLimits(const LimitType& limits, double now)
{
  const bool differ = limits.Seconds != this->Limits.Seconds;
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
  this->IsMeasured = this->HasEnded = false;
  this->Began = this->LastEnd = now;
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
  return this->Limits.Seconds > 0.0 ? this->Lights : LightsOfFirst << (2 * (this->Refinement + 1));
}

//------------------------------------------------------------------------------
vtkIndirectLightBatch vtkIndirectRefinementSchedule::GetBatch() const
{
  return { this->Batches, this->GetNumberOfLights() / LightsOfBatch };
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
  if (this->Batches < this->GetBatch().Count)
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
// Chooses the number of lights by the time of the last batch.
void vtkIndirectRefinementSchedule::Measure(double now)
{
  this->IsMeasured = true;
  const double left = this->Began + this->Limits.Seconds - now;
  const double most = LightsOfFirst << (2 * this->Limits.Refinements);
  const double batches = left / std::max(now - this->LastEnd, 1.0e-6);
  const int anew = static_cast<int>(std::clamp(batches, 0.0, most / LightsOfBatch)) * LightsOfBatch;
  const bool goesOn = batches >= this->GetBatch().Count - this->Batches;
  if (anew >= FewestLights && (!goesOn || anew > WorthAnew * this->Lights))
  {
    this->Lights = anew;
    this->Batches = 0;
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
    batches += ahead.GetBatch().Count;
  }
  const long long fade = StepsOfFade - this->Fade;
  return std::max(batches - this->Batches, fade) +
    (batches > 0 && this->Limits.Fades ? StepsOfFade - 1 : 0);
}
