// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAreaLightSampler.h"

#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectKey.h"
#include "Frame/vtkIndirectSettingList.h"
#include "VirtualLights/vtkIndirectAreaClusters.h"
#include "VirtualLights/vtkIndirectSampler.h"
#include "VirtualLights/vtkIndirectSenderClusters.h"
#include "vtkAreaLight.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <numeric>

vtkStandardNewMacro(vtkAreaLightSampler);

namespace
{
using Lights = std::vector<vtkIndirectAreaClusters::Light>;

// Returns the irradiance (VTK units) at a distance, right before a rectangle.
double FindIrradianceAt(const vtkIndirectAreaClusters::Image& image, double distance)
{
  const size_t values = 3 * static_cast<size_t>(image.Columns) * image.Rows;
  const double mean = std::accumulate(image.Radiances, image.Radiances + values, 0.0) / values;
  return mean * image.GetArea() / (glm::pi<double>() * distance * distance);
}

std::vector<vtkIndirectSampler::Row> MakeRows(const Lights& lights)
{
  std::vector<vtkIndirectSampler::Row> rows;
  rows.reserve(lights.size());
  for (const vtkIndirectAreaClusters::Light& light : lights)
  {
    rows.push_back({ { light.Position.x, light.Position.y, light.Position.z }, light.Area,
      { light.Normal.x, light.Normal.y, light.Normal.z },
      { light.RadianceArea.x, light.RadianceArea.y, light.RadianceArea.z }, light.ChildDistance,
      light.ContactSoftening });
  }
  return rows;
}

class AreaLights : public vtkIndirectSampler
{
public:
  explicit AreaLights(vtkAreaLightSampler& settings)
    : vtkIndirectSampler(&settings)
    , Set(settings)
  {
  }
  void AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const override;
  bool Update(const Input& input) override;
  vtkIndirectSamplerAbilities GetAbilities() const override;

protected:
  void ReleaseOwn(vtkWindow* window) override
  {
    this->vtkIndirectSampler::ReleaseOwn(window);
    this->MadeKey.Clear();
  }

private:
  const vtkAreaLightSampler& Set;
  vtkIndirectKey MadeKey; // the inputs of the virtual lights
};
}

//------------------------------------------------------------------------------
vtkAreaLightSampler::vtkAreaLightSampler()
  : vtkVirtualLightSampler(std::make_unique<AreaLights>(*this))
{
}

vtkAreaLightSampler::~vtkAreaLightSampler() = default;

//------------------------------------------------------------------------------
void vtkAreaLightSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Area lights: " << this->Lights.size() << "\n";
  for (const auto& light : this->Lights)
  {
    light->PrintSelf(os, indent.GetNextIndent());
  }
}

//------------------------------------------------------------------------------
void vtkAreaLightSampler::AddLight(vtkAreaLight* light)
{
  if (light && std::find(this->Lights.begin(), this->Lights.end(), light) == this->Lights.end())
  {
    this->Lights.emplace_back(light);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAreaLightSampler::RemoveLight(vtkAreaLight* light)
{
  const auto found = std::find(this->Lights.begin(), this->Lights.end(), light);
  if (found != this->Lights.end())
  {
    this->Lights.erase(found);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAreaLightSampler::RemoveAllLights()
{
  if (!this->Lights.empty())
  {
    this->Lights.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAreaLightSampler::SetLights(const std::vector<vtkSmartPointer<vtkAreaLight>>& lights)
{
  if (this->Lights != lights)
  {
    this->Lights = lights;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkAreaLight* vtkAreaLightSampler::GetAreaLight(int index) const
{
  return index >= 0 && index < this->GetNumberOfAreaLights()
    ? this->Lights[static_cast<size_t>(index)].Get()
    : nullptr;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkAreaLightSampler::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const auto& light : this->Lights)
  {
    time = std::max(time, light->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
void AreaLights::AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const
{
  this->vtkIndirectSampler::AddSettings(list, plan);
  const bool minMax = this->Set.GetClustering() == vtkAreaLightSampler::MIN_MAX;
  list.Add("Clustering", vtkIndirectSettingList::Choice{ minMax ? "MinMax" : "Variance" });
}

//------------------------------------------------------------------------------
vtkIndirectSamplerAbilities AreaLights::GetAbilities() const
{
  vtkIndirectSamplerAbilities abilities = this->vtkIndirectSampler::GetAbilities();
  abilities.Divides = this->Set.GetClustering() == vtkAreaLightSampler::VARIANCE;
  return abilities;
}

//------------------------------------------------------------------------------
bool AreaLights::Update(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  // Radiances come first, because reading them may update the pipeline of a texture.
  std::vector<vtkIndirectAreaClusters::Image> images;
  for (int i = 0; i < this->Set.GetNumberOfAreaLights(); ++i)
  {
    vtkAreaLight* const light = this->Set.GetAreaLight(i);
    if (!light->ShinesInto(glm::value_ptr(frame.SceneCenter), 1.0 / frame.SceneScale))
    {
      continue;
    }
    vtkIndirectAreaClusters::Image image(light, frame.SceneCenter, frame.SceneScale);
    const std::vector<float>& radiances = light->GetRadiances(image.Columns, image.Rows);
    if (!radiances.empty())
    {
      image.Radiances = radiances.data();
      images.push_back(image);
    }
  }
  vtkIndirectKey key;
  key.Add("sampler", this->GetSettingsTime()).Add("number of lights", frame.Lights.size());
  key.Add("error tolerance", input.ErrorTolerance);
  frame.AppendUnitsTo(key);
  if (key == this->MadeKey)
  {
    return true;
  }
  this->MadeKey.Clear();
  const int count = this->Set.GetNumberOfLights();
  vtkIndirectAreaClusters::LightTree tree;
  if (this->Set.GetClustering() == vtkAreaLightSampler::MIN_MAX)
  {
    tree.Lights = vtkIndirectAreaClusters::MakeMinMaxLights(images, count);
  }
  else
  {
    // The error counts against the irradiance from all lights at half of the scene's size.
    double usual = 0.0;
    for (const vtkIndirectAreaClusters::Image& image : images)
    {
      usual += FindIrradianceAt(image, 0.5);
    }
    tree = vtkIndirectAreaClusters::MakeLights(
      images, count, vtkIndirectSenderClusters::FindError(input.ErrorTolerance) * usual);
  }
  if (!this->Write(frame, MakeRows(tree.Lights), MakeRows(tree.Branches)))
  {
    return false;
  }
  this->MadeKey = key;
  return true;
}
