// SPDX-License-Identifier: BSD-3-Clause
// Numbers of lights, batches and frames that refine a still picture.
#include "Pipeline/vtkIndirectRefinementSchedule.h"
#include "vtkIndirectTestUtilities.h"

#include <algorithm>
#include <string>
#include <vector>

using namespace vtkIndirectTest;

namespace
{
using Schedule = vtkIndirectRefinementSchedule;

// A refinement whose batches take so many seconds each, the first one more than that, after a
// picture.
struct Run
{
  double Picture = 1.0;
  double Batch = 0.1;
  double First = 0.5;

  double Now = 0.0;
  int Batches = 0;
  int Lights = 0; // of the last refinement that is there

  Schedule Do(const Schedule::LimitType& limits)
  {
    Schedule schedule;
    schedule.SetLimits(limits, 0.0);
    schedule.Restart(0.0);
    this->Now = this->Picture;
    this->Batches = this->Lights = 0;
    schedule.BeginFrame(this->Now);
    while (schedule.HasBatch())
    {
      this->Now += this->Batches == 0 ? this->First : this->Batch;
      ++this->Batches;
      const int lights = schedule.GetNumberOfLights();
      this->Lights = schedule.EndBatch(this->Now) ? lights : this->Lights;
    }
    return schedule;
  }
};
}

VTK_INDIRECT_TEST(RefinementsWithoutLimit)
{
  Run run;
  Schedule schedule = run.Do({ 3, 0.0, false });
  CheckEqual("refinements", schedule.GetRefinements(), 3);
  CheckEqual("lights of the last one", run.Lights, 32768);
  CheckEqual("batches", run.Batches, (2048 + 8192 + 32768) / 64);
  CheckEqual("frames left", static_cast<int>(schedule.CountFramesLeft()), 0);
  schedule.Restart(5.0);
  CheckEqual("frames of the next picture", static_cast<int>(schedule.CountFramesLeft()), 672);
  schedule.Refuse();
  CheckEqual("frames after a refusal", static_cast<int>(schedule.CountFramesLeft()), 0);
  schedule.Forgive();
  CheckEqual("frames after that", static_cast<int>(schedule.CountFramesLeft()), 672);
}

// The seconds that are left after two batches decide.
VTK_INDIRECT_TEST(RefinementWithinSeconds)
{
  struct Case
  {
    const char* What;
    double Seconds;
    int Refinements;
    int Lights; // 0: the first picture stays
  };
  const Case cases[] = {
    { "no time for a batch", 0.9, 3, 0 },
    { "no time for the second one", 1.1, 3, 0 },
    { "time for 15 batches", 1.6 + 1.55, 3, 0 },
    { "time for 16 batches", 1.6 + 1.65, 3, 16 * 64 },
    { "time for the rest of 32 batches", 1.6 + 3.05, 3, 2048 },
    { "time for 39 batches", 1.6 + 3.95, 3, 2048 },
    { "time for 100 batches", 1.6 + 10.05, 3, 6400 },
    { "time for more than there is", 1.0e6, 3, 32768 },
    { "time for more than is asked for", 1.0e6, 2, 8192 },
    { "one refinement", 1.0e6, 1, 2048 },
  };
  for (const Case& c : cases)
  {
    Run run;
    const Schedule schedule = run.Do({ c.Refinements, c.Seconds, false });
    CheckEqual(std::string(c.What) + ": lights", run.Lights, c.Lights);
    Check(std::string(c.What) + ": batches", (run.Batches == 0) == (c.Seconds <= run.Picture));
    CheckEqual(std::string(c.What) + ": refinements", schedule.GetRefinements(), c.Lights ? 1 : 0);
    Check(std::string(c.What) + ": in time",
      run.Now <= std::max(c.Seconds, run.Picture + run.First + run.Batch) + 1.0e-9);
    // At most a fifth of the time stays unused, where lights are left and there is time for some.
    Check(std::string(c.What) + ": the time is used",
      c.Lights == 0 || c.Lights == 512 << (2 * c.Refinements) || run.Now >= 0.8 * c.Seconds);
  }
}

// Batches of one number of lights are not added to those of another.
VTK_INDIRECT_TEST(RefinementWithOtherSeconds)
{
  Schedule schedule;
  schedule.SetLimits({ 2, 0.0, false }, 0.0);
  schedule.Restart(0.0);
  for (int i = 0; i < 132; ++i)
  {
    schedule.EndBatch(0.01 * i);
  }
  CheckEqual("batches of 8192 lights", schedule.GetBatch().Number, 100);
  schedule.SetLimits({ 2, 100.0, false }, 5.0);
  CheckEqual("batches within seconds", schedule.GetBatch().Number, 0);
  CheckEqual("lights", schedule.GetNumberOfLights(), 2048);
  CheckEqual("refinements that stay", schedule.GetRefinements(), 1);
}

// On a screen, eight frames bring a finer picture; the next batches come meanwhile.
VTK_INDIRECT_TEST(RefinementsFade)
{
  Schedule schedule;
  schedule.SetLimits({ 2, 0.0, true }, 0.0);
  schedule.Restart(0.0);
  std::vector<double> shares;
  long long left = schedule.CountFramesLeft();
  CheckEqual("frames", static_cast<int>(left), 32 + 128 + 7);
  int wrong = 0;
  while (schedule.CountFramesLeft() > 0)
  {
    schedule.BeginFrame(0.0);
    if (schedule.HasBatch())
    {
      schedule.EndBatch(0.0);
    }
    shares.push_back(schedule.GetShare());
    wrong += schedule.CountFramesLeft() != left - 1;
    left = schedule.CountFramesLeft();
  }
  CheckEqual("frames that leave another number", wrong, 0);
  CheckEqual("frames drawn", static_cast<int>(shares.size()), 167);
  for (const size_t last : { size_t(31), size_t(159) })
  {
    for (size_t i = 0; i < 8; ++i)
    {
      CheckEqual("share", shares[last + i], (static_cast<double>(i) + 1.0) / 8.0);
    }
    CheckEqual("share before", shares[last - 1], 1.0);
  }
}

// With paths, lights end at 2048: further refinements trace rounds of paths alone, as many batches
// as lights would be.
VTK_INDIRECT_TEST(RefinementsWithPaths)
{
  Schedule schedule;
  schedule.SetLimits({ 2, 0.0, false, false }, 0.0);
  schedule.Restart(0.0);
  int summed = 0;
  int begun = 0;
  int finished = 0;
  std::vector<int> traced(32, 0);
  for (; schedule.HasBatch(); finished += schedule.EndBatch(0.0))
  {
    CheckEqual("lights", schedule.GetNumberOfLights(), 2048);
    summed += schedule.SumsLights();
    begun += schedule.IsAtBegin();
    ++traced[static_cast<size_t>(schedule.GetPart().Number)];
  }
  CheckEqual("batches of lights", summed, 32);
  CheckEqual("refinements that begin", begun, 2);
  CheckEqual("refinements that end", finished, 2);
  Check("each part has five rounds", traced == std::vector<int>(32, 5));
  CheckEqual("lights of the picture", schedule.GetLightsOfPicture(), 2048);
}

// Where lights grow, paths are those of as many rounds.
VTK_INDIRECT_TEST(RefinementsOfLightsAndPaths)
{
  Schedule schedule;
  schedule.SetLimits({ 2, 0.0, false, true }, 0.0);
  schedule.Restart(0.0);
  int summed = 0;
  std::vector<int> traced(32, 0);
  for (; schedule.HasBatch(); schedule.EndBatch(0.0))
  {
    summed += schedule.SumsLights();
    ++traced[static_cast<size_t>(schedule.GetPart().Number)];
  }
  CheckEqual("batches of lights", summed, 32 + 128);
  Check("each part has five rounds", traced == std::vector<int>(32, 5));
  CheckEqual("lights of the picture", schedule.GetLightsOfPicture(), 8192);
}

// Within seconds, rounds are added as long as there is time.
VTK_INDIRECT_TEST(PathsWithinSeconds)
{
  struct Case
  {
    const char* What;
    double Seconds;
    int Refinements;
    int Lights;
    int Rounds;
  };
  // The first batch takes 0.5 seconds, each other one 0.1.
  const Case cases[] = {
    { "no time for a batch", 0.9, 3, 0, 0 },
    { "time for 20 batches of lights", 1.6 + 2.05, 3, 20 * 64, 1 },
    { "time for all lights", 1.6 + 3.05, 3, 2048, 1 },
    { "time for two more rounds", 1.6 + 3.0 + 7.0, 3, 2048, 3 },
    { "time for more than is asked for", 1.0e6, 2, 2048, 4 },
  };
  for (const Case& c : cases)
  {
    Run run;
    run.Do({ c.Refinements, c.Seconds, false, false });
    CheckEqual(std::string(c.What) + ": lights", run.Lights, c.Lights);
    const int anew = c.Lights > 0 && c.Lights < 2048 ? 2 : 0; // batches that measure the time
    CheckEqual(std::string(c.What) + ": batches", c.Lights > 0 ? run.Batches - anew : 0,
      c.Rounds * c.Lights / 64);
    Check(std::string(c.What) + ": in time",
      run.Now <= std::max(c.Seconds, run.Picture + run.First + run.Batch) + 1.0e-9);
  }
}
