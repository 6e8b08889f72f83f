// SPDX-License-Identifier: BSD-3-Clause
#include "Emitters/vtkIndirectAreaPyramid.h"

#include <algorithm>

namespace
{
// The share of a pixel in a texel along an axis.
struct Share
{
  int Texel;
  float Length; // in texels
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
        shares[static_cast<size_t>(i)].push_back({ t, static_cast<float>(length) });
      }
    }
  }
  return shares;
}
}

//------------------------------------------------------------------------------
void vtkIndirectAreaPyramid::Build(
  const std::vector<float>& radiances, int columns, int rows, int most)
{
  int edge = 1;
  while (edge < std::max(columns, rows) && edge < most)
  {
    edge *= 2;
  }
  this->Levels.assign(1, std::vector<glm::vec4>(static_cast<size_t>(edge) * edge, glm::vec4(0.0f)));
  const std::vector<std::vector<Share>> across = FindShares(columns, edge);
  const std::vector<std::vector<Share>> upward = FindShares(rows, edge);
  const float* radiance = radiances.data();
  std::vector<glm::vec4> row(static_cast<size_t>(edge));
  for (int j = 0; j < rows; ++j)
  {
    std::fill(row.begin(), row.end(), glm::vec4(0.0f));
    for (int i = 0; i < columns; ++i, radiance += 3)
    {
      const glm::vec4 color(radiance[0], radiance[1], radiance[2], 0.0f);
      for (const Share& u : across[static_cast<size_t>(i)])
      {
        row[static_cast<size_t>(u.Texel)] += u.Length * color;
      }
    }
    for (const Share& v : upward[static_cast<size_t>(j)])
    {
      glm::vec4* texel = &this->Levels[0][static_cast<size_t>(v.Texel) * edge];
      for (int t = 0; t < edge; ++t)
      {
        texel[t] += v.Length * row[static_cast<size_t>(t)];
      }
    }
  }
  for (; edge > 1; edge /= 2)
  {
    const std::vector<glm::vec4>& below = this->Levels.back();
    const int half = edge / 2;
    std::vector<glm::vec4> level(static_cast<size_t>(half) * half);
    for (int y = 0; y < half; ++y)
    {
      for (int x = 0; x < half; ++x)
      {
        const glm::vec4* lower = &below[static_cast<size_t>(2 * y) * edge + 2 * x];
        const glm::vec4 parts[4] = { lower[0], lower[1], lower[edge], lower[edge + 1] };
        glm::vec4 texel = 0.25f * (parts[0] + parts[1] + parts[2] + parts[3]);
        for (const glm::vec4& part : parts)
        {
          const glm::vec3 apart(part - texel);
          texel.w += 0.25f * glm::dot(apart, apart);
        }
        level[static_cast<size_t>(y) * half + x] = texel;
      }
    }
    this->Levels.push_back(std::move(level));
  }
}

//------------------------------------------------------------------------------
std::vector<float> vtkIndirectAreaPyramid::MakeTexture(int width) const
{
  const int edge = this->GetEdge(0);
  std::vector<float> values(4 * static_cast<size_t>(width) * static_cast<size_t>(edge), 0.0f);
  for (int level = 0; level <= this->GetTop(); ++level)
  {
    const int size = this->GetEdge(level);
    const int column = level == 0 ? 0 : edge;
    const int row = level == 0 ? 0 : edge - 2 * size;
    for (int y = 0; y < size; ++y)
    {
      float* value = &values[4 * (static_cast<size_t>(row + y) * width + column)];
      const glm::vec4* texel =
        &this->Levels[static_cast<size_t>(level)][static_cast<size_t>(y) * size];
      for (int x = 0; x < size; ++x, value += 4)
      {
        std::copy(&texel[x].x, &texel[x].x + 3, value);
        value[3] = 3.0f * texel[x].w;
      }
    }
  }
  return values;
}
