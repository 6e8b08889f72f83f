// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAreaLightSampler.h"

#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectKey.h"
#include "VirtualLights/vtkIndirectAreaClusters.h"
#include "VirtualLights/vtkIndirectSampler.h"
#include "vtkAreaLight.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

vtkStandardNewMacro(vtkAreaLightSampler);

namespace
{
class AreaLights : public vtkIndirectSampler
{
public:
  explicit AreaLights(vtkAreaLightSampler& settings)
    : vtkIndirectSampler(&settings)
    , Set(settings)
  {
  }
  bool Update(const Input& input) override;

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
  frame.AppendUnitsTo(key);
  if (key == this->MadeKey)
  {
    return true;
  }
  this->MadeKey.Clear();
  std::vector<Row> rows;
  for (const vtkIndirectAreaClusters::Light& light :
    vtkIndirectAreaClusters::MakeLights(images, this->Set.GetNumberOfLights()))
  {
    rows.push_back({ { light.Position.x, light.Position.y, light.Position.z }, light.Area,
      { light.Normal.x, light.Normal.y, light.Normal.z },
      { light.RadianceArea.x, light.RadianceArea.y, light.RadianceArea.z } });
  }
  if (!this->Write(frame, rows))
  {
    return false;
  }
  this->MadeKey = key;
  return true;
}
