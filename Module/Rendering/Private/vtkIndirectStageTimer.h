// SPDX-License-Identifier: BSD-3-Clause
// Wall-clock time of a frame's stages. Timer queries are not used: on software OpenGL they read a
// few per cent of the time that passes.
#ifndef vtkIndirectStageTimer_h
#define vtkIndirectStageTimer_h

#include <array>  // for stages
#include <chrono> // for time points
#include <vector> // for samples

class vtkIndirectStageTimer
{
public:
  enum Stage
  {
    Delegate,
    ReflectiveShadowMap,
    Geometry,
    Lights,
    Visibility,
    Inject,
    Bounces,
    Estimate,
    Upsample,
    Composite,
    Frame,
    NumberOfStages
  };
  static const char* GetName(int stage);

  /** While on, glFinish brackets each stage, which costs what overlap there would have been. */
  bool Enabled = false;

  void BeginFrame();
  void EndFrame();
  void Begin(Stage stage);
  void End(Stage stage);
  void Reset();

  /** Percentile95Milliseconds: the least of the times that at least 95 % of them do not exceed. */
  struct Statistics
  {
    int Count = 0;
    double MedianMilliseconds = 0.0;
    double Percentile95Milliseconds = 0.0;
  };
  Statistics Get(int stage) const;
  /** Statistics over frames of the sum of some stages; bit i stands for stage i. */
  Statistics GetSum(unsigned int stages) const;
  static Statistics Summarize(std::vector<double> times);
  int GetNumberOfFrames() const { return static_cast<int>(this->Frames.size()); }

private:
  using Clock = std::chrono::steady_clock;
  using FrameTimes = std::array<double, NumberOfStages>;
  std::array<Clock::time_point, NumberOfStages> Started;
  FrameTimes Current{};
  std::vector<FrameTimes> Frames; // milliseconds
};

#endif
