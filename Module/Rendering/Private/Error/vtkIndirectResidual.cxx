// SPDX-License-Identifier: BSD-3-Clause
#include "Error/vtkIndirectResidual.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
using Residuals = std::vector<vtkIndirectResidual>;

// The smooth rest is a mean of about 200 x 200 pixels.
constexpr int NumberOfLevels = 7;
// Power of details over that of noise which counts as noise, by the level: the power itself is
// known from a few pixels only, and at the smallest details one path that meets something bright
// decides.
constexpr float StrictnessOfLevels[5] = { 4.0f, 3.0f, 2.0f, 1.5f, 1.2f };
// Least cosine between normals of one surface, and distance from its plane over that along the way.
constexpr float LeastCosineOfSurface = 0.8f;
constexpr float MostHeight = 0.15f;
// Weights along a row or column, of a cubic spline, and the sum of the squares of 5 x 5 of them.
constexpr float Spline[5] = { 0.0625f, 0.25f, 0.375f, 0.25f, 0.0625f };
constexpr float SumOfSquares = 0.0748f;

float GetStrictness(int level)
{
  return StrictnessOfLevels[std::min(level, 4)];
}

// Returns the variance of the smooth image of a level on one surface, over that of its pixels: for
// levels above one that of a Gaussian of the same width.
float FindVarianceOfSmooth(int level)
{
  constexpr float pi = 3.14159265f;
  return level == 0 ? 1.0f
    : level == 1    ? SumOfSquares
                    : 3.0f / (4.0f * pi * (std::pow(4.0f, static_cast<float>(level)) - 1.0f));
}

// Returns the variance of a level's details over that of the smooth image that has them.
float FindVarianceOfDetail(int level)
{
  return level == 0 ? 0.79f : level == 1 ? 0.535f : 0.46f;
}

struct Smooth
{
  glm::vec3 Value{ 0.0f };
  float Variance = 0.0f; // of one pixel around
  float Share = 1.0f;    // variance of Value over Variance
};

// Calls for each of 5 x 5 pixels at a distance, with its weight.
template <typename Call>
void ForEachAround(const Residuals& image, int width, size_t place, int distance, const Call& call)
{
  const int height = static_cast<int>(image.size()) / width;
  const int x = static_cast<int>(place) % width;
  const int y = static_cast<int>(place) / width;
  for (int j = -2; j <= 2; ++j)
  {
    const int row = y + j * distance;
    for (int i = -2; i <= 2 && row >= 0 && row < height; ++i)
    {
      const int column = x + i * distance;
      if (column >= 0 && column < width)
      {
        const size_t other = static_cast<size_t>(row) * width + column;
        const float likeness = other == place ? 1.0f : image[place].FindLikeness(image[other]);
        if (likeness > 0.0f)
        {
          call(other, Spline[i + 2] * Spline[j + 2] * likeness);
        }
      }
    }
  }
}

template <typename Call>
void ForEachSurface(const Residuals& image, const Call& call)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(image.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto place = static_cast<size_t>(i);
        if (image[place].HasSurface())
        {
          call(place);
        }
      }
    });
}

Smooth FindMean(
  const Residuals& image, const std::vector<Smooth>& from, int width, size_t place, int level)
{
  const float growth =
    FindVarianceOfSmooth(level + 1) / (SumOfSquares * FindVarianceOfSmooth(level));
  Smooth mean;
  mean.Share = 0.0f;
  float weights = 0.0f;
  float shares = 0.0f;
  ForEachAround(image, width, place, 1 << level,
    [&](size_t other, float weight)
    {
      const Smooth& smooth = from[other];
      mean.Value += weight * smooth.Value;
      mean.Variance += weight * smooth.Variance;
      mean.Share += weight * weight * smooth.Share;
      shares += weight * smooth.Share;
      weights += weight;
    });
  mean.Value /= weights;
  mean.Variance /= weights;
  // Means of neighbours have pixels in common. Means of a surface of a few pixels gain nothing.
  mean.Share = std::min(growth * mean.Share / (weights * weights), shares / weights);
  return mean;
}

// Returns the share of a power that is not noise.
float FindShare(float power, float noise)
{
  return power > noise ? 1.0f - noise / power : 0.0f;
}

float FindPower(const glm::vec3& value)
{
  return glm::dot(value, value) / 3.0f;
}
}

//------------------------------------------------------------------------------
float vtkIndirectResidual::FindLikeness(const vtkIndirectResidual& other) const
{
  const float cosine = glm::dot(other.Normal, this->Normal);
  if (cosine <= LeastCosineOfSurface)
  {
    return 0.0f;
  }
  const glm::vec3 way = other.Position - this->Position;
  const float height =
    std::max(std::abs(glm::dot(way, this->Normal)), std::abs(glm::dot(way, other.Normal)));
  const float most = MostHeight * glm::length(way);
  const float within =
    height > most ? std::max(2.0f - height / std::max(most, 1e-30f), 0.0f) : 1.0f;
  return within * (cosine - LeastCosineOfSurface) / (1.0f - LeastCosineOfSurface);
}

//------------------------------------------------------------------------------
void vtkIndirectResidual::Filter(Residuals& image, int width)
{
  std::vector<Smooth> smooth(image.size());
  std::vector<Smooth> smoother(image.size());
  std::vector<glm::vec3> sum(image.size(), glm::vec3(0.0f));
  std::vector<float> power(image.size(), 0.0f);
  for (size_t i = 0; i < image.size(); ++i)
  {
    smooth[i].Value = image[i].Value;
    smooth[i].Variance = image[i].Variance;
  }
  for (int level = 0; level < NumberOfLevels; ++level)
  {
    ForEachSurface(image,
      [&](size_t place)
      {
        smoother[place] = FindMean(image, smooth, width, place, level);
        power[place] = FindPower(smooth[place].Value - smoother[place].Value);
      });
    ForEachSurface(image,
      [&](size_t place)
      {
        float all = 0.0f;
        float weights = 0.0f;
        ForEachAround(image, width, place, 1 << level,
          [&](size_t other, float weight)
          {
            all += weight * power[other];
            weights += weight;
          });
        const float noise =
          FindVarianceOfDetail(level) * smooth[place].Share * smoother[place].Variance;
        sum[place] += FindShare(all / weights, GetStrictness(level) * noise) *
          (smooth[place].Value - smoother[place].Value);
      });
    smooth.swap(smoother);
  }
  ForEachSurface(image,
    [&](size_t place)
    {
      const Smooth& rest = smooth[place];
      const float noise = GetStrictness(NumberOfLevels) * rest.Share * rest.Variance;
      image[place].Value = sum[place] + FindShare(FindPower(rest.Value), noise) * rest.Value;
    });
}
