// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Plan/vtkIndirectStageTimer.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace
{
// Enough for a stable 95th percentile; older frames are dropped.
constexpr size_t MaximumNumberOfFrames = 1000;

// Returns the bits of the GPU's clock that the current context can read; 0 without timer queries.
int FindCounterBits()
{
  GLint version[2] = { 0, 0 };
  glGetIntegerv(GL_MAJOR_VERSION, &version[0]);
  glGetIntegerv(GL_MINOR_VERSION, &version[1]);
  bool has = version[0] > 3 || (version[0] == 3 && version[1] >= 3);
  GLint extensions = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &extensions);
  for (GLint i = 0; i < extensions && !has; ++i)
  {
    const auto* name =
      reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    has = name && std::strcmp(name, "GL_ARB_timer_query") == 0;
  }
  // The loader may not have loaded an extension's functions.
  if (!has || !glQueryCounter || !glGetQueryObjectui64v)
  {
    return 0;
  }
  GLint bits = 0;
  glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
  return bits;
}
}

//------------------------------------------------------------------------------
vtkIndirectStageTimer::~vtkIndirectStageTimer()
{
  if (this->Window && !this->Queries.empty())
  {
    this->Window->MakeCurrent();
    this->Release();
  }
}

//------------------------------------------------------------------------------
const char* vtkIndirectStageTimer::GetName(int stage)
{
  static const char* const names[NumberOfStages] = { "delegate", "rsm", "geometry", "lights",
    "visibility", "sky", "area", "inject", "bounces", "estimate", "upsample", "composite",
    "frame" };
  return names[stage];
}

//------------------------------------------------------------------------------
void vtkIndirectStageTimer::BeginFrame(vtkOpenGLRenderWindow* window)
{
  this->Current = FrameTimes();
  this->NumberOfUsedQueries = 0;
  this->Intervals.clear();
  if (this->Enabled && window != this->Window)
  {
    // A pass releases its window, with these queries, before it uses another one.
    this->Window = window;
    this->CounterBits = FindCounterBits();
  }
  this->Begin(Frame);
}

//------------------------------------------------------------------------------
void vtkIndirectStageTimer::EndFrame()
{
  this->End(Frame);
  if (this->Enabled)
  {
    this->ReadQueries();
    if (this->Frames.size() == MaximumNumberOfFrames)
    {
      this->Frames.erase(this->Frames.begin());
    }
    this->Frames.push_back(this->Current);
  }
}

//------------------------------------------------------------------------------
// The wall clock's interval contains the GPU's: the wall clock is read before and after the GPU's.
void vtkIndirectStageTimer::Begin(Stage stage)
{
  if (this->Enabled)
  {
    glFinish();
    this->Started[stage] = SteadyClock::now();
    if (this->CounterBits > 0)
    {
      this->Intervals.push_back({ stage, this->Query(), 0 });
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectStageTimer::End(Stage stage)
{
  if (this->Enabled)
  {
    // Intervals that an error left open are skipped.
    const auto open = std::find_if(this->Intervals.rbegin(), this->Intervals.rend(),
      [stage](const Interval& interval) { return interval.Stage == stage; });
    if (open != this->Intervals.rend() && open->End == 0)
    {
      open->End = this->Query();
    }
    glFinish();
    this->Current.OfWall[stage] +=
      std::chrono::duration<double, std::milli>(SteadyClock::now() - this->Started[stage]).count();
  }
}

//------------------------------------------------------------------------------
// Makes the GPU record its time; returns the query's place, which is never 0 for the end of an
// interval.
size_t vtkIndirectStageTimer::Query()
{
  const size_t place = this->NumberOfUsedQueries++;
  if (place == this->Queries.size())
  {
    GLuint query = 0;
    glGenQueries(1, &query);
    this->Queries.push_back(query);
  }
  glQueryCounter(this->Queries[place], GL_TIMESTAMP);
  return place;
}

//------------------------------------------------------------------------------
// Returns milliseconds; waits for the queries.
double vtkIndirectStageTimer::Measure(const Interval& interval) const
{
  uint64_t passed = 0;
  GLuint64 begin = 0;
  GLuint64 end = 0;
  glGetQueryObjectui64v(this->Queries[interval.Begin], GL_QUERY_RESULT, &begin);
  glGetQueryObjectui64v(this->Queries[interval.End], GL_QUERY_RESULT, &end);
  // The clock may have wrapped around in between, and its times may be slightly out of order.
  const uint64_t mask = ~uint64_t{ 0 } >> (64 - std::min(this->CounterBits, 64));
  passed = (end - begin) & mask;
  passed = passed > mask / 2 ? 0 : passed;
  return 1e-6 * static_cast<double>(passed);
}

//------------------------------------------------------------------------------
void vtkIndirectStageTimer::ReadQueries()
{
  this->Current.HasGPU = this->CounterBits > 0;
  for (const Interval& interval : this->Intervals)
  {
    if (interval.End > 0)
    {
      this->Current.OfGPU[interval.Stage] += this->Measure(interval);
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectStageTimer::Release()
{
  if (!this->Queries.empty())
  {
    glDeleteQueries(static_cast<GLsizei>(this->Queries.size()), this->Queries.data());
  }
  this->Queries.clear();
  this->Intervals.clear();
  this->Window = nullptr;
  this->CounterBits = 0;
}

//------------------------------------------------------------------------------
vtkIndirectStageTimer::Statistics vtkIndirectStageTimer::GetSum(
  unsigned int stages, Clock clock) const
{
  std::vector<double> times;
  for (const FrameTimes& frame : this->Frames)
  {
    if (clock == GPU && !frame.HasGPU)
    {
      continue;
    }
    const Times& ofFrame = clock == GPU ? frame.OfGPU : frame.OfWall;
    double sum = 0.0;
    for (int i = 0; i < NumberOfStages; ++i)
    {
      sum += (stages >> i) & 1u ? ofFrame[i] : 0.0;
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
