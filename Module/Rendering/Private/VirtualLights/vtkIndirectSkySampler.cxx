// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "VirtualLights/vtkIndirectSkySampler.h"

#include "Capture/vtkSurfaceCapturePass.h"
#include "Frame/vtkIndirectPlan.h"
#include "Frame/vtkIndirectReport.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "vtkEnvironmentLight.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkIndirectSkySampler);

namespace
{
// Along an edge of a map. See Documentation/methods/reflective-shadow-maps.md.
constexpr int TexelsOfMaps = 64;
// Maps of directions without light go when there are more than this.
constexpr size_t MostMaps = 64;

bool AreSame(const vtkIndirectCaster& a, const vtkIndirectCaster& b)
{
  return a.Prop == b.Prop && a.RedrawMTime == b.RedrawMTime && a.SendsLight == b.SendsLight &&
    std::equal(a.Bounds, a.Bounds + 6, b.Bounds);
}

using GroupList = std::vector<vtkIndirectSkyGroups::Group>;

GroupList::iterator Find(GroupList& groups, int number)
{
  return std::find_if(
    groups.begin(), groups.end(), [=](const auto& group) { return group.Number == number; });
}

bool IsLit(const vtkIndirectSkyGroups::Group& group)
{
  return group.Strength != glm::dvec3(0.0);
}
}

//------------------------------------------------------------------------------
vtkIndirectSkySampler::vtkIndirectSkySampler()
{
  this->Maps->SetResolution(TexelsOfMaps);
}

vtkIndirectSkySampler::~vtkIndirectSkySampler() = default;

//------------------------------------------------------------------------------
void vtkIndirectSkySampler::SetNumberOfLightsOf(vtkVirtualLightSampler* sampler)
{
  auto* pattern =
    vtkUniformLightSampler::SafeDownCast(sampler ? sampler->GetViewPattern() : nullptr);
  this->NumberOfLights = vtkIndirectAllTexelsSampler::SafeDownCast(sampler) ? VTK_INT_MAX
    : pattern ? pattern->GetNumberOfLights()
              : 256;
}

//------------------------------------------------------------------------------
// Whether what casts shadows has changed.
bool vtkIndirectSkySampler::UpdateScene(const vtkIndirectFrame& frame)
{
  if (frame.SceneScale == this->SceneScale && frame.SceneCenter == this->SceneCenter &&
    std::equal(frame.Casters.begin(), frame.Casters.end(), this->Casters.begin(),
      this->Casters.end(), AreSame))
  {
    return false;
  }
  this->SceneScale = frame.SceneScale;
  this->SceneCenter = frame.SceneCenter;
  this->Casters = frame.Casters;
  return true;
}

//------------------------------------------------------------------------------
// Directions keep their places while their maps hold, also those whose light has gone: a sky that
// turns redraws nothing. Returns whether directions have come, gone or
// moved, as that of a sun does.
bool vtkIndirectSkySampler::UpdateGroups(
  vtkIndirectSkyProjection& projection, vtkEnvironmentLight* environment, bool anew)
{
  const vtkMTimeType time = environment->GetMTime();
  bool changed = false;
  if (this->Environment != environment || this->EnvironmentTime != time)
  {
    this->Environment = environment;
    this->EnvironmentTime = time;
    ++this->SourceTime;
    GroupList lit = vtkIndirectSkyGroups::Make(projection, environment);
    for (vtkIndirectSkyGroups::Group& group : this->Groups)
    {
      const auto found = Find(lit, group.Number);
      group.Strength = found != lit.end() ? found->Strength : glm::dvec3(0.0);
      if (found != lit.end())
      {
        changed = changed || group.Direction != found->Direction;
        group.Direction = found->Direction;
        lit.erase(found);
      }
    }
    changed = changed || !lit.empty();
    this->Groups.insert(this->Groups.end(), lit.begin(), lit.end());
  }
  if (anew || this->Groups.size() > MostMaps)
  {
    const auto dark = std::remove_if(this->Groups.begin(), this->Groups.end(),
      [](const vtkIndirectSkyGroups::Group& group) { return !IsLit(group); });
    changed = changed || dark != this->Groups.end();
    this->Groups.erase(dark, this->Groups.end());
  }
  return changed;
}

//------------------------------------------------------------------------------
bool vtkIndirectSkySampler::DrawMaps(const vtkIndirectFrame& frame, const vtkIndirectPlan& plan,
  vtkSurfaceCapturePass* capture, vtkIndirectSkyProjection& projection,
  vtkEnvironmentLight* environment)
{
  const bool anew = this->UpdateScene(frame) || !this->MapsAreThere || !plan.Caching;
  if (!this->UpdateGroups(projection, environment, anew) && !anew)
  {
    return true;
  }
  // The same scene under other lights. They are of strength one: what the maps hold does not depend
  // on the sky's radiance.
  vtkIndirectFrame scene = frame;
  vtkIndirectPlan maps;
  maps.Caching = plan.Caching;
  scene.Lights.clear();
  for (const vtkIndirectSkyGroups::Group& group : this->Groups)
  {
    vtkIndirectLight light;
    light.Index = static_cast<int>(scene.Lights.size());
    light.DirectionWC = -group.Direction;
    light.Color = glm::dvec3(1.0);
    maps.MapLights.push_back(light.Index);
    scene.Lights.push_back(light);
  }
  this->MapsAreThere = this->Maps->Update(scene, maps, capture);
  ++this->SourceTime;
  return this->MapsAreThere;
}

//------------------------------------------------------------------------------
// The texels that send light, each once a map.
bool vtkIndirectSkySampler::ReadSenders(const Input& input)
{
  std::vector<vtkIndirectSenderClusters::Sender> senders;
  std::vector<glm::vec3> places;
  if (!this->Texels->Update({ input.Frame, *this->Maps, input.Geometry }))
  {
    return false;
  }
  const vtkIndirectTarget& table = this->Texels->GetTable();
  const std::vector<float> position = table.ReadBack(PositionArea);
  const std::vector<float> normal = table.ReadBack(NormalExponent);
  const std::vector<float> density = table.ReadBack(DensityArea);
  const size_t count = static_cast<size_t>(this->Texels->GetActualNumberOfLights());
  for (size_t i = 0; i < count; ++i)
  {
    const float* p = &position[4 * i];
    const float* n = &normal[4 * i];
    const float* d = &density[4 * i];
    const glm::vec3 place(p[0], p[1], p[2]);
    if (place != glm::vec3(0.0f)) // the scene's centre, where there is nothing
    {
      places.push_back(place);
    }
    if (std::max({ d[0], d[1], d[2] }) > 0.0f)
    {
      senders.push_back({ { p[0], p[1], p[2] }, { n[0], n[1], n[2] }, p[3], { d[0], d[1], d[2] },
        static_cast<int>(d[3]) });
    }
  }
  this->Texels->ReleaseGraphicsResources(input.Frame.Window);
  // Receivers that cast no shadows are in no map.
  if (input.Frame.NumberOfOtherReceivers == 0)
  {
    vtkIndirectSenderClusters::RemoveOutermost(senders, places);
  }
  this->Clusters.SetSenders(std::move(senders));
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectSkySampler::Update(const Input& input)
{
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  if (this->SendersTime != this->Maps->GetContentTime())
  {
    this->SendersTime = 0;
    this->MadeTime = 0;
    if (!this->ReadSenders(input))
    {
      return false;
    }
    this->SendersTime = this->Maps->GetContentTime();
  }
  else if (this->MadeTime == this->SourceTime && this->MadeCount == this->NumberOfLights)
  {
    return true;
  }
  this->MadeTime = 0;
  std::vector<glm::dvec3> strengths;
  for (const vtkIndirectSkyGroups::Group& group : this->Groups)
  {
    strengths.push_back(group.Strength);
  }
  const std::vector<vtkIndirectSenderClusters::Light> lights =
    this->Clusters.MakeLights(strengths, this->NumberOfLights);
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  if (!this->Resize(window, static_cast<int>(lights.size())))
  {
    return false;
  }
  vtkIndirectTarget& table = this->BeginChange();
  const size_t places = static_cast<size_t>(table.GetWidth()) * table.GetHeight();
  std::vector<float> rows[3];
  for (std::vector<float>& row : rows)
  {
    row.reserve(4 * places);
  }
  // Of no vtkLight.
  const double source = static_cast<double>(input.Frame.Lights.size());
  for (size_t i = 0; i < places; ++i)
  {
    const vtkIndirectSenderClusters::Light light =
      i < lights.size() ? lights[i] : vtkIndirectSenderClusters::Light();
    const glm::dvec4 values[3] = { glm::dvec4(light.Position, light.Area),
      glm::dvec4(light.Normal, 0.0), glm::dvec4(light.DensityArea, source) };
    for (int channel = 0; channel < 3; ++channel)
    {
      for (int c = 0; c < 4; ++c)
      {
        rows[channel].push_back(static_cast<float>(values[channel][c]));
      }
    }
  }
  for (int channel = 0; channel < 3; ++channel)
  {
    table.Write(channel, rows[channel]);
  }
  this->MadeTime = this->SourceTime;
  this->MadeCount = this->NumberOfLights;
  return true;
}

//------------------------------------------------------------------------------
long long vtkIndirectSkySampler::GetNumberOfFacesDrawn() const
{
  return this->Maps->GetNumberOfFacesDrawn();
}

//------------------------------------------------------------------------------
size_t vtkIndirectSkySampler::GetBytes() const
{
  return this->Superclass::GetBytes() + this->Maps->GetBytes();
}

//------------------------------------------------------------------------------
void vtkIndirectSkySampler::AddToReport(vtkIndirectReport& report) const
{
  report.MainMemoryBytes += this->Clusters.GetBytes();
  const auto lit = std::count_if(this->Groups.begin(), this->Groups.end(), IsLit);
  report.Modelled.emplace_back("bounce of light from the sky",
    std::to_string(this->GetActualNumberOfLights()) + " virtual lights of " +
      std::to_string(this->Clusters.GetNumberOfSenders()) + " texels in maps of " +
      std::to_string(lit) + " directions, " + std::to_string(this->Maps->GetTexels()) +
      " texels squared");
}

//------------------------------------------------------------------------------
void vtkIndirectSkySampler::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!window)
  {
    return;
  }
  this->Superclass::ReleaseGraphicsResources(window);
  this->Maps->ReleaseGraphicsResources(window);
  this->Texels->ReleaseGraphicsResources(window);
  this->Clusters.SetSenders({});
  this->Groups.clear();
  this->Casters.clear();
  this->Environment = nullptr;
  this->MapsAreThere = false;
  this->SendersTime = 0;
  this->MadeTime = 0;
}
