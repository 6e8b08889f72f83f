// SPDX-License-Identifier: BSD-3-Clause
#include "Gather/vtkIndirectAreaMaps.h"

#include "Frame/vtkIndirectFrame.h"

#include <algorithm>
#include <limits>

namespace
{
// Of all maps of a round: 16 MB.
constexpr int MostTexels = 2048;
constexpr int TexelsOfFew = 256;
constexpr int TexelsOfMany = 128;
}

//------------------------------------------------------------------------------
int vtkIndirectAreaMaps::GetTexels(const vtkIndirectAreaLamps& lamps)
{
  int count = 0;
  for (const auto& lamp : lamps.Get())
  {
    count += lamps.GetNumberOfPoints() * (lamp->TwoSided ? 2 : 1);
  }
  return count * TexelsOfFew * TexelsOfFew <= MostTexels * MostTexels ? TexelsOfFew : TexelsOfMany;
}

//------------------------------------------------------------------------------
void vtkIndirectAreaMaps::MakeEmitters(const vtkIndirectAreaLamps& lamps)
{
  this->Emitters.clear();
  for (size_t i = 0; i < this->Lamps.size(); ++i)
  {
    const vtkIndirectAreaLamps::Lamp& lamp = *lamps.Get()[i];
    Made& made = this->Lamps[i];
    for (size_t side = 0; side < 2; ++side)
    {
      glm::dvec2& range = made.Ranges[side];
      range = glm::dvec2(std::numeric_limits<double>::infinity(), 0.0);
      for (size_t k = 0; k < made.Points.size(); ++k)
      {
        vtkIndirectAreaLamps::Point& point = made.Points[k];
        point.Tiles[side] = -1;
        if (side == 0 || lamp.TwoSided)
        {
          point.Tiles[side] = static_cast<int>(this->Emitters.size());
          vtkIndirectDepthAtlas::Emitter emitter;
          emitter.Tile = vtkIndirectDepthTile::FromPlace(
            lamp.GetPlace(point), side == 0 ? lamp.Normal : -lamp.Normal);
          made.Window.Fit(emitter.Tile);
          range.x = std::min(range.x, emitter.Tile.Near);
          range.y = std::max(range.y, emitter.Tile.Far);
          emitter.Turn = k;
          this->Emitters.push_back(emitter);
        }
      }
    }
    for (const vtkIndirectAreaLamps::Point& point : made.Points)
    {
      for (size_t side = 0; side < 2 && point.Tiles[side] >= 0; ++side)
      {
        vtkIndirectDepthTile& tile = this->Emitters[static_cast<size_t>(point.Tiles[side])].Tile;
        tile.Near = made.Ranges[side].x;
        tile.Far = made.Ranges[side].y;
      }
    }
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaMaps::Update(const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture,
  const vtkIndirectAreaLamps& lamps, int round, bool caching, int most)
{
  bool same = round == this->Round && lamps.Get().size() == this->Lamps.size();
  this->Lamps.resize(lamps.Get().size());
  const bool sameRound = same;
  for (size_t i = 0; i < this->Lamps.size(); ++i)
  {
    const vtkIndirectAreaLamps::Lamp& lamp = *lamps.Get()[i];
    Made& made = this->Lamps[i];
    const bool sameLamp = sameRound && made.Light == lamp.Light && made.Time == lamp.Time &&
      made.Corner == lamp.Corner &&
      made.Points.size() == static_cast<size_t>(lamps.GetNumberOfPoints());
    if (!sameLamp)
    {
      made.Light = lamp.Light;
      made.Time = lamp.Time;
      made.Corner = lamp.Corner;
      made.Points = lamps.MakePoints(lamp, round);
    }
    const bool moved = made.Window.Update(frame,
      { lamp.Corner, lamp.Corner + lamp.Edge1, lamp.Corner + lamp.Edge2,
        lamp.Corner + lamp.Edge1 + lamp.Edge2 });
    same = same && sameLamp && !moved;
  }
  this->Round = round;
  if (!same)
  {
    this->MakeEmitters(lamps);
    ++this->ContentTime;
  }
  const size_t before = this->Atlas.GetNumberOfTilesDrawn();
  const bool updated =
    this->Atlas.Update(frame, capture, this->Emitters, GetTexels(lamps), caching, most);
  this->ContentTime += this->Atlas.GetNumberOfTilesDrawn() - before;
  return updated;
}

//------------------------------------------------------------------------------
glm::vec2 vtkIndirectAreaMaps::GetMiddle(
  const vtkIndirectAreaLamps::Point& point, size_t side) const
{
  const int tile = point.Tiles[side];
  if (tile < 0 || !this->Atlas.HasTile(static_cast<size_t>(tile)))
  {
    return glm::vec2(-1.0f);
  }
  const int columns = this->Atlas.GetNumberOfColumns();
  return (glm::vec2(tile % columns, tile / columns) + 0.5f) /
    glm::vec2(columns, this->Atlas.GetNumberOfRows());
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
void vtkIndirectAreaMaps::Release(vtkWindow* window)
{
  this->Atlas.Release(window);
  this->Lamps.clear();
  this->Emitters.clear();
  this->Round = -1;
}
