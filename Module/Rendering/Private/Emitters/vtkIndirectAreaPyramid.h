// SPDX-License-Identifier: BSD-3-Clause
// A pyramid of a rectangle's radiance, in halves, quarters and so on. vtkIndirectAreaImage.glsl
// descends it.
#pragma once

#include <glm/glm.hpp> // for colours
#include <vector>      // for levels

class vtkIndirectAreaPyramid
{
public:
  /** This is the largest number of texels along an edge of the finest level. */
  static constexpr int MostTexels = 256;

  /**
   * Builds the levels from pixels of three floats each; preserves the pixels' mean. most: texels
   * along an edge.
   */
  void Build(const std::vector<float>& radiances, int columns, int rows, int most = MostTexels);

  /** Returns the level of one texel. */
  int GetTop() const { return static_cast<int>(this->Levels.size()) - 1; }
  int GetEdge(int level) const { return 1 << (this->GetTop() - level); }
  glm::vec3 GetMean(int level, int x, int y) const
  {
    return glm::vec3(
      this->Levels[static_cast<size_t>(level)][static_cast<size_t>(y * this->GetEdge(level) + x)]);
  }
  bool IsUniform() const { return this->GetTop() == 0; }

  /**
   * Makes a texture of all levels side by side, the finest alone to the left, 3 / 2 edges by one,
   * in rows of this many texels: mean, and three times the variance.
   */
  std::vector<float> MakeTexture(int width) const;

private:
  // The finest level is the first. A texel has the mean, and the variance of its texels of the
  // finest level.
  std::vector<std::vector<glm::vec4>> Levels;
};
