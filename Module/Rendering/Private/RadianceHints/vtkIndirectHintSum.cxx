// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "RadianceHints/vtkIndirectHintSum.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Maps/vtkIndirectLightMaps.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Plan/vtkIndirectReport.h"
#include "Plan/vtkIndirectSettingList.h"
#include "Plan/vtkIndirectStageTimer.h"
#include "RadianceHints/vtkIndirectHintRegions.h"
#include "Senders/vtkIndirectVirtualLights.h"
#include "Visibility/vtkIndirectOccupancyVolume.h"
#include "Visibility/vtkIndirectVisibility.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace
{
const vtkIndirectChannels IrradianceChannels = {
  { "irradiance", "vtkiIrradiance", "indirect irradiance where a cell of pixels is mixed",
    GL_RGBA32F, "-", "VTK irradiance" },
};
const vtkIndirectChannels CoarseChannels = {
  { "hints.coarse", "vtkiCoarse", "irradiance at every InterpolationStep-th pixel, kind of cell",
    GL_RGBA32F, "-", "VTK irradiance" },
};

// Counts the props whose bounds are shorter along every axis than the longest edge of a cell.
int CountSmallProps(const vtkIndirectFrame& frame, const vtkIndirectHintGrid::Region& region)
{
  const glm::dvec3 cell = region.GetCell();
  const double longest = std::max({ cell.x, cell.y, cell.z });
  return static_cast<int>(std::count_if(frame.Casters.begin(), frame.Casters.end(),
    [&](const vtkIndirectCaster& caster)
    {
      const glm::dvec3 edges = frame.ToScene(vtkIndirectFrame::GetCorner(caster.Bounds, 7)) -
        frame.ToScene(vtkIndirectFrame::GetCorner(caster.Bounds, 0));
      return std::max({ edges.x, edges.y, edges.z }) < longest;
    }));
}
}

//------------------------------------------------------------------------------
vtkIndirectHintSum::vtkIndirectHintSum(vtkRadianceHintsPass& pass)
  : vtkIndirectSum(pass)
  , Set(pass)
  , Coarse{ { this, CoarseChannels }, { this, CoarseChannels } }
  , Senders(std::make_shared<vtkIndirectHintSenders>(&pass))
{
  // With depth, which marks the pixels that interpolation has left.
  this->Irradiance = std::make_unique<vtkIndirectTarget>(this, IrradianceChannels, true, 16);
}

//------------------------------------------------------------------------------
void vtkIndirectHintSum::AddSettings(
  vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const
{
  using Choice = vtkIndirectSettingList::Choice;
  const auto& set = this->Set.Settings;
  std::array<int, 3> hints = { set.GridResolution[0], set.GridResolution[1],
    set.GridResolution[2] };
  if (plan && !this->GridSettings.Regions.empty())
  {
    const auto& size = this->GridSettings.Regions.front().Size;
    hints = { size.x, size.y, size.z };
  }
  this->vtkIndirectSum::AddSettings(list, plan);
  list.Add("Order", set.Order)
    .Add("Extent", Choice{ set.Extent == vtkRadianceHintsPass::SCENE ? "Scene" : "View" })
    .Add("GridResolution", hints)
    .Add("NumberOfGrids", set.NumberOfGrids)
    .Add("FineGridExtent", set.FineGridExtent)
    .Add("NumberOfSamples", set.NumberOfSamples)
    .Add("MapCoverage", set.MapCoverage)
    .Add("NumberOfBounceSamples", set.NumberOfBounceSamples)
    .Add("BounceRange", set.BounceRange)
    .Add("LookupRotation", set.LookupRotation)
    .Add("DepthOcclusion", set.DepthOcclusion)
    .Add("NumberOfDepthSamples", set.NumberOfDepthSamples)
    .Add("DepthAttenuation", set.DepthAttenuation)
    .Add("InterpolationStep", set.InterpolationStep)
    .Add("TemporalSmoothing", set.TemporalSmoothing);
}

//------------------------------------------------------------------------------
vtkIndirectAbilities vtkIndirectHintSum::GetAbilities(double tolerance) const
{
  vtkIndirectAbilities abilities = this->vtkIndirectSum::GetAbilities(tolerance);
  abilities.MaximumNumberOfBounces = 16;
  abilities.TakesSampler = false;
  abilities.AutomaticVisibility = vtkIndirectVisibilityVoxels;
  abilities.ReadsMaps = !this->Set.Details->Dense;
  abilities.ErrorTolerance = this->FindErrorTolerance(tolerance);
  return abilities;
}

//------------------------------------------------------------------------------
// step: pixels between samples
std::string vtkIndirectHintSum::GetLookupDefinitions(int step) const
{
  return vtkIndirectHintFields::GetLookupDefinitions(
           this->FieldSettings, this->Grid.GetNumberOfGrids()) +
    vtkIndirectReceiverGrid::DefineStep(step);
}

//------------------------------------------------------------------------------
// Binds receivers and hints.
void vtkIndirectHintSum::ActivateLookup(const vtkIndirectProgram& program, const Input& input)
{
  input.Geometry.ActivateReceivers(program, input.Frame);
  this->Fields.ActivateLookup(input, this->FieldSettings, this->Grid, program);
}

//------------------------------------------------------------------------------
double vtkIndirectHintSum::FindErrorTolerance(double asked) const
{
  const int* hints = this->Set.Settings.GridResolution;
  if (hints[0] > 0 && hints[1] > 0 && hints[2] > 0)
  {
    return 0.0;
  }
  return asked > 0.0 ? std::clamp(asked, 0.002, 1.0) : 0.05;
}

//------------------------------------------------------------------------------
vtkIndirectSampler::Pointer vtkIndirectHintSum::ChooseSampler(
  const vtkIndirectSampler::Pointer&, const vtkIndirectPlan& plan)
{
  this->Senders->SetBlocksPerEdge(this->Set.Details->BlocksPerEdge);
  return !this->Set.Details->Dense && plan.Senders == vtkIndirectPlan::MAPS ? nullptr
                                                                            : this->Senders;
}

//------------------------------------------------------------------------------
vtkIndirectVisibilityNeeds vtkIndirectHintSum::GetVisibilityNeeds(const vtkIndirectPlan& plan) const
{
  const vtkIndirectHintDetails& details = *this->Set.Details;
  vtkIndirectVisibilityNeeds needs = this->vtkIndirectSum::GetVisibilityNeeds(plan);
  needs.Segments = false; // the grid's own tables say which hints see each other
  needs.Volume = details.SkipEmptyCells || plan.NumberOfBounces > 1;
  needs.Surfaces =
    needs.Senders || (plan.NumberOfBounces > 1 && (!details.FromHints || details.AlbedoVolume));
  return needs;
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkIndirectHintSum::Estimate(const Input& input)
{
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  vtkIndirectFullScreenState fullScreenState(window);

  if (!input.Lights)
  {
    this->Senders->Release(window);
  }
  input.Timer.Begin(vtkIndirectStageTimer::Visibility);
  const int hints = this->Grid.GetNumberOfHints();
  const bool placed = this->UpdateGeometry(input);
  input.Timer.End(vtkIndirectStageTimer::Visibility);
  if (!placed || !this->UpdateLight(input, hints == 0) || !this->LookUp(input))
  {
    return {};
  }
  vtkIndirectEstimate result = this->MakeResult();
  result.State = this->Converged ? vtkIndirectEstimate::CONVERGED : vtkIndirectEstimate::REFINING;
  vtkIndirectReceiverGrid& coarse = this->Coarse[this->CoarseNow];
  vtkIndirectContribution& irradiance = result.Contributions.front();
  const bool interpolated = coarse.GetStep() > 1;
  irradiance.Target = interpolated ? irradiance.Target : &coarse;
  irradiance.Coarse = interpolated ? &coarse : nullptr;
  return result;
}

//------------------------------------------------------------------------------
bool vtkIndirectHintSum::UpdateGeometry(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  const vtkIndirectVisibilityNeeds needs = this->GetVisibilityNeeds(input.Plan);

  vtkIndirectHintGrid::Settings settings;
  vtkIndirectHintRegions regions;
  regions.OfView = this->Set.Settings.Extent == vtkRadianceHintsPass::VIEW;
  std::copy_n(this->Set.Settings.GridResolution, 3, &regions.Resolution.x);
  regions.Tolerance = input.Plan.EstimatorErrorTolerance;
  this->Tolerance = input.Plan.ErrorToleranceIsSet ? regions.Tolerance : 0.0;
  regions.HasFine = this->Set.Settings.NumberOfGrids > 1;
  regions.FineExtent = this->Set.Settings.FineGridExtent;
  settings.Regions = regions.Find(frame);
  this->NumberOfSmallProps = CountSmallProps(frame, settings.Regions.back());
  settings.Masks = needs.Senders;
  settings.SkipEmpty = this->Set.Details->SkipEmptyCells;
  settings.Reach = this->Set.Details->NumberOfLookups > 1 ? 1.5 * std::sqrt(3.0) : 1.0;
  settings.NumberOfRays = needs.Surfaces ? this->Set.Details->NumberOfRays : 0;

  if (input.Plan.Caching && settings == this->GridSettings && this->Grid.GetNumberOfHints() > 0 &&
    this->VoxelUpdates == input.Visibility.GetNumberOfUpdates())
  {
    return true;
  }
  this->Grid.Release(frame.Window);
  this->Grid.Clear();
  this->LightKey.Clear();
  const int longestEdge = vtkTextureObject::GetMaximumTextureSize(frame.Window);
  std::string why = vtkIndirectHintGrid::FindObstacle(settings, longestEdge);
  if (why.empty())
  {
    this->GridSettings = settings;
    this->VoxelUpdates = input.Visibility.GetNumberOfUpdates();
    this->Grid.Build(settings,
      needs.Senders || needs.Volume ? &input.Visibility.GetVolume() : nullptr,
      &input.Visibility.GetSurfaces());
    why = this->Grid.FindObstacle(longestEdge);
  }
  if (!why.empty())
  {
    this->Grid.Clear();
    vtkErrorWithObjectMacro(&this->Pass, << why << " Lower GridResolution or NumberOfGrids.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectHintSum::UpdateLight(const Input& input, bool anew)
{
  vtkIndirectHintFields::Settings& settings = this->FieldSettings;
  static_cast<vtkIndirectHintDetails&>(settings) = *this->Set.Details;
  settings.Layout = this->Set.Settings.Order == 2 ? 0 : (this->Set.Details->LumaChroma ? 1 : 2);
  settings.Bounces = input.Plan.NumberOfBounces;
  settings.Visibility = input.Visibility.HidesSenders();
  settings.NumberOfSamples = this->Set.Settings.NumberOfSamples;
  settings.MapCoverage = this->Set.Settings.MapCoverage;
  settings.NumberOfBounceSamples = this->Set.Settings.NumberOfBounceSamples;
  settings.BounceRange = this->Set.Settings.BounceRange;
  settings.LookupRotation = this->Set.Settings.LookupRotation;
  settings.NumberOfDepthSamples =
    this->Set.Settings.DepthOcclusion ? this->Set.Settings.NumberOfDepthSamples : 0;
  settings.DepthAttenuation = this->Set.Settings.DepthAttenuation;

  vtkIndirectKey key;
  key.Add("estimator", this->Set.GetMTime()).Add("bounces", settings.Bounces);
  key.Add("senders", input.Plan.Senders);
  key.Add("senders", input.Lights ? input.Lights->GetContentTime() : input.Maps.GetContentTime());
  if (settings.NumberOfDepthSamples > 0)
  {
    key.Add("eye", input.Frame.WorldToView).Add("eye", input.Frame.Projection);
  }
  if (!anew && input.Plan.Caching && key == this->LightKey)
  {
    return true;
  }
  this->LightKey.Clear();
  if (!this->Fields.Fill(input, settings, this->Grid))
  {
    return false;
  }
  this->NothingReflects = settings.Bounces > 1 && input.Visibility.GetVolume().IsEmpty();
  ++this->NumberOfUpdates;
  this->LightKey = key;
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectHintSum::LookUp(const Input& input)
{
  vtkIndirectStageTimer& timer = input.Timer;
  const vtkIndirectFrame& frame = input.Frame;
  const int step = this->Set.Settings.InterpolationStep;
  const bool smooth = this->Set.Settings.TemporalSmoothing > 0.0;
  const int next = smooth ? 1 - this->CoarseNow : 0;
  if (!this->Coarse[next].Resize(frame, step))
  {
    return false;
  }
  const vtkIndirectTarget& last = this->Coarse[this->CoarseNow];
  const bool kept = this->CoarseValid && last.GetWidth() == this->Coarse[next].GetWidth() &&
    last.GetHeight() == this->Coarse[next].GetHeight();
  this->StillFrames = input.Still ? this->StillFrames + 1 : 0;
  // After as many frames and the one that brought a difference less is left of it than can be seen:
  // then look-ups come to rest.
  constexpr double least = 1.0 / 4096.0;
  const bool mix = smooth && kept &&
    (this->StillFrames == 0 ||
      std::pow(this->Set.Settings.TemporalSmoothing, this->StillFrames) > least);
  this->Converged = !mix;
  const std::string definitions = this->GetLookupDefinitions(step);
  this->LookUpKernel.SetDefinitions(definitions + (mix ? "#define VTKI_KEEP\n" : ""));
  timer.Begin(vtkIndirectStageTimer::Estimate);
  const bool drawn = this->LookUpKernel.Run(frame.Window, this->Coarse[next],
    [&](const vtkIndirectProgram& program)
    {
      this->ActivateLookup(program, input);
      if (mix)
      {
        program->SetUniformf("vtkiKeep", static_cast<float>(this->Set.Settings.TemporalSmoothing));
        this->Coarse[this->CoarseNow].Activate(0, program, "vtkiLast");
      }
    });
  timer.End(vtkIndirectStageTimer::Estimate);
  if (!drawn)
  {
    return false;
  }
  this->CoarseNow = next;
  this->CoarseValid = smooth;
  if (step == 1)
  {
    return true;
  }
  timer.Begin(vtkIndirectStageTimer::Upsample);
  const bool filled = this->FillMixedCells(input);
  timer.End(vtkIndirectStageTimer::Upsample);
  return filled;
}

//------------------------------------------------------------------------------
bool vtkIndirectHintSum::FillMixedCells(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  vtkIndirectReceiverGrid& coarse = this->Coarse[this->CoarseNow];
  const int cells = coarse.GetWidth() * coarse.GetHeight();
  const int step = coarse.GetStep();
  const std::string definitions = this->GetLookupDefinitions(step);
  if (!this->Irradiance->Resize(frame.Window, frame.Size[0], frame.Size[1]))
  {
    return false;
  }
  this->Irradiance->Begin();
  // Other cells' pixels are never read.
  this->Irradiance->ClearDepth();
  vtkOpenGLState* state = frame.Window->GetState();
  state->vtkglViewport(0, 0, coarse.GetWidth() * step, coarse.GetHeight() * step);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LESS);
  bool drawn = false;
  for (vtkIndirectPointProgram* points : { &this->MixedCells, &this->Pixels })
  {
    // The second draws the pixels that the first has discarded: where depth is still that of the
    // clear.
    vtkIndirectProgram program = points->Use(frame.Window, definitions);
    drawn = program != nullptr;
    if (!drawn)
    {
      break;
    }
    this->ActivateLookup(program, input);
    coarse.ActivateAll(program);
    points->Draw(cells, step);
  }
  state->vtkglDisable(GL_DEPTH_TEST);
  this->Irradiance->End();
  return drawn;
}

//------------------------------------------------------------------------------
void vtkIndirectHintSum::AddToReport(vtkIndirectReport& report) const
{
  report.Counters["hint_updates"] = this->NumberOfUpdates;
  std::string grid = std::to_string(this->Grid.GetNumberOfActiveHints()) + " of " +
    std::to_string(this->Grid.GetNumberOfHints()) + " hints of order " +
    std::to_string(this->Set.Settings.Order);
  for (const auto& region : this->GridSettings.Regions)
  {
    grid += (&region == &this->GridSettings.Regions[0] ? ", " : " and ") +
      std::to_string(region.Size.x) + " x " + std::to_string(region.Size.y) + " x " +
      std::to_string(region.Size.z);
  }
  report.Modelled.emplace_back(std::to_string(this->FieldSettings.Bounces) +
      (this->FieldSettings.Bounces == 1 ? " diffuse bounce" : " diffuse bounces"),
    grid);
  if (this->Tolerance > 0.0)
  {
    report.LeftOut.emplace_back("ErrorTolerance " + vtkIndirectReport::Number(this->Tolerance),
      "the grid is chosen for light from a quarter of its edge; nearer light is interpolated with "
      "a "
      "larger error, which is not estimated");
  }
  if (this->NumberOfSmallProps > 0)
  {
    report.LeftOut.emplace_back("light of props smaller than a cell of the grid",
      std::to_string(this->NumberOfSmallProps) +
        (this->NumberOfSmallProps == 1 ? " prop is" : " props are") +
        "; light from them and on them is too dark");
  }
  if (this->NothingReflects)
  {
    report.LeftOut.emplace_back(
      "bounces after the first", "nothing in the scene has polygons that reflect them");
  }
}

//------------------------------------------------------------------------------
std::vector<vtkIndirectHintSum::Hint> vtkIndirectHintSum::ReadHints()
{
  std::vector<Hint> hints(this->Grid.GetHints().size());
  const std::vector<std::vector<float>> channels = this->Fields.ReadBack();
  const int layout = this->Fields.GetLayout();
  if (channels.empty() || layout == 1)
  {
    vtkErrorWithObjectMacro(
      &this->Pass, "Hints can be read after a frame, of order 2, or of order 3 in RGB.");
    return {};
  }
  for (size_t i = 0; i < hints.size(); ++i)
  {
    const glm::vec4& place = this->Grid.GetHints()[i];
    std::copy(&place.x, &place.x + 3, hints[i].Position);
    for (int color = 0; color < 3; ++color)
    {
      for (int k = 0; k < 4; ++k)
      {
        hints[i].Coefficients.push_back(channels[color][4 * i + k]);
      }
      for (int k = 0; k < 4 && layout == 2; ++k)
      {
        hints[i].Coefficients.push_back(channels[3 + color][4 * i + k]);
      }
      if (layout == 2)
      {
        hints[i].Coefficients.push_back(channels[6][4 * i + color]);
      }
    }
  }
  return hints;
}

//------------------------------------------------------------------------------
void vtkIndirectHintSum::ReleaseOwn(vtkWindow* window)
{
  // Voxels of another pass have the same numbers.
  this->Grid.Clear();
  this->LightKey.Clear();
  this->CoarseValid = false;
  this->Senders->Release(window);
}
