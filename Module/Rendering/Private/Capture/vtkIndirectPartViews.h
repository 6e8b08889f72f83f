// SPDX-License-Identifier: BSD-3-Clause
// The parts of a mesh that a view of a depth tile sees, and the level of each: the coarsest one
// that deviates from the mesh by at most a share of a texel at the part's nearest point.
#pragma once

#include "Capture/vtkIndirectMeshParts.h" // for levels

#include <array>  // for bounds
#include <vector> // for members

class vtkProp;
struct vtkIndirectDepthTile;
struct vtkIndirectFrame;

class vtkIndirectPartViews
{
public:
  vtkIndirectPartViews(const vtkIndirectMeshParts& parts, vtkProp* prop);

  /** Finds the views of a tile that see each part. texels: along the tile's edge. */
  void SetTile(const vtkIndirectFrame& frame, const vtkIndirectDepthTile& tile, int texels);

  /**
   * Chooses the levels of the parts that one of the tile's views sees. Returns true if the prop's
   * own mesh is to be drawn, because no level of a part is within this error, in texels.
   */
  bool Choose(const vtkIndirectFrame& frame, const vtkIndirectDepthTile& view, int number,
    int texels, double mostError);

  /** Returns true if no level is drawn. */
  bool IsEmpty() const;
  const std::vector<vtkIndirectMeshParts::Level>& GetLevels(size_t number) const
  {
    return this->Levels[number];
  }
  /** Returns the greatest error of these, in world units. */
  double FindError(size_t number) const;

private:
  const vtkIndirectMeshParts& Parts;
  glm::dmat4 ToWorld;
  double Scale;
  std::vector<std::array<double, 6>> Bounds; // of the parts, in world coordinates
  std::vector<unsigned int> Seen;            // one bit a view for each part
  std::vector<unsigned int> SeenPieces;      // the same for each piece, once a view has asked
  const vtkIndirectDepthTile* Tile = nullptr;
  int Texels = 0;                                               // of the tile
  std::vector<std::vector<vtkIndirectMeshParts::Level>> Levels; // of each level

  using Bounds6 = std::array<double, 6>;
  Bounds6 ToWorldBounds(const Bounds6& bounds) const;
  void AddPieces(
    const vtkIndirectFrame& frame, const vtkIndirectMeshParts::Part& part, size_t level, int view);
};
