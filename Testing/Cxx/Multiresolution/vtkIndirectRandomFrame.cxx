// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectRandomFrame.h"
#include "vtkIndirectDetails.h"

#include "vtkLight.h"
#include "vtkRSMGatherPass.h"
#include "vtkRenderWindow.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>

namespace vtkIndirectTest
{
//------------------------------------------------------------------------------
const std::vector<FrameSize>& GetFrameSizes()
{
  static const std::vector<FrameSize> sizes = { { 37, 53 }, { 127, 64 }, { 64, 64 }, { 101, 97 },
    { 1, 1 }, { 96, 128 }, { 33, 131 }, { 2, 3 }, { 1, 2000 }, { 130, 66 }, { 65, 63 },
    { 2000, 1 } };
  return sizes;
}

//------------------------------------------------------------------------------
MultiresolutionScene::MultiresolutionScene(int width, int height)
  : Scene(width, height)
{
  this->Gather->SetModeToVirtualLights();
  this->Gather->InterpolationOff();
}

Image MultiresolutionScene::Splat()
{
  this->Pass->SetEstimator(this->Splatting);
  this->Render();
  return this->Copy("irradiance");
}

Image MultiresolutionScene::GatherAll()
{
  this->Pass->SetEstimator(this->Gather);
  this->Render();
  return this->Copy("irradiance");
}

void MultiresolutionScene::ScaleThresholds(double factor)
{
  vtkNew<vtkMultiresolutionSplattingPass> defaults;
  this->Splatting->SetPlaneThreshold(factor * defaults->GetPlaneThreshold());
  this->Splatting->SetNormalThreshold(factor * defaults->GetNormalThreshold());
  SET_DETAIL(this->Splatting, LightingThreshold, factor * DetailsOf(defaults).LightingThreshold);
}

//------------------------------------------------------------------------------
RandomFrame::RandomFrame(int number, const FrameSize& size, FrameLight light)
  : MultiresolutionScene(size.Width, size.Height)
{
  static const char* const lightNames[] = { "spot", "point", "directional", "three lights",
    "headlight" };
  this->Name = "frame " + std::to_string(number) + " of " + std::to_string(size.Width) + " x " +
    std::to_string(size.Height) + ", " + lightNames[static_cast<int>(light)];
  Random random(7000 + static_cast<std::uint64_t>(number));
  auto color = [&random]()
  { return glm::dvec3(random.Next(0.2, 1.0), random.Next(0.2, 1.0), random.Next(0.2, 1.0)); };
  auto place = [&random]()
  { return glm::dvec3(random.Next(0.1, 0.9), random.Next(0.05, 0.8), random.Next(0.1, 0.9)); };

  this->AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, color());
  if (random.Next() < 0.7)
  {
    this->AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, color());
    this->AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, color());
  }
  const int count = 2 + static_cast<int>(random.Next(0.0, 5.0));
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 at = place();
    const double extent = random.NextMagnitude(0.02, 0.2);
    const double kind = random.Next();
    if (kind < 0.35)
    {
      this->AddSphere(at, extent, 8 + 2 * static_cast<int>(random.Next(0.0, 20.0)), color());
    }
    else if (kind < 0.7)
    {
      const glm::dvec3 half =
        extent * glm::dvec3(random.Next(0.3, 1.0), random.Next(0.3, 1.0), random.Next(0.3, 1.0));
      this->AddBox(at - half, at + half, color());
    }
    else
    {
      const glm::dvec3 u = extent * random.NextDirection();
      const glm::dvec3 v = extent * glm::normalize(glm::cross(u, random.NextDirection()));
      this->AddQuad(at, at + 2.0 * u, at + 2.0 * v, color());
    }
  }

  const glm::dvec3 attenuation(0.3, 0.2, 1.0);
  const bool several = light == FrameLight::SEVERAL;
  const glm::dvec3 above(random.Next(0.2, 0.8), random.Next(0.85, 1.3), random.Next(0.2, 0.8));
  if (light == FrameLight::SPOT || several)
  {
    this->AddSpot(
      above, place() * glm::dvec3(1.0, 0.2, 1.0), random.Next(20.0, 55.0), 1, attenuation);
  }
  if (light == FrameLight::POINT || several)
  {
    this->AddPoint(above + glm::dvec3(0.1, -0.2, 0.05), attenuation);
  }
  if (light == FrameLight::DIRECTIONAL || several)
  {
    this->AddDirectional({ random.Next(-0.8, 0.8), -1.0, random.Next(-0.8, 0.8) });
  }
  if (light == FrameLight::HEADLIGHT)
  {
    vtkNew<vtkLight> head;
    head->SetLightTypeToHeadlight();
    this->Renderer->AddLight(head);
  }

  // The eye is in front of the open sides, near or far.
  const double distance = random.NextMagnitude(0.7, 2.5);
  const glm::dvec3 from =
    glm::normalize(glm::dvec3(random.Next(0.2, 1.0), random.Next(0.1, 0.8), random.Next(0.2, 1.0)));
  const glm::dvec3 target = 0.5 * (place() + glm::dvec3(0.4, 0.3, 0.4));
  this->SetEye(target + distance * from, target,
    glm::normalize(glm::dvec3(random.Next(-0.3, 0.3), 1.0, random.Next(-0.3, 0.3))),
    random.Next(20.0, 60.0), 0.02, 6.0);
  if (random.Next() < 0.25)
  {
    this->SetParallelEye(random.Next(0.3, 0.7));
  }
}

//------------------------------------------------------------------------------
ImageError Compare(const Image& image, const Image& expected, double least, double floor)
{
  ImageError error;
  double largest = 0.0;
  for (float value : expected.Values)
  {
    error.Mean += value / static_cast<double>(expected.Values.size());
    error.Power += static_cast<double>(value) * value / static_cast<double>(expected.Values.size());
    largest = std::max(largest, static_cast<double>(value));
  }
  if (image.Width != expected.Width || image.Height != expected.Height || !(largest > 0.0))
  {
    error.Worst = image.Values == expected.Values ? 0.0 : 1e30;
    error.RootMeanSquare = error.Worst;
    return error;
  }
  error.Power = std::sqrt(error.Power);
  double sum = 0.0;
  for (int y = 0; y < image.Height; ++y)
  {
    for (int x = 0; x < image.Width; ++x)
    {
      const glm::dvec3 wanted = expected.Color(x, y);
      const glm::dvec3 difference = image.Color(x, y) - wanted;
      const double relative =
        glm::length(difference) / std::max({ glm::length(wanted), least * largest, floor });
      // Written so that NaN counts as the worst.
      error.Worst = relative <= error.Worst ? error.Worst : relative;
      error.NumberOff += relative <= 1e-5 ? 0 : 1;
      sum += glm::dot(difference, difference) / 3.0;
    }
  }
  error.RootMeanSquare =
    std::sqrt(sum / (static_cast<double>(image.Width) * image.Height)) / error.Mean;
  return error;
}
}
