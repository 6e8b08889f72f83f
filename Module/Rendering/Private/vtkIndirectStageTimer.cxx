// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectGL.h"

#include "vtkIndirectStageTimer.h"

#include <algorithm>
#include <utility>

namespace
{
// Enough for a stable 95th percentile; older frames are dropped.
constexpr size_t MaximumNumberOfFrames = 1000;
}

//------------------------------------------------------------------------------
const char* vtkIndirectStageTimer::GetName(int stage)
{
  static const char* const names[NumberOfStages] = { "delegate", "rsm", "geometry", "lights",
    "visibility", "inject", "bounces", "estimate", "upsample", "composite", "frame" };
  return names[stage];
}

//------------------------------------------------------------------------------
void vtkIndirectStageTimer::BeginFrame()
{
  this->Current.fill(0.0);
  this->Begin(Frame);
}

//------------------------------------------------------------------------------
void vtkIndirectStageTimer::EndFrame()
{
  this->End(Frame);
  if (this->Enabled)
  {
    if (this->Frames.size() == MaximumNumberOfFrames)
    {
      this->Frames.erase(this->Frames.begin());
    }
    this->Frames.push_back(this->Current);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectStageTimer::Begin(Stage stage)
{
  if (this->Enabled)
  {
    glFinish();
    this->Started[stage] = Clock::now();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectStageTimer::End(Stage stage)
{
  if (this->Enabled)
  {
    glFinish();
    this->Current[stage] +=
      std::chrono::duration<double, std::milli>(Clock::now() - this->Started[stage]).count();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectStageTimer::Reset()
{
  this->Frames.clear();
}

//------------------------------------------------------------------------------
vtkIndirectStageTimer::Statistics vtkIndirectStageTimer::Get(int stage) const
{
  return this->GetSum(1u << stage);
}

//------------------------------------------------------------------------------
vtkIndirectStageTimer::Statistics vtkIndirectStageTimer::GetSum(unsigned int stages) const
{
  std::vector<double> times;
  for (const FrameTimes& frame : this->Frames)
  {
    double sum = 0.0;
    for (int i = 0; i < NumberOfStages; ++i)
    {
      sum += (stages >> i) & 1u ? frame[i] : 0.0;
    }
    times.push_back(sum);
  }
  return Summarize(std::move(times));
}

//------------------------------------------------------------------------------
vtkIndirectStageTimer::Statistics vtkIndirectStageTimer::Summarize(std::vector<double> times)
{
  Statistics result;
  result.Count = static_cast<int>(times.size());
  if (!times.empty())
  {
    std::sort(times.begin(), times.end());
    const size_t n = times.size();
    result.MedianMilliseconds = 0.5 * (times[(n - 1) / 2] + times[n / 2]);
    result.Percentile95Milliseconds = times[(95 * n + 99) / 100 - 1];
  }
  return result;
}
