// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Gather/vtkIndirectSkyGather.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Frame/vtkIndirectEyeUniforms.h"
#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectPlan.h"
#include "Frame/vtkIndirectReport.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "VirtualLights/vtkIndirectDirections.h"
#include "vtkEnvironmentLight.h"
#include "vtkMath.h"

#include <algorithm>

namespace
{
const vtkIndirectChannel Channels[] = {
  { "sky", "vtkiSky", "irradiance that comes directly from the environment", GL_RGBA32F, "-",
    "VTK irradiance" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};

// As in vtkIndirectSkyFS.glsl.
constexpr size_t BlockSize = 200;
constexpr size_t RowsPerDirection = 5;
}

//------------------------------------------------------------------------------
vtkIndirectSkyGather::vtkIndirectSkyGather()
  : Irradiance(Channels, false)
{
}

//------------------------------------------------------------------------------
void vtkIndirectSkyGather::UpdateDirections(const Input& input)
{
  const size_t count = static_cast<size_t>(input.Plan.NumberOfSkyDirections);
  const vtkMTimeType time = input.Environment->GetMTime();
  if (this->Directions.size() == count && this->Projected == input.Environment &&
    this->ProjectedTime == time)
  {
    return;
  }
  this->Directions = vtkIndirectDirections::MakeLattice(static_cast<int>(count));
  this->Light = vtkIndirectDirections::Project(input.Environment, this->Directions);
  this->Projected = input.Environment;
  this->ProjectedTime = time;
  this->Lit.clear();
  for (size_t i = 0; i < count; ++i)
  {
    if (this->Light[i] != glm::dvec3(0.0))
    {
      this->Lit.push_back(i);
    }
  }
  ++this->ContentTime;
}

//------------------------------------------------------------------------------
void vtkIndirectSkyGather::FitTiles(const vtkIndirectFrame& frame)
{
  std::vector<double> key = { frame.SceneScale, frame.SceneCenter.x, frame.SceneCenter.y,
    frame.SceneCenter.z };
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    key.insert(key.end(), caster.Bounds, caster.Bounds + 6);
  }
  const bool fits = key == this->FitKey && this->Emitters.size() == this->Directions.size();
  this->FitKey = std::move(key);
  this->Emitters.resize(this->Directions.size());
  for (size_t i = 0; i < this->Directions.size(); ++i)
  {
    if (!fits)
    {
      this->Emitters[i].Tile = vtkIndirectDepthTile::FromDirection(frame, this->Directions[i]);
    }
    this->Emitters[i].Sends = this->Light[i] != glm::dvec3(0.0);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyGather::UpdateMaps(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  this->UpdateDirections(input);
  this->Visible = input.Plan.SkyIsShadowed;
  if (!this->Visible)
  {
    this->Atlas.Release(frame.Window);
  }
  this->FitTiles(frame);
  const size_t drawn = this->Atlas.GetNumberOfTilesDrawn();
  const bool done = !this->Visible ||
    this->Atlas.Update(
      frame, input.Capture, this->Emitters, input.Plan.SkyTileTexels, input.Plan.Caching);
  this->ContentTime += this->Atlas.GetNumberOfTilesDrawn() - drawn;
  return done;
}

//------------------------------------------------------------------------------
std::vector<glm::vec4> vtkIndirectSkyGather::MakeBlock(
  const vtkIndirectFrame& frame, size_t first, size_t count) const
{
  std::vector<glm::vec4> block(BlockSize * RowsPerDirection, glm::vec4(0.0f));
  const int edge = std::max(1, this->Atlas.GetTilesAlongEdge());
  for (size_t k = 0; k < count; ++k)
  {
    const size_t i = this->Lit[first + k];
    const vtkIndirectDepthTile& tile = this->Emitters[i].Tile;
    const double range = tile.Far - tile.Near;
    auto row = [&](const glm::dvec3& axis, double unit)
    { return glm::vec4(glm::dvec4(axis / unit, -glm::dot(axis, tile.Place) / unit)); };
    const glm::dvec3 light = this->Light[i] / vtkMath::Pi();
    const int number = static_cast<int>(i);
    block[k] = row(tile.Right, tile.HalfWidth.x);
    block[BlockSize + k] = row(tile.Up, tile.HalfWidth.y);
    block[2 * BlockSize + k] = row(tile.Forward, range);
    block[3 * BlockSize + k] = glm::vec4(glm::vec3(light), number % edge);
    block[4 * BlockSize + k] = glm::vec4(tile.HalfWidth.x * tile.HalfWidth.x,
      tile.HalfWidth.y * tile.HalfWidth.y, range, number / edge);
  }
  return block;
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyGather::Sum(const Input& input)
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
  this->Kernel.SetDefinitions(this->Visible ? "#define VTKI_VISIBILITY\n" : "");
  const bool adds = this->Lit.size() > BlockSize;
  vtkShaderProgram* program = this->Kernel.Use(frame.Window, this->Irradiance, adds);
  if (!program)
  {
    return false;
  }
  this->Irradiance.Begin();
  if (adds)
  {
    this->Irradiance.Clear();
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFunc(GL_ONE, GL_ONE);
  }
  vtkIndirectSetEyeUniforms(program, frame);
  program->SetUniform2i("vtkiSize", frame.Size);
  input.Geometry.GetTarget().Activate(vtkIndirectGeometryBuffer::Surface, program);
  if (this->Visible)
  {
    this->Atlas.Activate(program);
  }
  for (size_t first = 0; first < this->Lit.size(); first += BlockSize)
  {
    const size_t count = std::min(BlockSize, this->Lit.size() - first);
    const std::vector<glm::vec4> block = this->MakeBlock(frame, first, count);
    this->Block.Update(frame.Window, block.data(), block.size() * sizeof(glm::vec4));
    this->Block.Activate(program);
    program->SetUniformi("vtkiSkyCount", static_cast<int>(count));
    this->Kernel.Draw();
    glFlush();
  }
  state->vtkglDisable(GL_BLEND);
  this->Irradiance.End();
  input.Geometry.GetTarget().Deactivate();
  if (this->Visible)
  {
    this->Atlas.Deactivate();
  }
  return true;
}

//------------------------------------------------------------------------------
size_t vtkIndirectSkyGather::GetBytes() const
{
  return this->Irradiance.GetBytes() + this->Atlas.GetBytes() + this->Block.GetBytes();
}

//------------------------------------------------------------------------------
void vtkIndirectSkyGather::AddToReport(vtkIndirectReport& report) const
{
  report.Bytes += this->GetBytes();
  report.Modelled.emplace_back("light from the sky",
    std::to_string(this->Lit.size()) + " of " + std::to_string(this->Directions.size()) +
      " directions" +
      (this->Visible
          ? ", depth maps of " + std::to_string(this->Atlas.GetTexels()) + " texels squared"
          : std::string()));
}

//------------------------------------------------------------------------------
void vtkIndirectSkyGather::Release(vtkWindow* window)
{
  this->Irradiance.Release(window);
  this->Atlas.Release(window);
  this->Block.Release();
  this->Kernel.Release();
  this->Projected = nullptr;
}
