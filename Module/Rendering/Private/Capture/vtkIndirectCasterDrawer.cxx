// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Capture/vtkIndirectCasterDrawer.h"

#include "Capture/vtkIndirectCoarseLevels.h"
#include "Capture/vtkIndirectPartViews.h"
#include "OpenGL/vtkIndirectBackEndChoices.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace
{
// After this many triangles the draw calls are flushed to OpenGL. Software rasterizers start on
// them while the next ones are prepared, which saves a tenth of the time.
constexpr size_t TrianglesOfFlush = 1 << 17;

// Returns an emitter's place and 1, or the direction to it and 0, in world coordinates.
glm::dvec4 GetEmitter(const vtkIndirectFrame& frame, const vtkIndirectCasterDrawer::View& view)
{
  const vtkIndirectDepthTile& tile = view.Camera;
  return tile.Parallel ? glm::dvec4(-tile.Forward, 0.0)
                       : glm::dvec4(frame.ToWorld(tile.Place), 1.0);
}
}

//------------------------------------------------------------------------------
vtkIndirectCasterDrawer::vtkIndirectCasterDrawer(vtkIndirectResource* owner)
  : Drawer(owner)
{
}

//------------------------------------------------------------------------------
vtkIndirectCasterDrawer::View::View(const vtkIndirectFrame& frame, const vtkIndirectDepthTile& tile,
  int number, const glm::ivec2& first, const glm::ivec2& size)
  : Whole(&tile)
  , Number(number)
  , Camera(tile.GetView(number))
  , ToClip(this->Camera.GetWorldToClip(frame))
  , First(first)
  , Size(size)
{
}

//------------------------------------------------------------------------------
void vtkIndirectCasterDrawer::View::Use(const vtkIndirectFrame& frame) const
{
  vtkOpenGLState* state = frame.Window->GetState();
  state->vtkglViewport(this->First.x, this->First.y, this->Size.x, this->Size.y);
  state->vtkglScissor(this->First.x, this->First.y, this->Size.x, this->Size.y);
}

//------------------------------------------------------------------------------
std::vector<const vtkIndirectCaster*> vtkIndirectCasterDrawer::Draw(const vtkIndirectFrame& frame,
  const std::vector<const vtkIndirectCaster*>& casters, const std::vector<View>& views, int texels,
  double mostError, bool slopes, vtkIndirectTarget* target)
{
  using namespace vtkIndirectBackEndChoices;
  std::vector<const vtkIndirectCaster*> others;
  this->MostError = mostError;
  this->Slopes = slopes;
  this->Target = Get(Triangles) == TrianglesOfTexels ? target : nullptr;
  this->TrianglesOfBatch = 0;
  this->Depths.resize(views.size());
  std::vector<Work> works;
  const auto draw = [&](const vtkIndirectCaster* caster, vtkIndirectMeshParts* parts)
  {
    works.push_back({ caster, parts, {}, {} });
    if (!this->DrawParts(frame, works.back(), views, texels))
    {
      works.pop_back();
      others.push_back(caster);
    }
  };
  // The processor's depths replace what is there, and so come first.
  std::vector<std::pair<const vtkIndirectCaster*, vtkIndirectMeshParts*>> later;
  for (const vtkIndirectCaster* caster : casters)
  {
    if (!vtkIndirectDepthDrawer::CanDraw(caster->Prop))
    {
      others.push_back(caster);
      continue;
    }
    vtkIndirectMeshParts* parts = frame.Levels ? frame.Levels->Find(caster->Prop) : nullptr;
    if (this->Writes(parts))
    {
      draw(caster, parts);
    }
    else
    {
      later.emplace_back(caster, parts);
    }
  }
  this->Upload(views);
  for (const auto& [caster, parts] : later)
  {
    draw(caster, parts);
  }
  for (const Work& work : works)
  {
    if (!this->DrawRest(frame, work))
    {
      others.push_back(work.Caster);
    }
  }
  return others;
}

//------------------------------------------------------------------------------
void vtkIndirectCasterDrawer::Use(const vtkIndirectFrame& frame, const View& view)
{
  view.Use(frame);
  if (this->Slopes)
  {
    const vtkIndirectDepthTile& camera = view.Camera;
    this->Drawer.SetSlopeScale(
      0.5 * (camera.Far - camera.Near) * glm::dvec2(view.Size) / camera.HalfWidth);
  }
}

//------------------------------------------------------------------------------
// Returns true if the processor writes the levels of parts.
bool vtkIndirectCasterDrawer::Writes(const vtkIndirectMeshParts* parts) const
{
  return this->Target && parts && parts->HasInsets;
}

//------------------------------------------------------------------------------
// Draws the levels of a prop's parts, and finds the views for which no level is fine enough, or all
// where the prop has no parts. Returns false after an error.
bool vtkIndirectCasterDrawer::DrawParts(
  const vtkIndirectFrame& frame, Work& work, const std::vector<View>& views, int texels)
{
  vtkProp* const prop = work.Caster->Prop;
  if (!work.Parts)
  {
    unsigned int seen = 0;
    for (const View& view : views)
    {
      seen = view.Number == 0 ? view.Whole->FindViews(frame, work.Caster->Bounds, texels) : seen;
      if ((seen >> view.Number) & 1u)
      {
        work.Whole.push_back(&view);
      }
    }
    return true;
  }
  vtkIndirectPartViews seen(*work.Parts, prop);
  const size_t full = vtkIndirectDepthDrawer::CountTriangles(prop);
  const bool writes = this->Writes(work.Parts);
  bool begun = false;
  for (size_t i = 0; i < views.size(); ++i)
  {
    const View& view = views[i];
    // Views of a tile follow each other, the view ahead first.
    if (view.Number == 0)
    {
      seen.SetTile(frame, *view.Whole, texels);
    }
    if (seen.Choose(frame, view.Camera, view.Number, texels, this->MostError))
    {
      work.Whole.push_back(&view);
    }
    if (seen.IsEmpty())
    {
      continue;
    }
    if (writes)
    {
      frame.Levels->Count(this->WriteLevels(frame, view, i, work, seen), full);
      continue;
    }
    if (!begun && !this->Drawer.Begin(frame.Window, prop, work.Parts, this->Slopes))
    {
      return false;
    }
    begun = true;
    const size_t drawn = this->DrawLevels(frame, view, *work.Parts, seen);
    frame.Levels->Count(drawn, full);
    this->Flush(drawn);
  }
  if (begun)
  {
    this->Drawer.End();
  }
  return true;
}

//------------------------------------------------------------------------------
// Draws what the processor has left, and the prop's own mesh into the views that show the mesh.
// Returns false after an error.
bool vtkIndirectCasterDrawer::DrawRest(const vtkIndirectFrame& frame, const Work& work)
{
  vtkProp* const prop = work.Caster->Prop;
  if (!work.Left.empty())
  {
    if (!this->Drawer.Begin(frame.Window, prop, work.Parts, this->Slopes))
    {
      return false;
    }
    for (const auto& [view, indices] : work.Left)
    {
      this->Use(frame, *view);
      this->Drawer.Draw(view->ToClip, GetEmitter(frame, *view), indices);
    }
    this->Drawer.End();
  }
  if (work.Whole.empty())
  {
    return true;
  }
  if (!this->Drawer.Begin(frame.Window, prop, nullptr, this->Slopes))
  {
    return false;
  }
  for (const View* view : work.Whole)
  {
    this->Use(frame, *view);
    this->Flush(this->Drawer.Draw(view->ToClip));
  }
  this->Drawer.End();
  return true;
}

//------------------------------------------------------------------------------
// Returns the number of triangles.
size_t vtkIndirectCasterDrawer::DrawLevels(const vtkIndirectFrame& frame, const View& view,
  const vtkIndirectMeshParts& parts, const vtkIndirectPartViews& seen)
{
  this->Use(frame, view);
  size_t drawn = 0;
  for (size_t level = 0; level < parts.NumberOfLevels; ++level)
  {
    const std::vector<vtkIndirectMeshParts::Level>& levels = seen.GetLevels(level);
    if (!levels.empty())
    {
      // A coarse level must not hide the mesh that it replaces: without insets it is drawn behind
      // by its error where it faces the emitter, and up to 55 degrees from there. Look-ups allow
      // for steeper slopes by their allowance for a texel; glPolygonOffset would do the same and
      // doubles the time of software rasterizers.
      const double behind = parts.HasInsets ? 0.0 : std::sqrt(3.0) * seen.FindError(level);
      drawn += this->Drawer.Draw(
        view.ToClip * glm::translate(glm::dmat4(1.0), view.Camera.Forward * behind),
        GetEmitter(frame, view), levels);
    }
  }
  return drawn;
}

//------------------------------------------------------------------------------
// Writes the depths of levels into the image of a view, and keeps the triangles that OpenGL has to
// draw. Returns the number of the levels' triangles.
size_t vtkIndirectCasterDrawer::WriteLevels(const vtkIndirectFrame& frame, const View& view,
  size_t number, Work& work, const vtkIndirectPartViews& seen)
{
  vtkIndirectMeshParts& parts = *work.Parts;
  parts.GatherPieces();
  std::vector<float>& depths = this->Depths[number];
  depths.resize(static_cast<size_t>(view.Size.x) * static_cast<size_t>(view.Size.y), 1.0f);
  const glm::dmat4 toWorld = vtkIndirectDepthDrawer::GetToWorld(work.Caster->Prop, parts);
  this->Small.SetView(glm::mat4(view.ToClip * toWorld), view.Size,
    glm::vec4(glm::inverse(toWorld) * GetEmitter(frame, view)));
  size_t indices = 0;
  std::vector<size_t> large;
  std::vector<unsigned int> left;
  for (size_t level = 0; level < parts.NumberOfLevels; ++level)
  {
    for (const vtkIndirectMeshParts::Level& range : seen.GetLevels(level))
    {
      for (size_t k = 0; k < range.NumberOfPieces; ++k)
      {
        const vtkIndirectMeshParts::Piece& piece = parts.Pieces[range.FirstPiece + k];
        this->Small.ProjectInsets(
          &parts.PiecePoints[vtkIndirectMeshParts::FloatsOfPoint * piece.FirstPoint],
          piece.NumberOfPoints);
        large.clear();
        this->Small.Draw(&parts.PieceIndices[piece.First], piece.Count, depths.data(), large);
        for (const size_t i : large)
        {
          const auto first = parts.Indices.begin() + static_cast<std::ptrdiff_t>(piece.First + i);
          left.insert(left.end(), first, first + 3);
        }
      }
      indices += range.Count;
    }
  }
  if (!left.empty())
  {
    work.Left.emplace_back(&view, std::move(left));
  }
  return indices / 3;
}

//------------------------------------------------------------------------------
void vtkIndirectCasterDrawer::Upload(const std::vector<View>& views)
{
  for (size_t i = 0; i < views.size(); ++i)
  {
    if (!this->Depths[i].empty())
    {
      this->Target->WriteDepth(&views[i].First[0], &views[i].Size[0], this->Depths[i].data());
    }
  }
  this->Depths.clear();
}

//------------------------------------------------------------------------------
// Flushes draw calls to OpenGL after TrianglesOfFlush triangles.
void vtkIndirectCasterDrawer::Flush(size_t triangles)
{
  this->TrianglesOfBatch += triangles;
  if (this->TrianglesOfBatch >= TrianglesOfFlush)
  {
    glFlush();
    this->TrianglesOfBatch = 0;
  }
}
