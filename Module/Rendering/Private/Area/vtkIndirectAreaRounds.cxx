// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Area/vtkIndirectAreaRounds.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"

namespace
{
const vtkIndirectChannels OpenChannels = {
  { "area.open", "vtkiAreaOpen", "irradiance if nothing hid area lights", GL_RGBA32F, "-",
    "VTK irradiance" },
};
const vtkIndirectChannels SumChannels = {
  { "area.seen", "vtkiAreaSeen", "what points of area lights give that are seen", GL_RGBA32F, "-",
    "VTK irradiance" },
  { "area.all", "vtkiAreaAll", "what all of them would", GL_RGBA32F, "-", "VTK irradiance" },
};
}

//------------------------------------------------------------------------------
vtkIndirectAreaRounds::vtkIndirectAreaRounds(vtkIndirectResource* owner, vtkIndirectDepthMaps& maps)
  : vtkIndirectResource(owner)
  , Maps(this, maps, vtkIndirectDepthMaps::AREA_ROUNDS)
  , Block(this, 1, vtkIndirectAreaLamps::MostPoints)
  , Open(this, OpenChannels, false)
  , Sums(this, SumChannels, false)
{
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaRounds::Resize(const vtkIndirectFrame& frame)
{
  return this->Open.Resize(frame.Window, frame.Size[0], frame.Size[1]) &&
    this->Sums.Resize(frame.Window, frame.Size[0], frame.Size[1]);
}

//------------------------------------------------------------------------------
// Adds the points that have a map.
bool vtkIndirectAreaRounds::Add(const Input& input, const vtkIndirectAreaMaps& maps)
{
  const vtkIndirectFrame& frame = input.Frame;
  this->Sums.Begin();
  const vtkIndirectAddition addition(frame.Window);
  bool done = true;
  for (size_t i = 0; done && i < input.Lamps.Get().size(); ++i)
  {
    vtkIndirectProgram program = this->ShareKernel.Use(frame.Window, this->Block.GetDefinitions());
    done = program != nullptr;
    if (done)
    {
      this->Block.Update(frame.Window, input.Lamps, i, 1, &maps);
      input.Geometry.ActivateReceivers(program, frame);
      program->SetUniformi("vtkiAreaCount", 1);
      program->SetUniformi("vtkiAreaPoints", static_cast<int>(maps.GetPoints(i).size()));
      this->Block.Activate(program);
      maps.GetAtlas().Activate(program);
      this->ShareKernel.Draw();
    }
  }
  this->Sums.End();
  return done;
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaRounds::Begin(const Input& input)
{
  this->Sums.Begin();
  this->Sums.Clear();
  this->Sums.End();
  this->Rounds = 1;
  return this->Add(input, input.First);
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaRounds::Continue(const Input& input)
{
  if (!this->Maps.IsComplete())
  {
    return true;
  }
  ++this->Rounds;
  const bool added = this->Add(input, this->Maps);
  if (this->IsFinished())
  {
    this->Maps.Release(input.Frame.Window);
  }
  return added;
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaRounds::Multiply(const vtkIndirectFrame& frame, vtkIndirectTarget& irradiance)
{
  return this->ProductKernel.Run(frame.Window, irradiance,
    [&](const vtkIndirectProgram& program)
    {
      this->Open.Activate(0, program);
      this->Sums.Activate(0, program);
      this->Sums.Activate(1, program);
    });
}
