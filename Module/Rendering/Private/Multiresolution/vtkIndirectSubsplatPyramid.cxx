// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Multiresolution/vtkIndirectSubsplatPyramid.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Scene/vtkIndirectEyeUniforms.h"
#include "Senders/vtkIndirectLightBlock.h"
#include "Visibility/vtkIndirectVisibility.h"

#include <algorithm>

namespace
{
const vtkIndirectChannels PlaneChannels = {
  { "subsplat.surface", "vtkiLevelSurface", "octahedral normal, depth, state", GL_RGBA32F, "view",
    "scene units" },
  { "subsplat.deviation", "vtkiFinerDeviation",
    "distance from the mean plane over the width, spread of the normals (negative: not needed)",
    GL_RG16F, "-", "-" },
};
const vtkIndirectChannels RangeChannels = {
  { "subsplat.surface", "vtkiLevelSurface", "octahedral normal, depth, state", GL_RGBA32F, "view",
    "scene units" },
  { "subsplat.minimum", "vtkiFinerMinimum", "least normal components and depth", GL_RGBA32F, "view",
    "scene units" },
  { "subsplat.maximum", "vtkiFinerMaximum", "greatest normal components and depth", GL_RGBA32F,
    "view", "scene units" },
};
const vtkIndirectChannels ProbeChannels = {
  { "subsplat.probe", "vtkiProbe", "luminance of the irradiance at a pixel of each texel", GL_R32F,
    "-", "VTK irradiance over the frame's unit" },
  { "subsplat.sender", "vtkiProbeSender", "position and area of the light of greatest curvature",
    GL_RGBA32F, "view", "scene units" },
  { "subsplat.senderDensity", "vtkiProbeDensity",
    "its normal times density and area, over the irradiance", GL_RGBA32F, "view", "-" },
};
const vtkIndirectChannels VariationChannels = {
  { "subsplat.variation", "vtkiVariation",
    "relative error of interpolation between probes; that light's normal times density and area",
    GL_RGBA32F, "view", "-" },
};
}

//------------------------------------------------------------------------------
bool vtkIndirectSubsplatPyramid::Resize(
  vtkOpenGLRenderWindow* window, const int size[2], const Settings& settings)
{
  if (settings.DepthRange != this->DepthRange)
  {
    this->Levels.clear();
    this->DepthRange = settings.DepthRange;
  }
  // The coarsest level is split into leaves, of the finest level at least.
  const size_t least = static_cast<size_t>(std::max(settings.FinestLevel + 1, 2));
  int width = size[0];
  int height = size[1];
  size_t count = 0;
  do
  {
    width = (width + 1) / 2;
    height = (height + 1) / 2;
    if (count == this->Levels.size())
    {
      this->Levels.push_back(std::make_unique<vtkIndirectTarget>(
        this, settings.DepthRange ? RangeChannels : PlaneChannels, false));
    }
    if (!this->Levels[count++]->Resize(window, width, height))
    {
      return false;
    }
  } while (2 * std::max(width, height) > settings.CoarsestResolution || count < least);
  this->Levels.resize(count);

  const bool probes = settings.LightingThreshold > 0.0;
  if (!probes && this->Probe)
  {
    this->Probe.reset();
    this->Variation.reset();
  }
  if (probes && !this->Probe)
  {
    this->Probe = std::make_unique<vtkIndirectTarget>(this, ProbeChannels, false);
    this->Variation = std::make_unique<vtkIndirectTarget>(this, VariationChannels, false);
  }
  return !probes ||
    (this->Probe->Resize(window, width, height) && this->Variation->Resize(window, width, height));
}

//------------------------------------------------------------------------------
bool vtkIndirectSubsplatPyramid::ProbeLighting(
  const Input& input, const Settings& settings, vtkIndirectLightBlock& lights)
{
  const vtkIndirectFrame& frame = input.Frame;
  const int size[2] = { this->Probe->GetWidth(), this->Probe->GetHeight() };
  this->ProbeLights.SetDefinitions(lights.GetDefinitions() + input.Visibility.GetDefinitions() +
    (settings.Reprojected ? "#define VTKI_REPROJECTED\n" : ""));
  for (const bool probe : { true, false })
  {
    vtkIndirectFullScreenProgram& kernel = probe ? this->ProbeLights : this->MeasureVariation;
    vtkIndirectTarget& target = probe ? *this->Probe : *this->Variation;
    const bool drawn = kernel.Run(frame.Window, target,
      [&](const vtkIndirectProgram& program)
      {
        input.Geometry.ActivateReceivers(program, frame);
        program->SetUniform2i("vtkiLevelSize", size);
        program->SetUniformf("vtkiEdge", EdgeOf(this->Levels.size()));
        program->SetUniformf("vtkiStorageScale", static_cast<float>(settings.StorageScale));
        program->SetUniformf("vtkiSamePlane", static_cast<float>(settings.PlaneThreshold));
        program->SetUniformf("vtkiSameNormal", static_cast<float>(settings.NormalThreshold));
        if (probe)
        {
          lights.Activate(program);
          input.Visibility.Activate(frame.Window, program, input.Creases);
          if (settings.Reprojected)
          {
            settings.Reprojected->Activate(0, program, "vtkiReprojected");
          }
        }
        else
        {
          this->Probe->Activate(0, program);
          this->Probe->Activate(2, program);
        }
      });
    if (!drawn)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectSubsplatPyramid::BuildLevel(
  const Input& input, const Settings& settings, size_t number)
{
  const vtkIndirectFrame& frame = input.Frame;
  const bool first = number == 1;
  vtkIndirectFullScreenProgram& kernel = first ? this->BuildFinest : this->BuildCoarser;
  vtkIndirectTarget& level = *this->Levels[number - 1];
  return kernel.Run(frame.Window, level,
    [&](const vtkIndirectProgram& program)
    {
      vtkIndirectSetEyeUniforms(program, frame);
      program->SetUniformf("vtkiEdge", EdgeOf(number));
      program->SetUniformi("vtkiSplits", static_cast<int>(number) > settings.FinestLevel);
      program->SetUniformi("vtkiLast", number == this->Levels.size());
      program->SetUniformf("vtkiPlaneThreshold", static_cast<float>(settings.PlaneThreshold));
      program->SetUniformf("vtkiDepthThreshold", static_cast<float>(settings.DepthThreshold));
      program->SetUniformf("vtkiNormalThreshold", static_cast<float>(settings.NormalThreshold));
      if (settings.HasCompute)
      {
        this->Lists.Activate(program, number - 1);
      }
      if (settings.LightingThreshold > 0.0)
      {
        // The error of interpolation goes with the square of the width.
        const double widths = std::exp2(static_cast<double>(this->Levels.size() - number));
        program->SetUniformf("vtkiVariationThreshold",
          static_cast<float>(settings.LightingThreshold * widths * widths));
        program->SetUniformf(
          "vtkiLightingThreshold", static_cast<float>(settings.LightingThreshold));
        this->Variation->Activate(0, program);
        this->Probe->Activate(1, program);
      }
      input.Geometry.GetTarget().Activate(vtkIndirectGeometryBuffer::Surface, program);
      if (first && settings.Reprojected)
      {
        settings.Reprojected->Activate(0, program, "vtkiReprojected");
      }
      if (!first)
      {
        const vtkIndirectTarget& finer = *this->Levels[number - 2];
        const int size[2] = { finer.GetWidth(), finer.GetHeight() };
        program->SetUniform2i("vtkiFinerSize", size);
        finer.Activate(0, program, "vtkiFinerSurface");
        for (int channel = 1; channel < (this->DepthRange ? 3 : 2); ++channel)
        {
          finer.Activate(channel, program);
        }
      }
    });
}

//------------------------------------------------------------------------------
bool vtkIndirectSubsplatPyramid::Build(
  const Input& input, const Settings& settings, vtkIndirectLightBlock& lights)
{
  std::string definitions;
  if (settings.HasCompute)
  {
    // Version 4.30, because some compilers lack the extension's atomic functions.
    definitions += "#version 430\n#define VTKI_LIST_SPLIT\n";
    std::vector<size_t> texels;
    for (const auto& level : this->Levels)
    {
      texels.push_back(static_cast<size_t>(level->GetWidth()) * level->GetHeight());
    }
    this->Lists.Begin(input.Frame.Window, texels);
  }
  definitions += settings.DepthRange ? "#define VTKI_DEPTH_RANGE\n" : "";
  definitions += settings.LightingThreshold > 0.0 ? "#define VTKI_VARIATION\n" : "";
  definitions += settings.Reprojected ? "#define VTKI_REPROJECTED\n" : "";
  this->BuildFinest.SetDefinitions(definitions);
  this->BuildCoarser.SetDefinitions(
    definitions + (settings.Balance ? "#define VTKI_BALANCE\n" : ""));

  bool done = !this->Probe || this->ProbeLighting(input, settings, lights);
  for (size_t number = 1; done && number <= this->Levels.size(); ++number)
  {
    done = this->BuildLevel(input, settings, number);
  }
  if (settings.HasCompute)
  {
    this->Lists.End();
  }
  return done;
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatPyramid::ReleaseOwn(vtkWindow*)
{
  this->Levels.clear();
  this->Probe.reset();
  this->Variation.reset();
}
