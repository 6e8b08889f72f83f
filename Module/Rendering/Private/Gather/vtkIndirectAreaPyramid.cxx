// SPDX-License-Identifier: BSD-3-Clause
#include "Gather/vtkIndirectAreaPyramid.h"

#include <algorithm>
#include <cmath>

namespace
{
// Shares of pixels in texels along an axis: each pixel's, of all texels that it lies in.
struct Share
{
  int Texel;
  double Length; // in texels
};

std::vector<std::vector<Share>> FindShares(int pixels, int texels)
{
  std::vector<std::vector<Share>> shares(static_cast<size_t>(pixels));
  const double scale = static_cast<double>(texels) / pixels;
  for (int i = 0; i < pixels; ++i)
  {
    const double lower = i * scale;
    const double upper = (i + 1) * scale;
    for (int t = static_cast<int>(lower); t < texels && t < upper; ++t)
    {
      const double length = std::min(upper, t + 1.0) - std::max(lower, 1.0 * t);
      if (length > 1e-12)
      {
        shares[static_cast<size_t>(i)].push_back({ t, length });
      }
    }
  }
  return shares;
}
}

//------------------------------------------------------------------------------
void vtkIndirectAreaPyramid::Build(const std::vector<float>& radiances, int columns, int rows)
{
  int edge = 1;
  while (edge < std::max(columns, rows) && edge < MostTexels)
  {
    edge *= 2;
  }
  this->Levels.assign(1, std::vector<Texel>(static_cast<size_t>(edge) * edge));
  std::vector<Texel>& finest = this->Levels[0];
  const std::vector<std::vector<Share>> across = FindShares(columns, edge);
  const std::vector<std::vector<Share>> upward = FindShares(rows, edge);
  const float* radiance = radiances.data();
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i, radiance += 3)
    {
      const glm::dvec3 color(radiance[0], radiance[1], radiance[2]);
      for (const Share& v : upward[static_cast<size_t>(j)])
      {
        for (const Share& u : across[static_cast<size_t>(i)])
        {
          finest[static_cast<size_t>(v.Texel) * edge + u.Texel].Mean += u.Length * v.Length * color;
        }
      }
    }
  }
  for (Texel& texel : finest)
  {
    texel.Least = texel.Most = texel.Mean.x + texel.Mean.y + texel.Mean.z;
  }
  for (; edge > 1; edge /= 2)
  {
    const std::vector<Texel>& below = this->Levels.back();
    const int half = edge / 2;
    std::vector<Texel> level(static_cast<size_t>(half) * half);
    for (int y = 0; y < half; ++y)
    {
      for (int x = 0; x < half; ++x)
      {
        Texel& texel = level[static_cast<size_t>(y) * half + x];
        for (int child = 0; child < 4; ++child)
        {
          const Texel& part =
            below[static_cast<size_t>(2 * y + child / 2) * edge + 2 * x + child % 2];
          texel.Mean += 0.25 * part.Mean;
          texel.Least = child == 0 ? part.Least : std::min(texel.Least, part.Least);
          texel.Most = child == 0 ? part.Most : std::max(texel.Most, part.Most);
        }
      }
    }
    this->Levels.push_back(std::move(level));
  }
}

//------------------------------------------------------------------------------
std::vector<float> vtkIndirectAreaPyramid::MakeTexture() const
{
  const int edge = this->GetEdge(0);
  const size_t width = static_cast<size_t>(edge + (edge + 1) / 2);
  std::vector<float> values(4 * width * static_cast<size_t>(edge), 0.0f);
  for (int level = 0; level <= this->GetTop(); ++level)
  {
    const int size = this->GetEdge(level);
    const int column = level == 0 ? 0 : edge;
    const int row = level == 0 ? 0 : edge - 2 * size;
    for (int y = 0; y < size; ++y)
    {
      for (int x = 0; x < size; ++x)
      {
        const Texel& texel =
          this->Levels[static_cast<size_t>(level)][static_cast<size_t>(y) * size + x];
        float* const value =
          &values[4 * (static_cast<size_t>(row + y) * width + static_cast<size_t>(column + x))];
        for (int c = 0; c < 3; ++c)
        {
          value[c] = static_cast<float>(texel.Mean[c]);
        }
        const double sum = texel.Mean.x + texel.Mean.y + texel.Mean.z;
        value[3] = static_cast<float>(std::max(texel.Most - sum, sum - texel.Least));
      }
    }
  }
  return values;
}
