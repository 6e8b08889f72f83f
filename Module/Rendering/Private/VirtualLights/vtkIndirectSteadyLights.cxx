// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualLights/vtkIndirectSteadyLights.h"

#include "VirtualLights/vtkIndirectSenderTexels.h"
#include "vtkSMPTools.h"

namespace
{
// With such an error all lights and children have branches: a map may become strong later.
constexpr double LeastError = 1e-9;
}

//------------------------------------------------------------------------------
void vtkIndirectSteadyLights::AddNodes(const vtkIndirectSenderClusters& clusters, size_t maps,
  const std::vector<vtkIndirectSenderClusters::Light>& lights)
{
  const size_t first = this->Nodes.size();
  this->Nodes.resize(first + lights.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(lights.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<glm::dvec3> sums(maps);
      for (vtkIdType i = begin; i < end; ++i)
      {
        const vtkIndirectSenderClusters::Light& light = lights[static_cast<size_t>(i)];
        Node& node = this->Nodes[first + static_cast<size_t>(i)];
        node.Light = light;
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
            node.Transfers.push_back({ static_cast<uint32_t>(map), glm::vec3(sums[map]) });
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
void vtkIndirectSteadyLights::Make(vtkIndirectSenderClusters& clusters, size_t maps, int count,
  bool divides, double nearness, int least)
{
  const vtkIndirectSenderClusters::LightTree tree =
    clusters.MakeLights(std::vector<glm::dvec3>(maps, glm::dvec3(1.0)), count,
      divides ? LeastError : 0.0, nearness, least);
  this->Nodes.clear();
  this->AddNodes(clusters, maps, tree.Lights);
  this->AddNodes(clusters, maps, tree.Branches);
  this->Lights = vtkIndirectSenderTexels::MakeRows(tree.Lights);
  this->Branches = vtkIndirectSenderTexels::MakeRows(tree.Branches);
}

//------------------------------------------------------------------------------
void vtkIndirectSteadyLights::Relight(
  const vtkIndirectSenderClusters& clusters, const std::vector<glm::dvec3>& strengths, double error)
{
  const std::vector<glm::vec3> factors(strengths.begin(), strengths.end());
  double flux = 0.0;
  for (size_t i = 0; i < this->Nodes.size(); ++i)
  {
    glm::vec3 sent(0.0f);
    for (const Transfer& transfer : this->Nodes[i].Transfers)
    {
      sent += factors[transfer.Map] * transfer.DensityArea;
    }
    this->Nodes[i].Light.DensityArea = glm::dvec3(sent);
    flux += i < this->Lights.size()
      ? glm::dot(this->Nodes[i].Light.DensityArea, glm::dvec3(1.0 / 3.0))
      : 0.0;
  }
  const double limit = this->Branches.empty() ? 0.0 : error * clusters.FindMeanIrradiance(flux);
  for (size_t i = 0; i < this->Nodes.size(); ++i)
  {
    const vtkIndirectSenderClusters::Light& light = this->Nodes[i].Light;
    vtkIndirectSampler::Row& row =
      i < this->Lights.size() ? this->Lights[i] : this->Branches[i - this->Lights.size()];
    for (int c = 0; c < 3; ++c)
    {
      row.DensityArea[c] = light.DensityArea[c];
    }
    // A distance below zero marks an unused place.
    row.ChildDistance = light.ChildDistance < 0.0
      ? light.ChildDistance
      : vtkIndirectSenderClusters::FindChildDistance(light, limit);
  }
}

//------------------------------------------------------------------------------
size_t vtkIndirectSteadyLights::GetBytes() const
{
  size_t bytes = (this->Lights.size() + this->Branches.size()) *
    (sizeof(vtkIndirectSampler::Row) + sizeof(Node));
  for (const Node& node : this->Nodes)
  {
    bytes += node.Transfers.size() * sizeof(Transfer);
  }
  return bytes;
}
