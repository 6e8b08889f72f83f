// SPDX-License-Identifier: BSD-3-Clause
// Times of a frame's stages: by wall clock, and by the GPU's own clock if OpenGL has timer queries.
// Mesa's llvmpipe starts that clock with a stage's first pixel: vertices are left out.
#pragma once

#include "vtkOpenGLRenderWindow.h" // for the weak pointer
#include "vtkWeakPointer.h"        // for members

#include <array>  // for stages
#include <chrono> // for time points
#include <vector> // for samples

class vtkIndirectStageTimer
{
public:
  vtkIndirectStageTimer() = default;
  ~vtkIndirectStageTimer();
  vtkIndirectStageTimer(const vtkIndirectStageTimer&) = delete;
  void operator=(const vtkIndirectStageTimer&) = delete;

  enum Stage
  {
    Delegate,
    ReflectiveShadowMap,
    Geometry,
    Lights,
    Visibility,
    Sky,
    Area,
    Inject,
    Bounces,
    Estimate,
    Upsample,
    Composite,
    Frame,
    NumberOfStages
  };
  static const char* GetName(int stage);

  /** If true, glFinish brackets each stage, which costs the overlap of stages. */
  bool Enabled = false;

  /** window: its context is current until the frame ends. */
  void BeginFrame(vtkOpenGLRenderWindow* window);
  void EndFrame();
  /** A stage may begin several times in a frame, and within another; not within itself. */
  void Begin(Stage stage);
  void End(Stage stage);
  void Reset() { this->Frames.clear(); }
  /** Releases the queries; times stay. */
  void Release();

  /**
   * Percentile95Milliseconds: the smallest of the times that at least 95 % of them do not exceed.
   */
  struct Statistics
  {
    int Count = 0;
    double MedianMilliseconds = 0.0;
    double Percentile95Milliseconds = 0.0;
  };
  enum Clock
  {
    Wall,
    GPU // over the frames whose OpenGL had queries
  };
  Statistics Get(int stage, Clock clock = Wall) const { return this->GetSum(1u << stage, clock); }
  /** Returns statistics over frames of the sum of some stages; bit i selects stage i. */
  Statistics GetSum(unsigned int stages, Clock clock = Wall) const;
  static Statistics Summarize(std::vector<double> times);
  int GetNumberOfFrames() const { return static_cast<int>(this->Frames.size()); }

private:
  using SteadyClock = std::chrono::steady_clock;
  using Times = std::array<double, NumberOfStages>; // milliseconds
  struct FrameTimes
  {
    Times OfWall{};
    Times OfGPU{};
    bool HasGPU = false;
  };
  // This is an interval of the GPU's clock in a frame, by the numbers of its queries.
  struct Interval
  {
    int Stage;
    size_t Begin;
    size_t End; // 0: not ended
  };

  size_t Query();
  double Measure(const Interval& interval) const;
  void ReadQueries();

  std::array<SteadyClock::time_point, NumberOfStages> Started;
  FrameTimes Current;
  std::vector<FrameTimes> Frames;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // window of the queries
  int CounterBits = 0;               // bits of the GPU's clock; 0: there are no timer queries
  std::vector<unsigned int> Queries; // queries, reused in each frame
  size_t NumberOfUsedQueries = 0;
  std::vector<Interval> Intervals;
};
