// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Senders/vtkIndirectSenderSampler.h"

#include "Capture/vtkSurfaceCapturePass.h"
#include "Plan/vtkIndirectPlan.h"
#include "Plan/vtkIndirectReport.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <utility>

namespace
{
// Texels along an edge of a map. See Documentation/methods/reflective-shadow-maps.md.
constexpr int TexelsOfMaps = 64;
constexpr int MostTexelsOfMaps = 256;
// A still picture of fewer triangles has maps of twice as many texels along an edge: relMSE (best
// 99 %) to all bounces 0.0011 -> 0.0007 on sky_machine, 0.0016 -> 0.0010 on sky_terrain, in 5 to
// 13 % more time for the first picture.
constexpr double FewTriangles = 131072.0;
// Texels of all faces of finer maps: half of what the table of senders holds, 256 in a row and
// 16,384 rows, since each map may have a second one for its window.
constexpr int MostTexelsOfAll = 2097152;
constexpr int FacesOfPositional = 6;
// Maps of directions without light are dropped if there are more maps than this.
constexpr size_t MostMaps = vtkIndirectEmitters::MostPieces;
// The least number of steady lights: half of that of automatic numbers, as NumberOfLights is
// halved.
constexpr int LeastSteadyLights = 64;

// Tells whether two lights have the same maps.
bool HaveSameMaps(const vtkIndirectLight& a, const vtkIndirectLight& b)
{
  return a.Positional == b.Positional && a.PositionWC == b.PositionWC &&
    a.DirectionWC == b.DirectionWC && a.Attenuation == b.Attenuation;
}

bool HaveSameNumber(const vtkIndirectLight& a, const vtkIndirectLight& b)
{
  return a.Index == b.Index;
}
}

//------------------------------------------------------------------------------
void vtkIndirectSenderSampler::Follow(const vtkIndirectSamplerAbilities& sampler, bool steady)
{
  // Reflected light of emitters that turn is a mild part of all light: on six scenes pictures of
  // half as many lights differ by as little from those of many.
  this->NumberOfLights = steady ? std::max(sampler.NumberOfLights / 2, 1) : sampler.NumberOfLights;
  this->MostLights = steady ? sampler.MostLights : 0;
  if (sampler.Divides != this->Divides || steady != this->Steady)
  {
    ++this->SourceTime;
    this->SendersTime = 0;
  }
  this->Divides = sampler.Divides;
  this->Steady = steady;
}

//------------------------------------------------------------------------------
vtkIndirectSamplerAbilities vtkIndirectSenderSampler::GetAbilities() const
{
  vtkIndirectSamplerAbilities abilities = this->vtkIndirectSampler::GetAbilities();
  abilities.TakesSenders = this->Steady;
  abilities.HasMore = this->Steady && this->MadeCount > 0 &&
    this->MadeCount < std::max(this->NumberOfLights, this->Narrow);
  return abilities;
}

//------------------------------------------------------------------------------
// Returns the texels along an edge of maps of this frame.
int vtkIndirectSenderSampler::FindTexels(
  const vtkIndirectFrame& frame, const vtkIndirectPlan& plan) const
{
  const bool fine =
    !plan.Interactive && !plan.LightsTurn && frame.CountDepthTriangles() < FewTriangles;
  const double fineness = this->Fineness > 0.0 ? this->Fineness : fine ? 2.0 : 1.0;
  int texels = std::min(static_cast<int>(TexelsOfMaps * fineness), MostTexelsOfMaps);
  int faces = 0;
  for (const vtkIndirectLight& emitter : this->Emitters)
  {
    faces += emitter.Positional ? FacesOfPositional : 1;
  }
  while (texels > TexelsOfMaps && faces * texels * texels > MostTexelsOfAll)
  {
    texels /= 2;
  }
  return texels;
}

//------------------------------------------------------------------------------
// Returns true if a caster has changed.
bool vtkIndirectSenderSampler::UpdateScene(const vtkIndirectFrame& frame)
{
  vtkIndirectKey key;
  frame.AppendUnitsTo(key);
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    caster.AppendTo(key);
    // Maps are fitted to the casters' wide bounds.
    key.Add("bounds", caster.Bounds, 6).Add("wide bounds", caster.GetFit(), 6);
  }
  return this->Scene.Take(std::move(key));
}

//------------------------------------------------------------------------------
void vtkIndirectSenderSampler::BeginFrame(
  const vtkIndirectFrame& frame, const vtkIndirectPlan& plan)
{
  this->SceneIsNew = this->UpdateScene(frame) || !this->MapsAreThere || !plan.Caching;
  this->Hasty = plan.Interactive && (this->Hasty || this->SceneIsNew);
}

//------------------------------------------------------------------------------
// Sets the emitters. Emitters keep their places while their maps are valid, even without light: a
// turning sky redraws no maps, except those of moving emitters such as a sun.
void vtkIndirectSenderSampler::SetEmitters(
  const vtkIndirectEmitters::List& emitters, const vtkIndirectKey& source)
{
  this->Source = source;
  this->Given = emitters;
  this->IsFresh = true;
  ++this->SourceTime;
  vtkIndirectEmitters::List lit = emitters;
  for (vtkIndirectLight& emitter : this->Emitters)
  {
    const auto found = std::find_if(lit.begin(), lit.end(),
      [&](const vtkIndirectLight& other) { return HaveSameNumber(emitter, other); });
    emitter.Color = glm::dvec3(0.0);
    emitter.Pieces = 0;
    if (found != lit.end())
    {
      this->EmittersHaveMoved = this->EmittersHaveMoved || !HaveSameMaps(emitter, *found);
      emitter = *found;
      lit.erase(found);
    }
  }
  this->EmittersHaveMoved = this->EmittersHaveMoved || !lit.empty();
  this->Emitters.insert(this->Emitters.end(), lit.begin(), lit.end());
}

//------------------------------------------------------------------------------
bool vtkIndirectSenderSampler::DrawMaps(
  const vtkIndirectFrame& frame, const vtkIndirectPlan& plan, vtkSurfaceCapturePass* capture)
{
  // A scene at rest takes exactly the given emitters in their order, so that the picture does not
  // depend on its history.
  const bool rests = !plan.Interactive && !this->IsFresh && !frame.IsFurtherPart();
  this->IsFresh = false;
  if (rests &&
    !std::equal(this->Emitters.begin(), this->Emitters.end(), this->Given.begin(),
      this->Given.end(), HaveSameNumber))
  {
    this->Emitters = this->Given;
    this->EmittersHaveMoved = true;
  }
  if (!plan.LightsTurn && (this->SceneIsNew || this->Emitters.size() > MostMaps))
  {
    const auto dark = std::remove_if(this->Emitters.begin(), this->Emitters.end(),
      [](const vtkIndirectLight& emitter) { return !emitter.IsReflected(); });
    this->EmittersHaveMoved = this->EmittersHaveMoved || dark != this->Emitters.end();
    this->Emitters.erase(dark, this->Emitters.end());
  }
  // While the camera moves, the maps' windows stay.
  const bool seen = this->SeenByMaps == frame.Seen.Near || plan.Interactive;
  if (!plan.Interactive || this->SceneIsNew)
  {
    this->TexelsOfMap = this->FindTexels(frame, plan);
  }
  const bool sized = this->TexelsOfDrawn == this->TexelsOfMap;
  if (!this->SceneIsNew && !this->EmittersHaveMoved && seen && sized)
  {
    return true;
  }
  this->SeenByMaps = frame.Seen.Near;
  this->EmittersHaveMoved = false;
  // The maps are drawn of the same scene under the emitters, of colour one: maps do not depend on
  // how much light there is.
  vtkIndirectFrame scene = frame;
  vtkIndirectPlan maps;
  maps.Caching = plan.Caching;
  scene.Lights.clear();
  for (vtkIndirectLight light : this->Emitters)
  {
    light.Color = glm::dvec3(1.0);
    light.Index = static_cast<int>(scene.Lights.size());
    maps.MapLights.push_back(light.Index);
    scene.Lights.push_back(light);
  }
  this->MapsAreThere = this->Maps.Update(scene, maps, capture, this->TexelsOfMap);
  this->TexelsOfDrawn = this->TexelsOfMap;
  ++this->SourceTime;
  return this->MapsAreThere;
}

//------------------------------------------------------------------------------
// Returns true if each surface faces the emitter of one of the maps.
bool vtkIndirectSenderSampler::SeesAllSides() const
{
  return this->Emitters.size() >= vtkIndirectEmitters::NumberOfSkyGroups ||
    std::any_of(this->Emitters.begin(), this->Emitters.end(),
      [](const vtkIndirectLight& emitter) { return emitter.Positional; });
}

//------------------------------------------------------------------------------
// Reads the texels that send light, each once for a map.
bool vtkIndirectSenderSampler::ReadSenders(const Input& input)
{
  std::vector<vtkIndirectSenderClusters::Sender> senders;
  std::vector<glm::vec3> places;
  if (!this->Texels.Read({ input.Frame, this->Maps, input.Geometry }, senders, places))
  {
    return false;
  }
  // Receivers that cast no shadows are missing from the maps. Maps of few directions miss surfaces
  // along them, which the vertices of paths show.
  if (input.Frame.NumberOfOtherReceivers == 0 && (input.Further || this->SeesAllSides()))
  {
    for (size_t i = 0; input.Further && i < input.Further->Senders.size(); ++i)
    {
      places.push_back(input.Further->Senders[i].Position);
    }
    // No texel may show a small caster. The middle of its bounds lies in its hull.
    for (const vtkIndirectCaster& caster : input.Frame.Casters)
    {
      places.emplace_back(input.Frame.ToScene(0.5 *
        (vtkIndirectFrame::GetCorner(caster.Bounds, 0) +
          vtkIndirectFrame::GetCorner(caster.Bounds, 7))));
    }
    vtkIndirectSenderTexels::RemoveOutermost(senders, places);
  }
  if (this->Steady)
  {
    this->FromMaps = std::move(senders);
  }
  else
  {
    this->FromMaps = {};
    this->SteadyLights = {};
    this->Clusters.SetSenders(std::move(senders));
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectSenderSampler::Update(const Input& input)
{
  const vtkMTimeType time = std::max(this->Maps.GetContentTime(), this->Maps.GetWindowTime());
  const bool anew = this->SendersTime != time;
  if (anew)
  {
    this->SendersTime = 0;
    this->MadeTime = 0;
    if (!this->ReadSenders(input))
    {
      return false;
    }
    this->SendersTime = time;
  }
  const double error = vtkIndirectSenderClusters::FindError(input.ErrorTolerance);
  if (this->Steady)
  {
    const bool same = this->MakeSteadyLights(input, anew);
    if (same && this->MadeTime == this->SourceTime && this->MadeError == error)
    {
      return true;
    }
    return this->WriteLights(
      input, this->SteadyLights.Relight(this->Clusters, this->FindStrengths(), error), error);
  }
  if (!anew && this->MadeTime == this->SourceTime && this->MadeCount == this->NumberOfLights &&
    this->Clusters.GetSeen() == input.Frame.Seen.Near)
  {
    return true;
  }
  this->Clusters.SetSeen(input.Frame.Seen.Near);
  this->MadeCount = this->NumberOfLights;
  return this->WriteLights(input,
    this->Clusters.MakeLights(
      this->FindStrengths(), this->NumberOfLights, this->Divides ? error : 0.0),
    error);
}

//------------------------------------------------------------------------------
// Makes the steady lights anew, but for their light, unless they hold; returns true if they do.
// anew: the maps' senders are new.
bool vtkIndirectSenderSampler::MakeSteadyLights(const Input& input, bool anew)
{
  const vtkIndirectFurtherSenders* further = input.Further;
  const size_t furtherTime = further ? further->Time : 0;
  const bool joined = !anew && this->FurtherTime == furtherTime;
  // While the camera moves, lights stay.
  const bool seen = this->Clusters.GetSeen() == input.Frame.Seen.Near || input.Interactive;
  this->Narrow = vtkIndirectSenderClusters::FindMostNarrow(input.Frame, this->MostLights);
  const int wanted = std::max(this->NumberOfLights, this->Narrow);
  const int most = input.Interactive ? this->NumberOfLights : wanted;
  if (joined && seen && (this->MadeCount == most || this->MadeCount == wanted))
  {
    return true;
  }
  if (!joined)
  {
    std::vector<vtkIndirectSenderClusters::Sender> senders = this->FromMaps;
    if (further)
    {
      senders.insert(senders.end(), further->Senders.begin(), further->Senders.end());
    }
    this->Clusters.SetSenders(std::move(senders));
    this->FurtherTime = furtherTime;
  }
  this->Clusters.SetSeen(input.Frame.Seen.Near);
  this->SteadyLights.Make(this->Clusters, this->Emitters.size(), this->NumberOfLights,
    this->Divides,
    further ? vtkIndirectSenderClusters::NearnessOfBounces
            : vtkIndirectSenderClusters::StandardNearness,
    LeastSteadyLights, most);
  this->MadeCount = most;
  return false;
}

//------------------------------------------------------------------------------
std::vector<glm::dvec3> vtkIndirectSenderSampler::FindStrengths() const
{
  std::vector<glm::dvec3> strengths;
  for (const vtkIndirectLight& emitter : this->Emitters)
  {
    strengths.push_back(emitter.Color);
  }
  return strengths;
}

//------------------------------------------------------------------------------
bool vtkIndirectSenderSampler::WriteLights(
  const Input& input, const vtkIndirectSenderClusters::LightTree& lights, double error)
{
  this->MadeTime = 0;
  if (!this->Write(input.Frame, vtkIndirectSenderTexels::MakeRows(lights.Lights),
        vtkIndirectSenderTexels::MakeRows(lights.Branches)))
  {
    return false;
  }
  this->MadeTime = this->SourceTime;
  this->MadeError = error;
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectSenderSampler::AddToReport(vtkIndirectReport& report) const
{
  report.MainMemoryBytes += this->Clusters.GetBytes() + this->SteadyLights.GetBytes() +
    this->FromMaps.size() * sizeof(vtkIndirectSenderClusters::Sender);
  size_t pieces = 0;
  for (const vtkIndirectLight& emitter : this->Emitters)
  {
    pieces += emitter.Positional ? emitter.Pieces : 0;
  }
  if (pieces > vtkIndirectEmitters::MostPieces)
  {
    report.LeftOut.emplace_back(
      "maps of senders of each of " + std::to_string(pieces) + " area lights",
      "those that are near each other and face alike share one of " +
        std::to_string(vtkIndirectEmitters::MostPieces) + " places");
  }
  for (const bool sky : { true, false })
  {
    const auto lit = std::count_if(this->Emitters.begin(), this->Emitters.end(),
      [&](const vtkIndirectLight& emitter)
      { return emitter.IsReflected() && emitter.Positional != sky; });
    if (lit > 0)
    {
      report.Modelled.emplace_back(
        sky ? "bounce of light from the sky" : "bounce of light from area lights",
        std::to_string(this->GetActualNumberOfLights()) + " virtual lights of " +
          std::to_string(this->Clusters.GetNumberOfSenders()) + " texels in maps of " +
          std::to_string(lit) + (sky ? " directions, " : " places, ") +
          std::to_string(this->Maps.GetTexels()) + " texels squared");
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectSenderSampler::ReleaseOwn(vtkWindow* window)
{
  this->vtkIndirectSampler::ReleaseOwn(window);
  this->Texels.Release(window);
  this->Clusters.SetSenders({});
  this->SteadyLights = {};
  this->FromMaps = {};
  this->Emitters.clear();
  this->Given.clear();
  this->Source.Clear();
  this->Scene.Clear();
  this->MapsAreThere = false;
  this->SendersTime = 0;
  this->MadeTime = 0;
}
