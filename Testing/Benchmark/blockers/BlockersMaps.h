// SPDX-License-Identifier: BSD-3-Clause
// Depth maps of lights as the estimators have them, drawn here by rays through the texels' centers.
#ifndef BlockersMaps_h
#define BlockersMaps_h

#include "BlockersScene.h" // for places

#include <glm/glm.hpp> // for vectors
#include <vector>      // for texels

class BlockersMaps
{
public:
  static constexpr int Texels = 128; // along an edge of a map, as in the library

  void Draw(const BlockersScene& scene);
  /** The look-up of vtkIndirectDepthTiles.glsl, by the same kernels. */
  bool IsSeen(size_t light, const glm::vec3& position, const glm::vec3& normal) const;
  /** As the library's atlas keeps them, so many tiles a row and column. */
  std::vector<float> GetAtlas(int columns) const;

private:
  struct Tile
  {
    glm::vec3 Right;
    glm::vec3 Up;
    glm::vec3 Axis;
    glm::vec3 Place;
  };

  void DrawSpheres(const BlockersScene& scene, const Tile& tile, float* texels) const;

  std::vector<Tile> Tiles;
  std::vector<float> Inverse; // of the depth, by tile
};

#endif
