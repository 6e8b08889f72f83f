// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkRadianceHintsPass.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Frame/vtkIndirectEyeUniforms.h"
#include "Frame/vtkIndirectPlan.h"
#include "Frame/vtkIndirectReport.h"
#include "Frame/vtkIndirectStageTimer.h"
#include "OpenGL/vtkIndirectPointProgram.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "RadianceHints/vtkIndirectHintFields.h"
#include "RadianceHints/vtkIndirectHintGrid.h"
#include "RadianceHints/vtkIndirectHintRegions.h"
#include "RadianceHints/vtkIndirectHintSenders.h"
#include "VirtualLights/vtkIndirectVirtualLights.h"
#include "Visibility/vtkIndirectOccupancyVolume.h"
#include "Visibility/vtkIndirectVisibility.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkRadianceHintsPass);

namespace
{
const vtkIndirectChannel NoChannel = { nullptr, nullptr, nullptr, 0, nullptr, nullptr };
const vtkIndirectChannel IrradianceChannels[] = {
  { "irradiance", "vtkiIrradiance", "indirect irradiance where a cell of pixels is mixed",
    GL_RGBA32F, "-", "VTK irradiance" },
  NoChannel,
};
const vtkIndirectChannel CoarseChannels[] = {
  { "hints.coarse", "vtkiCoarse", "irradiance at every InterpolationStep-th pixel, kind of cell",
    GL_RGBA32F, "-", "VTK irradiance" },
  NoChannel,
};
}

//------------------------------------------------------------------------------
struct vtkRadianceHintsPass::Internals
{
  vtkIndirectHintDetails Details;
  vtkIndirectHintGrid Grid;
  vtkIndirectHintGrid::Settings GridSettings;
  vtkIndirectHintFields Fields;
  vtkIndirectHintFields::Settings Settings; // of the last frame
  vtkIndirectTarget Coarse[2] = { vtkIndirectTarget(CoarseChannels, false),
    vtkIndirectTarget(CoarseChannels, false) };
  int CoarseNow = 0;
  bool CoarseValid = false;
  int StillFrames = 0;   // since something changed
  bool Converged = true; // the last look-up kept nothing of those before it
  int Step = 1; // of the last look-up: its buffers stay readable when InterpolationStep changes
  vtkIndirectFullScreenProgram LookUpKernel{ "vtkIndirectHintFS.glsl" };
  vtkIndirectPointProgram MixedCells{ "vtkIndirectHintCellVS.glsl", "vtkIndirectHintMixedFS.glsl" };
  vtkIndirectPointProgram Pixels{ "vtkIndirectHintCellVS.glsl", "vtkIndirectHintPixelFS.glsl" };
  vtkNew<vtkIndirectHintSenders> Senders;
  std::vector<double> LightKey;
  bool NothingReflects = false;  // bounces after the first have no surface
  double Tolerance = 0.0;        // that the last frame was asked for and the grid was chosen by
  long long NumberOfUpdates = 0; // of the hints' light, since construction
  size_t VoxelUpdates = 0;       // that the grid was made from

  // step: between samples
  std::string GetLookupDefinitions(int step) const
  {
    return vtkIndirectHintFields::GetLookupDefinitions(
             this->Settings, this->Grid.GetNumberOfGrids()) +
      "#define VTKI_STEP " + std::to_string(step) + "\n";
  }

  // Binds receivers and hints.
  void ActivateLookup(vtkShaderProgram* program, const vtkIndirectEstimateInput& input)
  {
    vtkIndirectSetEyeUniforms(program, input.Frame);
    program->SetUniform2i("vtkiSize", input.Frame.Size);
    input.Geometry.GetTarget().Activate(vtkIndirectGeometryBuffer::Surface, program);
    this->Fields.ActivateLookup(input, this->Settings, this->Grid, program);
  }
  void DeactivateLookup(const vtkIndirectEstimateInput& input)
  {
    input.Geometry.GetTarget().Deactivate();
    this->Fields.Deactivate(input, this->Grid);
  }
};

vtkRadianceHintsPass::vtkRadianceHintsPass()
  : Internal(new Internals)
{
  this->Occupancy = true;
  // With depth, which marks the pixels that interpolation has left.
  this->Irradiance = std::make_unique<vtkIndirectTarget>(IrradianceChannels, true, 16);
}

vtkRadianceHintsPass::~vtkRadianceHintsPass() = default;

//------------------------------------------------------------------------------
void vtkRadianceHintsPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const SettingsType& set = this->Settings;
  os << indent << "Preset: " << (set.Preset == PAPER ? "Paper" : "Robust") << "\n";
  os << indent << "Order: " << set.Order << "\n";
  os << indent << "Extent: " << (set.Extent == SCENE ? "Scene" : "View") << "\n";
  os << indent << "GridResolution: " << set.GridResolution[0] << " " << set.GridResolution[1] << " "
     << set.GridResolution[2] << "\n";
  os << indent << "NumberOfGrids: " << set.NumberOfGrids << "\n";
  os << indent << "FineGridExtent: " << set.FineGridExtent << "\n";
  os << indent << "NumberOfSamples: " << set.NumberOfSamples << "\n";
  os << indent << "DepthOcclusion: " << (set.DepthOcclusion ? "On" : "Off") << "\n";
  os << indent << "InterpolationStep: " << set.InterpolationStep << "\n";
  os << indent << "TemporalSmoothing: " << set.TemporalSmoothing << "\n";
  this->Internal->Coarse[this->Internal->CoarseNow].Print(os, indent);
}

//------------------------------------------------------------------------------
void vtkRadianceHintsPass::SetPreset(int preset)
{
  preset = preset == PAPER ? PAPER : ROBUST;
  if (preset != this->Settings.Preset)
  {
    this->Settings.Preset = preset;
    this->Internal->Details =
      preset == PAPER ? vtkIndirectHintDetails::OfPaper() : vtkIndirectHintDetails();
    this->SetOccupancy(preset == ROBUST);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const vtkIndirectHintDetails& vtkRadianceHintsPass::GetDetails() const
{
  return this->Internal->Details;
}

//------------------------------------------------------------------------------
void vtkRadianceHintsPass::SetDetails(const vtkIndirectHintDetails& details)
{
  this->Internal->Details = details;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRadianceHintsPass::SetGridResolution(int x, int y, int z)
{
  const int wanted[3] = { x, y, z };
  for (int axis = 0; axis < 3; ++axis)
  {
    const int hints = std::clamp(wanted[axis], 0, vtkIndirectHintRegions::MaximumResolution);
    if (hints != this->Settings.GridResolution[axis])
    {
      this->Settings.GridResolution[axis] = hints;
      this->Modified();
    }
  }
}

//------------------------------------------------------------------------------
double vtkRadianceHintsPass::FindErrorTolerance(double asked) const
{
  const int* hints = this->Settings.GridResolution;
  if (hints[0] > 0 && hints[1] > 0 && hints[2] > 0)
  {
    return 0.0;
  }
  return asked > 0.0 ? std::clamp(asked, 0.002, 1.0) : 0.05;
}

//------------------------------------------------------------------------------
int vtkRadianceHintsPass::GetNumberOfHints() const
{
  return this->Internal->Grid.GetNumberOfHints();
}

//------------------------------------------------------------------------------
int vtkRadianceHintsPass::GetNumberOfActiveHints() const
{
  return this->Internal->Grid.GetNumberOfActiveHints();
}

//------------------------------------------------------------------------------
size_t vtkRadianceHintsPass::GetBytes() const
{
  const Internals& in = *this->Internal;
  const size_t bytes = this->Superclass::GetBytes() + in.Grid.GetBytes() + in.Fields.GetBytes() +
    in.Coarse[0].GetBytes() + in.Coarse[1].GetBytes();
  return bytes;
}

//------------------------------------------------------------------------------
size_t vtkRadianceHintsPass::GetMainMemoryBytes() const
{
  return this->Superclass::GetMainMemoryBytes() + this->Internal->Grid.GetMainMemoryBytes();
}

//------------------------------------------------------------------------------
vtkVirtualLightSampler* vtkRadianceHintsPass::ChooseSampler(
  vtkVirtualLightSampler*, const vtkIndirectPlan& plan)
{
  Internals& in = *this->Internal;
  in.Senders->SetBlocksPerEdge(in.Details.BlocksPerEdge);
  return !in.Details.Dense && plan.Senders == vtkIndirectPlan::MAPS ? nullptr : in.Senders.Get();
}

//------------------------------------------------------------------------------
bool vtkRadianceHintsPass::ReadsMaps() const
{
  return !this->Internal->Details.Dense;
}

//------------------------------------------------------------------------------
vtkIndirectVisibilityNeeds vtkRadianceHintsPass::GetVisibilityNeeds(
  const vtkIndirectPlan& plan) const
{
  const vtkIndirectHintDetails& details = this->Internal->Details;
  vtkIndirectVisibilityNeeds needs;
  needs.Senders = plan.Visibility == vtkIndirectVisibilityVoxels;
  needs.Volume = details.SkipEmptyCells || plan.NumberOfBounces > 1;
  needs.Surfaces =
    needs.Senders || (plan.NumberOfBounces > 1 && (!details.FromHints || details.AlbedoVolume));
  needs.Resolution = this->OccupancyResolution;
  return needs;
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkRadianceHintsPass::Estimate(const Input& input)
{
  Internals& in = *this->Internal;
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunc(state);
  vtkIndirectFullScreenState fullScreenState(window);

  if (!input.Lights)
  {
    in.Senders->ReleaseGraphicsResources(window);
  }
  input.Timer.Begin(vtkIndirectStageTimer::Visibility);
  const int hints = in.Grid.GetNumberOfHints();
  const bool placed = this->UpdateGeometry(input);
  input.Timer.End(vtkIndirectStageTimer::Visibility);
  if (!placed || !this->UpdateLight(input, hints == 0) || !this->LookUp(input))
  {
    return {};
  }
  vtkIndirectEstimate result = this->MakeResult();
  result.State = in.Converged ? vtkIndirectEstimate::CONVERGED : vtkIndirectEstimate::REFINING;
  const vtkIndirectTarget& coarse = in.Coarse[in.CoarseNow];
  result.Irradiance = in.Step > 1 ? result.Irradiance : &coarse;
  result.Coarse = in.Step > 1 ? &coarse : nullptr;
  result.Step = in.Step;
  return result;
}

//------------------------------------------------------------------------------
bool vtkRadianceHintsPass::UpdateGeometry(const Input& input)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  const vtkIndirectVisibilityNeeds needs = this->GetVisibilityNeeds(input.Plan);

  vtkIndirectHintGrid::Settings settings;
  vtkIndirectHintRegions regions;
  regions.OfView = this->Settings.Extent == VIEW;
  std::copy_n(this->Settings.GridResolution, 3, &regions.Resolution.x);
  regions.Tolerance = this->FindErrorTolerance(input.Plan.ErrorTolerance);
  in.Tolerance = input.Plan.ErrorTolerance > 0.0 ? regions.Tolerance : 0.0;
  regions.HasFine = this->Settings.NumberOfGrids > 1;
  regions.FineExtent = this->Settings.FineGridExtent;
  settings.Regions = regions.Find(frame);
  settings.Masks = needs.Senders;
  settings.SkipEmpty = in.Details.SkipEmptyCells;
  settings.Reach = in.Details.NumberOfLookups > 1 ? 1.5 * std::sqrt(3.0) : 1.0;
  settings.NumberOfRays = needs.Surfaces ? in.Details.NumberOfRays : 0;

  if (input.Plan.Caching && settings == in.GridSettings && in.Grid.GetNumberOfHints() > 0 &&
    in.VoxelUpdates == input.Visibility.GetNumberOfUpdates())
  {
    return true;
  }
  in.Grid.Release(frame.Window);
  in.Grid.Clear();
  in.LightKey.clear();
  const int longestEdge = vtkTextureObject::GetMaximumTextureSize(frame.Window);
  std::string why = vtkIndirectHintGrid::FindObstacle(settings, longestEdge);
  if (why.empty())
  {
    in.GridSettings = settings;
    in.VoxelUpdates = input.Visibility.GetNumberOfUpdates();
    in.Grid.Build(settings, needs.Senders || needs.Volume ? &input.Visibility.GetVolume() : nullptr,
      &input.Visibility.GetSurfaces());
    why = in.Grid.FindObstacle(longestEdge);
  }
  if (!why.empty())
  {
    in.Grid.Clear();
    vtkErrorMacro(<< why << " Lower GridResolution or NumberOfGrids.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRadianceHintsPass::UpdateLight(const Input& input, bool anew)
{
  Internals& in = *this->Internal;
  vtkIndirectHintFields::Settings& settings = in.Settings;
  static_cast<vtkIndirectHintDetails&>(settings) = in.Details;
  settings.Layout = this->Settings.Order == 2 ? 0 : (in.Details.LumaChroma ? 1 : 2);
  settings.Bounces = input.Plan.NumberOfBounces;
  settings.NumberOfSamples = this->Settings.NumberOfSamples;
  settings.Visibility = input.Visibility.HidesSenders();
  settings.DepthOcclusion = this->Settings.DepthOcclusion;

  std::vector<double> key = { static_cast<double>(this->GetMTime()),
    static_cast<double>(settings.Bounces), static_cast<double>(input.Plan.Senders),
    static_cast<double>(
      input.Lights ? input.Lights->GetContentTime() : input.Maps.GetContentTime()) };
  if (settings.DepthOcclusion)
  {
    const vtkIndirectFrame& frame = input.Frame;
    key.insert(key.end(), &frame.WorldToView[0][0], &frame.WorldToView[0][0] + 16);
    key.insert(key.end(), &frame.Projection[0][0], &frame.Projection[0][0] + 16);
  }
  if (!anew && input.Plan.Caching && key == in.LightKey)
  {
    return true;
  }
  in.LightKey.clear();
  if (!in.Fields.Fill(input, settings, in.Grid))
  {
    return false;
  }
  in.NothingReflects = settings.Bounces > 1 && input.Visibility.GetVolume().IsEmpty();
  ++in.NumberOfUpdates;
  in.LightKey = key;
  return true;
}

//------------------------------------------------------------------------------
bool vtkRadianceHintsPass::LookUp(const Input& input)
{
  vtkIndirectStageTimer& timer = input.Timer;
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  const int step = this->Settings.InterpolationStep;
  const int width = (frame.Size[0] + 2 * step - 2) / step;
  const int height = (frame.Size[1] + 2 * step - 2) / step;
  const bool smooth = this->Settings.TemporalSmoothing > 0.0;
  const bool kept = in.CoarseValid && in.Coarse[in.CoarseNow].GetWidth() == width &&
    in.Coarse[in.CoarseNow].GetHeight() == height;
  const int next = smooth ? 1 - in.CoarseNow : 0;
  in.StillFrames = input.Still ? in.StillFrames + 1 : 0;
  // What is left of a difference, after as many frames and the one that brought it, is less than
  // can be seen: then look-ups come to rest.
  constexpr double least = 1.0 / 4096.0;
  const bool mix = smooth && kept &&
    (in.StillFrames == 0 || std::pow(this->Settings.TemporalSmoothing, in.StillFrames) > least);
  in.Converged = !mix;
  const std::string definitions = in.GetLookupDefinitions(step);
  in.LookUpKernel.SetDefinitions(definitions + (mix ? "#define VTKI_KEEP\n" : ""));
  if (!in.Coarse[next].Resize(frame.Window, width, height))
  {
    return false;
  }
  vtkShaderProgram* program = in.LookUpKernel.Use(frame.Window, in.Coarse[next]);
  if (!program)
  {
    return false;
  }

  in.Step = step;
  timer.Begin(vtkIndirectStageTimer::Estimate);
  in.Coarse[next].Begin();
  in.ActivateLookup(program, input);
  if (mix)
  {
    program->SetUniformf("vtkiKeep", static_cast<float>(this->Settings.TemporalSmoothing));
    in.Coarse[in.CoarseNow].Activate(0, program, "vtkiLast");
  }
  in.LookUpKernel.Draw();
  if (mix)
  {
    in.Coarse[in.CoarseNow].Deactivate();
  }
  in.DeactivateLookup(input);
  in.Coarse[next].End();
  timer.End(vtkIndirectStageTimer::Estimate);
  in.CoarseNow = next;
  in.CoarseValid = smooth;
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
bool vtkRadianceHintsPass::FillMixedCells(const Input& input)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  vtkIndirectTarget& coarse = in.Coarse[in.CoarseNow];
  const int cells = coarse.GetWidth() * coarse.GetHeight();
  const int step = this->Settings.InterpolationStep;
  const std::string definitions = in.GetLookupDefinitions(step);
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
  for (vtkIndirectPointProgram* points : { &in.MixedCells, &in.Pixels })
  {
    // The second draws the pixels that the first has discarded: where depth is still that of the
    // clear.
    vtkShaderProgram* program = points->Use(frame.Window, definitions);
    drawn = program != nullptr;
    if (!drawn)
    {
      break;
    }
    in.ActivateLookup(program, input);
    coarse.Activate(0, program);
    const int size[2] = { coarse.GetWidth(), coarse.GetHeight() };
    program->SetUniform2i("vtkiCoarseSize", size);
    points->Draw(cells, step);
    coarse.Deactivate();
    in.DeactivateLookup(input);
  }
  state->vtkglDisable(GL_DEPTH_TEST);
  this->Irradiance->End();
  return drawn;
}

//------------------------------------------------------------------------------
void vtkRadianceHintsPass::AddToReport(vtkIndirectReport& report) const
{
  const Internals& in = *this->Internal;
  report.Counters["hint_updates"] = in.NumberOfUpdates;
  std::string grid = std::to_string(this->GetNumberOfActiveHints()) + " of " +
    std::to_string(this->GetNumberOfHints()) + " hints of order " +
    std::to_string(this->Settings.Order);
  for (const auto& region : in.GridSettings.Regions)
  {
    grid += (&region == &in.GridSettings.Regions[0] ? ", " : " and ") +
      std::to_string(region.Size.x) + " x " + std::to_string(region.Size.y) + " x " +
      std::to_string(region.Size.z);
  }
  report.Modelled.emplace_back(std::to_string(in.Settings.Bounces) +
      (in.Settings.Bounces == 1 ? " diffuse bounce" : " diffuse bounces"),
    grid);
  if (in.Tolerance > 0.0)
  {
    report.LeftOut.emplace_back("ErrorTolerance " + vtkIndirectReport::Number(in.Tolerance),
      "the grid is chosen for light from a quarter of its edge; nearer light is interpolated with "
      "a "
      "larger error, which is not estimated");
  }
  if (in.NothingReflects)
  {
    report.LeftOut.emplace_back(
      "bounces after the first", "nothing in the scene has polygons that reflect them");
  }
}

//------------------------------------------------------------------------------
std::vector<vtkRadianceHintsPass::Hint> vtkRadianceHintsPass::ReadHints()
{
  Internals& in = *this->Internal;
  std::vector<Hint> hints(in.Grid.GetHints().size());
  const std::vector<std::vector<float>> channels = in.Fields.ReadBack();
  const int layout = in.Fields.GetLayout();
  if (channels.empty() || layout == 1)
  {
    vtkErrorMacro("Hints can be read after a frame, of order 2, or of order 3 in RGB.");
    return {};
  }
  for (size_t i = 0; i < hints.size(); ++i)
  {
    const glm::vec4& place = in.Grid.GetHints()[i];
    hints[i].Active = place.w > 0.0f;
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
void vtkRadianceHintsPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!this->CanBeOf(window))
  {
    return;
  }
  this->Superclass::ReleaseGraphicsResources(window);
  Internals& in = *this->Internal;
  // Voxels of another pass have the same numbers.
  in.Grid.Release(window);
  in.Grid.Clear();
  in.Fields.Release(window);
  in.LightKey.clear();
  in.Coarse[0].Release(window);
  in.Coarse[1].Release(window);
  in.CoarseValid = false;
  in.Senders->ReleaseGraphicsResources(window);
  in.LookUpKernel.Release();
  in.MixedCells.Release();
  in.Pixels.Release();
}
