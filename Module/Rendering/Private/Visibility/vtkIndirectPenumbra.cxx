// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Visibility/vtkIndirectPenumbra.h"

#include "Capture/vtkSurfaceCapturePass.h"
#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectReport.h"
#include "LightMaps/vtkIndirectLightMap.h"
#include "LightMaps/vtkIndirectLightMaps.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
const vtkIndirectChannels Channels = {
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

// Returns the corners of all casters' bounds, in scene units.
std::vector<glm::dvec3> FindCorners(const vtkIndirectFrame& frame)
{
  std::vector<glm::dvec3> corners;
  corners.reserve(8 * frame.Casters.size());
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    for (int i = 0; i < 8; ++i)
    {
      corners.push_back(frame.ToScene(vtkIndirectFrame::GetCorner(caster.GetFit(), i)));
    }
  }
  return corners;
}

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

// Returns the rotation from a map's face to the light's frame.
glm::dmat3 FaceToLight(int face)
{
  glm::dmat3 toFace;
  for (int i = 0; i < 3; ++i)
  {
    glm::vec3 axis(0.0f);
    axis[i] = 1.0f;
    toFace[i] = glm::dvec3(vtkIndirectKernels::vtkiToFace(axis, face));
  }
  return glm::transpose(toFace);
}

vtkIndirectDepthTile MakeTile(
  const glm::dmat3& axes, const glm::dvec3& place, const vtkIndirectShadowMap& map)
{
  vtkIndirectDepthTile tile;
  tile.Parallel = map.Projection == vtkIndirectKernels::VTKI_MAP_PARALLEL;
  tile.Place = place;
  tile.Right = axes[0];
  tile.Up = axes[1];
  tile.Forward = -axes[2];
  tile.HalfWidth = glm::dvec2(map.HalfWidth);
  tile.Near = map.Near;
  tile.Far = map.Far;
  return tile;
}

void FitPositional(
  const vtkIndirectFrame& frame, const vtkIndirectLightMap& centre, vtkIndirectPenumbra::Light& fit)
{
  using namespace vtkIndirectKernels;
  const glm::dmat3 rotation(centre.LightToWorld);
  const glm::dvec3 place = frame.ToScene(glm::dvec3(centre.LightToWorld[3]));
  const double distance = glm::length(place);
  // Larger lights are reduced to this size: they have the scene within them, and hardly any
  // shadows.
  const double radius = std::min(centre.Light.Size * frame.SceneScale, std::max(1.0, distance));

  double low = std::numeric_limits<double>::infinity(); // depths along the axis
  double high = -low;
  double tangent = 0.0; // of a view that holds all corners from any point of the light
  double most = 0.0;    // greatest depth along any axis
  glm::dvec3 lower(low);
  glm::dvec3 upper(-low);
  for (const glm::dvec3& corner : FindCorners(frame))
  {
    const glm::dvec3 p = glm::transpose(rotation) * (corner - place);
    const glm::dvec3 a = glm::abs(p);
    low = std::min(low, -p.z);
    high = std::max(high, -p.z);
    const double depth = -p.z - radius;
    tangent = depth > 0.0 ? std::max(tangent, (std::max(a.x, a.y) + radius) / depth)
                          : std::numeric_limits<double>::infinity();
    most = std::max({ most, a.x, a.y, a.z });
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  vtkIndirectShadowMap& map = fit.Map.Map;
  fit.Map.Size = radius;
  const bool narrow = centre.Light.FindMapProjection() == VTKI_MAP_SINGLE;
  const double nearest = std::max(low, NearestRadii * radius);
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
  if (single)
  {
    map.Far = high + radius;
    map.Near = low - radius;
  }
  else
  {
    const glm::dvec3 outside = glm::max(glm::max(lower, -upper), glm::dvec3(0.0));
    map.Far = most + radius;
    map.Near = std::max({ outside.x, outside.y, outside.z }) - radius;
  }
  // The depth range is found as for the map from the centre.
  map.Far = map.Far > 0.0 ? 1.001 * map.Far : 1.0;
  map.Near = std::min(
    std::max(0.999 * map.Near, vtkIndirectLightMap::NearestFraction * map.Far), 0.5 * map.Far);

  // The blocker lies half-way to the light, or a quarter of the scene's depth above the receiver.
  const double middle = std::max(distance, 0.5 * map.Far);
  const double above = std::min(0.5 * middle, 0.25 * (single ? high - low : most));
  const double width = 2.0 * radius * above / (middle - above);
  fit.Texels = TexelsAcrossPenumbra * 2.0 * map.HalfWidth * middle / width;
  for (const glm::dvec3& point : FindPoints())
  {
    glm::vec3 x;
    glm::vec3 y;
    glm::vec3 z;
    vtkiLightPointAxes(VTKI_LIGHT_SHIFT * glm::vec2(point), x, y, z);
    const glm::dmat3 turned = rotation * glm::dmat3(x, y, z);
    for (int face = 0; face < map.NumberOfFaces; ++face)
    {
      fit.Tiles.push_back(
        MakeTile(turned * FaceToLight(face), place + rotation * (radius * point), map));
    }
  }
}

void FitDirectional(
  const vtkIndirectFrame& frame, const vtkIndirectLightMap& centre, vtkIndirectPenumbra::Light& fit)
{
  using namespace vtkIndirectKernels;
  const glm::dmat3 rotation(centre.LightToWorld);
  const std::vector<glm::dvec3> corners = FindCorners(frame);
  glm::dvec3 lower(std::numeric_limits<double>::infinity());
  glm::dvec3 upper = -lower;
  for (const glm::dvec3& corner : corners)
  {
    lower = glm::min(lower, corner);
    upper = glm::max(upper, corner);
  }
  const glm::dvec3 middle = 0.5 * (lower + upper);
  const double sine = std::sin(std::min(centre.Light.Size, 0.5 * vtkMath::Pi()));
  std::vector<glm::dmat3> axes;
  const std::vector<glm::dvec3> points = FindPoints();
  for (const glm::dvec3& point : points)
  {
    glm::vec3 x;
    glm::vec3 y;
    glm::vec3 z;
    vtkiLightPointAxes(glm::vec2(sine * glm::dvec2(point)), x, y, z);
    axes.push_back(rotation * glm::dmat3(x, y, z));
  }
  glm::dvec3 half(0.0);
  for (const glm::dmat3& to : axes)
  {
    for (const glm::dvec3& corner : corners)
    {
      half = glm::max(half, glm::abs(glm::transpose(to) * (corner - middle)));
    }
  }
  // A margin keeps the outermost points off the edge, and a flat scene gets an extent, too.
  constexpr double margin = 1.01;
  vtkIndirectShadowMap& map = fit.Map.Map;
  map.Projection = VTKI_MAP_PARALLEL;
  map.NumberOfFaces = 1;
  map.HalfWidth = (margin + VTKI_LIGHT_SHIFT) * std::max({ half.x, half.y, 1e-3 * half.z });
  const double depth = std::max(margin * half.z, 1e-3 * map.HalfWidth);
  map.Near = 0.0;
  map.Far = 2.0 * depth;
  map.WorldToLight[3] =
    glm::dvec4(-(glm::transpose(rotation) * (frame.SceneCenter + middle / frame.SceneScale)), 1.0);
  fit.Map.Size = sine;
  // The blocker lies a quarter of the scene's depth above the receiver; `depth` is half of the
  // scene's depth.
  fit.Texels = TexelsAcrossPenumbra * map.HalfWidth / (0.5 * depth * sine);
  const double shift = VTKI_LIGHT_SHIFT * map.HalfWidth;
  for (size_t i = 0; i < points.size(); ++i)
  {
    const glm::dmat3& to = axes[i];
    const glm::dvec3 place =
      middle + depth * to[2] + shift * (points[i].x * to[0] + points[i].y * to[1]);
    fit.Tiles.push_back(MakeTile(to, place, map));
  }
}
}

//------------------------------------------------------------------------------
vtkIndirectPenumbra::vtkIndirectPenumbra(vtkIndirectResource* owner, vtkIndirectDepthMaps& maps)
  : vtkIndirectResource(owner)
  , DepthMaps(maps)
  , Atlas(maps.Get(vtkIndirectDepthMaps::PENUMBRAE))
  , Tiles(this, Channels, false)
{
}

vtkIndirectPenumbra::~vtkIndirectPenumbra() = default;

//------------------------------------------------------------------------------
vtkIndirectPenumbra::Light vtkIndirectPenumbra::Fit(
  const vtkIndirectFrame& frame, const vtkIndirectLightMap& centre)
{
  Light fit;
  fit.Map.Map = centre.GetShadowMap();
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
    report.Modelled.emplace_back("penumbra of light " + std::to_string(map.Light),
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
