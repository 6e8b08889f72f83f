// SPDX-License-Identifier: BSD-3-Clause
// Depth maps of lights as the estimators have them, drawn here by rays through the texels' centers.
#ifndef BlockersMaps_h
#define BlockersMaps_h

#include "BlockersScene.h"                   // for places
#include "Visibility/vtkIndirectDepthTile.h" // for tiles

#include <glm/glm.hpp> // for vectors
#include <vector>      // for texels

class BlockersMaps
{
public:
  static constexpr int Texels = 128; // across a map, as in the library
  static constexpr int Rows = 160;   // with the strips

  void Draw(const BlockersScene& scene);
  /** The look-up of vtkIndirectDepthTiles.glsl, by the same kernels. */
  bool IsSeen(size_t light, const glm::vec3& position, const glm::vec3& normal) const;
  /** As the library's atlas keeps them, so many tiles a row and column. */
  std::vector<float> GetAtlas(int columns) const;

private:
  static void DrawMesh(
    const BlockersScene& scene, const vtkIndirectDepthTile& tile, int number, float* texels);
  static void DrawSpheres(
    const BlockersScene& scene, const vtkIndirectDepthTile& tile, int number, float* texels);

  std::vector<vtkIndirectDepthTile> Tiles;
  std::vector<float> Inverse; // of the depth, by tile
};

#endif
