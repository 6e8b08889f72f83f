// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Gather/vtkIndirectAreaGather.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Frame/vtkIndirectEyeUniforms.h"
#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectPlan.h"
#include "Frame/vtkIndirectReport.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "vtkAreaLight.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
const vtkIndirectChannel Channels[] = {
  { "area", "vtkiArea", "irradiance that comes directly from area lights", GL_RGBA32F, "-",
    "VTK irradiance" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
const vtkIndirectChannel PyramidChannels[] = {
  { "area.pyramid", "vtkiAreaPyramid", "radiance; greatest deviation of its sum from the mean",
    GL_RGBA32F, "-", "VTK radiance" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};

// Points of a light, fewer of each where there are many lights; of those a moving frame asks the
// first ones.
constexpr int MostPoints = 64;
constexpr int LeastPoints = 16;
constexpr int MovingPoints = 16;
constexpr int TileTexels = 128;

glm::dvec3 ToVector(const double v[3])
{
  return { v[0], v[1], v[2] };
}

// Each prefix of these fills the square evenly (additive recurrence, Roberts 2018).
glm::dvec2 PlaceOf(int number)
{
  const glm::dvec2 place =
    0.5 + static_cast<double>(number) * glm::dvec2(0.75487766624669276, 0.56984029099805327);
  return glm::fract(place);
}
}

//------------------------------------------------------------------------------
vtkIndirectAreaGather::vtkIndirectAreaGather()
  : Kernels{ { "vtkIndirectAreaFS.glsl" }, { "vtkIndirectAreaFS.glsl" } }
  , Irradiance(Channels, false)
{
}

//------------------------------------------------------------------------------
// What is behind a point's texels: of a level that is as fine as the points are.
void vtkIndirectAreaGather::UpdatePoints(Lamp& lamp, int count)
{
  lamp.Points.resize(static_cast<size_t>(count));
  for (int k = 0; k < count; ++k)
  {
    lamp.Points[static_cast<size_t>(k)].Place = PlaceOf(k);
    lamp.Points[static_cast<size_t>(k)].Weight = glm::dvec3(1.0);
  }
  if (lamp.Pyramid.IsUniform())
  {
    return;
  }
  for (Point& point : lamp.Points)
  {
    point.Weight = glm::dvec3(0.0);
  }
  const int level = std::max(lamp.Pyramid.GetTop() - 5, 0);
  const int edge = lamp.Pyramid.GetEdge(level);
  const glm::dvec2 lengths(glm::length(lamp.Edge1), glm::length(lamp.Edge2));
  const glm::dvec3 unit = glm::max(lamp.Radiance, glm::dvec3(1e-300));
  for (int y = 0; y < edge; ++y)
  {
    for (int x = 0; x < edge; ++x)
    {
      const glm::dvec2 place(glm::dvec2(x + 0.5, y + 0.5) / (1.0 * edge));
      Point* nearest = nullptr;
      double least = 0.0;
      for (Point& point : lamp.Points)
      {
        const glm::dvec2 apart = (point.Place - place) * lengths;
        const double square = glm::dot(apart, apart);
        if (!nearest || square < least)
        {
          nearest = &point;
          least = square;
        }
      }
      nearest->Weight += lamp.Pyramid.GetMean(level, x, y) / unit *
        (static_cast<double>(count) / (1.0 * edge * edge));
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectAreaGather::UpdateLamps(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  std::vector<vtkAreaLight*> lit;
  for (const auto& light : input.Lights)
  {
    double mean[3];
    light->GetMeanRadiance(mean);
    if (light->GetSwitch() && light->GetArea() > 0.0 &&
      std::max({ mean[0], mean[1], mean[2] }) > 0.0)
    {
      lit.push_back(light);
    }
  }
  bool same = lit.size() == this->Lamps.size() && frame.SceneScale == this->SceneScale &&
    frame.SceneCenter == this->SceneCenter;
  for (size_t i = 0; same && i < lit.size(); ++i)
  {
    same = this->Lamps[i]->Light == lit[i] && this->Lamps[i]->Time == lit[i]->GetMTime();
  }
  if (same)
  {
    return;
  }
  ++this->ContentTime;
  this->SceneScale = frame.SceneScale;
  this->SceneCenter = frame.SceneCenter;
  for (; this->Lamps.size() > lit.size(); this->Lamps.pop_back())
  {
    if (this->Lamps.back()->Texture)
    {
      this->Lamps.back()->Texture->Release(frame.Window);
    }
  }
  while (this->Lamps.size() < lit.size())
  {
    this->Lamps.push_back(std::make_unique<Lamp>());
  }
  const int count = std::max(MostPoints / std::max(static_cast<int>(lit.size()), 1), LeastPoints);
  for (size_t i = 0; i < lit.size(); ++i)
  {
    Lamp& lamp = *this->Lamps[i];
    vtkAreaLight* const light = lit[i];
    lamp.Light = light;
    lamp.Time = light->GetMTime();
    const glm::dvec3 origin = ToVector(light->GetOrigin());
    lamp.Corner = (origin - frame.SceneCenter) * frame.SceneScale;
    lamp.Edge1 = (ToVector(light->GetPoint1()) - origin) * frame.SceneScale;
    lamp.Edge2 = (ToVector(light->GetPoint2()) - origin) * frame.SceneScale;
    double values[3];
    light->GetNormal(values);
    lamp.Normal = ToVector(values);
    light->GetMeanRadiance(values);
    lamp.Radiance = ToVector(values);
    lamp.TwoSided = light->GetTwoSided();
    int columns;
    int rows;
    const std::vector<float>& radiances = light->GetRadiances(columns, rows);
    lamp.Pyramid.Build(radiances, columns, rows);
    lamp.TextureIsStale = true;
    this->UpdatePoints(lamp, count);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaGather::UpdateMaps(const Input& input, int most)
{
  if (!this->Visible)
  {
    this->Atlas.Release(input.Frame.Window);
    return true;
  }
  std::vector<vtkIndirectDepthAtlas::Emitter> emitters;
  for (size_t i = 0; i < this->Lamps.size(); ++i)
  {
    Lamp& lamp = *this->Lamps[i];
    for (size_t k = 0; k < lamp.Points.size(); ++k)
    {
      Point& point = lamp.Points[k];
      const glm::dvec3 place =
        lamp.Corner + point.Place.x * lamp.Edge1 + point.Place.y * lamp.Edge2;
      for (int side = 0; side < 2; ++side)
      {
        point.Tiles[side] = -1;
        if (side == 0 || lamp.TwoSided)
        {
          point.Tiles[side] = static_cast<int>(emitters.size());
          vtkIndirectDepthAtlas::Emitter emitter;
          emitter.Tile =
            vtkIndirectDepthTile::FromPlace(place, side == 0 ? lamp.Normal : -lamp.Normal);
          emitter.Turn = k;
          emitters.push_back(emitter);
        }
      }
    }
  }
  const size_t before = this->Atlas.GetNumberOfTilesDrawn();
  const bool updated =
    this->Atlas.Update(input.Frame, input.Capture, emitters, TileTexels, input.Plan.Caching, most);
  this->ContentTime += this->Atlas.GetNumberOfTilesDrawn() - before;
  return updated;
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaGather::Update(const Input& input, int most)
{
  this->UpdateLamps(input);
  const bool visible = input.Plan.AreaIsShadowed;
  this->ContentTime += visible != this->Visible ? 1 : 0;
  this->Visible = visible;
  this->NumberOfSummedPoints = input.Plan.Interactive ? MovingPoints : MostPoints;
  return this->UpdateMaps(input, most);
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaGather::IsComplete() const
{
  return !this->Visible || this->Atlas.GetNumberOfStaleTiles() == 0;
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaGather::UpdateTexture(const Input& input, Lamp& lamp)
{
  if (lamp.Pyramid.IsUniform())
  {
    if (lamp.Texture)
    {
      lamp.Texture->Release(input.Frame.Window);
      lamp.Texture = nullptr;
    }
    return true;
  }
  if (!lamp.Texture)
  {
    lamp.Texture = std::make_unique<vtkIndirectTarget>(PyramidChannels, false);
    lamp.TextureIsStale = true;
  }
  const int edge = lamp.Pyramid.GetEdge(0);
  if (!lamp.Texture->Resize(input.Frame.Window, edge + (edge + 1) / 2, edge))
  {
    return false;
  }
  if (lamp.TextureIsStale)
  {
    lamp.Texture->Write(0, lamp.Pyramid.MakeTexture());
    lamp.TextureIsStale = false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectAreaGather::SetLamp(const Input& input, vtkShaderProgram* program, const Lamp& lamp)
{
  vtkIndirectSetEyeUniforms(program, input.Frame);
  program->SetUniform2i("vtkiSize", input.Frame.Size);
  vtkIndirectSetUniform(program, "vtkiAreaCorner", glm::vec3(lamp.Corner));
  vtkIndirectSetUniform(program, "vtkiAreaEdge1", glm::vec3(lamp.Edge1));
  vtkIndirectSetUniform(program, "vtkiAreaEdge2", glm::vec3(lamp.Edge2));
  vtkIndirectSetUniform(program, "vtkiAreaNormal", glm::vec3(lamp.Normal));
  program->SetUniformi("vtkiAreaTwoSided", lamp.TwoSided ? 1 : 0);
  if (lamp.Texture)
  {
    program->SetUniformi("vtkiAreaLevel", lamp.Pyramid.GetTop());
    // An eighth of what the picture is to be off by: errors of texels have either sign.
    const double tolerance = input.Plan.ErrorTolerance > 0.0 ? input.Plan.ErrorTolerance : 0.02;
    program->SetUniformf("vtkiAreaTolerance", static_cast<float>(0.125 * tolerance));
  }
  else
  {
    vtkIndirectSetUniform(program, "vtkiAreaRadiance", glm::vec3(lamp.Radiance));
  }
}

//------------------------------------------------------------------------------
void vtkIndirectAreaGather::SetPoints(
  const Input& input, vtkShaderProgram* program, const Lamp& lamp)
{
  const size_t count =
    std::min(lamp.Points.size(), static_cast<size_t>(this->NumberOfSummedPoints));
  std::vector<glm::vec4> block(2 * MostPoints, glm::vec4(0.0f));
  auto tileOf = [this](int tile)
  { return tile >= 0 && this->Atlas.HasTile(static_cast<size_t>(tile)) ? 1.0 * tile : -1.0; };
  for (size_t k = 0; k < count; ++k)
  {
    const Point& point = lamp.Points[k];
    const glm::dvec3 place = lamp.Corner + point.Place.x * lamp.Edge1 + point.Place.y * lamp.Edge2;
    block[k] = glm::vec4(glm::dvec4(place, tileOf(point.Tiles[0])));
    block[MostPoints + k] = glm::vec4(glm::dvec4(point.Weight, tileOf(point.Tiles[1])));
  }
  this->Block.Update(input.Frame.Window, block.data(), block.size() * sizeof(glm::vec4));
  this->Block.Activate(program);
  program->SetUniformi("vtkiAreaCount", static_cast<int>(count));
  const double area = glm::length(glm::cross(lamp.Edge1, lamp.Edge2));
  program->SetUniformf("vtkiAreaShare", static_cast<float>(area / std::max<size_t>(count, 1)));
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaGather::Sum(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  if (!this->Irradiance.Resize(frame.Window, frame.Size[0], frame.Size[1]))
  {
    return false;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunc(state);
  vtkIndirectFullScreenState kernelState(frame.Window);
  bool done = true;
  for (const auto& lamp : this->Lamps)
  {
    done = done && this->UpdateTexture(input, *lamp);
  }
  this->Irradiance.Begin();
  this->Irradiance.Clear();
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFunc(GL_ONE, GL_ONE);
  for (size_t i = 0; done && i < this->Lamps.size(); ++i)
  {
    const Lamp& lamp = *this->Lamps[i];
    vtkIndirectFullScreenProgram& kernel = this->Kernels[lamp.Texture != nullptr];
    vtkShaderProgram* program = kernel.Use(frame.Window,
      "#define VTKI_AREA_POINTS " + std::to_string(MostPoints) + "\n" +
        (this->Visible ? "#define VTKI_VISIBILITY\n" : "") +
        (lamp.Texture ? "#define VTKI_AREA_IMAGE\n" : ""));
    done = program != nullptr;
    if (!done)
    {
      break;
    }
    this->SetLamp(input, program, lamp);
    input.Geometry.GetTarget().Activate(vtkIndirectGeometryBuffer::Surface, program);
    if (lamp.Texture)
    {
      lamp.Texture->Activate(0, program);
    }
    if (this->Visible)
    {
      this->SetPoints(input, program, lamp);
      this->Atlas.Activate(program);
    }
    kernel.Draw();
    if (this->Visible)
    {
      this->Atlas.Deactivate();
    }
    if (lamp.Texture)
    {
      lamp.Texture->Deactivate();
    }
    input.Geometry.GetTarget().Deactivate();
  }
  state->vtkglDisable(GL_BLEND);
  this->Irradiance.End();
  return done;
}

//------------------------------------------------------------------------------
size_t vtkIndirectAreaGather::GetBytes() const
{
  size_t bytes = this->Irradiance.GetBytes() + this->Atlas.GetBytes() + this->Block.GetBytes();
  for (const auto& lamp : this->Lamps)
  {
    bytes += lamp->Texture ? lamp->Texture->GetBytes() : 0;
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkIndirectAreaGather::AddToReport(vtkIndirectReport& report) const
{
  if (this->Lamps.empty())
  {
    return;
  }
  std::string what = std::to_string(this->Lamps.size()) + " in closed form";
  if (this->Visible)
  {
    const size_t points =
      std::min(this->Lamps.front()->Points.size(), static_cast<size_t>(this->NumberOfSummedPoints));
    what += ", hidden by depth maps of " + std::to_string(points) + " points of each, " +
      std::to_string(TileTexels) + " texels squared";
  }
  report.Modelled.emplace_back("light of area lights", what);
  const int missing = this->Visible ? this->Atlas.GetNumberOfMissingTiles() : 0;
  const int stale = this->Visible ? this->Atlas.GetNumberOfStaleTiles() - missing : 0;
  if (missing > 0)
  {
    report.LeftOut.emplace_back(
      "depth maps of " + std::to_string(missing) + " points of area lights",
      "further frames draw them; until then others stand for them");
  }
  if (stale > 0)
  {
    report.LeftOut.emplace_back(
      "what has just moved, in " + std::to_string(stale) + " depth maps of area lights",
      "further frames draw them again");
  }
}

//------------------------------------------------------------------------------
void vtkIndirectAreaGather::Release(vtkWindow* window)
{
  this->Irradiance.Release(window);
  this->Atlas.Release(window);
  this->Block.Release();
  for (const auto& lamp : this->Lamps)
  {
    if (lamp->Texture)
    {
      lamp->Texture->Release(window);
    }
  }
  this->Lamps.clear();
  for (vtkIndirectFullScreenProgram& kernel : this->Kernels)
  {
    kernel.Release();
  }
}
