// SPDX-License-Identifier: BSD-3-Clause
// Differences between path tracing and a picture, without their noise.
#include "Error/vtkIndirectResidual.h"
#include "Senders/vtkIndirectSamplePattern.h"
#include "vtkIndirectTestUtilities.h"

#include <cmath>
#include <functional>
#include <vector>

using namespace vtkIndirectTest;

namespace
{
constexpr int Edge = 96;
using Residuals = std::vector<vtkIndirectResidual>;

// A flat image whose pixels have a true difference and noise of a standard deviation of one.
Residuals MakeImage(const std::function<double(int x, int y)>& difference)
{
  vtkIndirectSamplePattern::Random random(7);
  Residuals image(static_cast<size_t>(Edge) * Edge);
  for (size_t i = 0; i < image.size(); ++i)
  {
    const int x = static_cast<int>(i) % Edge;
    const int y = static_cast<int>(i) / Edge;
    image[i].Position = glm::vec3(x, y, 0.0f) / 1000.0f;
    image[i].Normal = { 0.0f, 0.0f, 1.0f };
    image[i].Variance = 1.0f;
    for (int c = 0; c < 3; ++c)
    {
      // Four even numbers together are near enough to a normal distribution.
      const double sum = random.Next() + random.Next() + random.Next() + random.Next() - 2.0;
      image[i].Value[c] = static_cast<float>(difference(x, y) + std::sqrt(3.0) * sum);
    }
  }
  return image;
}

double FindError(const Residuals& image, const std::function<double(int x, int y)>& difference)
{
  double sum = 0.0;
  for (size_t i = 0; i < image.size(); ++i)
  {
    const double truth = difference(static_cast<int>(i) % Edge, static_cast<int>(i) / Edge);
    for (int c = 0; c < 3; ++c)
    {
      sum += std::pow(image[i].Value[c] - truth, 2.0) / (3.0 * image.size());
    }
  }
  return std::sqrt(sum);
}
}

// A picture that is right stays as it is.
VTK_INDIRECT_TEST(ResidualOfNoise)
{
  const auto none = [](int, int) { return 0.0; };
  Residuals image = MakeImage(none);
  CheckAtLeast("noise before", FindError(image, none), 0.95, "a standard deviation of one");
  vtkIndirectResidual::Filter(image, Edge);
  CheckAtMost("noise that is left", FindError(image, none), 0.03,
    "the noise of the mean of an image of 96 x 96 pixels is 0.01");
}

// An error that is a wide bump, and one that is a step.
VTK_INDIRECT_TEST(ResidualOfErrors)
{
  const auto bump = [](int x, int y)
  { return 2.0 * std::exp(-(std::pow(x - 50.0, 2.0) + std::pow(y - 40.0, 2.0)) / 400.0); };
  Residuals image = MakeImage(bump);
  vtkIndirectResidual::Filter(image, Edge);
  CheckAtMost("a bump of two, 20 pixels wide", FindError(image, bump), 0.12,
    "noise of the mean of about 8 x 8 pixels");
  const auto step = [](int x, int) { return x < 48 ? 0.0 : 4.0; };
  image = MakeImage(step);
  vtkIndirectResidual::Filter(image, Edge);
  CheckAtMost("a step of four", FindError(image, step), 0.35,
    "details of a few pixels at the step are lost in the noise");
}

// Other surfaces, by their normals or by their planes, take no part.
VTK_INDIRECT_TEST(ResidualOfTwoSurfaces)
{
  for (const bool turned : { false, true })
  {
    const auto step = [](int x, int) { return x < 48 ? 0.0 : 4.0; };
    Residuals image = MakeImage(step);
    for (size_t i = 0; i < image.size(); ++i)
    {
      if (static_cast<int>(i) % Edge >= 48)
      {
        image[i].Normal = turned ? glm::vec3(-1.0f, 0.0f, 0.0f) : image[i].Normal;
        glm::vec3& place = image[i].Position;
        place =
          turned ? glm::vec3(0.048f, place.y, place.x - 0.048f) : place + glm::vec3(0, 0, 0.5f);
      }
    }
    image[100].Normal = glm::vec3(0.0f);
    image[100].Value = glm::vec3(1e6f);
    vtkIndirectResidual::Filter(image, Edge);
    image[100].Value = glm::vec3(0.0f);
    image[100].Value += static_cast<float>(step(100 % Edge, 0));
    CheckAtMost(turned ? "a step between two walls" : "a step between two floors",
      FindError(image, step), 0.05, "as without a step");
  }
}

// One path of many meets something bright.
VTK_INDIRECT_TEST(ResidualOfOnePath)
{
  const auto none = [](int, int) { return 0.0; };
  Residuals image = MakeImage(none);
  constexpr float paths = 8.0f;
  constexpr float found = 4000.0f;
  const size_t place = 40 * Edge + 40;
  image[place].Value = glm::vec3(found / paths);
  image[place].Variance = found * found * (1.0f / paths - 1.0f / (paths * paths)) / (paths - 1.0f);
  vtkIndirectResidual::Filter(image, Edge);
  float most = 0.0f;
  for (const vtkIndirectResidual& pixel : image)
  {
    most = std::max(most, glm::length(pixel.Value));
  }
  CheckAtMost(
    "the brightest pixel, of 500", most, 5.0, "a hundredth spreads over the pixels around");
}
