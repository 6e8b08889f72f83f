// SPDX-License-Identifier: BSD-3-Clause
// Estimators with a promise of convergence approach the sum over all texels as virtual lights grow
// in number, at least at the promised rate.
//
// Reference: every texel of the same maps, summed in double precision. Two rates, for four times
// the lights:
//   - 1.9 on receivers farther than two radii 2 sqrt(A / pi) of a light from every sender that they
//     see. There sampling dominates: a random pattern's error falls by 2, an even one's by more.
//   - 1.35 on all receivers. Where surfaces meet, the disk kernel is low by a fixed share in a line
//     as wide as a light: the line's share of the pixels goes with N^-1/2, hence the RMSE with
//     N^-1/4, by sqrt(2).
// One step of a deterministic pattern can be better or worse by chance, so each rate is the
// geometric mean over three steps of four times the lights.
#include "vtkIndirectEstimatorTable.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkRSMReferencePass.h"
#include "vtkReflectiveShadowMapPass.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace vtkIndirectTest;

namespace
{
constexpr double FarRate = 1.9;
constexpr double OverallRate = 1.35;
constexpr double Bias = 2e-3; // for as many lights as there are texels
constexpr int Steps = 3;

struct Truth
{
  Image Irradiance;
  int Numbers[Steps + 1]; // numbers of virtual lights
  int Texels = 0;
  // For each receiver the least squared distance to a visible sender, over a texel's area; negative
  // for unlit ones.
  std::vector<double> Nearest;
};

Truth MakeTruth(Scene& scene, int fewest)
{
  Truth truth;
  for (int i = 0; i <= Steps; ++i)
  {
    truth.Numbers[i] = fewest << (2 * i);
  }
  vtkNew<vtkRSMReferencePass> reference;
  scene.Pass->SetEstimator(reference);
  scene.Render();
  scene.CheckBuffers(1);
  truth.Irradiance = scene.Copy("irradiance");
  const std::vector<VirtualLight> texels = scene.CopyLights();
  truth.Texels = static_cast<int>(texels.size());
  std::vector<VirtualLight> senders;
  for (const VirtualLight& texel : texels)
  {
    if (texel.DensityArea != glm::dvec3(0.0))
    {
      senders.push_back(texel);
    }
  }
  for (const Scene::Receiver& receiver : scene.GetReceivers())
  {
    double nearest = receiver.Lit ? VTK_DOUBLE_MAX : -1.0;
    for (size_t i = 0; i < senders.size() && receiver.Lit; ++i)
    {
      const VirtualLight& sender = senders[i];
      const glm::dvec3 d = sender.Position - receiver.Position;
      const double r2 = glm::dot(d, d);
      // Cosines below a ten-thousandth are rounding of coplanar surfaces and add no light.
      const double least = 1e-4 * std::sqrt(r2);
      if (r2 < nearest * sender.Area && glm::dot(receiver.Normal, d) > least &&
        -glm::dot(sender.Normal, d) > least)
      {
        nearest = r2 / sender.Area;
      }
    }
    truth.Nearest.push_back(nearest);
  }
  return truth;
}

// Root mean square difference; over receivers farther than two radii of one of `lights` lights from
// every sender, or over all.
double RootMeanSquare(const Truth& truth, const Image& image, int lights, bool far, int* count)
{
  const double area = static_cast<double>(truth.Texels) / lights; // in texels
  double sum = 0.0;
  int receivers = 0;
  for (size_t i = 0; i < truth.Nearest.size(); ++i)
  {
    if (truth.Nearest[i] < 0.0 || (far && truth.Nearest[i] <= 4.0 * area / vtkMath::Pi()))
    {
      continue;
    }
    ++receivers;
    for (size_t c = 3 * i; c < 3 * i + 3; ++c)
    {
      sum += std::pow(double(image.Values[c]) - truth.Irradiance.Values[c], 2.0);
    }
  }
  if (count)
  {
    *count = receivers;
  }
  return std::sqrt(sum / std::max(1, 3 * receivers));
}

struct Rates
{
  double Far = 1.0;
  double Overall = 1.0;
  double Bias = 0.0;
};

// images: one for each number of lights, and the one with all texels.
Rates Measure(const Truth& truth, const std::vector<Image>& images)
{
  Rates rates;
  for (int i = 0; i < Steps; ++i)
  {
    for (bool far : { false, true })
    {
      const double coarse = RootMeanSquare(truth, images[i], truth.Numbers[i], far, nullptr);
      const double fine = RootMeanSquare(truth, images[i + 1], truth.Numbers[i], far, nullptr);
      (far ? rates.Far : rates.Overall) *= std::pow(coarse / fine, 1.0 / Steps);
    }
  }
  double sum = 0.0;
  double expected = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    sum += images[Steps + 1].Mean(c);
    expected += truth.Irradiance.Mean(c);
  }
  rates.Bias = sum / expected - 1.0;
  return rates;
}

bool Keeps(const Rates& rates)
{
  return rates.Far >= FarRate && rates.Overall >= OverallRate && std::abs(rates.Bias) <= Bias;
}

void CheckConvergence(Scene& scene, int fewest)
{
  const Truth truth = MakeTruth(scene, fewest);
  const double mean = truth.Irradiance.Mean();
  CheckAtLeast("mean irradiance", mean, 1e-3, "the test's own power");
  for (int i = 0; i < Steps; ++i)
  {
    int far = 0;
    RootMeanSquare(truth, truth.Irradiance, truth.Numbers[i], true, &far);
    CheckAtLeast("receivers far from senders with " + std::to_string(truth.Numbers[i]) + " lights",
      far, 40, "the test's own power");
  }
  for (const EstimatorEntry& estimator : GetEstimators())
  {
    if (!estimator.Converges)
    {
      continue;
    }
    const std::string name = std::string(estimator.Name) + ": ";
    auto render = [&](int lights)
    {
      estimator.Install(scene.Pass, lights);
      scene.Render();
      return scene.Copy("irradiance");
    };
    std::vector<Image> images;
    if (estimator.Sum == EstimatorEntry::ALL_TEXELS)
    {
      // The error is zero from the beginning and has no rate.
      images.assign(Steps + 2, render(1));
      CheckAbsolute(name + "bias", Measure(truth, images).Bias, 0.0, Bias, "the promise");
      continue;
    }
    for (int number : truth.Numbers)
    {
      images.push_back(render(number));
      std::printf("       %s%d lights: RMSE %.3e of the mean\n", name.c_str(), number,
        RootMeanSquare(truth, images.back(), number, false, nullptr) / mean);
    }
    images.push_back(render(truth.Texels));
    const Rates rates = Measure(truth, images);
    CheckAbsolute(name + "bias with all texels", rates.Bias, 0.0, Bias, "the promise");
    CheckAtLeast(name + "RMSE falls far from senders, for four times the lights", rates.Far,
      FarRate, "the promise");
    CheckAtLeast(
      name + "RMSE falls, for four times the lights", rates.Overall, OverallRate, "the promise");

    std::vector<Image> wrong = images;
    for (Image& image : wrong)
    {
      for (float& value : image.Values)
      {
        value *= 1.03f;
      }
    }
    Check(name + "3 % too bright would be rejected", !Keeps(Measure(truth, wrong)));
    wrong = images;
    std::fill(wrong.begin(), wrong.begin() + Steps + 1, images.front());
    Check(name + "lights that do not help would be rejected", !Keeps(Measure(truth, wrong)));
  }
}
}

VTK_INDIRECT_TEST(Spot)
{
  // A room without a front wall, and a ball in it.
  Scene scene(48, 36);
  scene.AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0.75, 0.75, 0.5 });
  scene.AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.75, 0.125, 0.125 });
  scene.AddQuad({ 1, 0, 0 }, { 1, 0, 1 }, { 1, 1, 0 }, { 0.125, 0.75, 0.125 });
  scene.AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.75, 0.75, 0.75 });
  scene.AddSphere({ 0.6, 0.25, 0.5 }, 0.2, 64, { 0.5, 0.5, 0.75 });
  scene.AddSpot({ 0.5, 0.95, 0.7 }, { 0.35, 0, 0.4 }, 50, 1, { 0.2, 0, 1 });
  scene.SetEye({ 0.5, 0.5, 2.6 }, { 0.5, 0.45, 0.5 }, { 0, 1, 0 }, 32, 0.5, 5);
  scene.Pass->SetReflectiveShadowMapResolution(256);
  CheckConvergence(scene, 64);
}

VTK_INDIRECT_TEST(Directional)
{
  // Sunlit ground, and a wall, a roof and a ball over it. The wall is oblique to the light: for a
  // grid whose rows are parallel to the line where surfaces meet, the error depends on its first
  // row (Documentation/methods/gather.md).
  Scene scene(48, 36);
  scene.AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0.75, 0.5, 0.25 });
  scene.AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.25, 0.5, 0.75 });
  scene.AddQuad({ 0.1, 0.9, 0 }, { 0.9, 0.9, 0 }, { 0.1, 0.9, 0.3 }, { 0.5, 0.5, 0.5 });
  scene.AddSphere({ 0.35, 0.45, 0.5 }, 0.17, 64, { 0.5, 0.75, 0.5 });
  scene.AddDirectional({ -0.4, -0.3, -0.5 });
  scene.SetEye({ 0.9, 0.35, 2.6 }, { 0.5, 0.4, 0.4 }, { 0, 1, 0 }, 32, 0.5, 5);
  scene.Pass->SetReflectiveShadowMapResolution(256);
  CheckConvergence(scene, 64);
}

VTK_INDIRECT_TEST(Point)
{
  // A closed box, with the eye in it. Six faces of 104 texels have about as many as one map of 256,
  // and lights in all directions must be four times as many.
  Scene scene(48, 36);
  scene.AddBox({ 0, 0, 0 }, { 1.3, 1, 1.6 }, { 0.5, 0.75, 0.25 });
  scene.AddSphere({ 0.4, 0.3, 0.6 }, 0.2, 64, { 0.75, 0.5, 0.5 });
  scene.AddPoint({ 0.75, 0.65, 0.7 }, { 0.1, 0.2, 1 });
  scene.SetEye({ 0.7, 0.55, 1.5 }, { 0.55, 0.45, 0.3 }, { 0, 1, 0 }, 70, 0.05, 5);
  scene.Pass->SetReflectiveShadowMapResolution(104);
  CheckConvergence(scene, 256);
}
