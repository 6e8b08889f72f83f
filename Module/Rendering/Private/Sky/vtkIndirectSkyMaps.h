// SPDX-License-Identifier: BSD-3-Clause
// The depth maps of the sky's directions, and what vtkIndirectSkyDirections.glsl reads of them.
// Where the picture reaches far, each direction has a second map, of the nearer part of the picture
// alone.
#pragma once

#include "Maps/vtkIndirectDepthMaps.h" // for maps
#include "OpenGL/vtkIndirectKey.h"     // for members

#include <array>       // for values of shaders
#include <cstddef>     // for size_t
#include <glm/glm.hpp> // for directions
#include <string>      // for definitions
#include <vector>      // for lists

struct vtkIndirectFrame;

class vtkIndirectSkyMaps
{
public:
  /** A direction that is summed: its number, and its light. */
  struct Term
  {
    size_t Number;
    glm::dvec3 Light; // irradiance of a surface that faces it
  };
  using Terms = std::vector<Term>;

  vtkIndirectSkyMaps(vtkIndirectDepthMaps& maps, vtkIndirectDepthMaps::ClientType client);

  /** Sets the directions that have places in the atlas. */
  void SetDirections(std::vector<glm::dvec3> directions);
  const std::vector<glm::dvec3>& GetDirections() const { return this->Directions; }
  /** Fits all maps to the frame, if they are not fitted to the same scene and view already. */
  void Fit(const vtkIndirectFrame& frame);
  /** Sets the numbers of the directions whose maps are drawn; until then all are. */
  void SetSending(const std::vector<size_t>& numbers);
  /** Asks for the maps, with this many texels along an edge. */
  void Request(const vtkIndirectFrame& frame, int texels);
  void Release(vtkWindow* window) { this->DepthMaps.Release(this->Client, window); }

  /** Returns true if all maps of a direction are drawn. */
  bool HasTiles(size_t number) const
  {
    return this->Atlas.HasTile(number) &&
      (!this->HasNear || this->Atlas.HasTile(this->Directions.size() + number));
  }
  /** Returns the maps as they were drawn. */
  const vtkIndirectDepthAtlas& GetAtlas() const { return this->Atlas; }
  /** Returns what shaders are told about the maps. */
  std::string GetDefinition() const { return this->HasNear ? "#define VTKI_SKY_NEAR\n" : ""; }
  /** Returns the size of the maps, for the report. */
  std::string DescribeTexels() const;

  /**
   * Returns the block of shaders for these terms from the first on, with room for `size` terms. A
   * direction without a map is hidden by nothing.
   */
  std::vector<glm::vec4> MakeBlock(const Terms& terms, size_t first, size_t size) const;

  /** Appends the inputs of the maps' fit. */
  static void AppendFitsTo(vtkIndirectKey& key, const vtkIndirectFrame& frame);

private:
  std::array<glm::dvec4, 2> FindNear(size_t number) const;
  glm::dvec2 FindCorner(size_t tile) const;

  vtkIndirectDepthMaps& DepthMaps;
  const vtkIndirectDepthMaps::ClientType Client;
  const vtkIndirectDepthAtlas& Atlas;
  std::vector<glm::dvec3> Directions;
  // Maps of all directions, then their maps of the nearer part, or none of these.
  std::vector<vtkIndirectDepthMaps::Map> Maps;
  vtkIndirectKey FitKey; // the inputs of the maps' fit
  bool HasNear = false;
  int Texels = 0;
};
