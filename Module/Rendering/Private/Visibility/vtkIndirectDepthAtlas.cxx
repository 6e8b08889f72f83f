// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Visibility/vtkIndirectDepthAtlas.h"

#include "Capture/vtkIndirectDarkLight.h"
#include "Capture/vtkIndirectShadowMaps.h"
#include "Capture/vtkSurfaceCapturePass.h"
#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectRendererAccess.h"
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

// Of the atlas, texels; of a texture OpenGL may allow less.
constexpr int MostTexels = 16384;

// Drawn however little time there is: the first ones together, because fewer stand for all others
// too badly.
constexpr size_t LeastTiles = 1;
constexpr size_t FirstTiles = 4;

// A coarse level is no farther than this from what it stands for: neighbours of a texel are as far.
constexpr double MostErrorOfLevels = 0.5;

// After so many triangles what was asked for goes to OpenGL. Software rasterizers begin with them
// while the next ones are prepared, which saves a tenth.
constexpr size_t TrianglesOfBatch = 1 << 17;
}

//------------------------------------------------------------------------------
vtkIndirectDepthAtlas::vtkIndirectDepthAtlas()
  : Depths(NoChannels, true)
  , Camera(vtkSmartPointer<vtkOpenGLCamera>::New())
{
}

vtkIndirectDepthAtlas::~vtkIndirectDepthAtlas() = default;

//------------------------------------------------------------------------------
// Tiles that can see what has come, gone or changed since they were drawn.
void vtkIndirectDepthAtlas::ForgetWhatChanged(const vtkIndirectFrame& frame)
{
  if (frame.SceneScale != this->SceneScale || frame.SceneCenter != this->SceneCenter)
  {
    for (Drawing& drawing : this->Drawn)
    {
      // Where a perspective tile begins and ends depends on the units.
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
// Those to draw now.
std::vector<int> vtkIndirectDepthAtlas::ChooseTiles(
  const std::vector<Emitter>& emitters, size_t most)
{
  this->Drawn.resize(emitters.size());
  std::vector<int> missing;
  std::vector<int> stale;
  for (size_t i = 0; i < emitters.size(); ++i)
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
  const std::vector<Emitter>& emitters, int texels, bool caching, int most)
{
  const int count = static_cast<int>(emitters.size());
  // In as few columns as there can be: rows of a tile that follow each other in memory are what
  // processors' caches like.
  const int height = std::min(vtkTextureObject::GetMaximumTextureSize(frame.Window), MostTexels);
  const int mostRows = std::max(1, height / texels);
  const int columns = std::max(1, (count + mostRows - 1) / mostRows);
  const int rows = std::max(1, (count + columns - 1) / columns);
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  if (!caching || texels != this->Texels || columns != this->Columns || rows != this->Rows)
  {
    this->Forget();
  }
  this->Texels = texels;
  this->Columns = columns;
  this->Rows = rows;
  if (!this->Depths.Resize(frame.Window, columns * texels, rows * texels))
  {
    this->Forget();
    return false;
  }
  this->ForgetWhatChanged(frame);
  const std::vector<int> stale = this->ChooseTiles(emitters, static_cast<size_t>(most));
  if (stale.empty())
  {
    return true;
  }
  this->Depths.Begin();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDisable(GL_BLEND);
  for (const int tile : stale)
  {
    this->Use(frame, tile);
    this->Depths.ClearDepth();
  }
  const std::vector<const vtkIndirectCaster*> others = this->DrawPlain(frame, stale);
  if (!others.empty())
  {
    this->DrawOthers(frame, capture, stale, others);
  }
  this->Depths.End();
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectDepthAtlas::Use(const vtkIndirectFrame& frame, int tile)
{
  vtkOpenGLState* state = frame.Window->GetState();
  const int x = tile % this->Columns * this->Texels;
  const int y = tile / this->Columns * this->Texels;
  state->vtkglViewport(x, y, this->Texels, this->Texels);
  state->vtkglScissor(x, y, this->Texels, this->Texels);
}

//------------------------------------------------------------------------------
// Prop by prop, all tiles of one. Returns those that only their mappers can draw.
std::vector<const vtkIndirectCaster*> vtkIndirectDepthAtlas::DrawPlain(
  const vtkIndirectFrame& frame, const std::vector<int>& tiles)
{
  // A tile, and how far a level is off in it, in world units.
  struct View
  {
    size_t Tile;
    double Error;
  };
  std::vector<const vtkIndirectCaster*> others;
  std::vector<glm::dmat4> toClip;
  for (const int tile : tiles)
  {
    toClip.push_back(this->Drawn[static_cast<size_t>(tile)].Tile.GetWorldToClip(frame));
  }
  size_t triangles = 0; // of the batch
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    if (!vtkIndirectDepthDrawer::CanDraw(caster.Prop))
    {
      others.push_back(&caster);
      continue;
    }
    // By what is drawn of it, in the order of tiles: its buffers are set up once for each.
    std::map<vtkIndirectCoarseLevels::Level*, std::vector<View>> views;
    const bool hasLevels = frame.Levels && frame.Levels->Has(caster.Prop);
    for (size_t i = 0; i < tiles.size(); ++i)
    {
      const vtkIndirectDepthTile& tile = this->Drawn[static_cast<size_t>(tiles[i])].Tile;
      if (tile.CanSee(frame, caster.Bounds, this->Texels))
      {
        View view = { i, 0.0 };
        vtkIndirectCoarseLevels::Level* level = nullptr;
        if (hasLevels)
        {
          const double texel = tile.FindTexelAt(frame, caster.Bounds, this->Texels);
          level = frame.Levels->Find(caster.Prop, MostErrorOfLevels * texel, view.Error);
        }
        views[level].push_back(view);
      }
    }
    bool failed = false;
    for (const auto& [level, list] : views)
    {
      if (!this->Drawer.Begin(frame.Window, caster.Prop, level))
      {
        failed = true;
        break;
      }
      for (const View& view : list)
      {
        const vtkIndirectDepthTile& tile = this->Drawn[static_cast<size_t>(tiles[view.Tile])].Tile;
        this->Use(frame, tiles[view.Tile]);
        if (level)
        {
          // What it stands for must not hide itself: it lies behind by its distance. What a slope
          // makes of that, look-ups allow for by what it makes of a texel; glPolygonOffset would
          // say the same and doubles the time of software rasterizers.
          const size_t drawn = this->Drawer.Draw(
            toClip[view.Tile] * glm::translate(glm::dmat4(1.0), tile.Forward * view.Error));
          frame.Levels->Count(drawn, this->Drawer.CountTriangles());
          triangles += drawn;
        }
        else
        {
          triangles += this->Drawer.Draw(toClip[view.Tile]);
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
  vtkSurfaceCapturePass* capture, const std::vector<int>& tiles,
  const std::vector<const vtkIndirectCaster*>& casters)
{
  vtkCamera*& active = vtkIndirectRendererAccess::Camera(frame.Renderer);
  vtkCamera* const eye = active;
  active = this->Camera;
  const vtkIndirectDarkLight dark(frame);
  capture->Attach(frame);
  for (const int number : tiles)
  {
    const vtkIndirectDepthTile& tile = this->Drawn[static_cast<size_t>(number)].Tile;
    this->Use(frame, number);
    tile.SetUp(this->Camera, frame);
    const double width = 2.0 * std::max(tile.HalfWidth.x, tile.HalfWidth.y) / this->Texels;
    capture->BeginMap(frame, { !tile.Parallel, tile.Parallel, tile.Near, tile.Far, width });
    for (const vtkIndirectCaster* caster : casters)
    {
      if (tile.CanSee(frame, caster->Bounds, this->Texels))
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
