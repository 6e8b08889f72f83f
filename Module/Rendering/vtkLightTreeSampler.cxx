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
}

//------------------------------------------------------------------------------
struct vtkLightTreeSampler::Internals
{
  vtkIndirectSenderTexels Texels;
  vtkIndirectSenderClusters Clusters;
  vtkNew<vtkUniformLightSampler> ViewPattern;
  size_t Sources = 0; // of the texels' lights
  // What the tree was made of, and the lights.
  vtkMTimeType MapTime = 0;
  int Count = 0;
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
}

//------------------------------------------------------------------------------
bool vtkLightTreeSampler::Update(const Input& input)
{
  Internals& in = *this->Internal;
  const double error = vtkIndirectSenderClusters::FindError(input.ErrorTolerance);
  const vtkMTimeType time = input.Maps.GetContentTime();
  const bool read = in.MapTime != time;
  if (!read && in.Count == this->NumberOfLights && in.Error == error)
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
    in.Clusters.SetSenders(std::move(senders));
    in.MapTime = time;
  }
  const vtkIndirectSenderClusters::Lights lights = in.Clusters.MakeLights(
    std::vector<glm::dvec3>(in.Sources, glm::dvec3(1.0)), this->NumberOfLights, error);
  if (!this->Write(input.Frame, vtkIndirectSenderTexels::MakeRows(lights.Tops),
        vtkIndirectSenderTexels::MakeRows(lights.Branches)))
  {
    return false;
  }
  in.Count = this->NumberOfLights;
  in.Error = error;
  return true;
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
  return this->Internal->Clusters.GetBytes();
}

//------------------------------------------------------------------------------
void vtkLightTreeSampler::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!window)
  {
    return;
  }
  this->Superclass::ReleaseGraphicsResources(window);
  this->Internal->Texels.Release(window);
  this->Internal->ViewPattern->ReleaseGraphicsResources(window);
  this->Internal->Clusters.SetSenders({});
  this->Internal->MapTime = 0;
  this->Internal->Count = 0;
}
