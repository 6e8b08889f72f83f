// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLightTreeSampler.h"

#include "Frame/vtkIndirectFrame.h"
#include "VirtualLights/vtkIndirectSenderClusters.h"
#include "VirtualLights/vtkIndirectSenderTexels.h"
#include "vtkObjectFactory.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>

vtkStandardNewMacro(vtkLightTreeSampler);

namespace
{
// What is more leaves less than a thousandth of the mean squared relative error, and takes longer
// to divide than maps take to draw.
constexpr size_t MostTexels = 65536;

// Of scenes by themselves: enough of walls and bodies, and of many small objects. See
// Documentation/methods/light-tree.md.
constexpr int LeastLights = 128;
constexpr int MostLights = 1024;
}

//------------------------------------------------------------------------------
struct vtkLightTreeSampler::Internals
{
  vtkIndirectSenderTexels Texels;
  vtkIndirectSenderClusters Clusters;
  vtkNew<vtkUniformLightSampler> ViewPattern;
  std::vector<vtkIndirectSenderClusters::Sender> FromMaps; // where further ones may come and go
  size_t Sources = 0;                                      // of the texels' lights
  size_t FurtherTime = 0;
  size_t FurtherMaps = 0;
  // What the tree was made of, and the lights.
  vtkMTimeType MapTime = 0;
  int Count = 0;
  bool Automatic = false;
  double Error = 0.0;
};

vtkLightTreeSampler::vtkLightTreeSampler()
  : Internal(new Internals)
{
  this->Internal->Texels.SetMostTexels(MostTexels);
}

vtkLightTreeSampler::~vtkLightTreeSampler() = default;

//------------------------------------------------------------------------------
void vtkLightTreeSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLights: " << this->NumberOfLights << "\n";
  os << indent << "AutomaticNumberOfLights: " << this->AutomaticNumberOfLights << "\n";
}

//------------------------------------------------------------------------------
void vtkLightTreeSampler::SetNumberOfLights(int number)
{
  const int clamped = std::min(std::max(number, 1), 1048576);
  if (clamped != this->NumberOfLights || this->AutomaticNumberOfLights)
  {
    this->NumberOfLights = clamped;
    this->AutomaticNumberOfLights = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkLightTreeSampler::Update(const Input& input)
{
  Internals& in = *this->Internal;
  const double error = vtkIndirectSenderClusters::FindError(input.ErrorTolerance);
  const vtkMTimeType time = input.Maps.GetContentTime();
  // Without further senders what maps show is not kept beside the tree.
  const bool anew = input.Further && input.Further->Time != in.FurtherTime && in.FromMaps.empty();
  const bool gone = !input.Further && in.FurtherTime != 0;
  const bool read = in.MapTime != time || anew || gone;
  const vtkIndirectFurtherSenders* further = input.Further;
  const size_t furtherTime = further ? further->Time : 0;
  const bool same = !read && in.FurtherTime == furtherTime;
  const bool automatic = this->AutomaticNumberOfLights;
  const int wanted = automatic ? MostLights : this->NumberOfLights;
  const int most =
    automatic && input.Interactive ? std::min(this->NumberOfLights, MostLights) : wanted;
  // While nothing but the camera moves, what a still picture had is kept.
  const bool enough = in.Count == most || in.Count == wanted;
  if (same && enough && in.Automatic == automatic && in.Error == error)
  {
    return true;
  }
  in.Count = 0;
  if (read)
  {
    in.MapTime = 0;
    std::vector<vtkIndirectSenderClusters::Sender> senders;
    std::vector<glm::vec3> places;
    if (!in.Texels.Read(input, senders, places))
    {
      return false;
    }
    in.Sources = 0;
    for (const vtkIndirectSenderClusters::Sender& sender : senders)
    {
      in.Sources = std::max(in.Sources, static_cast<size_t>(sender.Map) + 1);
    }
    in.FromMaps = std::move(senders);
    in.MapTime = time;
  }
  if (!same)
  {
    // What the maps show is kept where only the rest of it changes.
    std::vector<vtkIndirectSenderClusters::Sender> senders =
      further ? in.FromMaps : std::move(in.FromMaps);
    in.FurtherMaps = further ? further->NumberOfMaps : 0;
    for (size_t i = 0; further && i < further->Senders.size(); ++i)
    {
      senders.push_back(further->Senders[i]);
      senders.back().Map += static_cast<int>(in.Sources);
    }
    in.Clusters.SetSenders(std::move(senders));
    in.FurtherTime = furtherTime;
  }
  const vtkIndirectSenderClusters::Lights lights = in.Clusters.MakeLights(
    std::vector<glm::dvec3>(in.Sources + in.FurtherMaps, glm::dvec3(1.0)), most, error,
    further ? vtkIndirectSenderClusters::NearnessOfBounces
            : vtkIndirectSenderClusters::StandardNearness,
    automatic ? LeastLights : 0);
  if (!this->Write(input.Frame, vtkIndirectSenderTexels::MakeRows(lights.Tops),
        vtkIndirectSenderTexels::MakeRows(lights.Branches)))
  {
    return false;
  }
  in.Count = most;
  in.Automatic = automatic;
  in.Error = error;
  return true;
}

//------------------------------------------------------------------------------
bool vtkLightTreeSampler::HasMore() const
{
  const int count = this->Internal->Count;
  return this->AutomaticNumberOfLights && count > 0 && count < MostLights;
}

//------------------------------------------------------------------------------
// What the eye sees changes with every move of the camera, too often to make a tree of it.
vtkMapLightSampler* vtkLightTreeSampler::GetViewPattern()
{
  this->Internal->ViewPattern->SetNumberOfLights(this->NumberOfLights);
  return this->Internal->ViewPattern;
}

//------------------------------------------------------------------------------
size_t vtkLightTreeSampler::GetMainMemoryBytes() const
{
  return this->Internal->Clusters.GetBytes() +
    this->Internal->FromMaps.size() * sizeof(vtkIndirectSenderClusters::Sender);
}

//------------------------------------------------------------------------------
void vtkLightTreeSampler::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!this->CanBeOf(window))
  {
    return;
  }
  this->Superclass::ReleaseGraphicsResources(window);
  this->Internal->Texels.Release(window);
  this->Internal->ViewPattern->ReleaseGraphicsResources(window);
  this->Internal->Clusters.SetSenders({});
  this->Internal->FromMaps = {};
  this->Internal->MapTime = 0;
  this->Internal->Count = 0;
}
