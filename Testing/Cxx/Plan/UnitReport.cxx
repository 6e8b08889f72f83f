// SPDX-License-Identifier: BSD-3-Clause
// The report's statistics of frame times.
#include "vtkIndirectTestUtilities.h"

#include "Plan/vtkIndirectStageTimer.h"

#include <algorithm>

using namespace vtkIndirectTest;

// The 95th percentile by its definition: the least of the times that at least 95 % of them do not
// exceed. vtkindirect.frames computes the same, with the same test.
VTK_INDIRECT_TEST(Percentile)
{
  Random random(7);
  std::vector<double> times;
  int wrong = 0;
  for (int n = 1; n <= 200; ++n)
  {
    // Some frames take equally long.
    times.push_back(static_cast<double>(random.NextBits() % 300));
    double expected = INFINITY;
    for (const double candidate : times)
    {
      const auto within = std::count_if(
        times.begin(), times.end(), [candidate](double time) { return time <= candidate; });
      expected = 100 * within >= 95 * n ? std::min(expected, candidate) : expected;
    }
    const auto statistics = vtkIndirectStageTimer::Summarize(times);
    wrong += statistics.Percentile95Milliseconds != expected || statistics.Count != n;
  }
  CheckEqual("numbers of frames with another percentile", wrong, 0);
  const auto twenty = [](double last)
  {
    std::vector<double> of(20, 1.0);
    of.back() = last;
    return vtkIndirectStageTimer::Summarize(of);
  };
  CheckEqual("one slow frame of twenty", twenty(9.0).Percentile95Milliseconds, 1.0);
  CheckEqual("the median of it", twenty(9.0).MedianMilliseconds, 1.0);
}
