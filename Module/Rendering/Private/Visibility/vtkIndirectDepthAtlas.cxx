// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Visibility/vtkIndirectDepthAtlas.h"

#include "Capture/vtkIndirectDarkLight.h"
#include "Capture/vtkIndirectShadowMaps.h"
#include "Capture/vtkSurfaceCapturePass.h"
#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectRendererAccess.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <unordered_map>

namespace
{
const vtkIndirectChannel NoChannels[] = { { nullptr, nullptr, nullptr, 0, nullptr, nullptr } };

// Limits of the atlas: texels along an edge, and texels in all (256 MB). OpenGL may allow less for
// a texture.
constexpr int MostTexels = 16384;
constexpr double MostOfAll = 64.0 * 1024.0 * 1024.0;
// With too many tiles for the atlas, tiles have fewer texels, but at least this many.
constexpr int LeastTexels = 16;

// A frame draws at least this many tiles, however short its time. The first tiles are drawn
// together, because fewer tiles represent all other emitters badly.
constexpr size_t LeastTiles = 1;
constexpr size_t FirstTiles = 4;

// A coarse level deviates from its mesh by at most this many texels: the neighbours of a texel are
// as far away.
constexpr double MostErrorOfLevels = 0.5;

// After this many triangles the draw calls are flushed to OpenGL. Software rasterizers start on
// them while the next ones are prepared, which saves a tenth of the time.
constexpr size_t TrianglesOfBatch = 1 << 17;
}

//------------------------------------------------------------------------------
vtkIndirectDepthAtlas::vtkIndirectDepthAtlas(bool strips)
  : Strips(strips)
  , Depths(NoChannels, true)
  , Camera(vtkSmartPointer<vtkOpenGLCamera>::New())
{
}

vtkIndirectDepthAtlas::~vtkIndirectDepthAtlas() = default;

//------------------------------------------------------------------------------
// Marks tiles as stale that can see a caster that has come, gone or changed since they were drawn.
void vtkIndirectDepthAtlas::ForgetWhatChanged(const vtkIndirectFrame& frame)
{
  if (frame.SceneScale != this->SceneScale || frame.SceneCenter != this->SceneCenter)
  {
    for (Drawing& drawing : this->Drawn)
    {
      // The near and far plane of a perspective tile depend on the units.
      drawing.There = drawing.There && drawing.Tile.Parallel;
      if (drawing.There)
      {
        drawing.Tile = drawing.Tile.FromUnits(this->SceneScale, this->SceneCenter, frame);
      }
    }
    this->SceneScale = frame.SceneScale;
    this->SceneCenter = frame.SceneCenter;
  }
  std::vector<Caster> now;
  now.reserve(frame.Casters.size());
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    Caster entry = { caster.Prop, caster.Revision, {} };
    std::copy(caster.Bounds, caster.Bounds + 6, entry.Bounds);
    now.push_back(entry);
  }
  if (now == this->Casters)
  {
    return;
  }
  std::unordered_map<vtkProp*, const Caster*> before;
  for (const Caster& caster : this->Casters)
  {
    before[caster.Prop] = &caster;
  }
  std::vector<const double*> changed;
  for (const Caster& caster : now)
  {
    const auto found = before.find(caster.Prop);
    if (found == before.end())
    {
      changed.push_back(caster.Bounds);
      continue;
    }
    const Caster& last = *found->second;
    if (!(last == caster))
    {
      changed.push_back(caster.Bounds);
      changed.push_back(last.Bounds);
    }
    before.erase(found);
  }
  for (const auto& gone : before)
  {
    changed.push_back(gone.second->Bounds);
  }
  for (Drawing& drawing : this->Drawn)
  {
    for (size_t i = 0; drawing.Valid && i < changed.size(); ++i)
    {
      drawing.Valid = !drawing.Tile.CanSee(frame, changed[i], this->Texels);
    }
  }
  this->Casters = std::move(now);
}

//------------------------------------------------------------------------------
// Chooses the tiles to draw now.
std::vector<int> vtkIndirectDepthAtlas::ChooseTiles(
  const std::vector<Emitter>& emitters, size_t count, size_t most)
{
  this->Drawn.resize(count);
  std::vector<int> missing;
  std::vector<int> stale;
  for (size_t i = 0; i < count; ++i)
  {
    Drawing& drawing = this->Drawn[i];
    const vtkIndirectDepthTile& tile = emitters[i].Tile;
    const bool same = drawing.There && drawing.Tile == tile;
    const bool moved = drawing.There && tile.Parallel && drawing.Tile.Forward == tile.Forward;
    drawing.There = same || moved;
    drawing.Valid = drawing.Valid && same;
    if (!emitters[i].Sends)
    {
      continue;
    }
    if (!drawing.There)
    {
      missing.push_back(static_cast<int>(i));
    }
    else if (!drawing.Valid)
    {
      stale.push_back(static_cast<int>(i));
    }
  }
  std::stable_sort(missing.begin(), missing.end(),
    [&](int a, int b)
    { return emitters[static_cast<size_t>(a)].Turn < emitters[static_cast<size_t>(b)].Turn; });
  std::stable_sort(stale.begin(), stale.end(),
    [this](int a, int b) {
      return this->Drawn[static_cast<size_t>(a)].Time < this->Drawn[static_cast<size_t>(b)].Time;
    });
  const bool first = std::none_of(
    this->Drawn.begin(), this->Drawn.end(), [](const Drawing& drawing) { return drawing.There; });
  most = std::max(most, first ? FirstTiles : LeastTiles);
  std::vector<int> chosen = missing;
  chosen.insert(chosen.end(), stale.begin(), stale.end());
  const size_t all = chosen.size();
  chosen.resize(std::min(all, most));
  this->NumberOfMissingTiles =
    static_cast<int>(missing.size() - std::min(missing.size(), chosen.size()));
  this->NumberOfStaleTiles = static_cast<int>(all - chosen.size());
  for (const int i : chosen)
  {
    this->Drawn[static_cast<size_t>(i)] = { emitters[static_cast<size_t>(i)].Tile, true, true,
      ++this->NumberOfTilesDrawn };
  }
  return chosen;
}

//------------------------------------------------------------------------------
bool vtkIndirectDepthAtlas::Update(const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture,
  const std::vector<Emitter>& emitters, int texels, bool caching, int tilesPerFrame)
{
  const int edge = std::min(vtkTextureObject::GetMaximumTextureSize(frame.Window), MostTexels);
  const int fitting = this->FindTexels(emitters.size(), texels, edge);
  if (fitting != this->Texels)
  {
    this->Forget();
    this->Texels = fitting;
  }
  const glm::ivec2 size = this->GetTileSize(this->Texels);
  const int most = this->CountMostTiles(fitting, edge);
  const int count = static_cast<int>(std::min(emitters.size(), static_cast<size_t>(most)));
  // Uses as few columns as possible: then rows of a tile lie close together in memory, which suits
  // the processor's caches.
  const int mostRows = std::max(1, edge / size.y);
  const int columns = std::max(1, (count + mostRows - 1) / mostRows);
  const int rows = std::max(1, (count + columns - 1) / columns);
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  if (!caching || columns != this->Columns || rows != this->Rows)
  {
    this->Forget();
  }
  this->Columns = columns;
  this->Rows = rows;
  if (!this->Depths.Resize(frame.Window, columns * size.x, rows * size.y))
  {
    this->Forget();
    return false;
  }
  this->ForgetWhatChanged(frame);
  this->NumberOfTilesTooMany = static_cast<int>(emitters.size()) - count;
  const std::vector<int> stale =
    this->ChooseTiles(emitters, static_cast<size_t>(count), static_cast<size_t>(tilesPerFrame));
  if (stale.empty())
  {
    return true;
  }
  this->Depths.Begin();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDisable(GL_BLEND);
  const std::vector<View> views = this->Clear(frame, stale);
  const std::vector<const vtkIndirectCaster*> others = this->DrawPlain(frame, views);
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
// Returns how many tiles of this size fit into a texture of this edge and into the atlas's memory.
int vtkIndirectDepthAtlas::CountMostTiles(int texels, int edge) const
{
  const glm::ivec2 size = this->GetTileSize(texels);
  return std::max(1,
    std::min((edge / size.x) * (edge / size.y),
      static_cast<int>(MostOfAll / (static_cast<double>(size.x) * size.y))));
}

//------------------------------------------------------------------------------
// Returns the wanted number of texels, or fewer, so that all tiles fit.
int vtkIndirectDepthAtlas::FindTexels(size_t count, int texels, int edge) const
{
  while (
    texels / 2 >= LeastTexels && count > static_cast<size_t>(this->CountMostTiles(texels, edge)))
  {
    texels /= 2;
  }
  return texels;
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
void vtkIndirectDepthAtlas::Use(const vtkIndirectFrame& frame, int tile, int view)
{
  vtkOpenGLState* state = frame.Window->GetState();
  const glm::ivec2 first =
    glm::ivec2(tile % this->Columns, tile / this->Columns) * this->GetTileSize(this->Texels) +
    vtkIndirectDepthTile::GetPlaceOfView(view, this->Texels, this->Strips);
  const glm::ivec2 size = vtkIndirectDepthTile::GetSizeOfView(view, this->Texels);
  state->vtkglViewport(first.x, first.y, size.x, size.y);
  state->vtkglScissor(first.x, first.y, size.x, size.y);
}

//------------------------------------------------------------------------------
// Clears tiles and returns their views, which are to be drawn.
std::vector<vtkIndirectDepthAtlas::View> vtkIndirectDepthAtlas::Clear(
  const vtkIndirectFrame& frame, const std::vector<int>& tiles)
{
  std::vector<View> views;
  for (const int number : tiles)
  {
    const vtkIndirectDepthTile& tile = this->Drawn[static_cast<size_t>(number)].Tile;
    for (int k = 0; k < (this->Strips ? vtkIndirectDepthTile::NumberOfViews : 1); ++k)
    {
      if (k == 0 || tile.Strips[static_cast<size_t>(k - 1)].HalfWidth.x > 0.0)
      {
        View view = { number, k, tile.GetView(k), {} };
        view.ToClip = view.Camera.GetWorldToClip(frame);
        views.push_back(view);
        this->Use(frame, number, k);
        this->Depths.ClearDepth();
      }
    }
  }
  return views;
}

//------------------------------------------------------------------------------
// Finds the views of a view's tile that see these bounds.
unsigned int vtkIndirectDepthAtlas::FindViews(
  const vtkIndirectFrame& frame, const View& view, const double bounds[6])
{
  return this->Drawn[static_cast<size_t>(view.Tile)].Tile.FindViews(frame, bounds, this->Texels);
}

//------------------------------------------------------------------------------
// Draws all views of one prop after the other. Returns the casters that only their own mappers can
// draw.
std::vector<const vtkIndirectCaster*> vtkIndirectDepthAtlas::DrawPlain(
  const vtkIndirectFrame& frame, const std::vector<View>& views)
{
  // A view, and the deviation of a coarse level in it, in world units.
  struct Look
  {
    const View* Of;
    double Error;
  };
  std::vector<const vtkIndirectCaster*> others;
  size_t triangles = 0; // in the batch so far
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    if (!vtkIndirectDepthDrawer::CanDraw(caster.Prop))
    {
      others.push_back(&caster);
      continue;
    }
    // Groups views by level, in the order of tiles: the buffers of a level are set up once.
    std::map<vtkIndirectCoarseLevels::Level*, std::vector<Look>> looks;
    const bool hasLevels = frame.Levels && frame.Levels->Has(caster.Prop);
    unsigned int seen = 0;
    for (const View& view : views)
    {
      // Views of a tile follow each other, the view ahead first.
      seen = view.Number == 0 ? this->FindViews(frame, view, caster.Bounds) : seen;
      if ((seen >> view.Number) & 1u)
      {
        Look look = { &view, 0.0 };
        vtkIndirectCoarseLevels::Level* level = nullptr;
        if (hasLevels)
        {
          const double texel = view.Camera.FindTexelAt(frame, caster.Bounds,
            glm::dvec2(vtkIndirectDepthTile::GetSizeOfView(view.Number, this->Texels)));
          level = frame.Levels->Find(caster.Prop, MostErrorOfLevels * texel, look.Error);
        }
        looks[level].push_back(look);
      }
    }
    bool failed = false;
    for (const auto& [level, list] : looks)
    {
      if (!this->Drawer.Begin(frame.Window, caster.Prop, level))
      {
        failed = true;
        break;
      }
      for (const Look& look : list)
      {
        const View& view = *look.Of;
        this->Use(frame, view.Tile, view.Number);
        if (level)
        {
          // A coarse level must not hide the mesh that it replaces: it is drawn behind by its
          // deviation. Look-ups allow for the effect of slopes by their allowance for a texel;
          // glPolygonOffset would do the same and doubles the time of software rasterizers.
          const size_t drawn = this->Drawer.Draw(
            view.ToClip * glm::translate(glm::dmat4(1.0), view.Camera.Forward * look.Error));
          frame.Levels->Count(drawn, this->Drawer.CountTriangles());
          triangles += drawn;
        }
        else
        {
          triangles += this->Drawer.Draw(view.ToClip);
        }
        if (triangles >= TrianglesOfBatch)
        {
          glFlush();
          triangles = 0;
        }
      }
      this->Drawer.End();
    }
    if (failed)
    {
      others.push_back(&caster);
    }
  }
  return others;
}

//------------------------------------------------------------------------------
void vtkIndirectDepthAtlas::DrawOthers(const vtkIndirectFrame& frame,
  vtkSurfaceCapturePass* capture, const std::vector<View>& views,
  const std::vector<const vtkIndirectCaster*>& casters)
{
  vtkCamera*& active = vtkIndirectRendererAccess::Camera(frame.Renderer);
  vtkCamera* const eye = active;
  active = this->Camera;
  const vtkIndirectDarkLight dark(frame);
  capture->Attach(frame);
  for (const View& view : views)
  {
    const vtkIndirectDepthTile& tile = view.Camera;
    this->Use(frame, view.Tile, view.Number);
    tile.SetUp(this->Camera, frame);
    const glm::dvec2 widths = 2.0 * tile.HalfWidth /
      glm::dvec2(vtkIndirectDepthTile::GetSizeOfView(view.Number, this->Texels));
    capture->BeginMap(
      frame, { !tile.Parallel, tile.Parallel, tile.Near, tile.Far, std::max(widths.x, widths.y) });
    for (const vtkIndirectCaster* caster : casters)
    {
      if ((this->FindViews(frame, view, caster->Bounds) >> view.Number) & 1u)
      {
        capture->BeginCaster(false);
        caster->Prop->RenderOpaqueGeometry(frame.Renderer);
      }
    }
    capture->EndStage();
  }
  capture->Detach();
  active = eye;
}

//------------------------------------------------------------------------------
void vtkIndirectDepthAtlas::Activate(vtkShaderProgram* program) const
{
  this->Depths.ActivateDepth(program, "vtkiDepthTiles");
  vtkIndirectSetUniform(
    program, "vtkiTileShape", glm::vec3(this->Columns, this->Rows, this->Texels));
}

//------------------------------------------------------------------------------
void vtkIndirectDepthAtlas::Deactivate() const
{
  this->Depths.Deactivate();
}

//------------------------------------------------------------------------------
void vtkIndirectDepthAtlas::Release(vtkWindow* window)
{
  this->Depths.Release(window);
  this->Drawer.Release(window);
  this->Forget();
  this->Casters.clear();
  this->Columns = this->Rows = this->Texels = 0;
}
