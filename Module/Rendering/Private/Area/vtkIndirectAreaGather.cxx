// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Area/vtkIndirectAreaGather.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "OpenGL/vtkIndirectKey.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Plan/vtkIndirectPlan.h"
#include "Plan/vtkIndirectReport.h"
#include "Plan/vtkIndirectStageTimer.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkAreaLight.h"

#include <algorithm>

namespace
{
const vtkIndirectChannels AreaChannels = {
  { "area", "vtkiArea", "irradiance that comes directly from area lights", GL_RGBA32F, "-",
    "VTK irradiance" },
};
}

//------------------------------------------------------------------------------
vtkIndirectAreaGather::vtkIndirectAreaGather(vtkIndirectResource* owner, vtkIndirectDepthMaps& maps)
  : vtkIndirectFrameLight(owner)
  , Maps(this, maps, vtkIndirectDepthMaps::AREA_LIGHTS)
  , Rounds(this, maps)
  , Irradiance(this, AreaChannels, false)
  , Open(this, AreaChannels, false)
{
}

//------------------------------------------------------------------------------
void vtkIndirectAreaGather::AppendTo(vtkIndirectKey& key, const Input& input) const
{
  input.Frame.AppendFitsTo(key);
  for (const auto& light : *input.AreaLights)
  {
    key.Add("area lights", light);
  }
  key.Add("area lights", input.Plan.AreaIsShadowed).Add("area lights", input.Plan.AreaSpecular);
  key.Add("interactive", input.Plan.Interactive);
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaGather::Update(const Input& input)
{
  input.Timer.Begin(vtkIndirectStageTimer::Visibility);
  this->Lamps.Update(input.Frame, *input.AreaLights);
  this->Visible = input.Plan.AreaIsShadowed;
  this->Moving = input.Plan.Interactive;
  if (this->Visible)
  {
    this->Maps.Update(input.Frame, this->Lamps, 0);
    if (input.Still && this->Maps.IsComplete() && !this->IsFinished())
    {
      this->Rounds.RequestNext(input.Frame, this->Lamps);
    }
  }
  else
  {
    this->Maps.Release(input.Frame.Window);
    this->Rounds.Release(input.Frame.Window);
  }
  input.Timer.End(vtkIndirectStageTimer::Visibility);
  return true;
}

//------------------------------------------------------------------------------
// Returns true if further frames of the same view add nothing to the result.
bool vtkIndirectAreaGather::IsFinished() const
{
  return !this->Visible || this->Moving || this->Rounds.IsFinished();
}

//------------------------------------------------------------------------------
int vtkIndirectAreaGather::GetNumberOfTilesLeft() const
{
  if (!this->Visible)
  {
    return 0;
  }
  const int rounds = this->IsFinished()
    ? 0
    : vtkIndirectAreaLamps::NumberOfRounds - this->Rounds.GetNumberOfRounds();
  return this->Maps.GetAtlas().GetNumberOfTilesLeft() +
    rounds * this->Maps.GetAtlas().GetNumberOfTiles();
}

//------------------------------------------------------------------------------
// Returns the tolerance of an image's mean. The sum of its pieces' errors is a small part of their
// tolerances.
double vtkIndirectAreaGather::GetTolerance(const Input& input) const
{
  return (this->Moving ? 0.5 : 0.25) * input.Plan.ErrorTolerance;
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkIndirectAreaGather::MakeEstimate(const Input& input)
{
  vtkIndirectEstimate result;
  Input own = input;
  own.Still = input.Still && !this->Maps.GetAtlas().HasChanged();
  input.Timer.Begin(vtkIndirectStageTimer::Area);
  const bool summed = this->SumAll(own);
  input.Timer.End(vtkIndirectStageTimer::Area);
  if (summed)
  {
    result.State =
      this->IsFinished() ? vtkIndirectEstimate::CONVERGED : vtkIndirectEstimate::REFINING;
    result.Contributions = { { vtkIndirectContribution::AREA, &this->Irradiance } };
    result.Contributions.front().Open = input.Plan.Catches ? this->FindOpen() : nullptr;
    if (this->Specular)
    {
      result.Contributions.push_back(
        { vtkIndirectContribution::REFLECTED, &this->Lobes.GetReflected() });
    }
  }
  return result;
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaGather::SumAll(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  if (!this->Irradiance.Resize(frame.Window, frame.Size[0], frame.Size[1]))
  {
    return false;
  }
  vtkIndirectFullScreenState kernelState(frame.Window);
  if (input.Still)
  {
    return this->SumIrradiance(input);
  }
  if (!this->Lamps.UpdateTexture(frame) || !this->SumIrradiance(input))
  {
    return false;
  }
  return this->SumLobes(input);
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaGather::SumLobes(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  this->Specular = input.Plan.AreaSpecular;
  if (!this->Specular)
  {
    this->Lobes.Release(frame.Window);
    return true;
  }
  const int points =
    this->Moving ? vtkIndirectAreaSamples::NumberOfPoints : vtkIndirectAreaLamps::MostPoints;
  return this->Lobes.Sum(
    { frame, input.Geometry, this->Lamps, this->Visible ? &this->Maps : nullptr,
      static_cast<size_t>(points), this->GetTolerance(input) });
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaGather::SumIrradiance(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  if (this->Moving && !this->Lamps.Get().empty())
  {
    return this->SumMoving(input);
  }
  this->Open.Release(frame.Window);
  if (!this->Visible)
  {
    vtkIndirectFullScreenState kernelState(frame.Window);
    return this->SumOpen(input, this->Irradiance);
  }
  return this->SumRounds(input);
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaGather::SumMoving(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  vtkIndirectFullScreenState kernelState(frame.Window);
  vtkIndirectAreaSamples::Input samples = { frame, input.Geometry, this->Lamps,
    this->Visible ? &this->Maps : nullptr, this->GetTolerance(input),
    vtkIndirectAreaSamples::DistancesOfMoving };
  if (!this->Samples.Sum(samples, this->Irradiance))
  {
    return false;
  }
  if (!input.Plan.Catches)
  {
    this->Open.Release(frame.Window);
    return true;
  }
  samples.Maps = nullptr;
  return this->Open.Resize(frame.Window, frame.Size[0], frame.Size[1]) &&
    this->OpenSamples.Sum(samples, this->Open);
}

//------------------------------------------------------------------------------
// Returns the image of the light if nothing hid it.
const vtkIndirectTarget* vtkIndirectAreaGather::FindOpen() const
{
  return !this->Visible           ? &this->Irradiance
    : this->Open.GetFramebuffer() ? &this->Open
                                  : &this->Rounds.GetOpen();
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaGather::SumRounds(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  const vtkIndirectAreaRounds::Input rounds = { frame, input.Geometry, this->Lamps, this->Maps };
  bool done = this->Rounds.Resize(frame);
  if (done && input.Still)
  {
    done = this->Rounds.Continue(rounds);
  }
  vtkIndirectFullScreenState kernelState(frame.Window);
  if (done && !input.Still)
  {
    done = this->SumOpen(input, this->Rounds.GetOpen()) && this->Rounds.Begin(rounds);
  }
  return done && this->Rounds.Multiply(frame, this->Irradiance);
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaGather::SumOpen(const Input& input, vtkIndirectTarget& target)
{
  const vtkIndirectFrame& frame = input.Frame;
  const vtkIndirectAreaLamps::List& lamps = this->Lamps.Get();
  // Images are sampled: samples take less time than the closed form of an image at each pixel, and
  // more than that of a lamp of one radiance.
  if (std::any_of(lamps.begin(), lamps.end(), [](const auto& lamp) { return lamp->Row >= 0; }))
  {
    return this->StillSamples.Sum(
      { frame, input.Geometry, this->Lamps, nullptr, this->GetTolerance(input),
        vtkIndirectAreaSamples::DistancesOfStill },
      target);
  }
  bool done = true;
  target.Begin();
  target.Clear();
  const vtkIndirectAddition addition(frame.Window);
  for (size_t i = 0; done && i < lamps.size(); ++i)
  {
    vtkIndirectProgram program = this->Kernel.Use(frame.Window, this->Block.GetDefinitions());
    done = program != nullptr;
    if (done)
    {
      this->Block.Update(frame.Window, this->Lamps, i, 1, nullptr);
      this->Block.Activate(program);
      input.Geometry.ActivateReceivers(program, frame);
      program->SetUniformi("vtkiAreaCount", 1);
      this->Kernel.Draw();
    }
  }
  target.End();
  return done;
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
    const int points = this->Moving
      ? vtkIndirectAreaSamples::NumberOfPoints
      : this->Lamps.GetNumberOfPoints() * std::max(this->Rounds.GetNumberOfRounds(), 1);
    what += ", hidden by depth maps of " + std::to_string(points) + " points of each, " +
      std::to_string(this->Maps.GetAtlas().GetTexels()) + " texels squared";
  }
  report.Modelled.emplace_back("light of area lights", what);
  if (!this->IsFinished())
  {
    const int left = vtkIndirectAreaLamps::NumberOfRounds - this->Rounds.GetNumberOfRounds();
    report.LeftOut.emplace_back(
      std::to_string(left * this->Lamps.GetNumberOfPoints()) + " points of each area light",
      "further frames of a view that stands still ask them what hides the light");
  }
}
