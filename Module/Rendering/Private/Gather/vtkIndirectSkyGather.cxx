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

// From this share of all light on a direction's shadow is seen by itself: eight grey levels of 256
// where it is hidden from a surface that faces it. At most 32 directions have so much.
constexpr double StrongShare = 1.0 / 32.0;
constexpr int StrongTexels = 1024;
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
  double total = 0.0;
  for (const glm::dvec3& light : this->Light)
  {
    total += light.x + light.y + light.z;
  }
  for (Group& group : this->Groups)
  {
    group.Members.clear();
    group.Emitters.clear();
  }
  for (size_t i = 0; i < count; ++i)
  {
    const double light = this->Light[i].x + this->Light[i].y + this->Light[i].z;
    if (light > 0.0)
    {
      this->Groups[light > StrongShare * total ? Strong : Others].Members.push_back(i);
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
  const bool fits = key == this->FitKey;
  this->FitKey = std::move(key);
  for (Group& group : this->Groups)
  {
    if (fits && group.Emitters.size() == group.Members.size())
    {
      continue;
    }
    group.Emitters.resize(group.Members.size());
    for (size_t k = 0; k < group.Members.size(); ++k)
    {
      group.Emitters[k].Tile =
        vtkIndirectDepthTile::FromDirection(frame, this->Directions[group.Members[k]]);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyGather::UpdateMaps(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  this->UpdateDirections(input);
  this->Visible = input.Plan.SkyIsShadowed;
  this->FitTiles(frame);
  this->Groups[Strong].Texels = StrongTexels;
  this->Groups[Others].Texels = input.Plan.SkyTileTexels;
  const size_t drawn = this->GetNumberOfTilesDrawn();
  bool done = true;
  for (Group& group : this->Groups)
  {
    if (!this->Visible || group.Members.empty())
    {
      group.Atlas.Release(frame.Window);
      continue;
    }
    done = done &&
      group.Atlas.Update(frame, input.Capture, group.Emitters, group.Texels, input.Plan.Caching);
  }
  this->ContentTime += this->GetNumberOfTilesDrawn() - drawn;
  return done;
}

//------------------------------------------------------------------------------
std::vector<glm::vec4> vtkIndirectSkyGather::MakeBlock(
  const Group& group, size_t first, size_t count) const
{
  std::vector<glm::vec4> block(BlockSize * RowsPerDirection, glm::vec4(0.0f));
  const int edge = std::max(1, group.Atlas.GetTilesAlongEdge());
  for (size_t k = 0; k < count; ++k)
  {
    const vtkIndirectDepthTile& tile = group.Emitters[first + k].Tile;
    const double range = tile.Far - tile.Near;
    auto row = [&](const glm::dvec3& axis, double unit)
    { return glm::vec4(glm::dvec4(axis / unit, -glm::dot(axis, tile.Place) / unit)); };
    const glm::dvec3 light = this->Light[group.Members[first + k]] / vtkMath::Pi();
    const int number = static_cast<int>(first + k);
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
  // One draw writes, several add up.
  const bool adds =
    !this->Groups[Strong].Members.empty() || this->Groups[Others].Members.size() > BlockSize;
  this->Irradiance.Begin();
  if (adds)
  {
    this->Irradiance.Clear();
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFunc(GL_ONE, GL_ONE);
  }
  bool done = true;
  for (Group& group : this->Groups)
  {
    done = done && (group.Members.empty() || this->SumGroup(input, group, adds));
  }
  state->vtkglDisable(GL_BLEND);
  this->Irradiance.End();
  return done;
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyGather::SumGroup(const Input& input, Group& group, bool adds)
{
  const vtkIndirectFrame& frame = input.Frame;
  group.Kernel.SetDefinitions(std::string(this->Visible ? "#define VTKI_VISIBILITY\n" : "") +
    (&group == &this->Groups[Strong] ? "#define VTKI_FILTERED\n" : ""));
  vtkShaderProgram* program = group.Kernel.Use(frame.Window, this->Irradiance, adds);
  if (!program)
  {
    return false;
  }
  vtkIndirectSetEyeUniforms(program, frame);
  program->SetUniform2i("vtkiSize", frame.Size);
  input.Geometry.GetTarget().Activate(vtkIndirectGeometryBuffer::Surface, program);
  if (this->Visible)
  {
    group.Atlas.Activate(program);
  }
  for (size_t first = 0; first < group.Members.size(); first += BlockSize)
  {
    const size_t count = std::min(BlockSize, group.Members.size() - first);
    const std::vector<glm::vec4> block = this->MakeBlock(group, first, count);
    this->Block.Update(frame.Window, block.data(), block.size() * sizeof(glm::vec4));
    this->Block.Activate(program);
    program->SetUniformi("vtkiSkyCount", static_cast<int>(count));
    group.Kernel.Draw();
    glFlush();
  }
  input.Geometry.GetTarget().Deactivate();
  if (this->Visible)
  {
    group.Atlas.Deactivate();
  }
  return true;
}

//------------------------------------------------------------------------------
size_t vtkIndirectSkyGather::GetNumberOfTilesDrawn() const
{
  size_t drawn = 0;
  for (const Group& group : this->Groups)
  {
    drawn += group.Atlas.GetNumberOfTilesDrawn();
  }
  return drawn;
}

//------------------------------------------------------------------------------
size_t vtkIndirectSkyGather::GetBytes() const
{
  size_t bytes = this->Irradiance.GetBytes() + this->Block.GetBytes();
  for (const Group& group : this->Groups)
  {
    bytes += group.Atlas.GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkIndirectSkyGather::AddToReport(vtkIndirectReport& report) const
{
  report.Bytes += this->GetBytes();
  std::string maps;
  for (const Group& group : this->Groups)
  {
    if (this->Visible && !group.Members.empty())
    {
      maps += (maps.empty() ? "; depth maps: " : ", ") + std::to_string(group.Members.size()) +
        " of " + std::to_string(group.Texels) + " texels squared";
    }
  }
  const size_t lit = this->Groups[Strong].Members.size() + this->Groups[Others].Members.size();
  report.Modelled.emplace_back("light from the sky",
    std::to_string(lit) + " of " + std::to_string(this->Directions.size()) + " directions" + maps);
}

//------------------------------------------------------------------------------
void vtkIndirectSkyGather::Release(vtkWindow* window)
{
  this->Irradiance.Release(window);
  this->Block.Release();
  for (Group& group : this->Groups)
  {
    group.Atlas.Release(window);
    group.Kernel.Release();
  }
  this->Projected = nullptr;
}
