// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAreaLightSampler.h"

#include "Emitters/vtkIndirectEmitterAccess.h"
#include "OpenGL/vtkIndirectKey.h"
#include "Plan/vtkIndirectSettingList.h"
#include "Scene/vtkIndirectFrame.h"
#include "Senders/vtkIndirectAreaClusters.h"
#include "Senders/vtkIndirectSampler.h"
#include "Senders/vtkIndirectSenderTexels.h"
#include "vtkAreaLight.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>
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
  double usual = 0.0; // VTK irradiance from all lights at half of the scene's size
  for (int i = 0; i < this->Set.GetNumberOfAreaLights(); ++i)
  {
    vtkAreaLight* const light = this->Set.GetAreaLight(i);
    if (!vtkIndirectEmitterAccess::ShinesInto(
          light, glm::value_ptr(frame.SceneCenter), 1.0 / frame.SceneScale))
    {
      continue;
    }
    vtkIndirectAreaClusters::Image image(light, frame.SceneCenter, frame.SceneScale);
    const std::vector<float>& radiances =
      vtkIndirectEmitterAccess::GetRadiances(light, image.Columns, image.Rows);
    if (!radiances.empty())
    {
      image.Radiances = radiances.data();
      glm::dvec3 mean;
      light->GetMeanRadiance(&mean[0]);
      usual += (mean.x + mean.y + mean.z) / 3.0 * image.GetArea() / (glm::pi<double>() * 0.25);
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
    tree = vtkIndirectAreaClusters::MakeLights(
      images, count, vtkIndirectSenderClusters::FindError(input.ErrorTolerance) * usual);
  }
  if (!this->Write(frame, vtkIndirectSenderTexels::MakeRows(tree.Lights),
        vtkIndirectSenderTexels::MakeRows(tree.Branches)))
  {
    return false;
  }
  this->MadeKey = key;
  return true;
}
