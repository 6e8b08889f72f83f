// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Capture/vtkIndirectCasterDrawer.h"

#include "Capture/vtkIndirectCoarseLevels.h"
#include "Capture/vtkIndirectPartViews.h"
#include "Frame/vtkIndirectFrame.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace
{
// After this many triangles the draw calls are flushed to OpenGL. Software rasterizers start on
// them while the next ones are prepared, which saves a tenth of the time.
constexpr size_t TrianglesOfFlush = 1 << 17;
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
  double mostError, bool slopes)
{
  std::vector<const vtkIndirectCaster*> others;
  this->MostError = mostError;
  this->Slopes = slopes;
  this->TrianglesOfBatch = 0;
  for (const vtkIndirectCaster* caster : casters)
  {
    if (!vtkIndirectDepthDrawer::CanDraw(caster->Prop) ||
      !this->DrawProp(frame, *caster, views, texels))
    {
      others.push_back(caster);
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
// Draws one prop: the levels of its parts, or its own mesh where no level is fine enough. Returns
// false after an error.
bool vtkIndirectCasterDrawer::DrawProp(const vtkIndirectFrame& frame,
  const vtkIndirectCaster& caster, const std::vector<View>& views, int texels)
{
  vtkIndirectMeshParts* parts = frame.Levels ? frame.Levels->Find(caster.Prop) : nullptr;
  std::vector<const View*> whole; // views of the prop's own mesh
  if (parts)
  {
    vtkIndirectPartViews seen(*parts, caster.Prop);
    const size_t full = vtkIndirectDepthDrawer::CountTriangles(caster.Prop);
    bool begun = false;
    for (const View& view : views)
    {
      // Views of a tile follow each other, the view ahead first.
      if (view.Number == 0)
      {
        seen.SetTile(frame, *view.Whole, texels);
      }
      if (seen.Choose(frame, view.Camera, view.Number, texels, this->MostError))
      {
        whole.push_back(&view);
      }
      if (!seen.IsEmpty())
      {
        if (!begun && !this->Drawer.Begin(frame.Window, caster.Prop, parts, this->Slopes))
        {
          return false;
        }
        begun = true;
        this->DrawLevels(frame, view, *parts, seen, full);
      }
    }
    if (begun)
    {
      this->Drawer.End();
    }
  }
  else
  {
    unsigned int seen = 0;
    for (const View& view : views)
    {
      seen = view.Number == 0 ? view.Whole->FindViews(frame, caster.Bounds, texels) : seen;
      if ((seen >> view.Number) & 1u)
      {
        whole.push_back(&view);
      }
    }
  }
  if (whole.empty())
  {
    return true;
  }
  if (!this->Drawer.Begin(frame.Window, caster.Prop, nullptr, this->Slopes))
  {
    return false;
  }
  for (const View* view : whole)
  {
    this->Use(frame, *view);
    this->Flush(this->Drawer.Draw(view->ToClip));
  }
  this->Drawer.End();
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectCasterDrawer::DrawLevels(const vtkIndirectFrame& frame, const View& view,
  const vtkIndirectMeshParts& parts, const vtkIndirectPartViews& seen, size_t full)
{
  this->Use(frame, view);
  const vtkIndirectDepthTile& tile = view.Camera;
  const glm::dvec4 emitter =
    tile.Parallel ? glm::dvec4(-tile.Forward, 0.0) : glm::dvec4(frame.ToWorld(tile.Place), 1.0);
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
        view.ToClip * glm::translate(glm::dmat4(1.0), view.Camera.Forward * behind), emitter,
        levels);
    }
  }
  frame.Levels->Count(drawn, full);
  this->Flush(drawn);
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
