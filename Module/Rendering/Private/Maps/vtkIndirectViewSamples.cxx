// SPDX-License-Identifier: BSD-3-Clause
#include "Maps/vtkIndirectViewSamples.h"

#include "Capture/vtkSurfaceCapturePass.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <utility>

namespace
{
// Moving frames keep a box that holds this share of the places that the eye sees.
constexpr double LeastHeld = 0.75;
// Texels along an edge of the small picture.
constexpr int ViewTexels = 64;
// A scene that reaches this many half pictures from the picture's middle needs no window.
constexpr double WidestPicture = 2.0;
}

//------------------------------------------------------------------------------
vtkIndirectViewSamples::vtkIndirectViewSamples(vtkIndirectDepthMaps& maps)
  : DepthMaps(maps)
{
}

//------------------------------------------------------------------------------
vtkIndirectDepthTile vtkIndirectViewSamples::FindView(const vtkIndirectFrame& frame)
{
  const glm::dmat4& toScene = frame.ViewToScene;
  const glm::dmat4& projection = frame.Projection;
  vtkIndirectDepthTile view;
  view.Parallel = frame.Parallel;
  view.Place = glm::dvec3(toScene[3]);
  view.Right = glm::normalize(glm::dvec3(toScene[0]));
  view.Up = glm::normalize(glm::dvec3(toScene[1]));
  view.Forward = -glm::normalize(glm::dvec3(toScene[2]));
  view.HalfWidth = 1.0 / glm::dvec2(projection[0][0], projection[1][1]);
  view.Near = frame.Near;
  view.Far = frame.Far;
  if (frame.Parallel)
  {
    view.HalfWidth *= frame.SceneScale;
    view.Place -= view.HalfWidth.x * projection[3][0] * view.Right +
      view.HalfWidth.y * projection[3][1] * view.Up;
  }
  else
  {
    view.Middle = view.HalfWidth * glm::dvec2(projection[2][0], projection[2][1]);
  }
  return view;
}

//------------------------------------------------------------------------------
bool vtkIndirectViewSamples::ReachesBeyond(
  const vtkIndirectFrame& frame, const vtkIndirectDepthTile& view)
{
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec3 p =
      view.ToView(frame.ToScene(vtkIndirectFrame::GetCorner(frame.SceneBounds, i)));
    const double depth = view.Parallel ? 1.0 : p.z;
    const glm::dvec2 beside = glm::abs(glm::dvec2(p) - view.Middle * depth);
    const glm::dvec2 most = WidestPicture * view.HalfWidth * depth;
    if (depth <= 0.0 || beside.x > most.x || beside.y > most.y)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// Returns true if a moving frame follows a still one of the same scene units. Applications whose
// frames all move get new boxes.
bool vtkIndirectViewSamples::FollowsStillFrame(const vtkIndirectFrame& frame, bool moving)
{
  vtkIndirectKey units;
  frame.AppendUnitsTo(units);
  const bool changed = this->Units.Take(std::move(units));
  this->AreOfStillFrame = !moving || (this->AreOfStillFrame && !changed);
  return moving && this->AreOfStillFrame;
}

//------------------------------------------------------------------------------
bool vtkIndirectViewSamples::HoldsMost(const std::vector<vtkIndirectSeen::Place>& places) const
{
  const auto held = std::count_if(places.begin(), places.end(),
    [this](const vtkIndirectSeen::Place& place)
    {
      const glm::dvec3 beside = glm::abs(place.At - this->Box.Middle) - this->Box.Half;
      return std::max({ beside.x, beside.y, beside.z }) <= 0.0;
    });
  return static_cast<double>(held) >= LeastHeld * static_cast<double>(places.size());
}

//------------------------------------------------------------------------------
bool vtkIndirectViewSamples::Update(
  vtkIndirectFrame& frame, bool moving, vtkSurfaceCapturePass* capture)
{
  frame.Seen = {};
  frame.Seen.BoxesAreKept = this->FollowsStillFrame(frame, moving);
  const vtkIndirectDepthTile view = FindView(frame);
  if (frame.Casters.empty() || !ReachesBeyond(frame, view))
  {
    this->Box = this->Near = {};
    this->DepthMaps.Release(vtkIndirectDepthMaps::EYE, frame.Window);
    this->Depths.clear();
    return true;
  }
  this->DepthMaps.Request(vtkIndirectDepthMaps::EYE, frame, { { view } }, ViewTexels);
  const bool drawn = this->DepthMaps.Draw(frame, capture);
  // Drawing by mappers detaches the capture.
  capture->Attach(frame);
  const vtkIndirectDepthAtlas& atlas = this->DepthMaps.Get(vtkIndirectDepthMaps::EYE);
  if (!drawn)
  {
    return false;
  }
  if (this->Depths.empty() || this->Drawn != atlas.GetNumberOfTilesDrawn())
  {
    this->Depths = atlas.ReadBack();
    this->Drawn = atlas.GetNumberOfTilesDrawn();
  }
  const int edge = atlas.GetTexels();
  for (size_t i = 0; i < this->Depths.size(); ++i)
  {
    const double stored = this->Depths[i];
    if (stored >= 1.0)
    {
      continue;
    }
    const double range = view.Far - view.Near;
    const double depth = view.Parallel ? view.Near + stored * range
                                       : view.Near * view.Far / (view.Far - stored * range);
    const double scale = view.Parallel ? 1.0 : depth;
    const glm::dvec2 texel(static_cast<int>(i) % edge, static_cast<int>(i) / edge);
    const glm::dvec2 place = scale *
      (view.Middle + view.HalfWidth * (2.0 * (texel + 0.5) / static_cast<double>(edge) - 1.0));
    frame.Seen.Places.push_back({ view.Place + place.x * view.Right + place.y * view.Up +
        depth * view.Forward,
      2.0 * scale * std::min(view.HalfWidth.x / frame.Size[0], view.HalfWidth.y / frame.Size[1]) });
  }
  if (!frame.Seen.BoxesAreKept)
  {
    const double* const b = frame.SceneBounds;
    frame.Seen.FindBoxes(frame.ToScene(glm::dvec3(b[1], b[3], b[5])));
    this->Box = frame.Seen.Box;
    this->Near = frame.Seen.Near;
  }
  else if (this->Box.IsPart() && !this->HoldsMost(frame.Seen.Places))
  {
    // Maps of all of the scene serve any view.
    this->Box = this->Near = {};
  }
  frame.Seen.Box = this->Box;
  frame.Seen.Near = this->Near;
  return true;
}
