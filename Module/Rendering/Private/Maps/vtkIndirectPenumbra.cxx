// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Maps/vtkIndirectPenumbra.h"

#include "Capture/vtkSurfaceCapturePass.h"
#include "Maps/vtkIndirectLightMap.h"
#include "Maps/vtkIndirectLightMaps.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Plan/vtkIndirectReport.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
const vtkIndirectChannels PenumbraChannels = {
  { "penumbra", "vtkiPenumbraTiles", "depths of four neighbouring texels", GL_RGBA32F, "tile",
    "depth buffer" },
};

// Texels across the penumbra of a blocker half-way to the light, or a quarter of the scene's depth
// above the receiver: then the steps between the light's points are finer than a texel, and a
// contact is blurred by a sixteenth of that penumbra.
constexpr double TexelsAcrossPenumbra = 16.0;
constexpr int FewestTexels = 64;
// 16 MiB of depths and 64 MiB of the texture that shaders read.
constexpr int MaximumAtlas = 2048;
// A spot's maps hold its cone from this many radii of the light on; nearer to the light, some of
// its points see a receiver beside their map and do not count.
constexpr double NearestRadii = 4.0;

std::vector<glm::dvec3> FindPoints()
{
  std::vector<glm::dvec3> points;
  vtkIndirectKernels::vtkiLightPairs pairs = vtkIndirectKernels::vtkiBeginLightPairs();
  for (int i = 0; i < vtkIndirectKernels::VTKI_LIGHT_PAIRS; ++i)
  {
    const glm::dvec3 point(vtkIndirectKernels::vtkiNextLightPoint(pairs, i));
    points.push_back(point);
    points.push_back(-point);
  }
  return points;
}

// Returns the axes of the map from a point of the light, at this place of the disk across its axis.
glm::dmat3 FindAxesOfPoint(const glm::dmat3& rotation, const glm::vec2& place)
{
  glm::vec3 x;
  glm::vec3 y;
  glm::vec3 z;
  vtkIndirectKernels::vtkiLightPointAxes(place, x, y, z);
  return rotation * glm::dmat3(x, y, z);
}

void FitPositional(
  const vtkIndirectFrame& frame, const vtkIndirectLightMap& centre, vtkIndirectPenumbra::Light& fit)
{
  using namespace vtkIndirectKernels;
  const glm::dmat3 rotation(centre.Faces[0].GetToScene());
  const glm::dvec3 place = centre.Faces[0].Place;
  const double distance = glm::length(place);
  // Larger lights are reduced to this size: they have the scene within them, and hardly any
  // shadows.
  const double radius = std::min(centre.Light.Size * frame.SceneScale, std::max(1.0, distance));

  constexpr double infinity = std::numeric_limits<double>::infinity();
  double tangent = 0.0; // of a view that holds all corners from any point of the light
  glm::dvec3 lower(infinity);
  glm::dvec3 upper(-infinity);
  for (const glm::dvec3& p : frame.FindCorners(rotation, place))
  {
    const double depth = -p.z - radius;
    const double aside = std::max(std::abs(p.x), std::abs(p.y));
    tangent = depth > 0.0 ? std::max(tangent, (aside + radius) / depth) : infinity;
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  vtkIndirectShadowMap& map = fit.Map.Map;
  fit.Map.Size = radius;
  const bool narrow = centre.Light.FindMapProjection() == VTKI_MAP_SINGLE;
  const double nearest = std::max(-upper.z, NearestRadii * radius);
  const double cone =
    (std::tan(vtkMath::RadiansFromDegrees(centre.Light.ConeAngle)) * nearest + radius) /
    (nearest - radius);
  // A single map of an omnidirectional light is at most as wide as a face of a cube.
  const double widest = narrow ? cone : 1.0;
  const bool single = narrow || tangent <= widest;
  fit.Map.HoldsAll = !narrow || tangent <= widest;
  map.Projection = single ? VTKI_MAP_SINGLE : VTKI_MAP_FACES;
  // A spot whose first face is along its axis has no face that looks backward.
  map.NumberOfFaces = single ? 1 : centre.Projection == VTKI_MAP_FACES ? centre.NumberOfFaces : 6;
  map.HalfWidth = std::min(tangent, widest);
  if (single)
  {
    // This is the tangent of the sum of both angles.
    map.HalfWidth = (map.HalfWidth + VTKI_LIGHT_SHIFT) / (1.0 - map.HalfWidth * VTKI_LIGHT_SHIFT);
  }
  vtkIndirectLightMap::FitDepths(map, lower, upper, radius);

  // The blocker lies half-way to the light, or a quarter of the scene's depth above the receiver.
  const double middle = std::max(distance, 0.5 * map.Far);
  const glm::dvec3 most = glm::max(-lower, upper);
  const double extent = single ? upper.z - lower.z : std::max({ most.x, most.y, most.z });
  const double above = std::min(0.5 * middle, 0.25 * extent);
  const double width = 2.0 * radius * above / (middle - above);
  fit.Texels = TexelsAcrossPenumbra * 2.0 * map.HalfWidth * middle / width;
  for (const glm::dvec3& point : FindPoints())
  {
    const glm::dmat3 turned = FindAxesOfPoint(rotation, VTKI_LIGHT_SHIFT * glm::vec2(point));
    for (int face = 0; face < map.NumberOfFaces; ++face)
    {
      fit.Tiles.push_back(
        vtkIndirectLightMap::MakeFace(map, turned, place + rotation * (radius * point), face));
    }
  }
}

void FitDirectional(
  const vtkIndirectFrame& frame, const vtkIndirectLightMap& centre, vtkIndirectPenumbra::Light& fit)
{
  using namespace vtkIndirectKernels;
  const glm::dmat3 rotation(centre.Faces[0].GetToScene());
  const double sine = std::sin(std::min(centre.Light.Size, 0.5 * vtkMath::Pi()));
  std::vector<glm::dmat3> axes;
  const std::vector<glm::dvec3> points = FindPoints();
  for (const glm::dvec3& point : points)
  {
    axes.push_back(FindAxesOfPoint(rotation, glm::vec2(sine * glm::dvec2(point))));
  }
  const vtkIndirectSeenBox& seen = frame.Seen.Box;
  const glm::dvec3 middle = seen.IsPart() ? seen.Middle : glm::dvec3(0.0);
  glm::dvec3 half(0.0);
  glm::dvec2 reach(0.0); // of the part that is seen
  for (const glm::dmat3& to : axes)
  {
    for (const glm::dvec3& p : frame.FindCorners(to, middle))
    {
      half = glm::max(half, glm::abs(p));
    }
    reach = glm::max(reach, glm::dvec2(seen.FindReach(to[0]), seen.FindReach(to[1])));
  }
  if (seen.IsPart())
  {
    half = glm::min(half, glm::dvec3(reach, half.z));
  }
  // A margin keeps the outermost points off the edge, and a flat scene gets an extent, too.
  constexpr double margin = 1.01;
  vtkIndirectShadowMap& map = fit.Map.Map;
  map.HalfWidth = (margin + VTKI_LIGHT_SHIFT) * std::max({ half.x, half.y, 1e-3 * half.z });
  const double depth = std::max(margin * half.z, 1e-3 * map.HalfWidth);
  map.Far = 2.0 * depth;
  map.WorldToLight[3] = glm::dvec4(-(glm::transpose(rotation) * frame.ToWorld(middle)), 1.0);
  fit.Map.Size = sine;
  // The blocker lies a quarter of the scene's depth above the receiver; `depth` is half of the
  // scene's depth.
  fit.Texels = TexelsAcrossPenumbra * map.HalfWidth / (0.5 * depth * sine);
  const double shift = VTKI_LIGHT_SHIFT * map.HalfWidth;
  for (size_t i = 0; i < points.size(); ++i)
  {
    const glm::dvec3 place = middle + axes[i] * glm::dvec3(shift * glm::dvec2(points[i]), depth);
    fit.Tiles.push_back(vtkIndirectLightMap::MakeFace(map, axes[i], place, 0));
  }
}
}

//------------------------------------------------------------------------------
vtkIndirectPenumbra::vtkIndirectPenumbra(vtkIndirectResource* owner, vtkIndirectDepthMaps& maps)
  : vtkIndirectResource(owner)
  , DepthMaps(maps)
  , Atlas(maps.Get(vtkIndirectDepthMaps::PENUMBRAE))
  , Tiles(this, PenumbraChannels, false)
{
}

vtkIndirectPenumbra::~vtkIndirectPenumbra() = default;

//------------------------------------------------------------------------------
vtkIndirectPenumbra::Light vtkIndirectPenumbra::Fit(
  const vtkIndirectFrame& frame, const vtkIndirectLightMap& centre)
{
  Light fit;
  fit.Map.Map = centre;
  (centre.Light.Positional ? FitPositional : FitDirectional)(frame, centre, fit);
  return fit;
}

//------------------------------------------------------------------------------
bool vtkIndirectPenumbra::Update(
  const vtkIndirectFrame& frame, const vtkIndirectLightMaps& maps, vtkSurfaceCapturePass* capture)
{
  this->Lights.clear();
  std::vector<vtkIndirectDepthMaps::Map> all;
  double wanted = FewestTexels;
  for (int i = 0; i < maps.GetNumberOfMaps(); ++i)
  {
    if (maps.GetMap(i).Light.Size > 0.0)
    {
      Light light = Fit(frame, maps.GetMap(i));
      light.Map.Map.FirstLayer = static_cast<int>(all.size());
      wanted = std::max(wanted, light.Texels);
      for (const vtkIndirectDepthTile& tile : light.Tiles)
      {
        all.push_back({ tile });
      }
      light.Tiles.clear();
      this->Lights.push_back(std::move(light));
    }
  }
  if (this->Lights.empty())
  {
    this->Release(frame.Window);
    return true;
  }
  // Maps are no finer than the user wants shadows to be, and no finer than the atlas has room for.
  const double edge = std::ceil(std::sqrt(static_cast<double>(all.size())));
  wanted =
    std::min({ wanted, static_cast<double>(maps.GetTexels()), std::floor(MaximumAtlas / edge) });
  constexpr int step = 16; // a small move of a light keeps the number
  this->Texels = step * std::max(1, static_cast<int>(wanted / step));
  this->DepthMaps.Request(vtkIndirectDepthMaps::PENUMBRAE, frame, all, this->Texels);
  const bool drawn = this->DepthMaps.Draw(frame, capture);
  this->Texels = this->Atlas.GetTexels();
  // Drawing by mappers detaches the capture.
  capture->Attach(frame);
  return drawn && this->JoinTexels(frame);
}

//------------------------------------------------------------------------------
bool vtkIndirectPenumbra::JoinTexels(const vtkIndirectFrame& frame)
{
  const int width = this->Atlas.GetNumberOfColumns() * this->Texels;
  const int height = this->Atlas.GetNumberOfRows() * this->Texels;
  const bool there = this->Tiles.GetWidth() == width && this->Tiles.GetHeight() == height &&
    this->Joined == this->Atlas.GetNumberOfTilesDrawn();
  if (!this->Tiles.Resize(frame.Window, width, height))
  {
    return false;
  }
  if (there)
  {
    return true;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  vtkIndirectFullScreenState kernelState(frame.Window);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const bool joined = this->Kernel.Run(frame.Window, this->Tiles,
    [&](const vtkIndirectProgram& program) { this->Atlas.Activate(program); });
  this->Joined = joined ? this->Atlas.GetNumberOfTilesDrawn() : this->Joined;
  return joined;
}

//------------------------------------------------------------------------------
void vtkIndirectPenumbra::Activate(vtkIndirectShadowMaps& shadows)
{
  if (this->Lights.empty())
  {
    return;
  }
  for (const Light& light : this->Lights)
  {
    shadows.Penumbrae.push_back(light.Map);
  }
  shadows.TileTexels = this->Texels;
  shadows.TileColumns = this->Atlas.GetNumberOfColumns();
  shadows.TileRows = this->Atlas.GetNumberOfRows();
  vtkTextureObject* texture = this->Tiles.GetTexture(0);
  texture->Activate();
  shadows.TileUnit = texture->GetTextureUnit();
}

//------------------------------------------------------------------------------
void vtkIndirectPenumbra::Deactivate() const
{
  if (!this->Lights.empty())
  {
    this->Tiles.GetTexture(0)->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectPenumbra::AddToReport(vtkIndirectReport& report) const
{
  report.Bytes += this->Tiles.GetBytes();
  for (const Light& light : this->Lights)
  {
    const vtkIndirectShadowMap& map = light.Map.Map;
    const int maps = vtkIndirectKernels::VTKI_LIGHT_POINTS * map.NumberOfFaces;
    report.Modelled.emplace_back("penumbra of light " + std::to_string(map.Light.Index),
      std::to_string(vtkIndirectKernels::VTKI_LIGHT_POINTS) + " points of it, " +
        std::to_string(maps) + " depth maps of " + std::to_string(this->Texels) +
        " texels squared");
  }
}

//------------------------------------------------------------------------------
void vtkIndirectPenumbra::ReleaseOwn(vtkWindow* window)
{
  this->DepthMaps.Release(vtkIndirectDepthMaps::PENUMBRAE, window);
  this->Lights.clear();
  this->Texels = 0;
}
