// SPDX-License-Identifier: BSD-3-Clause
// The depth maps of one client of vtkIndirectDepthMaps, as tiles of one texture. VTK's mappers draw
// tiles through the capture, so that glyphs, impostors and textures cast the shadows that they
// draw. Tiles are kept while the camera moves: a tile is drawn again only when its emitter, or a
// caster that the tile can see, has changed.
#pragma once

#include "Capture/vtkIndirectCasterDrawer.h" // for a member
#include "Capture/vtkIndirectDepthTile.h"    // for tiles
#include "OpenGL/vtkIndirectResource.h"      // for the base class
#include "OpenGL/vtkIndirectTarget.h"        // for a member

#include <array>   // for bounds
#include <cstddef> // for size_t
#include <utility> // for pairs
#include <vector>  // for tiles

class vtkSurfaceCapturePass;
struct vtkIndirectCaster;

class vtkIndirectDepthAtlas : public vtkIndirectResource
{
public:
  /** strips: true if tiles have strips below the view ahead. */
  explicit vtkIndirectDepthAtlas(bool strips = false);
  ~vtkIndirectDepthAtlas() override;

  /** A map that a client asks for. */
  struct Map
  {
    vtkIndirectDepthTile Tile;
    bool Sends = true; // false: the emitter sends no light now, and its tile is left as it is
    size_t Turn = 0;   // of the maps without a tile the lowest numbers are drawn first
  };
  using Bounds = std::array<double, 6>; // world coordinates

  /** Converts the tiles to a frame's units. Perspective tiles are dropped: depths depend on units.
   */
  void Convert(double scale, const glm::dvec3& center, const vtkIndirectFrame& frame);
  /** Marks tiles as stale that can see any of these bounds, in which something has changed. */
  void MarkStale(const vtkIndirectFrame& frame, const std::vector<Bounds>& changed);
  /**
   * Takes these maps in place of the former ones, and finds the tiles to draw. Tiles have this many
   * texels along an edge, or a half, a quarter and so on if this memory, in texels, or OpenGL's
   * largest texture cannot hold all tiles. When the tile of a direction is fitted to a changed
   * scene, its previous map is kept until the tile is drawn again.
   */
  void Request(
    const vtkIndirectFrame& frame, const std::vector<Map>& maps, int texels, double memory);
  /**
   * Draws at most `most` of the tiles that Request has found, but at least one, or four if no tile
   * is drawn yet: maps without a tile come first, then the tiles that have waited longest. Returns
   * false, after an error, when OpenGL refuses.
   */
  bool Draw(const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture, int most);

  /** Drops all tiles. */
  void Forget() { this->Drawn.clear(); }

  /** Returns true if this map has a tile; the tile may show the scene of a few frames ago. */
  bool HasTile(size_t map) const { return map < this->Drawn.size() && this->Drawn[map].There; }
  /** Returns a map's tile as it was drawn. */
  const vtkIndirectDepthTile& GetTile(size_t map) const { return this->Drawn[map].Tile; }
  ///@{
  /**
   * Return the number of maps left to be drawn, missing or not up to date, and the number of
   * missing ones among them.
   */
  int GetNumberOfTilesLeft() const { return static_cast<int>(this->Left.size()); }
  int GetNumberOfMissingTiles() const { return this->NumberOfMissingTiles; }
  ///@}
  /** Returns true if the last Draw has drawn a tile. */
  bool HasChanged() const { return this->Changed; }
  /** Returns the number of maps, the last ones, that have no room even with the smallest tiles. */
  int GetNumberOfTilesTooMany() const { return this->NumberOfTilesTooMany; }

  /** Binds the depths and sets vtkiDepthTiles and vtkiTileShape. */
  void Activate(const vtkIndirectProgram& program) const;

  int GetNumberOfTiles() const { return static_cast<int>(this->Drawn.size()); }
  int GetTexels() const { return this->Texels; }
  int GetNumberOfColumns() const { return this->Columns; }
  int GetNumberOfRows() const { return this->Rows; }
  /** Returns the middle of a tile's view ahead, from 0 to 1 across the atlas. */
  glm::dvec2 GetMiddle(int tile) const;
  /** Returns how many tiles were drawn since construction. */
  size_t GetNumberOfTilesDrawn() const { return this->NumberOfTilesDrawn; }
  /** Returns the depths of all texels, bottom row first; 1: nothing is there. */
  std::vector<float> ReadBack() const
  {
    return this->Depths.ReadBack(vtkIndirectTarget::DepthChannel);
  }
  /** Returns the number of texels of all tiles. */
  double CountTexels() const;

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  // This is a tile as it was drawn.
  struct Drawing
  {
    vtkIndirectDepthTile Tile;
    bool There = false; // drawn for this tile
    bool Valid = false; // up to date: nothing that the tile sees has changed since
    size_t Time = 0;    // NumberOfTilesDrawn at the time of drawing
  };
  void FindTilesToDraw(const std::vector<Map>& maps, size_t count);
  std::vector<int> TakeTiles(size_t most);
  int CountMostTiles(int texels, int edge, double memory) const;

  glm::ivec2 GetTileSize(int texels) const;
  std::vector<vtkIndirectCasterDrawer::View> Clear(
    const vtkIndirectFrame& frame, const std::vector<int>& tiles);
  void DrawOthers(const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture,
    const std::vector<vtkIndirectCasterDrawer::View>& views,
    const std::vector<const vtkIndirectCaster*>& casters);

  const bool Strips;
  vtkIndirectTarget Depths;
  vtkIndirectCasterDrawer Drawer{ this };
  std::vector<Drawing> Drawn;
  std::vector<std::pair<int, vtkIndirectDepthTile>> Left; // tiles to draw, first the missing ones
  int Texels = 0;
  int Columns = 0; // tiles side by side
  int Rows = 0;
  int NumberOfMissingTiles = 0;
  int NumberOfTilesTooMany = 0;
  size_t NumberOfTilesDrawn = 0;
  bool Changed = false;
  bool ReceiversCast = true; // all receivers cast shadows
};
