// SPDX-License-Identifier: BSD-3-Clause
// The radiance of a rectangle in halves, quarters and so on, as vtkIndirectAreaFS.glsl descends it.
#ifndef vtkIndirectAreaPyramid_h
#define vtkIndirectAreaPyramid_h

#include <glm/glm.hpp> // for colours
#include <vector>      // for levels

class vtkIndirectAreaPyramid
{
public:
  /** Texels along an edge of the finest level at most. */
  static constexpr int MostTexels = 256;

  /** From pixels, three floats each; their mean is kept. */
  void Build(const std::vector<float>& radiances, int columns, int rows);

  /** The level of one texel. */
  int GetTop() const { return static_cast<int>(this->Levels.size()) - 1; }
  int GetEdge(int level) const { return 1 << (this->GetTop() - level); }
  const glm::dvec3& GetMean(int level, int x, int y) const
  {
    return this
      ->Levels[static_cast<size_t>(level)][static_cast<size_t>(y * this->GetEdge(level) + x)]
      .Mean;
  }
  bool IsUniform() const { return this->GetTop() == 0; }

  /** All levels beside each other, the finest alone to the left: 3 / 2 edges by one. */
  std::vector<float> MakeTexture() const;

private:
  struct Texel
  {
    glm::dvec3 Mean{ 0.0 };
    double Least = 0.0; // of the sum over the colours
    double Most = 0.0;
  };
  std::vector<std::vector<Texel>> Levels; // the finest first
};

#endif
