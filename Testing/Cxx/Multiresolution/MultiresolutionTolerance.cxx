// SPDX-License-Identifier: BSD-3-Clause
// ErrorTolerance of multiresolution splatting in random frames not used for its calibration: the
// error of interpolating between subsplats is within it.
#include "vtkIndirectRandomFrame.h"

#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cstdio>

using namespace vtkIndirectTest;

namespace
{
constexpr int Lights = 256; // the default

struct ToleranceFrame : RandomFrame
{
  Image Normal;
  Image Converged; // thresholds of zero: the sum at every pixel over the same lights

  ToleranceFrame(int number, const FrameSize& size, FrameLight light, int mapEdge)
    : RandomFrame(number, size, light)
  {
    this->Sampler->SetNumberOfLights(Lights);
    this->Pass->SetNumberOfRefinements(0);
    this->Pass->SetReflectiveShadowMapResolution(mapEdge);
    this->Converged = this->GatherAll();
    this->Normal = this->Copy("normal");
  }
  Image SplatWithin(double tolerance)
  {
    this->Pass->SetErrorTolerance(tolerance);
    Image image = this->Splat();
    this->Pass->SetErrorTolerance(0.0);
    return image;
  }
};

}

VTK_INDIRECT_TEST(ToleranceInterpolation)
{
  constexpr int frames = 20;
  const std::vector<double> tolerances = { 0.02, 0.05, 0.1, 0.2 };
  std::vector<std::vector<double>> shares(tolerances.size());
  for (int number = 0; number < frames; ++number)
  {
    ToleranceFrame scene(900 + number, { 251 - number, 191 + 2 * number },
      static_cast<FrameLight>(number % NumberOfFrameLights), 128);
    std::printf("       %s: errors over tolerances", scene.Name.c_str());
    for (size_t i = 0; i < tolerances.size(); ++i)
    {
      const Image image = scene.SplatWithin(tolerances[i]);
      shares[i].push_back(FindRelativeError(image, scene.Converged, scene.Normal) / tolerances[i]);
      std::printf(" %.2f", shares[i].back());
    }
    std::printf("\n");
  }
  for (size_t i = 0; i < tolerances.size(); ++i)
  {
    const std::string what = "tolerance " + std::to_string(tolerances[i]).substr(0, 4) + ": ";
    CheckAtMost(what + "error over it, median frame", Percentile(shares[i], 0.5), 0.4,
      "measured 0.11 to 0.29");
    CheckAtMost(what + "frames beyond it",
      std::count_if(shares[i].begin(), shares[i].end(), [](double share) { return share > 1.0; }),
      4, "measured 3 or 4: spots narrower than a subsplat");
  }
}
