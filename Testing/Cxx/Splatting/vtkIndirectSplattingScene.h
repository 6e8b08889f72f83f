// SPDX-License-Identifier: BSD-3-Clause
// Random scenes, summed by splats and by the gather of the same lights.
#ifndef vtkIndirectSplattingScene_h
#define vtkIndirectSplattingScene_h

#include "Multiresolution/vtkIndirectRandomFrame.h"
#include "vtkIndirectForcedPath.h"    // for the way
#include "vtkIndirectSplattingPass.h" // for members
#include "vtkUniformLightSampler.h"   // for the number of lights

#include <algorithm>        // for bounds
#include <cmath>            // for finite values
#include <initializer_list> // for thresholds
#include <string>           // for names
#include <vector>           // for errors

namespace vtkIndirectTest
{
/** Method of summing splats. */
enum class SplatWay
{
  TILES,
  ELLIPSOIDS
};
constexpr int NumberOfSplatWays = 2;
/** Pixels below this share of the brightest one are not compared. */
constexpr double Least = 1e-4;
inline const char* GetName(SplatWay way)
{
  return way == SplatWay::TILES ? "tiles" : "ellipsoids";
}

/** Adds splatting to a scene. */
template <typename Base>
struct SplattingFrameOf : Base
{
  using Base::Base;

  vtkNew<vtkIndirectSplattingPass> Splats;

  Image SplatLights(SplatWay way)
  {
    const vtkIndirectForcedPath path(way == SplatWay::TILES ? "compute=on" : "compute=off");
    this->Splats->Modified();
    this->Pass->SetEstimator(this->Splats);
    this->Render();
    return this->Copy("irradiance");
  }

  /** Returns the share of the irradiance beyond the bounds, which the report has in per cent. */
  double ReadCutOffShare()
  {
    const std::string report = this->Pass->GetReport();
    const std::string why = "\"why\": \"";
    size_t at = report.find("\"light beyond the bounds of splats\"");
    at = at == std::string::npos ? at : report.find(why, at);
    return at == std::string::npos ? 0.0 : std::stod(report.substr(at + why.size())) / 100.0;
  }
};
using SplattingFrame = SplattingFrameOf<RandomFrame>;

inline double Sum(const Image& image)
{
  double sum = 0.0;
  for (float value : image.Values)
  {
    sum += value;
  }
  return sum;
}

inline bool IsFinite(const Image& image)
{
  return std::all_of(image.Values.begin(), image.Values.end(),
    [](float value) { return std::isfinite(value) && value >= 0.0f; });
}

/** The lowest intensity that counts, over a squared distance, at a threshold of 0.05: of the mean
 * of the nonzero intensities at a twentieth of the scene's diagonal. */
inline double FindLowest(Scene& scene, const std::vector<double>& intensities)
{
  double bounds[6];
  scene.Renderer->ComputeVisiblePropBounds(bounds);
  const double diagonal = std::sqrt(std::pow(bounds[1] - bounds[0], 2.0) +
    std::pow(bounds[3] - bounds[2], 2.0) + std::pow(bounds[5] - bounds[4], 2.0));
  const double length = diagonal / 20.0;
  double sum = 0.0;
  double count = 0.0;
  for (double intensity : intensities)
  {
    sum += intensity;
    count += intensity > 0.0 ? 1.0 : 0.0;
  }
  return 0.05 * sum / std::max(count, 1.0) / (length * length);
}

/** Adds the distance of a pixel from the range between its sure light and its sure and unsure
 * light, each component over the sure part or `least`. */
inline void AddErrors(const glm::dvec3& value, const glm::dvec3& sure, const glm::dvec3& unsure,
  double least, std::vector<double>& errors)
{
  for (int c = 0; c < 3; ++c)
  {
    errors.push_back(std::max({ sure[c] - value[c], value[c] - sure[c] - unsure[c], 0.0 }) /
      std::max(sure[c], least));
  }
}

/** Differences of other methods from tiles. */
struct WaysAgainstTiles
{
  double Worst[NumberOfSplatWays] = {};

  void Add(SplattingFrame& scene, const Image& tiles, double least)
  {
    for (int way = 1; way < NumberOfSplatWays; ++way)
    {
      const ImageError error = Compare(scene.SplatLights(static_cast<SplatWay>(way)), tiles, least);
      this->Worst[way] = std::max(this->Worst[way], error.Worst);
    }
  }

  /** Adds differences at each threshold; returns the number of thresholds with light. */
  int AddThresholds(SplattingFrame& scene, std::initializer_list<double> thresholds, double least)
  {
    int lit = 0;
    for (double threshold : thresholds)
    {
      scene.Splats->SetIntensityThreshold(threshold);
      const Image tiles = scene.SplatLights(SplatWay::TILES);
      lit += Sum(tiles) > 0.0 ? 1 : 0;
      this->Add(scene, tiles, least);
    }
    return lit;
  }

  void Check() const
  {
    for (int way = 1; way < NumberOfSplatWays; ++way)
    {
      CheckAtMost(std::string(GetName(static_cast<SplatWay>(way))) + " against tiles, worst",
        this->Worst[way], 1e-5, "the order of sums");
    }
  }
};

/** Sets an eye among the splats of a small scene, parallel in one of four frames. */
inline void SetEyeAmongSplats(SplattingFrame& scene, int number)
{
  Random random(400 + static_cast<std::uint64_t>(number));
  scene.SetEye({ random.Next(0.2, 0.7), random.Next(0.1, 0.6), random.Next(0.2, 0.7) },
    { random.Next(0.0, 0.3), 0.0, random.Next(0.0, 0.3) }, { 0.1, 1.0, 0.1 },
    random.Next(40.0, 110.0), 0.01, 6.0);
  if (number % 4 == 3)
  {
    scene.SetParallelEye(0.4);
  }
  scene.Sampler->SetNumberOfLights(80);
  scene.Pass->SetReflectiveShadowMapResolution(64);
}
}

#endif
