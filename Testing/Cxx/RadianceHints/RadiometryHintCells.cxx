// SPDX-License-Identifier: BSD-3-Clause
// Radiance hints between their look-ups: every pixel's value, against joint bilateral interpolation
// in double precision of a frame with a look-up at every pixel.
#include "vtkIndirectTestUtilities.h"

#include "vtkProperty.h"
#include "vtkRadianceHintsPass.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
constexpr double MinimumCosine = 0.9;  // the estimator's defaults
constexpr double PlaneTolerance = 0.5; // share of the distance between samples

struct Cells
{
  std::vector<Scene::Receiver> Receivers;
  Image Sampled; // looked up at every pixel
  glm::dvec3 Eye;
  glm::dvec3 Forward;
  double PixelSize; // at distance one
  int Whole = 0;    // pixels whose four samples are on their own surface
  int Mixed = 0;    // pixels with some samples on it
  int Alone = 0;    // pixels with none on it

  const Scene::Receiver& At(const glm::ivec2& pixel) const
  {
    return this->Receivers[pixel.x + this->Sampled.Width * pixel.y];
  }

  bool Same(const Scene::Receiver& a, const Scene::Receiver& b, int step) const
  {
    const glm::dvec3 offset = b.Position - a.Position;
    const double depth = glm::dot(a.Position - this->Eye, this->Forward);
    const double tolerance = PlaneTolerance * step * this->PixelSize * depth;
    return b.Lit && glm::dot(a.Normal, b.Normal) >= MinimumCosine &&
      std::max(std::abs(glm::dot(a.Normal, offset)), std::abs(glm::dot(b.Normal, offset))) <=
      tolerance;
  }

  glm::dvec3 Interpolate(const glm::ivec2& pixel, int step)
  {
    const glm::ivec2 size(this->Sampled.Width, this->Sampled.Height);
    const glm::ivec2 first = pixel / step * step;
    const glm::ivec2 second = glm::min(first + step, size - 1);
    const glm::dvec2 blend =
      glm::dvec2(pixel - first) / glm::dvec2(glm::max(second - first, glm::ivec2(1)));
    glm::dvec3 sum(0.0);
    double weights = 0.0;
    int agreeing = 0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const glm::ivec2 at(corner & 1 ? second.x : first.x, corner & 2 ? second.y : first.y);
      const double w =
        (corner & 1 ? blend.x : 1.0 - blend.x) * (corner & 2 ? blend.y : 1.0 - blend.y);
      if (this->Same(this->At(pixel), this->At(at), step))
      {
        sum += w * this->Sampled.Color(at.x, at.y);
        weights += w;
        ++agreeing;
      }
    }
    const bool alone = weights < 0.05;
    this->Whole += agreeing == 4;
    this->Mixed += agreeing < 4 && !alone;
    this->Alone += alone;
    return alone ? this->Sampled.Color(pixel.x, pixel.y) : sum / weights;
  }
};
}

// Two walls and a floor with a box and a ball, and background beyond. The image ends in the middle
// of cells.
VTK_INDIRECT_TEST(HintsCells)
{
  constexpr int width = 121;
  constexpr int height = 94;
  Scene scene(width, height);
  vtkNew<vtkRadianceHintsPass> hints;
  scene.Pass->SetEstimator(hints);
  scene.Pass->SetVisibilityToAuto();
  scene.AddQuad({ 0, 0, 0 }, { 0, 0, 2 }, { 2, 0, 0 }, { 0.8, 0.8, 0.8 });
  scene.AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 2 }, { 0.8, 0.2, 0.2 });
  scene.AddQuad({ 0, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 0.2, 0.8, 0.2 });
  scene.AddBox({ 0.9, 0.0, 0.5 }, { 1.2, 0.4, 0.8 }, { 0.3, 0.3, 0.9 });
  // Flat shading, because no buffer distinguishes facets from interpolated normals.
  scene.AddSphere({ 0.5, 0.3, 1.0 }, 0.25, 48, { 0.7, 0.7, 0.3 })
    ->GetProperty()
    ->SetInterpolationToFlat();
  scene.AddPoint({ 1.0, 1.2, 1.3 }, { 0.0, 0.0, 1.0 });
  Cells cells;
  cells.Eye = { 2.4, 1.3, 2.6 };
  const glm::dvec3 target(0.6, 0.45, 0.6);
  constexpr double angle = 40.0;
  cells.Forward = glm::normalize(target - cells.Eye);
  cells.PixelSize = 2.0 * std::tan(glm::radians(0.5 * angle)) / height;
  scene.SetEye(cells.Eye, target, { 0, 1, 0 }, angle, 0.5, 8.0);

  hints->SetInterpolationStep(1);
  scene.Render();
  cells.Receivers = scene.GetReceivers();
  cells.Sampled = scene.Copy("irradiance");
  const double mean = cells.Sampled.Mean();
  CheckAtLeast("mean irradiance", mean, 1e-3, "there is something to interpolate");

  for (int step : { 2, 3, 4, 7 })
  {
    hints->SetInterpolationStep(step);
    scene.Render();
    const Image image = scene.Copy("irradiance");
    const Image shown = scene.Copy("indirect");
    const Image albedo = scene.Copy("albedo");
    cells.Whole = cells.Mixed = cells.Alone = 0;
    int lit = 0;
    int differ = 0;
    double composite = 0.0;
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        const glm::ivec2 pixel(x, y);
        const bool isLit = cells.At(pixel).Lit;
        const glm::dvec3 expected = isLit ? cells.Interpolate(pixel, step) : glm::dvec3(0.0);
        lit += isLit;
        differ += glm::length(image.Color(x, y) - expected) > 1e-4 * mean;
        composite = std::max(
          composite, glm::length(shown.Color(x, y) - albedo.Color(x, y) * image.Color(x, y)));
      }
    }
    const std::string what = "step " + std::to_string(step) + ": ";
    // Facets of the ball lie on the tolerances in places, where floats decide otherwise than
    // doubles.
    CheckAtMost(what + "pixels that differ", differ, 1e-3 * lit, "rounding at the tolerances");
    CheckAtMost(what + "indirect light against albedo times it", composite, 1e-5 * mean, "floats");
    CheckAtLeast(
      what + "pixels surrounded by their own surface", cells.Whole, 0.3 * lit, "the test's power");
    CheckAtLeast(what + "pixels at an edge", cells.Mixed, 0.02 * lit, "the test's power");
    CheckAtLeast(what + "pixels without a sample", cells.Alone, 1, "the test's power");
  }
  scene.Pass->SetEstimator(nullptr);
}
