// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkIndirectLighting.h"

#include "Plan/vtkIndirectReport.h"
#include "Scene/vtkIndirectFrame.h"
#include "Scene/vtkIndirectInformationKeys.h"
#include "Scene/vtkIndirectMaterial.h"
#include "Scene/vtkIndirectPropKind.h"
#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkDataSet.h"
#include "vtkEnvironmentLight.h"
#include "vtkImageData.h"
#include "vtkIndirectSettings.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
// Size of the sky's image: a pixel is 2.8 degrees, while a lobe's radiance is halved within 33.
constexpr int Columns = 128;
constexpr int Rows = 64;

const char* const Titles[] = { "Scene", "Soft", "Full", "Gentle", "Studio" };
const char* const Names[] = { "scene", "soft", "full", "gentle", "studio" };

// Returns the camera's axes in world coordinates, rounded, without scaling and shear: right, up, to
// the viewer. Returns the world's axes if the camera has none.
glm::dmat3 FindAxes(vtkCamera* camera)
{
  const glm::dmat3 axes =
    glm::transpose(glm::dmat3(vtkIndirectFrame::ToGLM(camera->GetModelViewTransformMatrix())));
  const glm::dvec3 up = glm::normalize(axes[1]);
  const glm::dvec3 right = glm::normalize(axes[0] - glm::dot(axes[0], up) * up);
  const glm::dvec3 back = glm::cross(right, up);
  const auto round = vtkIndirectFrame::RoundDirection;
  return std::isfinite(glm::dot(back, back)) ? glm::dmat3(round(right), round(up), round(back))
                                             : glm::dmat3(1.0);
}

bool HasColorsOfData(vtkMapper* mapper)
{
  int ofCells = 0;
  vtkDataSet* data = vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0));
  return mapper->GetScalarVisibility() &&
    (!data ||
      vtkAbstractMapper::GetScalars(data, mapper->GetScalarMode(), mapper->GetArrayAccessMode(),
        mapper->GetArrayId(), mapper->GetArrayName(), ofCells));
}

std::string Count(size_t count, const std::string& thing)
{
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}
}

//------------------------------------------------------------------------------
vtkIndirectLighting::vtkIndirectLighting()
  : Preset(vtkIndirectLightingScene)
{
}

vtkIndirectLighting::~vtkIndirectLighting() = default;

//------------------------------------------------------------------------------
const char* vtkIndirectLighting::GetTitle(int preset)
{
  return Titles[preset];
}

//------------------------------------------------------------------------------
vtkLightCollection* vtkIndirectLighting::GetLights() const
{
  return this->Preset == vtkIndirectLightingScene || this->Inactive ? nullptr : this->Lights.Get();
}

//------------------------------------------------------------------------------
void vtkIndirectLighting::Update(
  vtkRenderer* renderer, const vtkIndirectSettings& settings, vtkEnvironmentLight* users)
{
  this->Preset = settings.Lighting;
  // Without a sky most of a preset would be dark.
  this->Inactive = settings.IndirectScale == 0.0;
  this->Environment = users;
  if (!this->GetLights())
  {
    return;
  }
  this->NumberOfReplaced = 0;
  vtkCollectionSimpleIterator it;
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    this->NumberOfReplaced += light->GetSwitch() ? 1 : 0;
  }
  this->SetRig(settings.Lighting, CollectLamps(renderer), FindAlbedo(renderer), !users);
  this->Turn(renderer);
  if (!users)
  {
    this->Environment = this->Sky;
  }
}

//------------------------------------------------------------------------------
// Collects the renderer's lamps. The list is empty unless all lights that are on are directional
// and follow the camera.
std::vector<vtkIndirectDistantLight> vtkIndirectLighting::CollectLamps(vtkRenderer* renderer)
{
  std::vector<vtkIndirectDistantLight> lamps;
  vtkCollectionSimpleIterator it;
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    if (light->GetPositional() || light->LightTypeIsSceneLight())
    {
      return {};
    }
    vtkIndirectDistantLight lamp;
    const double* color = light->GetDiffuseColor();
    lamp.Color = light->GetIntensity() * glm::dvec3(color[0], color[1], color[2]);
    if (light->LightTypeIsCameraLight())
    {
      // The light is given in the camera's own axes; the camera looks along -z.
      const double* p = light->GetPosition();
      const double* f = light->GetFocalPoint();
      const glm::dvec3 direction(p[0] - f[0], p[1] - f[1], p[2] - f[2]);
      const double length = glm::length(direction);
      lamp.Direction = length > 0.0 ? direction / length : lamp.Direction;
    }
    // Negative light cannot be in a sky.
    if (glm::all(glm::greaterThanEqual(lamp.Color, glm::dvec3(0.0))) &&
      lamp.Color != glm::dvec3(0.0))
    {
      lamps.push_back(lamp);
    }
  }
  return lamps;
}

//------------------------------------------------------------------------------
// Finds the albedo of the brightest channel of actors of one colour. Data and textures have many
// colours, which together reflect less than the brightest one.
vtkIndirectPresetAlbedo vtkIndirectLighting::FindAlbedo(vtkRenderer* renderer)
{
  vtkIndirectPresetAlbedo albedo;
  vtkCollectionSimpleIterator it;
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    vtkMapper* mapper = actor->GetMapper();
    vtkProperty* property = actor->GetProperty();
    if (!actor->GetVisibility() || !mapper || !property->GetLighting() ||
      vtkIndirectPropKind::CatchesLight(actor))
    {
      continue;
    }
    if (actor->GetTexture() || property->GetNumberOfTextures() > 0 || HasColorsOfData(mapper))
    {
      albedo.OfData = true;
      continue;
    }
    const glm::dvec3 color = vtkIndirectMaterial::FindPlain(actor);
    albedo.Brightest = std::max({ albedo.Brightest, color.x, color.y, color.z });
  }
  return albedo;
}

//------------------------------------------------------------------------------
void vtkIndirectLighting::SetRig(int preset, const std::vector<vtkIndirectDistantLight>& lamps,
  const vtkIndirectPresetAlbedo& albedo, bool hasOwnSky)
{
  vtkIndirectKey key;
  key.Add("preset", preset).Add("own sky", hasOwnSky);
  key.Add("albedo", albedo.Brightest).Add("albedo", albedo.OfData);
  for (const vtkIndirectDistantLight& lamp : lamps)
  {
    key.Add("lights", lamp.Direction).Add("lights", lamp.Color);
  }
  if (!this->PresetLightsKey.Take(std::move(key)))
  {
    return;
  }
  this->PresetLights = vtkIndirectPresetLights::Make(preset, lamps, albedo, hasOwnSky);

  // The image is laid out for vtkEnvironmentLight: the middle is ahead, which is -z; the bottom row
  // is first.
  vtkNew<vtkImageData> image;
  image->SetDimensions(Columns, Rows, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  auto* pixel = static_cast<float*>(image->GetScalarPointer());
  for (int j = 0; j < Rows; ++j)
  {
    const double latitude = vtkMath::Pi() * ((j + 0.5) / Rows - 0.5);
    for (int i = 0; i < Columns; ++i)
    {
      const double longitude = 2.0 * vtkMath::Pi() * ((i + 0.5) / Columns - 0.5);
      const glm::dvec3 radiance =
        this->PresetLights.GetRadiance({ std::cos(latitude) * std::sin(longitude),
          std::sin(latitude), -std::cos(latitude) * std::cos(longitude) });
      for (int c = 0; c < 3; ++c)
      {
        *pixel++ = static_cast<float>(radiance[c]);
      }
    }
  }
  this->Sky->SetImage(image);

  this->Lights->RemoveAllItems();
  this->Directions.clear();
  if (this->PresetLights.Key.Color != glm::dvec3(0.0))
  {
    this->AddLight(this->PresetLights.Key, false);
  }
  for (const vtkIndirectDistantLight& fill : this->PresetLights.Fills)
  {
    this->AddLight(fill, true);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectLighting::AddLight(const vtkIndirectDistantLight& lamp, bool fill)
{
  vtkNew<vtkLight> light;
  light->SetColor(lamp.Color.x, lamp.Color.y, lamp.Color.z);
  if (lamp.Direction == glm::dvec3(0.0, 0.0, 1.0))
  {
    light->SetLightTypeToHeadlight();
  }
  else
  {
    light->SetLightTypeToSceneLight();
  }
  vtkIndirectInformationKeys::Set(light, vtkIndirectInformationKeys::LightFill(),
    fill ? 1.0 : 1.0 - this->PresetLights.KeyShadow, 1.0);
  light->SetShadowAttenuation(fill ? 0.0 : this->PresetLights.KeyShadow);
  this->Lights->AddItem(light);
  this->Directions.push_back(lamp.Direction);
}

//------------------------------------------------------------------------------
void vtkIndirectLighting::Turn(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const glm::dmat3 axes = FindAxes(camera);
  // Turning does not change a uniform sky.
  if (!this->PresetLights.Lobes.empty())
  {
    this->Sky->SetRight(axes[0].x, axes[0].y, axes[0].z);
    this->Sky->SetUp(axes[1].x, axes[1].y, axes[1].z);
  }
  for (size_t i = 0; i < this->Directions.size(); ++i)
  {
    auto* light = vtkLight::SafeDownCast(this->Lights->GetItemAsObject(static_cast<int>(i)));
    if (light->LightTypeIsHeadlight())
    {
      light->SetPosition(camera->GetPosition());
      light->SetFocalPoint(camera->GetFocalPoint());
      continue;
    }
    const glm::dvec3 direction = axes * this->Directions[i];
    light->SetPosition(direction.x, direction.y, direction.z);
    light->SetFocalPoint(0.0, 0.0, 0.0);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectLighting::AddToReport(vtkIndirectReport& report) const
{
  if (this->Preset == vtkIndirectLightingScene)
  {
    return;
  }
  const std::string name = std::string("lighting ") + Names[this->Preset];
  if (this->Inactive)
  {
    report.LeftOut.emplace_back(
      name, "IndirectScale is 0, so there is no sky: the renderer's lights have its place");
    return;
  }
  std::string what;
  auto add = [&what](const std::string& part) { what += (what.empty() ? "" : ", ") + part; };
  if (this->PresetLights.Key.Color != glm::dvec3(0.0))
  {
    add("a key light with shadows");
  }
  add(Count(this->PresetLights.Fills.size(), "light") + " without shadows");
  if (this->Environment == this->Sky.Get())
  {
    add("a sky of radiance " + vtkIndirectReport::Number(this->PresetLights.Ambient.x, 3) +
      " and " + Count(this->PresetLights.Lobes.size(), "soft light") + ", which follow the camera");
  }
  else
  {
    add("the environment that is set, in place of the preset's sky");
  }
  report.Modelled.emplace_back(name,
    what + ", in place of " + Count(static_cast<size_t>(this->NumberOfReplaced), "light") +
      " of the renderer");
  report.LeftOut.emplace_back(name + ": what hides the lights without shadows",
    "they are as VTK draws them, too bright where they are hidden; nothing is reflected of them");
  report.LeftOut.emplace_back(name + " on what has no surface",
    "translucent props, volumes and annotation keep the renderer's lights");
}
