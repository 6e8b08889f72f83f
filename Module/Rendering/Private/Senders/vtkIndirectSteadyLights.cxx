// SPDX-License-Identifier: BSD-3-Clause
#include "Senders/vtkIndirectSteadyLights.h"

#include "vtkSMPTools.h"

namespace
{
// With such an error all lights and children have branches: a map may become strong later.
constexpr double LeastError = 1e-9;
}

//------------------------------------------------------------------------------
vtkIndirectSteadyLights::Transfers vtkIndirectSteadyLights::FindTransfers(
  const vtkIndirectSenderClusters& clusters, size_t maps, const std::vector<Light>& lights)
{
  Transfers transfers(lights.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(lights.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<glm::dvec3> sums(maps);
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Light& light = lights[static_cast<size_t>(i)];
        sums.assign(maps, glm::dvec3(0.0));
        for (size_t place = light.Begin; place < light.End; ++place)
        {
          const vtkIndirectSenderClusters::Sender& sender = clusters.GetSender(place);
          sums[static_cast<size_t>(sender.Map)] += light.Share * glm::dvec3(sender.Reflected);
        }
        for (size_t map = 0; map < maps; ++map)
        {
          if (sums[map] != glm::dvec3(0.0))
          {
            transfers[static_cast<size_t>(i)].push_back(
              { static_cast<uint32_t>(map), glm::vec3(sums[map]) });
          }
        }
      }
    });
  return transfers;
}

//------------------------------------------------------------------------------
void vtkIndirectSteadyLights::Make(vtkIndirectSenderClusters& clusters, size_t maps, int count,
  bool divides, double nearness, int least, int narrow)
{
  this->Tree = clusters.MakeLights(std::vector<glm::dvec3>(maps, glm::dvec3(1.0)), count,
    divides ? LeastError : 0.0, nearness, least, narrow);
  this->OfLights = FindTransfers(clusters, maps, this->Tree.Lights);
  this->OfBranches = FindTransfers(clusters, maps, this->Tree.Branches);
}

//------------------------------------------------------------------------------
void vtkIndirectSteadyLights::SetDensities(
  const Transfers& transfers, const std::vector<glm::dvec3>& strengths, std::vector<Light>& lights)
{
  const std::vector<glm::vec3> factors(strengths.begin(), strengths.end());
  for (size_t i = 0; i < lights.size(); ++i)
  {
    glm::vec3 sent(0.0f);
    for (const Transfer& transfer : transfers[i])
    {
      sent += factors[transfer.Map] * transfer.DensityArea;
    }
    lights[i].DensityArea = glm::dvec3(sent);
  }
}

//------------------------------------------------------------------------------
// A distance below zero marks an unused place.
void vtkIndirectSteadyLights::SetChildDistances(double limit, std::vector<Light>& lights)
{
  for (Light& light : lights)
  {
    light.ChildDistance = light.ChildDistance < 0.0
      ? light.ChildDistance
      : vtkIndirectSenderClusters::FindChildDistance(light, limit);
  }
}

//------------------------------------------------------------------------------
const vtkIndirectSenderClusters::LightTree& vtkIndirectSteadyLights::Relight(
  const vtkIndirectSenderClusters& clusters, const std::vector<glm::dvec3>& strengths, double error)
{
  SetDensities(this->OfLights, strengths, this->Tree.Lights);
  SetDensities(this->OfBranches, strengths, this->Tree.Branches);
  double flux = 0.0;
  for (const Light& light : this->Tree.Lights)
  {
    flux += glm::dot(light.DensityArea, glm::dvec3(1.0 / 3.0));
  }
  const double limit =
    this->Tree.Branches.empty() ? 0.0 : error * clusters.FindMeanIrradiance(flux);
  SetChildDistances(limit, this->Tree.Lights);
  SetChildDistances(limit, this->Tree.Branches);
  return this->Tree;
}

//------------------------------------------------------------------------------
size_t vtkIndirectSteadyLights::GetBytes() const
{
  size_t bytes = (this->Tree.Lights.size() + this->Tree.Branches.size()) * sizeof(Light);
  for (const Transfers* all : { &this->OfLights, &this->OfBranches })
  {
    for (const std::vector<Transfer>& transfers : *all)
    {
      bytes += sizeof(transfers) + transfers.size() * sizeof(Transfer);
    }
  }
  return bytes;
}
