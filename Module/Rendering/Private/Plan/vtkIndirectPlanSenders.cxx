// SPDX-License-Identifier: BSD-3-Clause
// The parts of the plan that concern senders: where surfaces get the light that they reflect, and
// how many bounces of it are computed.
#include "Plan/vtkIndirectPlan.h"
#include "Scene/vtkIndirectFrame.h"

#include <algorithm>

namespace
{
// The last bounce of a random walk if NumberOfBounces is automatic: in a closed room of albedo 0.97
// later bounces would add a fiftieth of all light.
constexpr int MostBounces = 128;
// Bounces of an estimator that computes them itself: an albedo of a half leaves 0.4 % beyond.
constexpr int AutomaticBounces = 8;
}

//------------------------------------------------------------------------------
void vtkIndirectPlan::FindSenders(const vtkIndirectFrame& frame,
  const vtkIndirectSettings& settings, const vtkIndirectCircumstances& circumstances)
{
  if (frame.Casters.empty())
  {
    return; // no caster could reflect the light
  }
  // The eye sees all lit senders under its headlight, unless a prop must not send light. A
  // headlight that has a size casts visible penumbrae, which need maps.
  if (frame.Lights.size() == 1 && frame.Lights.front().Headlight &&
    !frame.Lights.front().Positional && !frame.Lights.front().Fill && frame.AllSendLight &&
    !(frame.Lights.front().Size > 0.0 && settings.Shadows))
  {
    if (circumstances.SamplerWalks)
    {
      this->Senders = RAYS;
      this->Modelled.emplace_back(
        "a headlight, by rays", "the eye sees what it lights; no shadow is visible");
      return;
    }
    this->Senders = HEADLIGHT;
    return;
  }
  for (size_t i = 0; i < frame.Lights.size(); ++i)
  {
    if (frame.Lights[i].Color == glm::dvec3(0.0))
    {
      this->LeftOut.emplace_back("light " + std::to_string(frame.Lights[i].Index),
        frame.Lights[i].Finite ? "it emits nothing" : "its place or its strength is not finite");
      continue;
    }
    if (frame.Lights[i].Fill)
    {
      continue;
    }
    this->MapLights.push_back(static_cast<int>(i));
    if (frame.Lights[i].Size > 0.0)
    {
      this->LeftOut.emplace_back("size of light " + std::to_string(frame.Lights[i].Index) +
          (settings.Shadows ? " beyond its shadows" : ""),
        settings.Shadows ? "cosines, highlights, falloff and bounces are those of its centre"
                         : "Shadows are off");
    }
  }
  this->Senders = this->MapLights.empty() ? NO_SENDERS : MAPS;
  if (this->Senders == MAPS && circumstances.SamplerWalks && !settings.Shadows)
  {
    this->Senders = RAYS;
    this->MapLights.clear();
    this->Modelled.emplace_back("lights without maps", "Shadows are off, and rays find senders");
  }
}

//------------------------------------------------------------------------------
// Finds out whether all lights that surfaces reflect come from far away and turn with the camera,
// or there is only a sky that does.
// The lights' own maps would give other virtual lights, with other depth maps, in each view.
void vtkIndirectPlan::FindTurningLights(const vtkIndirectFrame& frame,
  const vtkIndirectSettings& settings, const vtkIndirectAbilities& estimator,
  const vtkIndirectCircumstances& circumstances)
{
  const bool skyTurns =
    this->Senders == NO_SENDERS && this->SkyBounces && circumstances.EnvironmentTurns;
  this->LightsTurn = (this->Senders == MAPS || this->Senders == HEADLIGHT || skyTurns) &&
    settings.IndirectScale > 0.0 && estimator.TakesSampler && circumstances.SamplerTakesSenders &&
    !estimator.IsOfPaper &&
    std::all_of(this->MapLights.begin(), this->MapLights.end(),
      [&frame](int place)
      {
        const vtkIndirectLight& light = frame.Lights[static_cast<size_t>(place)];
        return !light.Positional && (light.FollowsCamera || frame.ReplacedLights);
      });
  if (this->Senders == HEADLIGHT && !this->LightsTurn)
  {
    this->Modelled.emplace_back(
      "a headlight, from the geometry buffer", "the eye sees what it lights; no shadow is visible");
    this->LeftOut.emplace_back("senders outside the view", "the headlight has no map of its own");
  }
  if (!this->LightsTurn)
  {
    return;
  }
  this->EstimateModelled.emplace_back("bounces of lights that follow the camera",
    "as light of the three nearest of the sky's directions, which are fixed in the world");
  if (!settings.Shadows || this->Senders == HEADLIGHT)
  {
    this->Senders = NO_SENDERS;
    this->MapLights.clear();
  }
}

//------------------------------------------------------------------------------
// Plans further bounces. A random walk adds the bounces that an estimator of virtual lights cannot
// compute itself, as more virtual lights.
void vtkIndirectPlan::FindBounces(const vtkIndirectFrame& frame,
  const vtkIndirectSettings& settings, const vtkIndirectAbilities& estimator,
  const vtkIndirectCircumstances& circumstances)
{
  const bool sent = this->Senders != NO_SENDERS || this->HasSenderMaps();
  const bool walks = !estimator.ReadsMaps && !estimator.SumsSky && sent;
  this->AskedBounces = settings.NumberOfBounces;
  this->SampledBounces = settings.NumberOfBounces;
  if (settings.NumberOfBounces == 0)
  {
    // Paths end by themselves, by the albedo, so late bounces cost nothing if no light reaches
    // them. A walk for every view would take most of a frame.
    const bool follows = !this->LightsTurn &&
      std::any_of(frame.Lights.begin(), frame.Lights.end(),
        [](const vtkIndirectLight& light) { return light.FollowsCamera && !light.Fill; });
    const bool one = follows || estimator.IsOfPaper;
    const bool itself = estimator.MaximumNumberOfBounces > 1;
    this->NumberOfBounces = itself && !one ? AutomaticBounces : 1;
    this->SampledBounces = walks && estimator.TakesSampler && !itself && !one ? MostBounces : 1;
    if (sent && (itself || (walks && one)))
    {
      const std::string last = std::to_string(this->NumberOfBounces);
      this->EstimateLeftOut.emplace_back("bounces after bounce " + last,
        "NumberOfBounces is automatic, which is " + last +
          (follows                  ? std::string(" where lights follow the camera")
              : estimator.IsOfPaper ? std::string(" with the preset PAPER")
                                    : " with " + estimator.Name) +
          "; the result is too dark");
    }
  }
  if (this->SampledBounces > estimator.MaximumNumberOfBounces && walks &&
    !circumstances.SamplerWalks && !circumstances.OtherSamplerWalks)
  {
    this->WalkedBounces = this->SampledBounces;
  }
  this->LastBounce = std::max(this->NumberOfBounces, this->WalkedBounces);
  if (circumstances.SamplerWalks || circumstances.OtherSamplerWalks)
  {
    this->LastBounce = std::max(this->LastBounce, this->SampledBounces);
  }
}
