// SPDX-License-Identifier: BSD-3-Clause
// The radiance of a rectangle in halves, quarters and so on, as vtkIndirectAreaImage.glsl descends
// it.
#ifndef vtkIndirectAreaPyramid_h
#define vtkIndirectAreaPyramid_h

#include <glm/glm.hpp> // for colours
#include <vector>      // for levels

class vtkIndirectAreaPyramid
{
public:
  /** Texels along an edge of the finest level at most. */
  static constexpr int MostTexels = 256;

  /** From pixels, three floats each; their mean is kept. most: texels along an edge. */
  void Build(const std::vector<float>& radiances, int columns, int rows, int most = MostTexels);

  /** The level of one texel. */
  int GetTop() const { return static_cast<int>(this->Levels.size()) - 1; }
  int GetEdge(int level) const { return 1 << (this->GetTop() - level); }
  glm::vec3 GetMean(int level, int x, int y) const
  {
    return glm::vec3(
      this->Levels[static_cast<size_t>(level)][static_cast<size_t>(y * this->GetEdge(level) + x)]);
  }
  bool IsUniform() const { return this->GetTop() == 0; }

  /**
   * All levels beside each other, the finest alone to the left, 3 / 2 edges by one, in rows of so
   * many texels: mean, and three times the variance.
   */
  std::vector<float> MakeTexture(int width) const;

private:
  // The finest first. Mean; variance of the texels of the finest level below.
  std::vector<std::vector<glm::vec4>> Levels;
};

#endif
