// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Senders/vtkIndirectSampleWarp.h"

#include "Maps/vtkIndirectLightMap.h"
#include "Maps/vtkIndirectLightMaps.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"

#include <algorithm>
#include <cmath>

namespace
{
const vtkIndirectChannels NodeChannels = {
  { "importance.lit", "vtkiLit", "cells that send light, by quadrants", GL_RGBA32F, "chart", "1" },
  { "importance.flux", "vtkiFlux", "light that cells send, by quadrants", GL_RGBA32F, "chart",
    "of the strongest light" },
};

const vtkIndirectChannels SampleChannels = {
  { "importance.samples", "vtkiPattern", "map coordinates, layer, texels that it stands for",
    GL_RGBA32F, "map", "1" },
};

// A map of one face has no cone of light.
constexpr float OneFace = 2.0f;
}

vtkIndirectSampleWarp::vtkIndirectSampleWarp(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Even(this, NodeChannels, false)
  , Odd(this, NodeChannels, false)
  , Samples(this, SampleChannels, false)
{
}

//------------------------------------------------------------------------------
// Makes a chart for each light; returns false, after an error, when OpenGL refuses.
bool vtkIndirectSampleWarp::UpdateCharts(
  vtkOpenGLRenderWindow* window, const vtkIndirectLightMaps& maps)
{
  std::vector<float> charts;
  int edge = 2;
  this->Strongest = 0.0;
  for (int i = 0; i < maps.GetNumberOfMaps(); ++i)
  {
    const vtkIndirectLightMap& map = maps.GetMap(i);
    const bool faces = map.Projection == vtkIndirectKernels::VTKI_MAP_FACES;
    const double cone =
      map.Light.ConeAngle < 90.0 ? std::cos(glm::radians(map.Light.ConeAngle)) : -1.0;
    charts.insert(charts.end(),
      { static_cast<float>(map.FirstLayer), faces ? static_cast<float>(cone) : OneFace, 0.0f,
        0.0f });
    // A sphere in a square has to be as fine as the middles of a cube's faces.
    edge = std::max(edge, maps.GetTexels() * (faces ? 2 : 1));
    this->Strongest =
      std::max({ this->Strongest, map.Light.Color.x, map.Light.Color.y, map.Light.Color.z });
  }
  this->Cells = 2;
  this->Levels = 1;
  while (this->Cells < std::min(edge, MostCells))
  {
    this->Cells *= 2;
    ++this->Levels;
  }
  const int count = maps.GetNumberOfMaps();
  this->Columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
  this->Rows = (count + this->Columns - 1) / this->Columns;
  if (this->ChartTexture.IsEmpty() || charts != this->Charts)
  {
    this->Charts = charts;
    if (!this->ChartTexture.Set(
          window, vtkIndirectDataTexture::FLOATS, 4, { count, 1, 0 }, this->Charts.data()))
    {
      return false;
    }
  }
  int widths[2] = { 0, 0 };
  for (int level = 0; level < this->Levels; ++level)
  {
    widths[level % 2] += this->FindLevelWidth(level);
  }
  const int channels = this->WithFlux ? 2 : 1;
  const int height = this->Rows * (this->Cells / 2);
  this->Even.SetNumberOfChannels(channels);
  this->Odd.SetNumberOfChannels(channels);
  return this->Even.Resize(window, widths[0], height) &&
    this->Odd.Resize(window, std::max(1, widths[1]), std::max(1, height / 2));
}

//------------------------------------------------------------------------------
void vtkIndirectSampleWarp::ActivateCharts(const vtkIndirectProgram& program) const
{
  this->ChartTexture.Activate(program, "vtkiCharts");
  program->SetUniformi("vtkiCells", this->Cells);
  program->SetUniformi("vtkiColumns", this->Columns);
  program->SetUniformi("vtkiNumberOfCharts", static_cast<int>(this->Charts.size() / 4));
}

//------------------------------------------------------------------------------
void vtkIndirectSampleWarp::ActivateNodes(
  int parity, const vtkIndirectProgram& program, const char* lit, const char* flux) const
{
  const vtkIndirectTarget& nodes = parity == 0 ? this->Even : this->Odd;
  nodes.Activate(0, program, lit);
  if (this->WithFlux)
  {
    nodes.Activate(1, program, flux);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectSampleWarp::SumNodes(
  vtkOpenGLRenderWindow* window, const vtkIndirectLightMaps& maps, double occlusion)
{
  const std::string definitions = this->WithFlux ? "#define VTKI_FLUX\n" : "";
  vtkIndirectFullScreenState fullScreen(window);
  vtkOpenGLState* state = window->GetState();
  const int height = this->Rows * (this->Cells / 2);
  int begin[2] = { this->FindLevelWidth(0), 0 };
  this->ImportanceProgram.SetDefinitions(
    definitions + (maps.HasSpecular() ? "#define VTKI_SPECULAR\n" : ""));
  this->SumProgram.SetDefinitions(definitions);
  bool done = this->ImportanceProgram.Run(window, this->Even,
    [&](const vtkIndirectProgram& program)
    {
      state->vtkglViewport(0, 0, begin[0], height);
      maps.Activate(program);
      this->ActivateCharts(program);
      program->SetUniformf(
        "vtkiScale", static_cast<float>(this->Strongest > 0.0 ? 1.0 / this->Strongest : 1.0));
      program->SetUniformf("vtkiOcclusion", static_cast<float>(occlusion));
    });
  int below = 0;
  for (int level = 1; done && level < this->Levels; ++level)
  {
    const int parity = level % 2;
    done = this->SumProgram.Run(window, parity == 0 ? this->Even : this->Odd,
      [&](const vtkIndirectProgram& program)
      {
        state->vtkglViewport(begin[parity], 0, this->FindLevelWidth(level), height >> level);
        this->ActivateNodes(1 - parity, program, "vtkiLit", "vtkiFlux");
        program->SetUniformi("vtkiBelow", below);
        program->SetUniformi("vtkiBegin", begin[parity]);
      });
    below = begin[parity];
    begin[parity] += this->FindLevelWidth(level);
  }
  return done;
}

//------------------------------------------------------------------------------
bool vtkIndirectSampleWarp::Warp(vtkOpenGLRenderWindow* window, const vtkIndirectLightMaps& maps,
  const vtkIndirectMapSampler::Drawing& drawing, const vtkIndirectPatternTexture& pattern)
{
  constexpr int width = vtkIndirectSampler::RowLength;
  const int rows = std::max(1, (pattern.GetNumberOfSamples() + width - 1) / width);
  if (!this->Samples.Resize(window, width, rows))
  {
    return false;
  }
  this->WarpProgram.SetDefinitions(this->WithFlux ? "#define VTKI_FLUX\n" : "");
  vtkIndirectFullScreenState fullScreen(window);
  return this->WarpProgram.Run(window, this->Samples,
    [&](const vtkIndirectProgram& program)
    {
      pattern.Activate(program);
      maps.Activate(program);
      this->ActivateCharts(program);
      this->ActivateNodes(0, program, "vtkiLitEven", "vtkiFluxEven");
      this->ActivateNodes(1, program, "vtkiLitOdd", "vtkiFluxOdd");
      program->SetUniformi("vtkiLevels", this->Levels);
      if (this->WithFlux)
      {
        program->SetUniformf("vtkiEvenness", static_cast<float>(drawing.Evenness));
        program->SetUniformi("vtkiMethod", drawing.Method);
        program->SetUniformi("vtkiWarpedLevels", drawing.Levels);
      }
    });
}

//------------------------------------------------------------------------------
bool vtkIndirectSampleWarp::Update(vtkOpenGLRenderWindow* window, const vtkIndirectLightMaps& maps,
  const vtkIndirectMapSampler::Drawing& drawing, const vtkIndirectPatternTexture& pattern)
{
  const bool flux = drawing.By == vtkIndirectMapSampler::Drawing::FLUX;
  if (this->MapTime != maps.GetContentTime() || this->WithFlux != flux ||
    this->Occlusion != drawing.Occlusion)
  {
    this->MapTime = 0;
    this->WithFlux = flux;
    if (!this->UpdateCharts(window, maps) || !this->SumNodes(window, maps, drawing.Occlusion))
    {
      return false;
    }
    this->MapTime = maps.GetContentTime();
    this->Occlusion = drawing.Occlusion;
  }
  return this->Warp(window, maps, drawing, pattern);
}

//------------------------------------------------------------------------------
void vtkIndirectSampleWarp::ReleaseOwn(vtkWindow*)
{
  this->Charts.clear();
  this->MapTime = 0;
}
