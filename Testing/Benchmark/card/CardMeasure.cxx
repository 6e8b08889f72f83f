// SPDX-License-Identifier: BSD-3-Clause
#include "CardMeasure.h"

#include "CardScene.h"

#include "Plan/vtkIndirectStageTimer.h"
#include "vtkCamera.h"
#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkIndirectIlluminationPass.h"
#include "vtkOpenGLRenderTimer.h"

#include <chrono>
#include <functional>
#include <vector>

using Json = nlohmann::json;

namespace
{
// Enough for a median and, on a card, a 95th percentile; a slow one is not asked for so many.
constexpr int MinimumNumberOfFrames = 3;
constexpr int MaximumNumberOfFrames = 40;
constexpr double LongEnough = 0.8; // seconds

using Clock = std::chrono::steady_clock;

double GetMilliseconds(Clock::time_point since)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - since).count();
}

bool IsEnough(int frames, Clock::time_point since)
{
  return frames >= MinimumNumberOfFrames &&
    (frames >= MaximumNumberOfFrames || GetMilliseconds(since) > 1000.0 * LongEnough);
}

// Time on the card between two points of the stream of commands; null where it cannot be asked.
class Stopwatch
{
public:
  void Start()
  {
    this->Timer.Reset();
    this->Timer.Start();
  }
  void Stop() { this->Timer.Stop(); }
  /** After the commands have finished. */
  bool Read(double& milliseconds)
  {
    if (!vtkOpenGLRenderTimer::IsSupported() || !this->Timer.Ready())
    {
      return false;
    }
    milliseconds = this->Timer.GetElapsedMilliseconds();
    return true;
  }
  void Release() { this->Timer.ReleaseGraphicsResources(); }

private:
  vtkOpenGLRenderTimer Timer;
};

Json MakeRow(const char* stage, const std::vector<double>& wall, const std::vector<double>& gpu)
{
  // As the stages of a report are summarized.
  const auto byWall = vtkIndirectStageTimer::Summarize(wall);
  Json row = { { "stage", stage }, { "frames", byWall.Count }, { "gpu_ms", nullptr },
    { "gpu_p95_ms", nullptr }, { "wall_ms", byWall.MedianMilliseconds },
    { "wall_p95_ms", byWall.Percentile95Milliseconds } };
  if (gpu.size() == wall.size())
  {
    const auto byGPU = vtkIndirectStageTimer::Summarize(gpu);
    row["gpu_ms"] = byGPU.MedianMilliseconds;
    row["gpu_p95_ms"] = byGPU.Percentile95Milliseconds;
  }
  return row;
}

// Frames one by one, each finished before the next; `before` is called before each.
Json MeasureFrames(card::Scene& scene, const char* stage, const std::function<void(int)>& before)
{
  std::vector<double> wall;
  std::vector<double> gpu;
  Stopwatch stopwatch;
  before(0);
  scene.Window->Render(); // what is built once
  const Clock::time_point since = Clock::now();
  for (int frame = 1; !IsEnough(frame - 1, since); ++frame)
  {
    before(frame);
    scene.Window->WaitForCompletion();
    const Clock::time_point begin = Clock::now();
    stopwatch.Start();
    scene.Window->Render();
    stopwatch.Stop();
    scene.Window->WaitForCompletion();
    wall.push_back(GetMilliseconds(begin));
    double milliseconds = 0.0;
    if (stopwatch.Read(milliseconds))
    {
      gpu.push_back(milliseconds);
    }
  }
  stopwatch.Release();
  return MakeRow(stage, wall, gpu);
}

// As many frames as were measured one by one, without waiting between them.
Json MeasureInFlight(card::Scene& scene, int frames)
{
  Stopwatch stopwatch;
  scene.Window->WaitForCompletion();
  const Clock::time_point begin = Clock::now();
  stopwatch.Start();
  for (int i = 0; i < frames; ++i)
  {
    scene.Window->Render();
  }
  stopwatch.Stop();
  scene.Window->WaitForCompletion();
  const double wall = GetMilliseconds(begin) / frames;
  double gpu = 0.0;
  Json row = MakeRow("frames in flight", { wall },
    stopwatch.Read(gpu) ? std::vector<double>{ gpu / frames } : std::vector<double>{});
  row["frames"] = frames;
  stopwatch.Release();
  return row;
}

// The stages of the report, and what else it says.
void AddStages(card::Scene& scene, vtkIndirectIlluminationPass* pass, Json& result)
{
  pass->SetTiming(true);
  const Clock::time_point since = Clock::now();
  int frames = 0;
  for (; !IsEnough(frames, since); ++frames)
  {
    scene.Window->Render();
  }
  const Json report = Json::parse(pass->GetReport(false));
  pass->SetTiming(false);
  for (const auto& [stage, times] : report.at("stages").items())
  {
    result["rows"].push_back({ { "stage", stage }, { "frames", frames },
      { "gpu_ms", times.contains("gpu_median_ms") ? times.at("gpu_median_ms") : Json() },
      { "gpu_p95_ms", times.contains("gpu_p95_ms") ? times.at("gpu_p95_ms") : Json() },
      { "wall_ms", times.at("median_ms") }, { "wall_p95_ms", times.at("p95_ms") } });
  }
  result["bytes"] = report.at("bytes");
  result["virtual_lights"] = report.at("virtual_lights");
  result["indirect_ms"] = report.at("indirect_ms");
  result["gpu_indirect_ms"] =
    report.contains("gpu_indirect_ms") ? report.at("gpu_indirect_ms") : Json();
  result["report"] = report;
}
}

//------------------------------------------------------------------------------
Json card::Measure(Scene& scene, vtkIndirectIlluminationPass* pass)
{
  Json result = { { "rows", Json::array() } };
  if (pass)
  {
    pass->SetCaching(false);
  }
  result["rows"].push_back(MeasureFrames(scene, "frame", [](int) {}));
  result["rows"].push_back(MeasureInFlight(scene, result["rows"][0].at("frames")));
  if (pass)
  {
    AddStages(scene, pass, result);
    pass->SetCaching(true);
  }
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  vtkNew<vtkCamera> before;
  before->DeepCopy(camera);
  // To and fro, so that what is in view stays the same.
  constexpr double angle = 0.25; // degrees
  result["rows"].push_back(MeasureFrames(
    scene, "camera turns", [&](int frame) { camera->Azimuth(frame % 2 == 0 ? angle : -angle); }));
  camera->DeepCopy(before);
  return result;
}
