// SPDX-License-Identifier: BSD-3-Clause
// The part of the plan that refines a still picture.
#include "Plan/vtkIndirectPlan.h"

namespace
{
// The guide has times and errors of refinements: "A picture left alone".
constexpr int RefinementsOnScreen = 2;
constexpr int MostRefinements = 3;
}

//------------------------------------------------------------------------------
void vtkIndirectPlan::FindRefinements(const vtkIndirectSettings& settings,
  const vtkIndirectAbilities& estimator, const vtkIndirectCircumstances& circumstances)
{
  const bool automatic = settings.NumberOfRefinements < 0;
  const bool seen = !circumstances.OffScreen;
  const bool follows = this->FinishesAtOnce || (seen && circumstances.IdleFrames);
  const int asked = !automatic             ? settings.NumberOfRefinements
    : settings.TimeBudget > 0.0            ? MostRefinements
    : this->ErrorToleranceIsSet && follows ? MostRefinements
    : seen && circumstances.IdleFrames     ? RefinementsOnScreen
                                           : 0;
  if (asked == 0 || this->Interactive)
  {
    return;
  }
  const std::string why = !this->Irradiance         ? this->WhyNoIrradiance
    : !settings.Caching                             ? "Caching is off"
    : !estimator.Refines                            ? estimator.Name + " sums no lights in batches"
    : this->Senders == HEADLIGHT                    ? "the eye's own surfaces send its light"
    : this->OtherSamplers                           ? "passes add lights of their own samplers"
    : this->Visibility != vtkIndirectVisibilityMaps ? "virtual lights have no depth maps"
                                                    : "";
  this->RefinesLights = why.empty();
  const bool refines = this->RefinesLights || (this->HasSkyMaps() && settings.Caching);
  this->Refinements = refines ? asked : 0;
  this->RefinementSeconds = refines ? settings.TimeBudget : 0.0;
  this->RefinementFades = seen;
  this->AddsBatches = circumstances.IsIdleFrame;
  this->FindPaths();
  if (!why.empty() && (!automatic || settings.TimeBudget > 0.0))
  {
    this->LeftOut.emplace_back(
      refines ? "refinement of indirect light" : "refinement of the still picture", why);
  }
}

//------------------------------------------------------------------------------
// Paths correct pictures of which they know all light (vtkIndirectPathTracer).
void vtkIndirectPlan::FindPaths()
{
  const bool hides = (!this->Sky || this->SkyIsShadowed) &&
    (!(this->AreaLights || this->VirtualAreaLights) || this->AreaIsShadowed);
  const std::string why = this->Refraction ? "paths do not pass through glass"
    : this->SenderLobes                    ? "paths are not reflected specularly"
    : this->Catches                        ? "props catch light"
    : !hides                               ? "some light passes through surfaces"
    : this->IndirectScale != 1.0           ? "IndirectScale is not 1"
                                           : "";
  const bool asked = this->RefinesLights && this->Refinements > 0;
  this->TracesPaths = asked && why.empty();
  if (asked && !why.empty())
  {
    this->LeftOut.emplace_back("correction by path tracing", why);
  }
}
