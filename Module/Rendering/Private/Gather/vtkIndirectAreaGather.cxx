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

#include <algorithm>

namespace
{
const vtkIndirectChannel Channels[] = {
  { "area", "vtkiArea", "irradiance that comes directly from area lights", GL_RGBA32F, "-",
    "VTK irradiance" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
constexpr int MostPoints = vtkIndirectAreaLamps::MostPoints;
constexpr int TileTexels = 128;
}

//------------------------------------------------------------------------------
vtkIndirectAreaGather::vtkIndirectAreaGather()
  : Kernels{ { "vtkIndirectAreaFS.glsl" }, { "vtkIndirectAreaFS.glsl" } }
  , Irradiance(Channels, false)
{
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
  for (const auto& each : this->Lamps.Get())
  {
    Lamp& lamp = *each;
    for (size_t k = 0; k < lamp.Points.size(); ++k)
    {
      vtkIndirectAreaLamps::Point& point = lamp.Points[k];
      const glm::dvec3 place = lamp.GetPlace(point);
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
  this->ContentTime += this->Lamps.Update(input.Frame, input.Lights) ? 1 : 0;
  const bool visible = input.Plan.AreaIsShadowed;
  this->ContentTime += visible != this->Visible ? 1 : 0;
  this->Visible = visible;
  this->Moving = input.Plan.Interactive;
  return this->UpdateMaps(input, most);
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaGather::IsComplete() const
{
  return !this->Visible || this->Atlas.GetNumberOfStaleTiles() == 0;
}

//------------------------------------------------------------------------------
// Of the mean of an image. The sum of its pieces' errors is a small part of what they are allowed.
double vtkIndirectAreaGather::GetTolerance(const Input& input) const
{
  const double tolerance = input.Plan.ErrorTolerance > 0.0 ? input.Plan.ErrorTolerance : 0.02;
  return (this->Moving ? 0.5 : 0.25) * tolerance;
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
  if (lamp.Row >= 0)
  {
    const int image[2] = { lamp.Row, lamp.Pyramid.GetTop() };
    program->SetUniform2i("vtkiAreaImage", image);
    program->SetUniformf("vtkiAreaTolerance", static_cast<float>(this->GetTolerance(input)));
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
  const size_t count = lamp.Points.size();
  std::vector<glm::vec4> block(2 * MostPoints, glm::vec4(0.0f));
  auto tileOf = [this](int tile)
  { return tile >= 0 && this->Atlas.HasTile(static_cast<size_t>(tile)) ? 1.0 * tile : -1.0; };
  for (size_t k = 0; k < count; ++k)
  {
    const vtkIndirectAreaLamps::Point& point = lamp.Points[k];
    block[k] = glm::vec4(glm::dvec4(lamp.GetPlace(point), tileOf(point.Tiles[0])));
    block[MostPoints + k] = glm::vec4(glm::dvec4(point.Weight, tileOf(point.Tiles[1])));
  }
  this->Block.Update(input.Frame.Window, block.data(), block.size() * sizeof(glm::vec4));
  this->Block.Activate(program);
  program->SetUniformi("vtkiAreaCount", static_cast<int>(count));
  program->SetUniformf(
    "vtkiAreaShare", static_cast<float>(lamp.GetArea() / std::max<size_t>(count, 1)));
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
  if (!this->Lamps.UpdateTexture(frame))
  {
    return false;
  }
  if (this->Moving && !this->Lamps.Get().empty())
  {
    return this->Samples.Sum({ frame, input.Geometry, this->Lamps,
                               this->Visible ? &this->Atlas : nullptr, this->GetTolerance(input) },
      this->Irradiance);
  }
  return this->SumPixels(input);
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaGather::SumPixels(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  vtkOpenGLState* state = frame.Window->GetState();
  bool done = true;
  this->Irradiance.Begin();
  this->Irradiance.Clear();
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFunc(GL_ONE, GL_ONE);
  for (const auto& each : this->Lamps.Get())
  {
    const Lamp& lamp = *each;
    vtkIndirectFullScreenProgram& kernel = this->Kernels[lamp.Row >= 0];
    vtkShaderProgram* program = kernel.Use(frame.Window,
      "#define VTKI_AREA_POINTS " + std::to_string(MostPoints) + "\n" +
        (this->Visible ? "#define VTKI_VISIBILITY\n" : "") +
        (lamp.Row >= 0 ? "#define VTKI_AREA_IMAGE\n" : ""));
    done = program != nullptr;
    if (!done)
    {
      break;
    }
    this->SetLamp(input, program, lamp);
    input.Geometry.GetTarget().Activate(vtkIndirectGeometryBuffer::Surface, program);
    if (lamp.Row >= 0)
    {
      this->Lamps.GetTexture().Activate(0, program);
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
    if (lamp.Row >= 0)
    {
      this->Lamps.GetTexture().Deactivate();
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
  return this->Irradiance.GetBytes() + this->Atlas.GetBytes() + this->Block.GetBytes() +
    this->Lamps.GetBytes() + this->Samples.GetBytes();
}

//------------------------------------------------------------------------------
void vtkIndirectAreaGather::AddToReport(vtkIndirectReport& report) const
{
  const vtkIndirectAreaLamps::List& lamps = this->Lamps.Get();
  if (lamps.empty())
  {
    return;
  }
  std::string what = std::to_string(lamps.size()) + " in closed form" +
    (this->Moving ? " at every fourth pixel" : "");
  if (this->Visible)
  {
    const size_t points = this->Moving ? static_cast<size_t>(vtkIndirectAreaSamples::NumberOfPoints)
                                       : lamps.front()->Points.size();
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
  this->Lamps.Release(window);
  this->Samples.Release(window);
  for (vtkIndirectFullScreenProgram& kernel : this->Kernels)
  {
    kernel.Release();
  }
}
