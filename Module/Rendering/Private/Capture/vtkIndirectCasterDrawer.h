// SPDX-License-Identifier: BSD-3-Clause
// Draws the depth of casters into views of the bound target, without their mappers where that gives
// the same: plain polygons from their mappers' buffers, and of dense meshes the levels of parts
// that deviate by less than a share of a texel.
#pragma once

#include "Capture/vtkIndirectDepthDrawer.h"    // for a member
#include "Capture/vtkIndirectDepthTile.h"      // for views
#include "Capture/vtkIndirectSmallTriangles.h" // for a member

#include <cstddef>     // for size_t
#include <glm/glm.hpp> // for matrices
#include <utility>     // for pairs
#include <vector>      // for lists

class vtkIndirectPartViews;
class vtkIndirectTarget;
struct vtkIndirectCaster;
struct vtkIndirectFrame;

class vtkIndirectCasterDrawer
{
public:
  explicit vtkIndirectCasterDrawer(vtkIndirectResource* owner);

  /** A view of a tile, and its place in the bound target. */
  struct View
  {
    const vtkIndirectDepthTile* Whole; // the tile
    int Number;                        // of the tile's views
    vtkIndirectDepthTile Camera;
    glm::dmat4 ToClip;
    glm::ivec2 First; // the viewport, in texels
    glm::ivec2 Size;

    View(const vtkIndirectFrame& frame, const vtkIndirectDepthTile& tile, int number,
      const glm::ivec2& first, const glm::ivec2& size);
    /** Sets the viewport and the scissor to it. */
    void Use(const vtkIndirectFrame& frame) const;
  };

  /**
   * Draws casters into views. The views of a tile follow each other, the view ahead first; that one
   * has this many texels along an edge. Returns the casters that only their own mappers can draw.
   * mostError: of coarse levels, in texels. slopes: true to write slopes of depth to the first
   * channel, too; for parallel tiles. target: the bound target, whose views are clear and show no
   * slopes, where the processor may write depths in OpenGL's place.
   */
  std::vector<const vtkIndirectCaster*> Draw(const vtkIndirectFrame& frame,
    const std::vector<const vtkIndirectCaster*>& casters, const std::vector<View>& views,
    int texels, double mostError, bool slopes = false, vtkIndirectTarget* target = nullptr);

private:
  // This is a prop in its views.
  struct Work
  {
    const vtkIndirectCaster* Caster;
    vtkIndirectMeshParts* Parts;                                         // null: none
    std::vector<const View*> Whole;                                      // views of its own mesh
    std::vector<std::pair<const View*, std::vector<unsigned int>>> Left; // triangles of its parts
  };

  void Use(const vtkIndirectFrame& frame, const View& view);
  bool Writes(const vtkIndirectMeshParts* parts) const;
  bool DrawParts(
    const vtkIndirectFrame& frame, Work& work, const std::vector<View>& views, int texels);
  bool DrawRest(const vtkIndirectFrame& frame, const Work& work);
  size_t DrawLevels(const vtkIndirectFrame& frame, const View& view,
    const vtkIndirectMeshParts& parts, const vtkIndirectPartViews& seen);
  size_t WriteLevels(const vtkIndirectFrame& frame, const View& view, size_t number, Work& work,
    const vtkIndirectPartViews& seen);
  void Upload(const std::vector<View>& views);
  void Flush(size_t triangles);

  vtkIndirectDepthDrawer Drawer;
  double MostError = 0.0;
  bool Slopes = false;
  size_t TrianglesOfBatch = 0;         // drawn since the last flush
  vtkIndirectTarget* Target = nullptr; // null: the processor writes nothing
  vtkIndirectSmallTriangles Small;
  std::vector<std::vector<float>> Depths; // of each view; empty: nothing is written
};
