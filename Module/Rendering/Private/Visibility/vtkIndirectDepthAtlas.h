// SPDX-License-Identifier: BSD-3-Clause
// Depth maps of any number of emitters, tiles of one texture. VTK's mappers draw them through the
// capture, so that glyphs, impostors and textures cast the shadows that they draw. They are kept
// while the camera moves: a tile is drawn again only when its emitter, or something that it can
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
  vtkIndirectDepthAtlas();
  ~vtkIndirectDepthAtlas();

  /**
   * An emitter's tile, whether it sends anything (others are left as they are), and when it is
   * drawn among those that have none: those of lower numbers come first.
   */
  struct Emitter
  {
    vtkIndirectDepthTile Tile;
    bool Sends = true;
    size_t Turn = 0;
  };

  /**
   * Brings tiles of these emitters up to date, each of so many texels along an edge, and not more
   * of them than `most`, but one, and four where there are none: first those that have none, then
   * those that have waited longest. Of a direction that is fitted to another scene, what was drawn
   * before is kept until then. Without caching nothing is kept. Returns false, after an error, when
   * OpenGL refuses.
   */
  bool Update(const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture,
    const std::vector<Emitter>& emitters, int texels, bool caching, int most = 1 << 30);

  /** Says that nothing of it is to be kept. */
  void Forget() { this->Drawn.clear(); }

  /** Whether there is a map of this emitter; it may show what was there a few frames ago. */
  bool HasTile(size_t emitter) const
  {
    return emitter < this->Drawn.size() && this->Drawn[emitter].There;
  }
  /** That map as it was drawn. */
  const vtkIndirectDepthTile& GetTile(size_t emitter) const { return this->Drawn[emitter].Tile; }
  ///@{
  /** After Update: emitters that have no map; and maps, these included, that are not up to date. */
  int GetNumberOfMissingTiles() const { return this->NumberOfMissingTiles; }
  int GetNumberOfStaleTiles() const { return this->NumberOfStaleTiles; }
  ///@}

  /** Binds the depths and sets vtkiDepthTiles and vtkiTileShape; pair. */
  void Activate(vtkShaderProgram* program) const;
  void Deactivate() const;

  int GetNumberOfTiles() const { return static_cast<int>(this->Drawn.size()); }
  int GetTexels() const { return this->Texels; }
  int GetNumberOfColumns() const { return this->Columns; }
  int GetNumberOfRows() const { return this->Rows; }
  /** How many were drawn, since construction. */
  size_t GetNumberOfTilesDrawn() const { return this->NumberOfTilesDrawn; }
  size_t GetBytes() const { return this->Depths.GetBytes(); }
  void Release(vtkWindow* window);

private:
  // A tile as it was drawn.
  struct Drawing
  {
    vtkIndirectDepthTile Tile;
    bool There = false; // drawn for this tile
    bool Valid = false; // and nothing that it can see has changed since
    size_t Time = 0;    // NumberOfTilesDrawn then
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
  std::vector<int> ChooseTiles(const std::vector<Emitter>& emitters, size_t most);
  void Use(const vtkIndirectFrame& frame, int tile);
  std::vector<const vtkIndirectCaster*> DrawPlain(
    const vtkIndirectFrame& frame, const std::vector<int>& tiles);
  void DrawOthers(const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture,
    const std::vector<int>& tiles, const std::vector<const vtkIndirectCaster*>& casters);

  vtkIndirectTarget Depths;
  vtkIndirectDepthDrawer Drawer;
  vtkSmartPointer<vtkOpenGLCamera> Camera;
  std::vector<Drawing> Drawn;
  std::vector<Caster> Casters; // when they were
  double SceneScale = 0.0;
  glm::dvec3 SceneCenter{ 0.0 };
  int Texels = 0;
  int Columns = 0; // of tiles
  int Rows = 0;
  int NumberOfMissingTiles = 0;
  int NumberOfStaleTiles = 0;
  size_t NumberOfTilesDrawn = 0;
};

#endif
