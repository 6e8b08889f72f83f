// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectGL.h"

#include "vtkRadianceHintsPass.h"

#include "vtkCamera.h"
#include "vtkGeometryBufferPass.h"
#include "vtkIndirectHintGrid.h"
#include "vtkIndirectKernelProgram.h"
#include "vtkIndirectOccupancyVolume.h"
#include "vtkIndirectReport.h"
#include "vtkIndirectStageTimer.h"
#include "vtkIndirectTarget.h"
#include "vtkIndirectUniforms.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkRadianceHintsPass);

namespace
{
#define VTKI_FIELD(i)                                                                              \
  { "hints.field" #i, "vtkiField" #i, "spherical harmonics of incoming radiance", GL_RGBA32F,      \
    "scene", "radiance" }
const vtkIndirectChannel DistanceChannel = { "hints.distance", "vtkiHintDistance",
  "nearest and farthest sender, share of senders that face the hint", GL_RGBA32F, "-",
  "BounceRange" };
const vtkIndirectChannel NoChannel = { nullptr, nullptr, nullptr, 0, nullptr, nullptr };
const vtkIndirectChannel ThreeFields[] = { VTKI_FIELD(0), VTKI_FIELD(1), VTKI_FIELD(2),
  DistanceChannel, NoChannel };
const vtkIndirectChannel SevenFields[] = { VTKI_FIELD(0), VTKI_FIELD(1), VTKI_FIELD(2),
  VTKI_FIELD(3), VTKI_FIELD(4), VTKI_FIELD(5), VTKI_FIELD(6), DistanceChannel, NoChannel };
#undef VTKI_FIELD

const vtkIndirectChannel SenderChannels[] = {
  { "hints.senders.position", "vtkiLightPosition", "place and area of a block of a map", GL_RGBA32F,
    "scene", "scene units" },
  { "hints.senders.normal", "vtkiLightNormal", "normal", GL_RGBA32F, "scene", "1" },
  { "hints.senders.density", "vtkiLightDensity", "reflected density times area", GL_RGBA32F, "-",
    "VTK flux" },
  NoChannel,
};
const vtkIndirectChannel RadiosityChannels[] = {
  { "hints.radiosity", "vtkiRadiosity", "what surfaces reflect", GL_RGBA32F, "-", "VTK radiance" },
  NoChannel,
};
const vtkIndirectChannel IrradianceChannels[] = {
  { "irradiance", "vtkiIrradiance", "indirect irradiance", GL_RGBA32F, "-", "VTK irradiance" },
  NoChannel,
};
const vtkIndirectChannel CoarseChannels[] = {
  { "hints.coarse", "vtkiCoarse", "irradiance at every InterpolationStep-th pixel", GL_RGBA32F, "-",
    "VTK irradiance" },
  NoChannel,
};

constexpr int SenderRowLength = 256;
// Texels of a block that are read, along its edge: more change its sums by less than its share of
// the map's noise.
constexpr int ReadsPerBlockEdge = 8;
// Least area of a sender over that of a face of the hint's cell. A sender of area A is softened over
// sqrt(A / 2 pi): a fifth of a cell's edge for this, less than a hint's distance from its own wall.
constexpr double SofteningShare = 0.25;

enum Kernel
{
  SendersKernel,
  DenseKernel,
  SampledKernel,
  CopyKernel,
  RadiosityKernel,
  SurfacesKernel,
  ExchangeKernel,
  CoarseKernel,
  UpsampleKernel,
  NumberOfKernels
};
const char* const KernelFiles[NumberOfKernels] = { "vtkIndirectHintSendersFS.glsl",
  "vtkIndirectHintDenseFS.glsl", "vtkIndirectHintSampledFS.glsl", "vtkIndirectHintCopyFS.glsl",
  "vtkIndirectHintRadiosityFS.glsl", "vtkIndirectHintSurfacesFS.glsl",
  "vtkIndirectHintExchangeFS.glsl", "vtkIndirectHintFS.glsl", "vtkIndirectHintUpsampleFS.glsl" };
}

//------------------------------------------------------------------------------
struct vtkRadianceHintsPass::Internals
{
  vtkIndirectOccupancyVolume Volume;
  vtkIndirectHintGrid Grid;
  vtkIndirectHintGrid::Settings GridSettings;
  // Fields by layout: the first bounce, all bounces, and the one before while bounces are computed.
  std::unique_ptr<vtkIndirectTarget> Fields[3];
  int FieldLayout = -1;
  int Current = 0; // which of them is looked up
  vtkIndirectTarget Senders{ SenderChannels, false };
  vtkIndirectTarget Radiosity{ RadiosityChannels, false };
  vtkIndirectTarget Coarse[2] = { vtkIndirectTarget(CoarseChannels, false),
    vtkIndirectTarget(CoarseChannels, false) };
  int CoarseNow = 0;
  bool CoarseValid = false;
  std::unique_ptr<vtkIndirectKernelProgram> Kernels[NumberOfKernels];
  vtkNew<vtkUniformLightSampler> HeadlightSampler;
  std::vector<double> LightKey;
  int Bounces = 1; // of the last frame
  bool Blocked = false;

  Internals()
  {
    for (int i = 0; i < NumberOfKernels; ++i)
    {
      this->Kernels[i] = std::make_unique<vtkIndirectKernelProgram>(KernelFiles[i]);
    }
    this->HeadlightSampler->SetNumberOfLights(1024);
  }

  vtkShaderProgram* Use(
    int kernel, vtkOpenGLRenderWindow* window, int layout, bool occupancy = false)
  {
    this->Kernels[kernel]->SetDefinitions("#define VTKI_HINT_LAYOUT " + std::to_string(layout) +
      "\n" + (occupancy ? "#define VTKI_HINT_OCCUPANCY\n" : ""));
    return this->Kernels[kernel]->Use(window);
  }
  void ActivateField(int field, vtkShaderProgram* program)
  {
    for (int i = 0; i <= (this->FieldLayout == 2 ? 7 : 3); ++i)
    {
      this->Fields[field]->Activate(i, program);
    }
  }
  void ActivateLookup(
    const Input& input, const vtkRadianceHintsPass* self, vtkShaderProgram* program)
  {
    this->Grid.Activate(input.Frame.Window, program);
    this->ActivateField(this->Current, program);
    if (this->Blocked)
    {
      this->Volume.Activate(input.Frame.Window, program);
      this->Grid.ActivateMasks(input.Frame.Window, program);
    }
    program->SetUniformi("vtkiLookupCount", self->NumberOfLookups);
    program->SetUniformi("vtkiLookupRotation", self->LookupRotation ? 1 : 0);
    program->SetUniformi("vtkiLobes", self->Deringing ? 1 : 0);
    program->SetUniformi("vtkiFacing", self->FacingWeights ? 1 : 0);
  }
  void Deactivate()
  {
    this->Grid.Deactivate();
    this->Volume.Deactivate();
    for (const auto& field : this->Fields)
    {
      if (field && field->GetWidth() > 0)
      {
        field->Deactivate();
      }
    }
  }
};

vtkRadianceHintsPass::vtkRadianceHintsPass()
  : Internal(new Internals)
{
  // With depth, which tells the pixels that interpolation has left.
  this->Irradiance = std::make_unique<vtkIndirectTarget>(IrradianceChannels, true);
}

vtkRadianceHintsPass::~vtkRadianceHintsPass() = default;

//------------------------------------------------------------------------------
void vtkRadianceHintsPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  auto flag = [](bool on) { return on ? "On" : "Off"; };
  os << indent << "Order: " << this->Order << "\n";
  os << indent << "ColorLayout: " << (this->ColorLayout == RGB ? "RGB" : "LumaChroma") << "\n";
  os << indent << "Extent: " << (this->Extent == SCENE ? "Scene" : "View") << "\n";
  os << indent << "GridResolution: " << this->GridResolution[0] << " " << this->GridResolution[1]
     << " " << this->GridResolution[2] << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "NumberOfGrids: " << this->NumberOfGrids << "\n";
  os << indent << "FineGridExtent: " << this->FineGridExtent << "\n";
  os << indent << "Sampling: " << (this->Sampling == DENSE ? "Dense" : "Sampled") << "\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "Coverage: " << this->Coverage << "\n";
  os << indent << "BlocksPerEdge: " << this->BlocksPerEdge << "\n";
  os << indent << "Softening: " << flag(this->Softening) << "\n";
  os << indent << "Deringing: " << flag(this->Deringing) << "\n";
  os << indent << "FacingWeights: " << flag(this->FacingWeights) << "\n";
  os << indent << "Occupancy: " << flag(this->Occupancy) << "\n";
  os << indent << "OccupancyResolution: " << this->OccupancyResolution << "\n";
  os << indent << "SkipEmptyCells: " << flag(this->SkipEmptyCells) << "\n";
  os << indent << "AlbedoVolume: " << flag(this->AlbedoVolume) << "\n";
  os << indent << "BounceSampling: " << (this->BounceSampling == HINTS ? "Hints" : "Surfaces")
     << "\n";
  os << indent << "NumberOfRays: " << this->NumberOfRays << "\n";
  os << indent << "NumberOfBounceSamples: " << this->NumberOfBounceSamples << "\n";
  os << indent << "BounceRange: " << this->BounceRange << "\n";
  os << indent << "NumberOfLookups: " << this->NumberOfLookups << "\n";
  os << indent << "LookupRotation: " << flag(this->LookupRotation) << "\n";
  os << indent << "DepthOcclusion: " << flag(this->DepthOcclusion) << "\n";
  os << indent << "NumberOfDepthSamples: " << this->NumberOfDepthSamples << "\n";
  os << indent << "DepthAttenuation: " << this->DepthAttenuation << "\n";
  os << indent << "InterpolationStep: " << this->InterpolationStep << "\n";
  os << indent << "InterpolationMinimumCosine: " << this->InterpolationMinimumCosine << "\n";
  os << indent << "InterpolationPlaneTolerance: " << this->InterpolationPlaneTolerance << "\n";
  os << indent << "TemporalSmoothing: " << this->TemporalSmoothing << "\n";
  os << indent << "NumberOfHintUpdates: " << this->NumberOfHintUpdates << "\n";
  os << indent << "NumberOfVoxelUpdates: " << this->NumberOfVoxelUpdates << "\n";
}

//------------------------------------------------------------------------------
void vtkRadianceHintsPass::SetToPaper()
{
  this->SetColorLayout(RGB);
  this->SetSampling(SAMPLED);
  this->SetNumberOfSamples(40);
  this->SetSoftening(false);
  this->SetDeringing(false);
  this->SetFacingWeights(false);
  this->SetOccupancy(false);
  this->SetSkipEmptyCells(false);
  this->SetAlbedoVolume(false);
  this->SetBounceSampling(HINTS);
  this->SetNumberOfBounceSamples(32);
  this->SetNumberOfLookups(4);
}

//------------------------------------------------------------------------------
void vtkRadianceHintsPass::SetNumberOfLookups(int lookups)
{
  lookups = lookups < 3 ? 1 : 4;
  if (lookups != this->NumberOfLookups)
  {
    this->NumberOfLookups = lookups;
    this->Modified();
  }
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
int vtkRadianceHintsPass::GetLayout() const
{
  return this->Order == 2 ? 0 : (this->ColorLayout == LUMA_CHROMA ? 1 : 2);
}

//------------------------------------------------------------------------------
size_t vtkRadianceHintsPass::GetBytes() const
{
  Internals& in = *this->Internal;
  size_t bytes = this->Superclass::GetBytes() + in.Volume.GetBytes() + in.Grid.GetBytes() +
    in.Senders.GetBytes() + in.Radiosity.GetBytes() + in.Coarse[0].GetBytes() +
    in.Coarse[1].GetBytes();
  for (const auto& field : in.Fields)
  {
    bytes += field ? field->GetBytes() : 0;
  }
  return bytes;
}

//------------------------------------------------------------------------------
vtkVirtualLightSampler* vtkRadianceHintsPass::ChooseSampler(vtkVirtualLightSampler*)
{
  // Read only where a headlight has no map.
  return this->Internal->HeadlightSampler;
}

//------------------------------------------------------------------------------
bool vtkRadianceHintsPass::Estimate(const Input& input, vtkIndirectStageTimer& timer)
{
  Internals& in = *this->Internal;
  vtkOpenGLState* state = input.Frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunc(state);
  vtkIndirectKernelState kernelState(input.Frame.Window);

  timer.Begin(vtkIndirectStageTimer::Visibility);
  const int hints = in.Grid.GetNumberOfHints();
  this->UpdateGeometry(input);
  timer.End(vtkIndirectStageTimer::Visibility);
  return this->UpdateLight(input, timer, hints == 0) && this->LookUp(input, timer);
}

//------------------------------------------------------------------------------
void vtkRadianceHintsPass::UpdateGeometry(const Input& input)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  const bool raysNeeded = this->Occupancy ||
    (input.NumberOfBounces > 1 && (this->BounceSampling == SURFACES || this->AlbedoVolume));
  const bool voxelsNeeded =
    this->Occupancy || this->SkipEmptyCells || input.NumberOfBounces > 1;

  vtkIndirectHintGrid::Settings settings;
  glm::dvec3 lower;
  glm::dvec3 upper;
  for (int axis = 0; axis < 3; ++axis)
  {
    lower[axis] = (frame.SceneBounds[2 * axis] - frame.SceneCenter[axis]) * frame.SceneScale;
    upper[axis] = (frame.SceneBounds[2 * axis + 1] - frame.SceneCenter[axis]) * frame.SceneScale;
  }
  const glm::dmat4 viewToScene = frame.ViewToScene;
  if (this->Extent == VIEW)
  {
    glm::dvec3 least(INFINITY);
    glm::dvec3 most(-INFINITY);
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec3 ndc(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, 1.0);
      const double depth = corner & 4 ? frame.Far : frame.Near;
      const glm::dvec3 view = frame.RayOrigin * ndc + depth * (frame.RayDirection * ndc);
      const glm::dvec3 place(viewToScene * glm::dvec4(view, 1.0));
      least = glm::min(least, place);
      most = glm::max(most, place);
    }
    least = glm::max(least, lower);
    most = glm::min(most, upper);
    if (glm::all(glm::lessThan(least, most)))
    {
      lower = least;
      upper = most;
    }
  }
  auto fit = [this](const glm::dvec3& extent)
  {
    const int along = static_cast<int>(std::ceil(std::sqrt(12.0 / this->ErrorTolerance)));
    const double longest = std::max({ extent.x, extent.y, extent.z });
    glm::ivec3 size;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double share = longest > 0.0 ? extent[axis] / longest : 1.0;
      size[axis] = this->GridResolution[axis] > 0
        ? std::min(this->GridResolution[axis], 64)
        : std::clamp(static_cast<int>(std::ceil(along * share - 1e-6)), 2, 64);
    }
    return size;
  };
  // A flat scene still has room in front of it.
  const double longest = glm::length(upper - lower);
  const glm::dvec3 room = glm::max(glm::dvec3(0.0), 0.02 * longest - 0.5 * (upper - lower));
  vtkIndirectHintGrid::Region region;
  region.Lower = lower - room;
  region.Upper = upper + room;
  region.Size = fit(region.Upper - region.Lower);
  settings.Regions.push_back(region);
  if (this->NumberOfGrids > 1)
  {
    // Whole cells only, so that small movements of the camera leave the hints where they are.
    vtkIndirectHintGrid::Region fine;
    const glm::dvec3 edge = this->FineGridExtent * (region.Upper - region.Lower);
    fine.Size = region.Size;
    const glm::dvec3 cell = edge / glm::dvec3(fine.Size);
    double focal[3];
    frame.Renderer->GetActiveCamera()->GetFocalPoint(focal);
    const glm::dvec3 center =
      (glm::dvec3(focal[0], focal[1], focal[2]) - frame.SceneCenter) * frame.SceneScale;
    const glm::dvec3 corner =
      glm::clamp(center - 0.5 * edge, region.Lower, region.Upper - edge) - region.Lower;
    // Eight cells at a time: a step of one would make new hints for every small movement.
    fine.Lower = region.Lower + glm::floor(corner / (4.0 * cell) + 0.5) * (4.0 * cell);
    fine.Upper = fine.Lower + edge;
    settings.Regions.push_back(fine);
  }
  settings.Masks = this->Occupancy;
  settings.SkipEmpty = this->SkipEmptyCells;
  settings.Reach = this->NumberOfLookups > 1 ? 1.5 * std::sqrt(3.0) : 1.0;
  settings.NumberOfRays = raysNeeded ? this->NumberOfRays : 0;

  bool changed = !input.Caching || !(settings == in.GridSettings) ||
    in.Grid.GetNumberOfHints() == 0;
  if (voxelsNeeded)
  {
    if (!input.Caching)
    {
      in.Volume.Forget();
    }
    if (in.Volume.Update(frame, this->OccupancyResolution))
    {
      ++this->NumberOfVoxelUpdates;
      changed = true;
    }
  }
  in.Blocked = this->Occupancy && !in.Volume.IsEmpty();
  if (changed)
  {
    in.Grid.Release(frame.Window);
    in.GridSettings = settings;
    in.Grid.Build(settings, voxelsNeeded ? &in.Volume : nullptr);
    in.LightKey.clear();
  }
}

//------------------------------------------------------------------------------
bool vtkRadianceHintsPass::UpdateLight(
  const Input& input, vtkIndirectStageTimer& timer, bool anew)
{
  Internals& in = *this->Internal;
  in.Bounces = std::min(input.NumberOfBounces, this->GetMaximumNumberOfBounces());
  std::vector<double> key = { static_cast<double>(this->GetMTime()),
    static_cast<double>(input.NumberOfBounces), static_cast<double>(input.EyeIsMap),
    static_cast<double>(
      input.EyeIsMap ? input.Sampler->GetContentTime() : input.Maps.GetContentTime()) };
  if (this->DepthOcclusion)
  {
    key.insert(key.end(), &input.Frame.WorldToView[0][0], &input.Frame.WorldToView[0][0] + 16);
    key.insert(key.end(), &input.Frame.Projection[0][0], &input.Frame.Projection[0][0] + 16);
  }
  if (!anew && input.Caching && key == in.LightKey)
  {
    return true;
  }
  in.LightKey.clear();
  const int layout = this->GetLayout();
  if (layout != in.FieldLayout)
  {
    for (auto& field : in.Fields)
    {
      if (field)
      {
        field->Release(input.Frame.Window);
      }
      field =
        std::make_unique<vtkIndirectTarget>(layout == 2 ? SevenFields : ThreeFields, false);
    }
    in.FieldLayout = layout;
  }
  const int rows = in.Grid.GetNumberOfRows();
  const int fields = in.Bounces == 1 ? 1 : (this->BounceSampling == HINTS ? 3 : 2);
  for (int i = 0; i < 3; ++i)
  {
    if (i < fields)
    {
      if (!in.Fields[i]->Resize(input.Frame.Window, vtkIndirectHintGrid::RowLength, rows))
      {
        return false;
      }
    }
    else
    {
      in.Fields[i]->Release(input.Frame.Window);
    }
  }
  timer.Begin(vtkIndirectStageTimer::Inject);
  const bool injected = this->UpdateSenders(input) && this->Inject(input);
  timer.End(vtkIndirectStageTimer::Inject);
  if (!injected)
  {
    return false;
  }
  in.Current = 0;
  timer.Begin(vtkIndirectStageTimer::Bounces);
  bool bounced = true;
  for (int bounce = 2; bounce <= in.Bounces && bounced && !in.Volume.IsEmpty(); ++bounce)
  {
    bounced = this->Bounce(input, bounce);
  }
  timer.End(vtkIndirectStageTimer::Bounces);
  ++this->NumberOfHintUpdates;
  if (bounced)
  {
    in.LightKey = key;
  }
  return bounced;
}

//------------------------------------------------------------------------------
bool vtkRadianceHintsPass::UpdateSenders(const Input& input)
{
  Internals& in = *this->Internal;
  if (input.EyeIsMap || this->Sampling == SAMPLED)
  {
    in.Senders.Release(input.Frame.Window);
    return true;
  }
  const int count = input.Maps.GetNumberOfLayers() * this->BlocksPerEdge * this->BlocksPerEdge;
  const int rows = (count + SenderRowLength - 1) / SenderRowLength;
  vtkShaderProgram* program = in.Use(SendersKernel, input.Frame.Window, 0);
  if (!program || !in.Senders.Resize(input.Frame.Window, SenderRowLength, rows))
  {
    return false;
  }
  in.Senders.Begin();
  input.Maps.Activate(program);
  program->SetUniformi("vtkiBlocks", this->BlocksPerEdge);
  program->SetUniformi("vtkiReads", ReadsPerBlockEdge);
  program->SetUniformi("vtkiRowLength", SenderRowLength);
  program->SetUniformi("vtkiLightCount", count);
  in.Kernels[SendersKernel]->Draw();
  input.Maps.Deactivate();
  in.Senders.End();
  return true;
}

//------------------------------------------------------------------------------
bool vtkRadianceHintsPass::Inject(const Input& input)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  const bool list = input.EyeIsMap || this->Sampling == DENSE;
  const int kernel = list ? DenseKernel : SampledKernel;
  vtkShaderProgram* program = in.Use(kernel, frame.Window, in.FieldLayout, in.Blocked);
  if (!program)
  {
    return false;
  }
  vtkIndirectTarget& senders = input.EyeIsMap ? input.Sampler->GetTarget() : in.Senders;
  in.Fields[0]->Begin();
  in.Grid.Activate(frame.Window, program);
  if (in.Blocked)
  {
    in.Grid.ActivateRays(frame.Window, program);
    in.Grid.ActivateSurfels(frame.Window, program);
  }
  if (list)
  {
    for (int i = 0; i < 3; ++i)
    {
      senders.Activate(i, program);
    }
    program->SetUniformi("vtkiRowLength",
      input.EyeIsMap ? vtkVirtualLightSampler::RowLength : SenderRowLength);
    program->SetUniformi("vtkiLightCount",
      input.EyeIsMap
        ? input.Sampler->GetActualNumberOfLights()
        : input.Maps.GetNumberOfLayers() * this->BlocksPerEdge * this->BlocksPerEdge);
  }
  else
  {
    input.Maps.Activate(program);
    const int layers = input.Maps.GetNumberOfLayers();
    program->SetUniformi("vtkiLayerCount", layers);
    program->SetUniformi("vtkiSampleCount", std::max(1, (this->NumberOfSamples + layers - 1) / layers));
    program->SetUniformf("vtkiCoverage", static_cast<float>(this->Coverage));
  }
  program->SetUniformf("vtkiRange", static_cast<float>(this->BounceRange));
  program->SetUniformf(
    "vtkiSoftening", this->Softening ? static_cast<float>(SofteningShare) : 0.0f);
  program->SetUniformi("vtkiDepthSamples", this->DepthOcclusion ? this->NumberOfDepthSamples : 0);
  program->SetUniformf("vtkiDepthFactor", static_cast<float>(this->DepthAttenuation));
  input.Geometry.GetTarget().Activate(vtkGeometryBufferPass::Surface, program);
  const glm::dmat4 sceneToView = glm::inverse(frame.ViewToScene);
  const glm::dmat4 unscale(glm::dvec4(1.0 / frame.SceneScale, 0.0, 0.0, 0.0),
    glm::dvec4(0.0, 1.0 / frame.SceneScale, 0.0, 0.0),
    glm::dvec4(0.0, 0.0, 1.0 / frame.SceneScale, 0.0), glm::dvec4(0.0, 0.0, 0.0, 1.0));
  vtkIndirectSetUniform(program, "vtkiSceneToView", glm::mat4(sceneToView));
  vtkIndirectSetUniform(
    program, "vtkiSceneToClip", glm::mat4(frame.Projection * unscale * sceneToView));
  in.Kernels[kernel]->Draw();
  input.Geometry.GetTarget().Deactivate();
  if (list)
  {
    senders.Deactivate();
  }
  else
  {
    input.Maps.Deactivate();
  }
  in.Deactivate();
  in.Fields[0]->End();
  return true;
}

//------------------------------------------------------------------------------
bool vtkRadianceHintsPass::Bounce(const Input& input, int)
{
  Internals& in = *this->Internal;
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  const bool exchange = this->BounceSampling == HINTS;
  const glm::dvec3& mean = in.Volume.GetMeanAlbedo();
  const float albedo[4] = { static_cast<float>(mean.x), static_cast<float>(mean.y),
    static_cast<float>(mean.z), this->AlbedoVolume ? 0.0f : 1.0f };
  const int next = exchange ? (in.Current == 1 ? 2 : 1) : 1;
  if (!exchange)
  {
    vtkShaderProgram* program = in.Use(RadiosityKernel, window, in.FieldLayout, in.Blocked);
    if (!program ||
      !in.Radiosity.Resize(
        window, vtkIndirectHintGrid::RowLength, in.Grid.GetNumberOfSurfelRows()))
    {
      return false;
    }
    in.Radiosity.Begin();
    in.ActivateLookup(input, this, program);
    in.Grid.ActivateSurfels(window, program);
    program->SetUniform4f("vtkiMeanAlbedo", albedo);
    in.Kernels[RadiosityKernel]->Draw();
    in.Deactivate();
    in.Radiosity.End();
  }

  vtkShaderProgram* program = in.Use(CopyKernel, window, in.FieldLayout);
  if (!program)
  {
    return false;
  }
  in.Fields[next]->Begin();
  in.Grid.Activate(window, program);
  in.ActivateField(0, program);
  in.Kernels[CopyKernel]->Draw();
  in.Deactivate();

  const int kernel = exchange ? ExchangeKernel : SurfacesKernel;
  program = in.Use(kernel, window, in.FieldLayout, exchange && in.Blocked);
  if (!program)
  {
    in.Fields[next]->End();
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFunc(GL_ONE, GL_ONE);
  in.Grid.Activate(window, program);
  if (exchange)
  {
    in.ActivateField(in.Current, program);
    if (this->AlbedoVolume)
    {
      in.Grid.ActivateAlbedo(window, program);
    }
    if (in.Blocked)
    {
      in.Volume.Activate(window, program);
    }
    program->SetUniform4f("vtkiMeanAlbedo", albedo);
    program->SetUniformi("vtkiSampleCount", this->NumberOfBounceSamples);
    program->SetUniformf("vtkiRange", static_cast<float>(this->BounceRange));
    program->SetUniformi("vtkiLobes", this->Deringing ? 1 : 0);
  }
  else
  {
    in.Grid.ActivateRays(window, program);
    in.Radiosity.Activate(0, program);
  }
  in.Kernels[kernel]->Draw();
  state->vtkglDisable(GL_BLEND);
  in.Deactivate();
  if (!exchange)
  {
    in.Radiosity.Deactivate();
  }
  in.Fields[next]->End();
  in.Current = next;
  return true;
}

//------------------------------------------------------------------------------
bool vtkRadianceHintsPass::LookUp(const Input& input, vtkIndirectStageTimer& timer)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  const int step = this->InterpolationStep;
  const bool interpolate = step > 1;
  const bool smooth = this->TemporalSmoothing > 0.0;
  const int coarse[2] = { (frame.Size[0] + 2 * step - 2) / step,
    (frame.Size[1] + 2 * step - 2) / step };
  const int width = interpolate ? coarse[0] : frame.Size[0];
  const int height = interpolate ? coarse[1] : frame.Size[1];
  const bool kept = in.CoarseValid && in.Coarse[in.CoarseNow].GetWidth() == width &&
    in.Coarse[in.CoarseNow].GetHeight() == height;
  const int next = smooth ? 1 - in.CoarseNow : 0;
  if (!this->Irradiance->Resize(frame.Window, frame.Size[0], frame.Size[1]) ||
    ((interpolate || smooth) && !in.Coarse[next].Resize(frame.Window, width, height)))
  {
    return false;
  }
  auto prepare = [&](vtkShaderProgram* program)
  {
    vtkIndirectSetEyeUniforms(program, frame);
    program->SetUniform2i("vtkiSize", frame.Size);
    program->SetUniformi("vtkiStep", step);
    input.Geometry.GetTarget().Activate(vtkGeometryBufferPass::Surface, program);
    in.ActivateLookup(input, this, program);
  };

  timer.Begin(vtkIndirectStageTimer::Estimate);
  vtkShaderProgram* program = in.Use(CoarseKernel, frame.Window, in.FieldLayout, in.Blocked);
  if (!program)
  {
    return false;
  }
  vtkIndirectTarget& target = interpolate || smooth ? in.Coarse[next] : *this->Irradiance;
  target.Begin();
  prepare(program);
  const bool mix = smooth && kept;
  program->SetUniformf("vtkiKeep", mix ? static_cast<float>(this->TemporalSmoothing) : 0.0f);
  if (mix)
  {
    vtkTextureObject* last = in.Coarse[in.CoarseNow].GetTexture(0);
    last->Activate();
    program->SetUniformi("vtkiLast", last->GetTextureUnit());
  }
  in.Kernels[CoarseKernel]->Draw();
  if (mix)
  {
    in.Coarse[in.CoarseNow].Deactivate();
  }
  input.Geometry.GetTarget().Deactivate();
  in.Deactivate();
  target.End();
  timer.End(vtkIndirectStageTimer::Estimate);
  in.CoarseNow = next;
  in.CoarseValid = smooth;
  if (!interpolate && !smooth)
  {
    return true;
  }

  timer.Begin(vtkIndirectStageTimer::Upsample);
  program = in.Use(UpsampleKernel, frame.Window, 0);
  if (!program)
  {
    return false;
  }
  this->Irradiance->Begin();
  this->Irradiance->Clear();
  vtkOpenGLState* state = frame.Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LESS);
  vtkIndirectSetEyeUniforms(program, frame);
  program->SetUniform2i("vtkiSize", frame.Size);
  program->SetUniformi("vtkiStep", step);
  input.Geometry.GetTarget().Activate(vtkGeometryBufferPass::Surface, program);
  in.Coarse[next].Activate(0, program);
  program->SetUniform2i("vtkiCoarseSize", coarse);
  program->SetUniformf("vtkiMinimumCosine", static_cast<float>(this->InterpolationMinimumCosine));
  program->SetUniformf("vtkiPlaneTolerance", static_cast<float>(this->InterpolationPlaneTolerance));
  in.Kernels[UpsampleKernel]->Draw();
  in.Coarse[next].Deactivate();
  input.Geometry.GetTarget().Deactivate();
  // What is left is as deep as the clear: only there is the same depth less.
  program = in.Use(CoarseKernel, frame.Window, in.FieldLayout, in.Blocked);
  if (program)
  {
    prepare(program);
    program->SetUniformi("vtkiStep", 1);
    program->SetUniformf("vtkiKeep", 0.0f);
    in.Kernels[CoarseKernel]->Draw();
    input.Geometry.GetTarget().Deactivate();
    in.Deactivate();
  }
  state->vtkglDisable(GL_DEPTH_TEST);
  this->Irradiance->End();
  timer.End(vtkIndirectStageTimer::Upsample);
  return true;
}

//------------------------------------------------------------------------------
void vtkRadianceHintsPass::AddToReport(vtkIndirectReport& report) const
{
  const Internals& in = *this->Internal;
  report.VirtualLights = 0;
  const std::string grid = std::to_string(this->GetNumberOfActiveHints()) + " of " +
    std::to_string(this->GetNumberOfHints()) + " hints of order " + std::to_string(this->Order);
  report.Modelled.emplace_back(
    std::to_string(in.Bounces) + (in.Bounces == 1 ? " diffuse bounce" : " diffuse bounces"), grid);
  if (in.Blocked)
  {
    report.Modelled.emplace_back("visibility between sender and receiver",
      std::to_string(in.Volume.GetNumberOfOccupiedVoxels()) + " occupied voxels of " +
        std::to_string(this->OccupancyResolution) + " along the longest edge");
    for (const auto& entry : in.Volume.GetLeftOut())
    {
      report.LeftOut.push_back(entry);
    }
  }
  else
  {
    report.LeftOut.emplace_back("visibility between sender and receiver",
      "Occupancy is off or nothing has polygons; the result is too bright");
  }
  if (in.Bounces > 1 && in.Volume.IsEmpty())
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
  if (in.FieldLayout < 0 || in.FieldLayout == 1 || in.Fields[in.Current]->GetWidth() == 0)
  {
    vtkErrorMacro("Hints can be read after a frame, and of ColorLayout RGB or order 2 only.");
    return {};
  }
  std::vector<std::vector<float>> channels;
  for (int i = 0; i < (in.FieldLayout == 2 ? 7 : 3); ++i)
  {
    channels.push_back(in.Fields[in.Current]->ReadBack(i));
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
      for (int k = 0; k < 4 && in.FieldLayout == 2; ++k)
      {
        hints[i].Coefficients.push_back(channels[3 + color][4 * i + k]);
      }
      if (in.FieldLayout == 2)
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
  this->Superclass::ReleaseGraphicsResources(window);
  Internals& in = *this->Internal;
  in.Volume.Release(window);
  in.Grid.Release(window);
  for (auto& field : in.Fields)
  {
    if (field)
    {
      field->Release(window);
    }
  }
  in.LightKey.clear();
  in.Senders.Release(window);
  in.Radiosity.Release(window);
  in.Coarse[0].Release(window);
  in.Coarse[1].Release(window);
  in.CoarseValid = false;
  in.HeadlightSampler->ReleaseGraphicsResources(window);
  for (const auto& kernel : in.Kernels)
  {
    kernel->Release();
  }
}
