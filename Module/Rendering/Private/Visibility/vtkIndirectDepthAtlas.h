// SPDX-License-Identifier: BSD-3-Clause
// Depth maps of any number of emitters, as tiles of one texture. VTK's mappers draw them through
// the capture, so that glyphs, impostors and textures cast the shadows that they draw. Tiles are
// kept while the camera moves: a tile is drawn again only when its emitter, or a caster that it can
// see, has changed.
#ifndef vtkIndirectDepthAtlas_h
#define vtkIndirectDepthAtlas_h

#include "Capture/vtkIndirectDepthDrawer.h"  // for a member
#include "OpenGL/vtkIndirectTarget.h"        // for a member
#include "Visibility/vtkIndirectDepthTile.h" // for tiles
#include "vtkSmartPointer.h"                 // for a member
#include "vtkType.h"                         // for times

#include <algorithm> // for comparison
#include <cstddef>   // for size_t
#include <vector>    // for tiles

class vtkOpenGLCamera;
class vtkProp;
class vtkSurfaceCapturePass;
struct vtkIndirectCaster;

class vtkIndirectDepthAtlas
{
public:
  /** strips: true if tiles have strips below the view ahead. */
  explicit vtkIndirectDepthAtlas(bool strips = false);
  ~vtkIndirectDepthAtlas();

  /**
   * An emitter's tile, whether the emitter sends any light (tiles of others are left as they are),
   * and its turn among the emitters without a tile: lower numbers are drawn first.
   */
  struct Emitter
  {
    vtkIndirectDepthTile Tile;
    bool Sends = true;
    size_t Turn = 0;
  };

  /**
   * Brings the tiles of these emitters up to date. Tiles have this many texels along an edge, or a
   * half, a quarter and so on if 256 MB or OpenGL's largest texture cannot hold all of them. Draws
   * at most `tilesPerFrame` tiles, but at least one, or four if no tile is drawn yet: emitters
   * without a tile come first, then the tiles that have waited longest. When the tile of a
   * direction is fitted to a changed scene, its previous map is kept until it is drawn again.
   * Without caching nothing is kept. Returns false, after an error, when OpenGL refuses.
   */
  bool Update(const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture,
    const std::vector<Emitter>& emitters, int texels, bool caching, int tilesPerFrame = 1 << 30);

  /** Drops all tiles; the next Update draws them again. */
  void Forget() { this->Drawn.clear(); }

  /** Returns true if this emitter has a map; the map may show the scene of a few frames ago. */
  bool HasTile(size_t emitter) const
  {
    return emitter < this->Drawn.size() && this->Drawn[emitter].There;
  }
  /** Returns the emitter's tile as it was drawn. */
  const vtkIndirectDepthTile& GetTile(size_t emitter) const { return this->Drawn[emitter].Tile; }
  ///@{
  /**
   * Return, after Update, the number of emitters without a map, and the number of emitters whose
   * map is missing or not up to date.
   */
  int GetNumberOfMissingTiles() const { return this->NumberOfMissingTiles; }
  int GetNumberOfStaleTiles() const { return this->NumberOfStaleTiles; }
  ///@}
  /**
   * Returns the number of emitters, the last ones, that have no room even with the smallest tiles.
   */
  int GetNumberOfTilesTooMany() const { return this->NumberOfTilesTooMany; }

  /** Binds the depths and sets vtkiDepthTiles and vtkiTileShape; pair. */
  void Activate(vtkShaderProgram* program) const;
  void Deactivate() const;

  int GetNumberOfTiles() const { return static_cast<int>(this->Drawn.size()); }
  int GetTexels() const { return this->Texels; }
  int GetNumberOfColumns() const { return this->Columns; }
  int GetNumberOfRows() const { return this->Rows; }
  /** Returns the middle of a tile's view ahead, from 0 to 1 across the atlas. */
  glm::dvec2 GetMiddle(int tile) const;
  /** Returns how many tiles were drawn since construction. */
  size_t GetNumberOfTilesDrawn() const { return this->NumberOfTilesDrawn; }
  size_t GetBytes() const { return this->Depths.GetBytes(); }
  void Release(vtkWindow* window);

private:
  // A tile as it was drawn.
  struct Drawing
  {
    vtkIndirectDepthTile Tile;
    bool There = false; // drawn for this tile
    bool Valid = false; // up to date: nothing that the tile sees has changed since
    size_t Time = 0;    // NumberOfTilesDrawn at the time of drawing
  };
  struct Caster
  {
    vtkProp* Prop;
    vtkTypeUInt64 Revision;
    double Bounds[6];
    bool operator==(const Caster& other) const
    {
      return this->Prop == other.Prop && this->Revision == other.Revision &&
        std::equal(this->Bounds, this->Bounds + 6, other.Bounds);
    }
  };

  void ForgetWhatChanged(const vtkIndirectFrame& frame);
  std::vector<int> ChooseTiles(const std::vector<Emitter>& emitters, size_t count, size_t most);
  int CountMostTiles(int texels, int edge) const;
  int FindTexels(size_t count, int texels, int edge) const;
  // A view of a tile that is to be drawn.
  struct View
  {
    int Tile;
    int Number;
    vtkIndirectDepthTile Camera;
    glm::dmat4 ToClip;
  };

  glm::ivec2 GetTileSize(int texels) const;
  void Use(const vtkIndirectFrame& frame, int tile, int view);
  std::vector<View> Clear(const vtkIndirectFrame& frame, const std::vector<int>& tiles);
  unsigned int FindViews(const vtkIndirectFrame& frame, const View& view, const double bounds[6]);
  std::vector<const vtkIndirectCaster*> DrawPlain(
    const vtkIndirectFrame& frame, const std::vector<View>& views);
  void DrawOthers(const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture,
    const std::vector<View>& views, const std::vector<const vtkIndirectCaster*>& casters);

  const bool Strips;
  vtkIndirectTarget Depths;
  vtkIndirectDepthDrawer Drawer;
  vtkSmartPointer<vtkOpenGLCamera> Camera;
  std::vector<Drawing> Drawn;
  std::vector<Caster> Casters; // state of the last Update
  double SceneScale = 0.0;
  glm::dvec3 SceneCenter{ 0.0 };
  int Texels = 0;
  int Columns = 0; // tiles side by side
  int Rows = 0;
  int NumberOfMissingTiles = 0;
  int NumberOfStaleTiles = 0;
  int NumberOfTilesTooMany = 0;
  size_t NumberOfTilesDrawn = 0;
};

#endif
