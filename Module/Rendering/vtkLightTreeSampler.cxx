// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLightTreeSampler.h"

#include "Maps/vtkIndirectLightMaps.h"
#include "Plan/vtkIndirectPlan.h"
#include "Plan/vtkIndirectReport.h"
#include "Plan/vtkIndirectSettingList.h"
#include "Scene/vtkIndirectFrame.h"
#include "Senders/vtkIndirectMapSampler.h"
#include "Senders/vtkIndirectSenderClusters.h"
#include "Senders/vtkIndirectSenderTexels.h"
#include "vtkObjectFactory.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>

vtkStandardNewMacro(vtkLightTreeSampler);

namespace
{
// More texels leave less than a thousandth of the mean squared relative error, and take longer to
// divide than maps take to draw.
constexpr size_t MostTexels = 65536;

// The range of automatic numbers of lights: enough for walls and bodies, and for many small
// objects. See Documentation/methods/light-tree.md.
constexpr int LeastLights = 128;
constexpr int MostLights = vtkIndirectSamplerAbilities::MostAutomaticLights;

class TreeLights : public vtkIndirectSampler
{
public:
  explicit TreeLights(vtkLightTreeSampler& settings)
    : vtkIndirectSampler(&settings)
    , Set(settings)
  {
  }
  void AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const override;
  bool Update(const Input& input) override;
  vtkIndirectSamplerAbilities GetAbilities() const override;
  vtkIndirectMapSampler* GetHeadlightPattern() override;
  void AddToReport(vtkIndirectReport& report) const override;

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  const vtkLightTreeSampler& Set;
  vtkIndirectSenderTexels Texels;
  vtkIndirectSenderClusters Clusters;
  vtkNew<vtkUniformLightSampler> HeadlightPattern;
  std::vector<vtkIndirectSenderClusters::Sender> FromMaps; // kept if there are further senders,
                                                           // which may come and go
  size_t Sources = 0;                                      // number of the texels' lights
  size_t FurtherTime = 0;
  size_t FurtherMaps = 0;
  // These numbers identify the inputs of the tree and the lights.
  vtkMTimeType MapTime = 0;
  vtkMTimeType WindowTime = 0;
  size_t NumberOfTexels = 0; // at most
  int Count = 0;
  bool Automatic = false;
  double Error = 0.0;
};
}

//------------------------------------------------------------------------------
vtkLightTreeSampler::vtkLightTreeSampler()
  : vtkVirtualLightSampler(std::make_unique<TreeLights>(*this))
{
}

//------------------------------------------------------------------------------
void TreeLights::AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const
{
  const bool automatic = this->Set.GetAutomaticNumberOfLights();
  if (plan && automatic && plan->Senders == vtkIndirectPlan::MAPS)
  {
    list.Add("NumberOfLights", this->GetActualNumberOfLights());
  }
  this->vtkIndirectSampler::AddSettings(list, plan);
  list.Add("AutomaticNumberOfLights", automatic);
}

//------------------------------------------------------------------------------
void vtkLightTreeSampler::SetNumberOfLights(int number)
{
  this->SetAutomaticNumberOfLights(false);
  this->Superclass::SetNumberOfLights(number);
}

//------------------------------------------------------------------------------
bool TreeLights::Update(const Input& input)
{
  const double error = vtkIndirectSenderClusters::FindError(input.ErrorTolerance);
  const vtkMTimeType time = input.Maps.GetContentTime();
  // Without further senders the maps' senders are not kept beside the tree, so they are read again.
  const bool anew =
    input.Further && input.Further->Time != this->FurtherTime && this->FromMaps.empty();
  const bool gone = !input.Further && this->FurtherTime != 0;
  // Windows follow the camera: while the camera moves, lights stay.
  const vtkMTimeType windowTime = input.Maps.GetWindowTime();
  const bool moved = this->WindowTime != windowTime && !input.Interactive;
  const size_t texels = MostTexels *
    static_cast<size_t>(vtkIndirectSamplerAbilities::FindDetail(this->Set.GetNumberOfLights()));
  const bool read =
    this->MapTime != time || moved || anew || gone || texels != this->NumberOfTexels;
  const vtkIndirectFurtherSenders* further = input.Further;
  const size_t furtherTime = further ? further->Time : 0;
  const bool same = !read && this->FurtherTime == furtherTime;
  const bool automatic = this->Set.GetAutomaticNumberOfLights();
  const int wanted = automatic ? MostLights : this->Set.GetNumberOfLights();
  const int most =
    automatic && input.Interactive ? std::min(this->Set.GetNumberOfLights(), MostLights) : wanted;
  // While only the camera moves, the lights of a still picture are kept.
  const bool enough = this->Count == most || this->Count == wanted;
  const bool seen = this->Clusters.GetSeen() == input.Frame.Seen.Near || input.Interactive;
  if (same && enough && seen && this->Automatic == automatic && this->Error == error)
  {
    return true;
  }
  this->Count = 0;
  if (read)
  {
    this->MapTime = 0;
    std::vector<vtkIndirectSenderClusters::Sender> senders;
    std::vector<glm::vec3> places;
    this->Texels.SetMostTexels(texels);
    if (!this->Texels.Read(input, senders, places))
    {
      return false;
    }
    this->Sources = 0;
    for (const vtkIndirectSenderClusters::Sender& sender : senders)
    {
      this->Sources = std::max(this->Sources, static_cast<size_t>(sender.Map) + 1);
    }
    this->FromMaps = std::move(senders);
    this->MapTime = time;
    this->NumberOfTexels = texels;
    this->WindowTime = windowTime;
  }
  if (!same)
  {
    // The maps' senders are kept if there are further ones, which may change alone.
    std::vector<vtkIndirectSenderClusters::Sender> senders =
      further ? this->FromMaps : std::move(this->FromMaps);
    this->FurtherMaps = further ? further->NumberOfMaps : 0;
    for (size_t i = 0; further && i < further->Senders.size(); ++i)
    {
      senders.push_back(further->Senders[i]);
      senders.back().Map += static_cast<int>(this->Sources);
    }
    this->Clusters.SetSenders(std::move(senders));
    this->FurtherTime = furtherTime;
  }
  this->Clusters.SetSeen(input.Frame.Seen.Near);
  const vtkIndirectSenderClusters::LightTree lights = this->Clusters.MakeLights(
    std::vector<glm::dvec3>(this->Sources + this->FurtherMaps, glm::dvec3(1.0)), most, error,
    further ? vtkIndirectSenderClusters::NearnessOfBounces
            : vtkIndirectSenderClusters::StandardNearness,
    automatic ? LeastLights : 0,
    vtkIndirectSenderClusters::FindMostNarrow(input.Frame, automatic ? most : 0));
  if (!this->Write(input.Frame, vtkIndirectSenderTexels::MakeRows(lights.Lights),
        vtkIndirectSenderTexels::MakeRows(lights.Branches)))
  {
    return false;
  }
  this->Count = most;
  this->Automatic = automatic;
  this->Error = error;
  return true;
}

//------------------------------------------------------------------------------
vtkIndirectSamplerAbilities TreeLights::GetAbilities() const
{
  vtkIndirectSamplerAbilities abilities = this->vtkIndirectSampler::GetAbilities();
  abilities.TakesSenders = true;
  abilities.MostLights = this->Set.GetAutomaticNumberOfLights() ? MostLights : 0;
  abilities.Divides = true;
  abilities.HasMore =
    this->Set.GetAutomaticNumberOfLights() && this->Count > 0 && this->Count < MostLights;
  return abilities;
}

//------------------------------------------------------------------------------
// The surfaces that the eye sees change with every move of the camera, too often for a tree.
vtkIndirectMapSampler* TreeLights::GetHeadlightPattern()
{
  this->HeadlightPattern->SetNumberOfLights(this->Set.GetNumberOfLights());
  return vtkIndirectSampler::Get(this->HeadlightPattern)->GetHeadlightPattern();
}

//------------------------------------------------------------------------------
void TreeLights::AddToReport(vtkIndirectReport& report) const
{
  report.MainMemoryBytes +=
    this->Clusters.GetBytes() + this->FromMaps.size() * sizeof(vtkIndirectSenderClusters::Sender);
}

//------------------------------------------------------------------------------
void TreeLights::ReleaseOwn(vtkWindow* window)
{
  this->vtkIndirectSampler::ReleaseOwn(window);
  this->Texels.Release(window);
  this->HeadlightPattern->ReleaseGraphicsResources(window);
  this->Clusters.SetSenders({});
  this->FromMaps = {};
  this->MapTime = 0;
  this->Count = 0;
}
