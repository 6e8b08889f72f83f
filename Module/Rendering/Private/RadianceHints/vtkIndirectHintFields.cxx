// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "RadianceHints/vtkIndirectHintFields.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Maps/vtkIndirectLightMaps.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Plan/vtkIndirectStageTimer.h"
#include "RadianceHints/vtkIndirectHintGrid.h"
#include "Scene/vtkIndirectFrame.h"
#include "Senders/vtkIndirectVirtualLights.h"
#include "Visibility/vtkIndirectOccupancyVolume.h"
#include "Visibility/vtkIndirectVisibility.h"
#include "vtkOpenGLFramebufferObject.h"

#include <algorithm>
#include <string>

namespace
{
#define VTKI_FIELD(i)                                                                              \
  {                                                                                                \
    "hints.field" #i, "vtkiField" #i, "spherical harmonics of incoming radiance", GL_RGBA32F,      \
      "scene", "radiance"                                                                          \
  }
const vtkIndirectChannel DistanceChannel = { "hints.distance", "vtkiHintDistance",
  "nearest and farthest sender, share of senders that face the hint", GL_RGBA32F, "-",
  "BounceRange" };
const vtkIndirectChannels ThreeFields = { VTKI_FIELD(0), VTKI_FIELD(1), VTKI_FIELD(2),
  DistanceChannel };
const vtkIndirectChannels SevenFields = { VTKI_FIELD(0), VTKI_FIELD(1), VTKI_FIELD(2),
  VTKI_FIELD(3), VTKI_FIELD(4), VTKI_FIELD(5), VTKI_FIELD(6), DistanceChannel };
#undef VTKI_FIELD

const vtkIndirectChannels RadiosityChannels = {
  { "hints.radiosity", "vtkiRadiosity", "what surfaces reflect", GL_RGBA32F, "-", "VTK radiance" },
};

// Least area of a sender over that of a face of the hint's cell. A sender of area A is softened
// over sqrt(A / 2 pi): here a fifth of a cell's edge, less than a hint's distance from its own
// wall.
constexpr double SofteningShare = 0.25;

std::string Define(const std::string& name, int value)
{
  return "#define " + name + " " + std::to_string(value) + "\n";
}

// Returns the common definitions of stages with fields; grids: their number.
std::string GetDefinitions(int layout, bool occupancy, int grids)
{
  return Define("VTKI_HINT_LAYOUT", layout) + Define("VTKI_GRIDS", grids) +
    (occupancy ? "#define VTKI_HINT_OCCUPANCY\n" : "");
}
}

//------------------------------------------------------------------------------
std::string vtkIndirectHintFields::GetLookupDefinitions(const Settings& settings, int grids)
{
  return GetDefinitions(settings.Layout, settings.Visibility, grids) +
    Define("VTKI_LOOKUPS", settings.NumberOfLookups) +
    Define("VTKI_LOOKUP_ROTATION", settings.LookupRotation) +
    Define("VTKI_LOBES", settings.Deringing) + Define("VTKI_FACING", settings.FacingWeights);
}

//------------------------------------------------------------------------------
vtkIndirectHintFields::vtkIndirectHintFields(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Radiosity(this, RadiosityChannels, false)
  , DenseKernel(this, "vtkIndirectHintDenseFS.glsl")
  , SampledKernel(this, "vtkIndirectHintSampledFS.glsl")
  , CopyKernel(this, "vtkIndirectHintCopyFS.glsl")
  , RadiosityKernel(this, "vtkIndirectHintRadiosityFS.glsl")
  , SurfacesKernel(this, "vtkIndirectHintSurfacesFS.glsl")
  , ExchangeKernel(this, "vtkIndirectHintExchangeFS.glsl")
{
}

vtkIndirectHintFields::~vtkIndirectHintFields() = default;

//------------------------------------------------------------------------------
bool vtkIndirectHintFields::Resize(const Input& input, const Settings& settings, int rows)
{
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  if (settings.Layout != this->Layout)
  {
    for (auto& field : this->Fields)
    {
      field = std::make_unique<vtkIndirectTarget>(
        this, settings.Layout == 2 ? SevenFields : ThreeFields, false);
    }
    this->Layout = settings.Layout;
  }
  const int fields = settings.Bounces == 1 ? 1 : (settings.FromHints ? 3 : 2);
  for (int i = 0; i < 3; ++i)
  {
    if (i >= fields)
    {
      this->Fields[i]->Release(window);
    }
    else if (!this->Fields[i]->Resize(window, vtkIndirectHintGrid::RowLength, rows))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectHintFields::Fill(
  const Input& input, const Settings& settings, vtkIndirectHintGrid& grid)
{
  vtkIndirectStageTimer& timer = input.Timer;
  if (!this->Resize(input, settings, grid.GetNumberOfRows()))
  {
    return false;
  }
  timer.Begin(vtkIndirectStageTimer::Inject);
  const bool injected = this->Inject(input, settings, grid);
  timer.End(vtkIndirectStageTimer::Inject);
  if (!injected)
  {
    return false;
  }
  this->Current = 0;
  timer.Begin(vtkIndirectStageTimer::Bounces);
  bool bounced = true;
  for (int bounce = 2;
       bounce <= settings.Bounces && bounced && !input.Visibility.GetVolume().IsEmpty(); ++bounce)
  {
    bounced = this->Bounce(input, settings, grid);
  }
  timer.End(vtkIndirectStageTimer::Bounces);
  return bounced;
}

//------------------------------------------------------------------------------
bool vtkIndirectHintFields::Inject(
  const Input& input, const Settings& settings, vtkIndirectHintGrid& grid)
{
  const vtkIndirectFrame& frame = input.Frame;
  // The paper's method samples the maps anew for each hint.
  const bool list = input.Lights != nullptr;
  vtkIndirectFullScreenProgram& kernel = list ? this->DenseKernel : this->SampledKernel;
  kernel.SetDefinitions(GetDefinitions(this->Layout, settings.Visibility, grid.GetNumberOfGrids()) +
    (list ? input.Lights->GetDefinitions() : ""));
  return kernel.Run(frame.Window, *this->Fields[0],
    [&](const vtkIndirectProgram& program)
    {
      grid.Activate(frame.Window, program);
      if (settings.Visibility)
      {
        grid.ActivateRays(frame.Window, program);
        grid.ActivateSurfels(frame.Window, program);
      }
      if (list)
      {
        input.Lights->Activate(program);
      }
      else
      {
        input.Maps.Activate(program);
        const int layers = input.Maps.GetNumberOfLayers();
        program->SetUniformi("vtkiLayerCount", layers);
        program->SetUniformi(
          "vtkiSampleCount", std::max(1, (settings.NumberOfSamples + layers - 1) / layers));
        program->SetUniformf("vtkiCoverage", static_cast<float>(settings.MapCoverage));
      }
      program->SetUniformf("vtkiRange", static_cast<float>(settings.BounceRange));
      program->SetUniformf(
        "vtkiSoftening", settings.Softening ? static_cast<float>(SofteningShare) : 0.0f);
      program->SetUniformi("vtkiDepthSamples", settings.NumberOfDepthSamples);
      program->SetUniformf("vtkiDepthFactor", static_cast<float>(settings.DepthAttenuation));
      input.Geometry.GetTarget().Activate(vtkIndirectGeometryBuffer::Surface, program);
      const glm::dmat4 sceneToView = glm::inverse(frame.ViewToScene);
      const glm::dmat4 unscale(glm::dvec4(1.0 / frame.SceneScale, 0.0, 0.0, 0.0),
        glm::dvec4(0.0, 1.0 / frame.SceneScale, 0.0, 0.0),
        glm::dvec4(0.0, 0.0, 1.0 / frame.SceneScale, 0.0), glm::dvec4(0.0, 0.0, 0.0, 1.0));
      vtkIndirectSetUniform(program, "vtkiSceneToView", glm::mat4(sceneToView));
      vtkIndirectSetUniform(
        program, "vtkiSceneToClip", glm::mat4(frame.Projection * unscale * sceneToView));
    });
}

//------------------------------------------------------------------------------
bool vtkIndirectHintFields::Reflect(
  const Input& input, const Settings& settings, vtkIndirectHintGrid& grid, const float albedo[4])
{
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  this->RadiosityKernel.SetDefinitions(GetLookupDefinitions(settings, grid.GetNumberOfGrids()));
  if (!this->Radiosity.Resize(window, vtkIndirectHintGrid::RowLength, grid.GetNumberOfSurfelRows()))
  {
    return false;
  }
  return this->RadiosityKernel.Run(window, this->Radiosity,
    [&](const vtkIndirectProgram& program)
    {
      this->ActivateLookup(input, settings, grid, program);
      grid.ActivateSurfels(window, program);
      program->SetUniform4f("vtkiMeanAlbedo", albedo);
    });
}

//------------------------------------------------------------------------------
bool vtkIndirectHintFields::Bounce(
  const Input& input, const Settings& settings, vtkIndirectHintGrid& grid)
{
  const vtkIndirectOccupancyVolume& volume = input.Visibility.GetVolume();
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  const glm::dvec3& mean = volume.GetMeanAlbedo();
  const float albedo[4] = { static_cast<float>(mean.x), static_cast<float>(mean.y),
    static_cast<float>(mean.z), settings.AlbedoVolume ? 0.0f : 1.0f };
  if (!settings.FromHints && !this->Reflect(input, settings, grid, albedo))
  {
    return false;
  }

  // L^k = L^1 + T L^(k-1)
  const int next = settings.FromHints && this->Current == 1 ? 2 : 1;
  this->CopyKernel.SetDefinitions(GetDefinitions(this->Layout, false, grid.GetNumberOfGrids()));
  const bool copied = this->CopyKernel.Run(window, *this->Fields[next],
    [&](const vtkIndirectProgram& program) { this->ActivateField(0, program); });

  vtkIndirectFullScreenProgram& kernel =
    settings.FromHints ? this->ExchangeKernel : this->SurfacesKernel;
  kernel.SetDefinitions(GetDefinitions(
    this->Layout, settings.FromHints && settings.Visibility, grid.GetNumberOfGrids()));
  const vtkIndirectAddition addition(window);
  const bool bounced = copied &&
    kernel.Run(window, *this->Fields[next],
      [&](const vtkIndirectProgram& program)
      {
        grid.Activate(window, program);
        if (settings.FromHints)
        {
          this->ActivateField(this->Current, program);
          if (settings.AlbedoVolume)
          {
            grid.ActivateAlbedo(window, program);
          }
          if (settings.Visibility)
          {
            volume.Activate(window, program);
          }
          program->SetUniform4f("vtkiMeanAlbedo", albedo);
          program->SetUniformi("vtkiSampleCount", settings.NumberOfBounceSamples);
          program->SetUniformf("vtkiRange", static_cast<float>(settings.BounceRange));
          program->SetUniformi("vtkiLobes", settings.Deringing ? 1 : 0);
        }
        else
        {
          grid.ActivateRays(window, program);
          this->Radiosity.Activate(0, program);
        }
      });
  this->Current = bounced ? next : this->Current;
  return bounced;
}

//------------------------------------------------------------------------------
void vtkIndirectHintFields::ActivateField(int field, const vtkIndirectProgram& program)
{
  for (int i = 0; i <= (this->Layout == 2 ? 7 : 3); ++i)
  {
    this->Fields[field]->Activate(i, program);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectHintFields::ActivateLookup(const Input& input, const Settings& settings,
  vtkIndirectHintGrid& grid, const vtkIndirectProgram& program)
{
  grid.Activate(input.Frame.Window, program);
  this->ActivateField(this->Current, program);
  if (settings.Visibility)
  {
    input.Visibility.GetVolume().Activate(input.Frame.Window, program);
    grid.ActivateMasks(input.Frame.Window, program);
  }
}

//------------------------------------------------------------------------------
std::vector<std::vector<float>> vtkIndirectHintFields::ReadBack() const
{
  std::vector<std::vector<float>> channels;
  if (this->Layout >= 0 && this->Fields[this->Current]->GetWidth() > 0)
  {
    for (int i = 0; i < (this->Layout == 2 ? 7 : 3); ++i)
    {
      channels.push_back(this->Fields[this->Current]->ReadBack(i));
    }
  }
  return channels;
}
