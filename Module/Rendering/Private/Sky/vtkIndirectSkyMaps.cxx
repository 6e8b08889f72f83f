// SPDX-License-Identifier: BSD-3-Clause
#include "Sky/vtkIndirectSkyMaps.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "Scene/vtkIndirectFrame.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
// The same number is in vtkIndirectSkyDirections.glsl.
constexpr size_t RowsPerDirection = 7;

// Returns the bias of a tile's look-ups, over the range of its depths.
double FindBias(const vtkIndirectDepthTile& tile, double texels)
{
  return vtkIndirectKernels::VTKI_TILE_ROUGHNESS * 2.0 / texels *
    std::max(tile.HalfWidth.x, tile.HalfWidth.y) / (tile.Far - tile.Near);
}
}

//------------------------------------------------------------------------------
vtkIndirectSkyMaps::vtkIndirectSkyMaps(
  vtkIndirectDepthMaps& maps, vtkIndirectDepthMaps::ClientType client)
  : DepthMaps(maps)
  , Client(client)
  , Atlas(maps.Get(client))
{
}

//------------------------------------------------------------------------------
void vtkIndirectSkyMaps::SetDirections(std::vector<glm::dvec3> directions)
{
  if (this->Directions != directions)
  {
    this->Directions = std::move(directions);
    this->FitKey.Clear();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectSkyMaps::AppendFitsTo(vtkIndirectKey& key, const vtkIndirectFrame& frame)
{
  frame.AppendFitsTo(key);
  if (frame.Seen.IsNearFiner())
  {
    frame.Seen.Near.AppendTo(key);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectSkyMaps::Fit(const vtkIndirectFrame& frame)
{
  vtkIndirectKey key;
  AppendFitsTo(key, frame);
  if (!this->FitKey.Take(std::move(key)))
  {
    return;
  }
  this->HasNear = frame.Seen.IsNearFiner();
  this->Maps.clear();
  for (int i = 0; i < (this->HasNear ? 2 : 1); ++i)
  {
    const vtkIndirectSeenBox& receivers = i == 0 ? frame.Seen.Box : frame.Seen.Near;
    size_t turn = 0;
    for (const glm::dvec3& direction : this->Directions)
    {
      this->Maps.push_back(
        { vtkIndirectDepthTile::FromDirection(frame, direction, receivers), true, turn });
      ++turn;
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectSkyMaps::SetSending(const std::vector<size_t>& numbers)
{
  for (vtkIndirectDepthMaps::Map& map : this->Maps)
  {
    map.Sends = false;
  }
  for (const size_t number : numbers)
  {
    for (size_t i = number; i < this->Maps.size(); i += this->Directions.size())
    {
      this->Maps[i].Sends = true;
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectSkyMaps::Request(const vtkIndirectFrame& frame, int texels)
{
  this->Texels = texels;
  this->DepthMaps.Request(this->Client, frame, this->Maps, texels);
}

//------------------------------------------------------------------------------
std::string vtkIndirectSkyMaps::DescribeTexels() const
{
  return std::to_string(this->Atlas.GetTexels()) + " texels squared" +
    (this->HasNear ? ", and as many of the nearer part of the picture" : "");
}

//------------------------------------------------------------------------------
// Returns the first texel of a tile.
glm::dvec2 vtkIndirectSkyMaps::FindCorner(size_t tile) const
{
  const size_t columns = static_cast<size_t>(std::max(1, this->Atlas.GetNumberOfColumns()));
  return static_cast<double>(this->Atlas.GetTexels()) *
    glm::dvec2(static_cast<double>(tile % columns), static_cast<double>(tile / columns));
}

//------------------------------------------------------------------------------
// Returns scale and offset from texels of a direction's map to those of its map of the nearer part;
// and the first texel of this map, its depths less those of the other map, and a texel's width over
// a texel's width there. All are zero where this map does not serve.
std::array<glm::dvec4, 2> vtkIndirectSkyMaps::FindNear(size_t number) const
{
  if (!this->HasNear || !this->HasTiles(number))
  {
    return {};
  }
  const vtkIndirectDepthTile& tile = this->Atlas.GetTile(number);
  const vtkIndirectDepthTile& near = this->Atlas.GetTile(this->Directions.size() + number);
  const double texels = this->Atlas.GetTexels();
  const glm::dvec3 middle = near.ToView(tile.Place);
  // Both maps have the same depths, unless the scene has changed between their drawings.
  if (std::abs(middle.z) + std::abs(tile.Far - near.Far) > 1e-6 * tile.Far)
  {
    return {};
  }
  const glm::dvec2 scale = tile.HalfWidth / near.HalfWidth;
  const glm::dvec2 offset = 0.5 * texels * (1.0 - scale + glm::dvec2(middle) / near.HalfWidth);
  const double wide = std::max(tile.HalfWidth.x, tile.HalfWidth.y);
  const double narrow = std::max(near.HalfWidth.x, near.HalfWidth.y);
  return { glm::dvec4(scale, offset),
    glm::dvec4(this->FindCorner(this->Directions.size() + number),
      FindBias(tile, texels) - FindBias(near, texels), narrow / wide) };
}

//------------------------------------------------------------------------------
std::vector<glm::vec4> vtkIndirectSkyMaps::MakeBlock(
  const Terms& terms, size_t first, size_t size) const
{
  std::vector<glm::vec4> block(size * RowsPerDirection, glm::vec4(0.0f));
  const double texels = this->Atlas.GetTexels() > 0 ? this->Atlas.GetTexels() : this->Texels;
  for (size_t k = 0; k < size && first + k < terms.size(); ++k)
  {
    const Term& term = terms[first + k];
    const bool there = this->Atlas.HasTile(term.Number);
    const vtkIndirectDepthTile& tile =
      there ? this->Atlas.GetTile(term.Number) : this->Maps[term.Number].Tile;
    const double range = tile.Far - tile.Near;
    const glm::dvec2 texel = 2.0 / texels * tile.HalfWidth;
    auto row = [&](const glm::dvec3& axis, double unit, double origin)
    { return glm::vec4(glm::dvec4(axis / unit, origin - glm::dot(axis, tile.Place) / unit)); };
    // A direction without a map is looked up beyond the map's border, where nothing hides it.
    block[k] = there ? row(tile.Right, texel.x, 0.5 * texels)
                     : glm::vec4(0.0f, 0.0f, 0.0f, static_cast<float>(-texels));
    block[size + k] = row(tile.Up, texel.y, 0.5 * texels);
    block[2 * size + k] = row(tile.Forward, range, -FindBias(tile, texels));
    block[3 * size + k] = glm::vec4(
      glm::dvec4(range * term.Light, range * (term.Light.x + term.Light.y + term.Light.z)));
    block[4 * size + k] =
      glm::vec4(glm::dvec4(this->FindCorner(term.Number), texel * texel / (range * range)));
    const std::array<glm::dvec4, 2> near = this->FindNear(term.Number);
    block[5 * size + k] = glm::vec4(near[0]);
    block[6 * size + k] = glm::vec4(near[1]);
  }
  return block;
}
