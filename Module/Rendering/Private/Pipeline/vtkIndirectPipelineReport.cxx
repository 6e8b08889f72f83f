// SPDX-License-Identifier: BSD-3-Clause
// Writes into the report what vtkIndirectPipeline did in the last frame.
#include "OpenGL/vtkIndirectGL.h"

#include "Pipeline/vtkIndirectPipeline.h"

#include "Maps/vtkIndirectLightMap.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "Pipeline/vtkIndirectLighting.h"
#include "Plan/vtkIndirectReport.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{
const char* const WhyItWaits = "MapsFirst: its depth maps are not all there yet";
}

//------------------------------------------------------------------------------
void vtkIndirectPipeline::AddSettings(vtkIndirectSettingList& list,
  const vtkIndirectSettings& settings, const vtkIndirectPlan* plan) const
{
  using Choice = vtkIndirectSettingList::Choice;
  static const char* const visibilities[] = { "Auto", "None", "Voxels", "Maps" };
  const bool maps = plan && plan->Senders == vtkIndirectPlan::MAPS;
  const int lighting = plan && settings.IndirectScale == 0.0
    ? static_cast<int>(vtkIndirectLightingScene)
    : settings.Lighting;
  list.Add("Lighting", Choice{ vtkIndirectLighting::GetTitle(lighting) })
    .Add("Visibility", Choice{ visibilities[plan ? plan->Visibility : settings.Visibility] })
    .Add("Shadows", plan ? plan->Shadows : settings.Shadows)
    .Add("Antialiasing", plan ? plan->Antialiasing : settings.Antialiasing)
    .Add("ReflectiveShadowMapResolution",
      maps ? this->Maps.GetTexels() : this->MapsPass->GetResolution())
    .Add("NumberOfBounces", plan ? plan->LastBounce : settings.NumberOfBounces)
    .Add("IndirectScale", settings.IndirectScale)
    .Add("ErrorTolerance", plan ? plan->EstimatorErrorTolerance : settings.ErrorTolerance)
    .Add("Caching", settings.Caching)
    .Add("MapsFirst", plan ? plan->WaitsForMaps : settings.MapsFirst)
    .Add("NumberOfRefinements", plan ? plan->Refinements : settings.NumberOfRefinements)
    .Add("TimeBudget", plan ? plan->RefinementSeconds : settings.TimeBudget)
    .Add("IdleFrames", settings.IdleFrames)
    .Add("SpheresInMotion", settings.SpheresInMotion)
    .Add("RemainingGeometry", settings.RemainingGeometry)
    .Add("Timing", this->Timer.Enabled);
}

//------------------------------------------------------------------------------
// Reports maps with coarse texels where the camera looks.
void vtkIndirectPipeline::AddCoarseMapsToReport(vtkIndirectReport& report) const
{
  // Share of the picture's height: wider steps at the edges of shadows are visible.
  constexpr double coarse = 0.01;
  vtkCamera* camera = this->Renderer ? this->Renderer->GetActiveCamera() : nullptr;
  if (!camera || !this->Plan.Shadows)
  {
    return;
  }
  double focal[3];
  camera->GetFocalPoint(focal);
  const double seen = camera->GetParallelProjection() ? 2.0 * camera->GetParallelScale()
                                                      : 2.0 * camera->GetDistance() *
      std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  double worst = 0.0;
  int count = 0;
  for (int i = 0; i < this->Maps.GetNumberOfMaps(); ++i)
  {
    const double texel =
      this->Maps.GetMap(i).FindTexelAt({ focal[0], focal[1], focal[2] }, this->Maps.GetTexels());
    const double share = seen > 0.0 ? texel / seen : 0.0;
    count += share > coarse ? 1 : 0;
    worst = std::max(worst, share);
  }
  if (count > 0)
  {
    char share[32];
    std::snprintf(share, sizeof(share), "%.3g", 100.0 * worst);
    report.LeftOut.emplace_back("fine shadows of " + std::to_string(count) + " lights",
      std::string("a texel of a light's map is up to ") + share +
        " % of the height of what is seen at the focal point; what is smaller casts no shadow");
  }
}

//------------------------------------------------------------------------------
void vtkIndirectPipeline::AddToReport(vtkIndirectReport& report) const
{
  std::copy(this->Frame.Size, this->Frame.Size + 2, report.Size);
  report.Counters = { { "shader_builds", this->Capture->GetNumberOfShaderBuilds() },
    { "faces_drawn", this->Maps.GetNumberOfFacesDrawn() + this->Samplers.GetNumberOfFacesDrawn() },
    { "voxel_updates", static_cast<long long>(this->Bounce.GetVisibility().GetNumberOfUpdates()) },
    { "sphere_updates",
      static_cast<long long>(this->Bounce.GetVisibility().GetNumberOfSphereUpdates()) },
    { "sky_tiles_drawn",
      static_cast<long long>(
        this->DepthMaps.Get(vtkIndirectDepthMaps::STRONG_SKY).GetNumberOfTilesDrawn() +
        this->DepthMaps.Get(vtkIndirectDepthMaps::SKY).GetNumberOfTilesDrawn()) },
    { "tiles_drawn", static_cast<long long>(this->DepthMaps.GetNumberOfTilesDrawn()) },
    { "estimates", this->NumberOfEstimates } };
  report.Counters["tiles_left"] = this->CountTilesLeft();
  report.Counters["refinements"] = this->Schedule.GetRefinements();
  report.Counters["batches_left"] = this->CountBatchesLeft();
  report.Add({}, this->Frame.DescribeLeftOut());
  if (!this->BuffersAreThere)
  {
    report.Modelled.emplace_back("the delegate alone", this->WhyNoBuffers);
    if (vtkIndirectVisibleLamps::Count(this->UsableAreaLights) > 0)
    {
      report.LeftOut.emplace_back("area lights that are seen", this->WhyNoBuffers);
    }
    return;
  }
  report.BackEndChoices = this->BackEndChoices;
  report.Bytes = this->Geometry.GetTarget().GetBytes() + this->Creases.GetBytes() +
    this->Accumulation.GetBytes() + this->Antialiasing.GetBytes() + this->VisibleLamps.GetBytes();
  report.Changed = this->FrameKey.FindChanges(this->LastFrameKey);
  report.Add(this->Plan.Modelled, this->Plan.LeftOut);
  if (this->Plan.Antialiasing && !this->Antialiasing.GetWhyNot().empty())
  {
    const std::string name = "antialiased edges";
    report.Modelled.erase(std::remove_if(report.Modelled.begin(), report.Modelled.end(),
                            [&](const auto& entry) { return entry.first == name; }),
      report.Modelled.end());
    report.LeftOut.emplace_back(name, this->Antialiasing.GetWhyNot());
  }
  if (this->Plan.Senders != vtkIndirectPlan::HEADLIGHT)
  {
    this->Maps.AddToReport(report);
    this->Penumbra.AddToReport(report);
    this->AddCoarseMapsToReport(report);
  }
  for (const Part& part : this->Parts)
  {
    if (this->IsCurrent(part))
    {
      if (part.IsOfEstimator)
      {
        report.Add(this->Plan.EstimateModelled, this->Plan.EstimateLeftOut);
      }
      report.Bytes += part.Light->GetBytes();
      report.MainMemoryBytes += part.Light->GetMainMemoryBytes();
      part.Light->AddToReport(report);
    }
    else if (part.IsAsked)
    {
      report.LeftOut.emplace_back(
        part.Name, part.Waits ? WhyItWaits : "its computation had an error");
    }
  }
  this->AddRefinementToReport(report);
  report.EstimatedError = this->EstimatedError.value_or(-1.0);
  if (report.EstimatedError >= 0.0)
  {
    report.Modelled.emplace_back("estimated error",
      "path tracing at " + std::to_string(this->ErrorProbe.GetNumberOfPixels()) + " pixels, " +
        (this->Plan.AskedBounces > 0 ? std::to_string(this->Plan.AskedBounces) : "all") +
        " bounces");
  }
  if (this->LampsAreReplaceable)
  {
    report.Modelled.emplace_back("balance of the preset's light",
      vtkIndirectReport::Number(this->Balance.Replaced, 3) +
        " of the diffuse light of lights without shadows is replaced, by light of strength " +
        vtkIndirectReport::Number(this->Balance.Strength, 3) +
        ": the most with which the picture is as bright as VTK's and no channel clips");
  }
  this->DepthMaps.AddToReport(report);
  this->Levels.AddToReport(report);
  if (this->IsInWindow())
  {
    this->Frame.Window->MakeCurrent();
    report.ReadGL();
  }
}
