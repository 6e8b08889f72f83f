// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Maps/vtkIndirectDepthAtlas.h"

#include "Capture/vtkIndirectDarkLight.h"
#include "Capture/vtkIndirectShadowMaps.h"
#include "Capture/vtkSurfaceCapturePass.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <iterator>

namespace
{
const vtkIndirectChannels NoChannels;

// Texels along an edge of the texture; OpenGL may allow less.
constexpr int MostTexels = 16384;
// With too many tiles for the atlas, tiles have fewer texels, but at least this many.
constexpr int LeastTexels = 16;

// A frame draws at least this many tiles, however short its time. The first tiles are drawn
// together, because fewer tiles represent all other emitters badly.
constexpr size_t LeastTiles = 1;
constexpr size_t FirstTiles = 4;

// Coarse levels deviate from their mesh by at most this many texels. With half a texel a level in
// front of its mesh loses 0.20 of the light at once, with this 0.015.
constexpr double MostErrorOfLevels = 0.2886;
}

//------------------------------------------------------------------------------
vtkIndirectDepthAtlas::vtkIndirectDepthAtlas(bool strips)
  : Strips(strips)
  , Depths(this, NoChannels, true)
{
}

vtkIndirectDepthAtlas::~vtkIndirectDepthAtlas() = default;

//------------------------------------------------------------------------------
void vtkIndirectDepthAtlas::Convert(
  double scale, const glm::dvec3& center, const vtkIndirectFrame& frame)
{
  for (Drawing& drawing : this->Drawn)
  {
    drawing.There = drawing.There && drawing.Tile.Parallel;
    if (drawing.There)
    {
      drawing.Tile = drawing.Tile.FromUnits(scale, center, frame);
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectDepthAtlas::MarkStale(
  const vtkIndirectFrame& frame, const std::vector<Bounds>& changed)
{
  for (Drawing& drawing : this->Drawn)
  {
    for (size_t i = 0; drawing.Valid && i < changed.size(); ++i)
    {
      drawing.Valid = !drawing.Tile.CanSee(frame, changed[i].data(), this->Texels);
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectDepthAtlas::Request(
  const vtkIndirectFrame& frame, const std::vector<Map>& maps, int texels, double memory)
{
  this->ReceiversCast = frame.NumberOfOtherReceivers == 0;
  const int edge = std::min(vtkTextureObject::GetMaximumTextureSize(frame.Window), MostTexels);
  int most = this->CountMostTiles(texels, edge, memory);
  while (texels / 2 >= LeastTexels && maps.size() > static_cast<size_t>(most))
  {
    texels /= 2;
    most = this->CountMostTiles(texels, edge, memory);
  }
  const glm::ivec2 size = this->GetTileSize(texels);
  const int count = static_cast<int>(std::min(maps.size(), static_cast<size_t>(most)));
  // Uses as few columns as possible: then rows of a tile lie close together in memory, which suits
  // the processor's caches.
  const int mostRows = std::max(1, edge / size.y);
  const int columns = std::max(1, (count + mostRows - 1) / mostRows);
  const int rows = std::max(1, (count + columns - 1) / columns);
  if (texels != this->Texels || columns != this->Columns || rows != this->Rows)
  {
    this->Forget();
  }
  this->Texels = texels;
  this->Columns = columns;
  this->Rows = rows;
  this->NumberOfTilesTooMany = static_cast<int>(maps.size()) - count;
  this->FindTilesToDraw(maps, static_cast<size_t>(count));
}

//------------------------------------------------------------------------------
void vtkIndirectDepthAtlas::FindTilesToDraw(const std::vector<Map>& maps, size_t count)
{
  this->Drawn.resize(count);
  std::vector<size_t> missing;
  std::vector<size_t> stale;
  for (size_t i = 0; i < count; ++i)
  {
    Drawing& drawing = this->Drawn[i];
    const vtkIndirectDepthTile& tile = maps[i].Tile;
    const bool same = drawing.There && drawing.Tile == tile;
    const bool moved = drawing.There && tile.Parallel && drawing.Tile.Forward == tile.Forward;
    drawing.There = same || moved;
    drawing.Valid = drawing.Valid && same;
    if (maps[i].Sends && !drawing.Valid)
    {
      (drawing.There ? stale : missing).push_back(i);
    }
  }
  std::stable_sort(missing.begin(), missing.end(),
    [&](size_t a, size_t b) { return maps[a].Turn < maps[b].Turn; });
  std::stable_sort(stale.begin(), stale.end(),
    [this](size_t a, size_t b) { return this->Drawn[a].Time < this->Drawn[b].Time; });
  this->NumberOfMissingTiles = static_cast<int>(missing.size());
  this->Left.clear();
  for (const std::vector<size_t>* list : { &missing, &stale })
  {
    for (const size_t i : *list)
    {
      this->Left.emplace_back(static_cast<int>(i), maps[i].Tile);
    }
  }
}

//------------------------------------------------------------------------------
// Takes the tiles to draw now from the tiles that are left.
std::vector<int> vtkIndirectDepthAtlas::TakeTiles(size_t most)
{
  const bool first = std::none_of(
    this->Drawn.begin(), this->Drawn.end(), [](const Drawing& drawing) { return drawing.There; });
  most = std::min(std::max(most, first ? FirstTiles : LeastTiles), this->Left.size());
  std::vector<int> taken;
  for (size_t i = 0; i < most; ++i)
  {
    const auto& [number, tile] = this->Left[i];
    this->Drawn[static_cast<size_t>(number)] = { tile, true, true, ++this->NumberOfTilesDrawn };
    taken.push_back(number);
  }
  this->Left.erase(this->Left.begin(), this->Left.begin() + static_cast<std::ptrdiff_t>(most));
  this->NumberOfMissingTiles = std::max(this->NumberOfMissingTiles - static_cast<int>(most), 0);
  return taken;
}

//------------------------------------------------------------------------------
bool vtkIndirectDepthAtlas::Draw(
  const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture, int most)
{
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  const glm::ivec2 size = glm::ivec2(this->Columns, this->Rows) * this->GetTileSize(this->Texels);
  this->Changed = false;
  if (!this->Depths.Resize(frame.Window, size.x, size.y))
  {
    this->Forget();
    return false;
  }
  const std::vector<int> tiles = this->TakeTiles(static_cast<size_t>(most));
  if (tiles.empty())
  {
    return true;
  }
  this->Changed = true;
  this->Depths.Begin();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDisable(GL_BLEND);
  const std::vector<vtkIndirectCasterDrawer::View> views = this->Clear(frame, tiles);
  std::vector<const vtkIndirectCaster*> casters;
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    casters.push_back(&caster);
  }
  const std::vector<const vtkIndirectCaster*> others =
    this->Drawer.Draw(frame, casters, views, this->Texels, MostErrorOfLevels, false, &this->Depths);
  if (!others.empty())
  {
    this->DrawOthers(frame, capture, views, others);
  }
  this->Depths.End();
  return true;
}

//------------------------------------------------------------------------------
glm::ivec2 vtkIndirectDepthAtlas::GetTileSize(int texels) const
{
  const float strips = this->Strips ? vtkIndirectKernels::VTKI_TILE_STRIPS : 0.0f;
  return glm::ivec2(texels, texels + static_cast<int>(strips * static_cast<float>(texels)));
}

//------------------------------------------------------------------------------
// Returns how many tiles of this size fit into a texture of this edge and into this memory.
int vtkIndirectDepthAtlas::CountMostTiles(int texels, int edge, double memory) const
{
  const glm::ivec2 size = this->GetTileSize(texels);
  return std::max(1,
    std::min((edge / size.x) * (edge / size.y),
      static_cast<int>(memory / (static_cast<double>(size.x) * size.y))));
}

//------------------------------------------------------------------------------
double vtkIndirectDepthAtlas::CountTexels() const
{
  const glm::dvec2 size(this->GetTileSize(this->Texels));
  return size.x * size.y * this->Columns * this->Rows;
}

//------------------------------------------------------------------------------
glm::dvec2 vtkIndirectDepthAtlas::GetMiddle(int tile) const
{
  const glm::dvec2 size(this->GetTileSize(this->Texels));
  const glm::dvec2 inTile(0.5, 1.0 - 0.5 * size.x / size.y);
  return (glm::dvec2(tile % this->Columns, tile / this->Columns) + inTile) /
    glm::dvec2(this->Columns, this->Rows);
}

//------------------------------------------------------------------------------
// Clears tiles and returns their views, which are to be drawn.
std::vector<vtkIndirectCasterDrawer::View> vtkIndirectDepthAtlas::Clear(
  const vtkIndirectFrame& frame, const std::vector<int>& tiles)
{
  std::vector<vtkIndirectCasterDrawer::View> views;
  for (const int number : tiles)
  {
    const vtkIndirectDepthTile& tile = this->Drawn[static_cast<size_t>(number)].Tile;
    for (int k = 0; k < (this->Strips ? vtkIndirectDepthTile::NumberOfViews : 1); ++k)
    {
      if (k == 0 || tile.Strips[static_cast<size_t>(k - 1)].HalfWidth.x > 0.0)
      {
        const glm::ivec2 place(number % this->Columns, number / this->Columns);
        views.emplace_back(frame, tile, k,
          place * this->GetTileSize(this->Texels) +
            vtkIndirectDepthTile::GetPlaceOfView(k, this->Texels, this->Strips),
          vtkIndirectDepthTile::GetSizeOfView(k, this->Texels));
        views.back().Use(frame);
        this->Depths.ClearDepth();
      }
    }
  }
  return views;
}

//------------------------------------------------------------------------------
void vtkIndirectDepthAtlas::DrawOthers(const vtkIndirectFrame& frame,
  vtkSurfaceCapturePass* capture, const std::vector<vtkIndirectCasterDrawer::View>& views,
  const std::vector<const vtkIndirectCaster*>& casters)
{
  const vtkIndirectDarkLight dark(frame);
  capture->Attach(frame);
  for (const vtkIndirectCasterDrawer::View& view : views)
  {
    std::vector<const vtkIndirectCaster*> seen;
    std::copy_if(casters.begin(), casters.end(), std::back_inserter(seen),
      [&](const vtkIndirectCaster* caster)
      { return (view.Whole->FindViews(frame, caster->Bounds, this->Texels) >> view.Number) & 1u; });
    view.Use(frame);
    capture->DrawMap(frame, view.Camera, this->Texels, seen);
  }
  capture->Detach();
}

//------------------------------------------------------------------------------
void vtkIndirectDepthAtlas::Activate(const vtkIndirectProgram& program) const
{
  this->Depths.ActivateDepth(program, "vtkiDepthTiles");
  vtkIndirectSetUniform(
    program, "vtkiTileShape", glm::vec3(this->Columns, this->Rows, this->Texels));
  if (program->IsUniformUsed("vtkiReceiversCast"))
  {
    program->SetUniformi("vtkiReceiversCast", this->ReceiversCast ? 1 : 0);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectDepthAtlas::ReleaseOwn(vtkWindow*)
{
  this->Forget();
  this->Left.clear();
  this->NumberOfMissingTiles = this->NumberOfTilesTooMany = 0;
  this->Changed = false;
  this->Columns = this->Rows = this->Texels = 0;
}
