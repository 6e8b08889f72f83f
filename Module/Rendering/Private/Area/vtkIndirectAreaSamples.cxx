// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Area/vtkIndirectAreaSamples.h"

#include "Area/vtkIndirectAreaMaps.h"
#include "Capture/vtkIndirectGeometryBuffer.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"

#include <algorithm>

namespace
{
const vtkIndirectChannels OpenSampleChannels = {
  { "area.open", "vtkiAreaOpen", "irradiance if nothing hid area lights; distance", GL_RGBA32F, "-",
    "VTK irradiance" },
  { "area.openFront", "vtkiAreaOpenFront", "a bit for each lamp that sends light to its side of it",
    GL_RGBA32F, "-", "-" },
};
const vtkIndirectChannels SampleChannels = {
  { "area.light", "vtkiAreaLight", "irradiance from area lights; distance over that of samples",
    GL_RGBA32F, "-", "VTK irradiance" },
  { "area.share", "vtkiAreaShare", "share of it that is seen", GL_RGBA32F, "-", "1" },
};

// Pixels between places of known unoccluded light, and between samples; the same numbers are in
// vtkIndirectAreaSamples.glsl.
constexpr int OpenStep = 8;
constexpr int SampleStep = 4;
// These lamps with their points take less than 16384 bytes, which every OpenGL allows for a block.
constexpr size_t LampsOfBatch = 8;
}

//------------------------------------------------------------------------------
vtkIndirectAreaSamples::vtkIndirectAreaSamples(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Block(this, LampsOfBatch, NumberOfPoints)
  , Open(this, OpenSampleChannels)
  , Samples(this, SampleChannels)
{
}

//------------------------------------------------------------------------------
vtkIndirectProgram vtkIndirectAreaSamples::Use(
  const Input& input, const Batch& batch, vtkIndirectFullScreenProgram& kernel, int step)
{
  vtkIndirectProgram program = kernel.Use(input.Frame.Window,
    std::string(input.Maps ? "#define VTKI_VISIBILITY\n" : "") +
      (batch.Images > 0 ? "#define VTKI_AREA_IMAGE\n" : "") + this->Block.GetDefinitions() +
      "#define VTKI_AREA_DISTANCES " + std::to_string(input.Distances) + ".0f\n" +
      vtkIndirectReceiverGrid::DefineStep(step));
  if (!program)
  {
    return nullptr;
  }
  input.Geometry.ActivateReceivers(program, input.Frame);
  program->SetUniformi("vtkiAreaCount", static_cast<int>(batch.Count));
  this->Block.Activate(program);
  if (input.Maps)
  {
    input.Maps->GetAtlas().Activate(program);
  }
  if (batch.Images > 0)
  {
    input.Lamps.GetTexture().Activate(0, program);
    program->SetUniformf("vtkiAreaTolerance", static_cast<float>(input.Tolerance));
  }
  return program;
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaSamples::FindOpen(const Input& input, const Batch& batch)
{
  this->Open.Begin();
  const bool done = this->Use(input, batch, this->OpenKernel, OpenStep) != nullptr;
  if (done)
  {
    this->OpenKernel.Draw();
  }
  this->Open.End();
  return done;
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaSamples::FindSamples(const Input& input, const Batch& batch)
{
  this->Samples.Begin();
  vtkIndirectProgram program = this->Use(input, batch, this->SampleKernel, OpenStep);
  if (program)
  {
    this->Open.ActivateAll(program);
    this->SampleKernel.Draw();
  }
  this->Samples.End();
  return program != nullptr;
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaSamples::Interpolate(
  const Input& input, const Batch& batch, vtkIndirectTarget& irradiance)
{
  irradiance.Begin();
  vtkIndirectProgram program = this->Use(input, batch, this->SumKernel, SampleStep);
  if (program)
  {
    this->Samples.ActivateAll(program);
    const vtkIndirectAddition addition(input.Frame.Window, batch.First > 0);
    this->SumKernel.Draw();
  }
  irradiance.End();
  return program != nullptr;
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaSamples::Sum(const Input& input, vtkIndirectTarget& irradiance)
{
  const vtkIndirectAreaLamps::List& lamps = input.Lamps.Get();
  bool done = true;
  for (size_t first = 0; done && first < lamps.size(); first += LampsOfBatch)
  {
    Batch batch = { first, std::min(lamps.size() - first, LampsOfBatch), 0 };
    for (size_t i = 0; i < batch.Count; ++i)
    {
      batch.Images += lamps[first + i]->Row >= 0 ? 1 : 0;
    }
    done =
      this->Open.Resize(input.Frame, OpenStep) && this->Samples.Resize(input.Frame, SampleStep);
    if (done)
    {
      this->Block.Update(input.Frame.Window, input.Lamps, first, batch.Count, input.Maps);
    }
    done = done && this->FindOpen(input, batch) && this->FindSamples(input, batch) &&
      this->Interpolate(input, batch, irradiance);
  }
  return done;
}
