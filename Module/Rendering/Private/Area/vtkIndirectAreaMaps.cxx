// SPDX-License-Identifier: BSD-3-Clause
#include "Area/vtkIndirectAreaMaps.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "Scene/vtkIndirectFrame.h"

namespace
{
// Texels along an edge of all maps of a round together, without strips: 16 MB.
constexpr int MostTexels = 2048;
constexpr int TexelsOfFew = 256;
constexpr int TexelsOfMany = 128;
}

//------------------------------------------------------------------------------
void vtkIndirectAreaMaps::MakeMaps(const vtkIndirectAreaLamps& lamps)
{
  this->Maps.clear();
  for (size_t i = 0; i < this->Lamps.size(); ++i)
  {
    const vtkIndirectAreaLamps::Lamp& lamp = *lamps.Get()[i];
    Made& made = this->Lamps[i];
    const size_t sides = lamp.TwoSided ? 2 : 1;
    const size_t first = this->Maps.size();
    this->Maps.resize(first + sides * made.Points.size());
    for (size_t side = 0; side < sides; ++side)
    {
      std::vector<vtkIndirectDepthTile*> tiles;
      for (size_t k = 0; k < made.Points.size(); ++k)
      {
        vtkIndirectAreaLamps::Point& point = made.Points[k];
        const size_t number = first + side * made.Points.size() + k;
        point.Tiles[0] = static_cast<int>(first + k);
        point.Tiles[1] = lamp.TwoSided ? static_cast<int>(first + made.Points.size() + k) : -1;
        vtkIndirectDepthMaps::Map& map = this->Maps[number];
        map.Tile = vtkIndirectDepthTile::FromPlace(
          lamp.GetPlace(point.Place), side == 0 ? lamp.Normal : -lamp.Normal);
        map.Turn = k;
        tiles.push_back(&map.Tile);
      }
      made.Window.Fit(tiles);
      made.Views[side] = *tiles.front();
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectAreaMaps::Update(
  const vtkIndirectFrame& frame, const vtkIndirectAreaLamps& lamps, int round)
{
  bool same = round == this->Round && lamps.Get().size() == this->Lamps.size();
  this->Lamps.resize(lamps.Get().size());
  const bool sameRound = same;
  for (size_t i = 0; i < this->Lamps.size(); ++i)
  {
    const vtkIndirectAreaLamps::Lamp& lamp = *lamps.Get()[i];
    Made& made = this->Lamps[i];
    const bool sameLamp = sameRound && made.Light == lamp.Light && made.Corner == lamp.Corner &&
      made.Points.size() == static_cast<size_t>(lamps.GetNumberOfPoints());
    if (!sameLamp)
    {
      made.Light = lamp.Light;
      made.Corner = lamp.Corner;
      made.Points = lamps.MakePoints(lamp, round);
    }
    const bool moved = made.Window.Update(frame,
      { lamp.Corner, lamp.GetPlace({ 1.0, 0.0 }), lamp.GetPlace({ 0.0, 1.0 }),
        lamp.GetPlace({ 1.0, 1.0 }) });
    same = same && sameLamp && !moved;
  }
  this->Round = round;
  if (!same)
  {
    this->MakeMaps(lamps);
  }
  const size_t most = 1u * MostTexels * MostTexels / (TexelsOfFew * TexelsOfFew);
  this->DepthMaps.Request(
    this->Client, frame, this->Maps, this->Maps.size() <= most ? TexelsOfFew : TexelsOfMany);
}

//------------------------------------------------------------------------------
glm::vec2 vtkIndirectAreaMaps::GetMiddle(
  const vtkIndirectAreaLamps::Point& point, size_t side) const
{
  const int tile = point.Tiles[side];
  return tile >= 0 && this->Atlas.HasTile(static_cast<size_t>(tile))
    ? glm::vec2(this->Atlas.GetMiddle(tile))
    : glm::vec2(-1.0f);
}

//------------------------------------------------------------------------------
glm::vec4 vtkIndirectAreaMaps::GetWindow(
  const vtkIndirectAreaLamps::Point& point, size_t side) const
{
  const int tile = point.Tiles[side];
  if (tile < 0 || !this->Atlas.HasTile(static_cast<size_t>(tile)))
  {
    return glm::vec4(1.0f, 1.0f, 0.0f, 0.0f);
  }
  const vtkIndirectDepthTile& drawn = this->Atlas.GetTile(static_cast<size_t>(tile));
  return glm::vec4(glm::dvec4(1.0 / drawn.HalfWidth, -drawn.Middle / drawn.HalfWidth));
}

//------------------------------------------------------------------------------
glm::vec4 vtkIndirectAreaMaps::GetStripWindow(size_t lamp, size_t side, size_t strip) const
{
  const vtkIndirectDepthTile::Strip& drawn = this->Lamps[lamp].Views[side].Strips[strip];
  // Without a caster to hide the lamp all places are outside.
  return drawn.HalfWidth.x > 0.0
    ? glm::vec4(glm::dvec4(1.0 / drawn.HalfWidth, -drawn.Middle / drawn.HalfWidth))
    : glm::vec4(1e-6f, 1e-6f, 2.0f, 2.0f);
}

//------------------------------------------------------------------------------
glm::dvec4 vtkIndirectAreaMaps::GetRange(size_t lamp, size_t side) const
{
  const vtkIndirectDepthTile& view = this->Lamps[lamp].Views[side];
  const glm::dvec4 range(view.Near, view.Far, view.StripNear, view.StripFar);
  return 1.0 / glm::max(range, glm::dvec4(vtkIndirectKernels::VTKI_WINDOW_NEAR));
}

//------------------------------------------------------------------------------
void vtkIndirectAreaMaps::ReleaseOwn(vtkWindow* window)
{
  this->DepthMaps.Release(this->Client, window);
  this->Lamps.clear();
  this->Maps.clear();
  this->Round = -1;
}
