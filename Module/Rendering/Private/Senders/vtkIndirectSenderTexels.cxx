// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Senders/vtkIndirectSenderTexels.h"

#include "Emitters/vtkIndirectDirections.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <array>
#include <set>

//------------------------------------------------------------------------------
bool vtkIndirectSenderTexels::Read(const vtkIndirectSampler::Input& input,
  std::vector<vtkIndirectSenderClusters::Sender>& senders, std::vector<glm::vec3>& places)
{
  senders.clear();
  places.clear();
  if (!this->Texels.Update(input))
  {
    return false;
  }
  const vtkIndirectTarget& table = this->Texels.GetTable();
  const std::vector<float> position = table.ReadBack(vtkIndirectSampler::PositionArea);
  const std::vector<float> normal = table.ReadBack(vtkIndirectSampler::NormalChildDistance);
  const std::vector<float> density = table.ReadBack(vtkIndirectSampler::DensityArea);
  const size_t count = static_cast<size_t>(this->Texels.GetActualNumberOfLights());
  const vtkIndirectTarget* lobes = this->Texels.GetLobes();
  const std::vector<float> direction =
    lobes ? lobes->ReadBack(vtkIndirectSampler::LobeDirectionExponent) : std::vector<float>();
  const std::vector<float> flux =
    lobes ? lobes->ReadBack(vtkIndirectSampler::LobeDensityArea) : std::vector<float>();
  for (size_t i = 0; i < count; ++i)
  {
    const float* p = &position[4 * i];
    const float* n = &normal[4 * i];
    const float* d = &density[4 * i];
    const glm::vec3 place(p[0], p[1], p[2]);
    if (place != glm::vec3(0.0f)) // empty texels hold the scene's centre
    {
      places.push_back(place);
    }
    const bool mirrors =
      lobes && std::max({ flux[4 * i], flux[4 * i + 1], flux[4 * i + 2] }) > 0.0f;
    if (std::max({ d[0], d[1], d[2] }) > 0.0f || mirrors)
    {
      senders.push_back(
        { place, { n[0], n[1], n[2] }, p[3], { d[0], d[1], d[2] }, static_cast<int>(d[3]) });
    }
    if (mirrors)
    {
      vtkIndirectSenderClusters::Sender& sender = senders.back();
      const float* w = &direction[4 * i];
      sender.LobeDirection = { w[0], w[1], w[2] };
      sender.LobeExponent = w[3];
      sender.LobeReflected = { flux[4 * i], flux[4 * i + 1], flux[4 * i + 2] };
    }
  }
  this->Texels.Release(input.Frame.Window);
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectSenderTexels::RemoveOutermost(
  std::vector<vtkIndirectSenderClusters::Sender>& senders, const std::vector<glm::vec3>& places)
{
  // Finds corners of the hull: the farthest places in these directions. Round hulls lose little by
  // that, boxes nothing. Along the normal of a wide ground lies the top of a small thing on it,
  // which is farthest in no other direction.
  constexpr int lattice = 128;
  constexpr float parts = 4.0f; // of an axis: one normal in each cell
  std::vector<glm::vec3> directions;
  for (const glm::dvec3& exact : vtkIndirectDirections::MakeLattice(lattice))
  {
    directions.emplace_back(exact);
  }
  std::set<std::array<int, 3>> cells;
  for (const vtkIndirectSenderClusters::Sender& sender : senders)
  {
    const glm::ivec3 cell(glm::floor(parts * sender.Normal));
    if (cells.insert({ cell.x, cell.y, cell.z }).second)
    {
      directions.push_back(sender.Normal);
    }
  }
  std::vector<glm::vec3> corners;
  for (const glm::vec3& direction : directions)
  {
    float farthest = 0.0f;
    const glm::vec3* corner = nullptr;
    for (const glm::vec3& place : places)
    {
      const float distance = glm::dot(place, direction);
      if (!corner || distance > farthest)
      {
        farthest = distance;
        corner = &place;
      }
    }
    if (corner)
    {
      corners.push_back(*corner);
    }
  }
  // The rounding of packed normals, along a scene of length one.
  constexpr float rounding = 2.6e-4f;
  const auto outermost = std::remove_if(senders.begin(), senders.end(),
    [&](const vtkIndirectSenderClusters::Sender& sender)
    {
      const float height = glm::dot(sender.Normal, sender.Position) + rounding;
      return std::none_of(corners.begin(), corners.end(),
        [&](const glm::vec3& corner) { return glm::dot(sender.Normal, corner) > height; });
    });
  senders.erase(outermost, senders.end());
}

//------------------------------------------------------------------------------
std::vector<vtkIndirectSampler::Row> vtkIndirectSenderTexels::MakeRows(
  const std::vector<vtkIndirectSenderClusters::Light>& lights)
{
  std::vector<vtkIndirectSampler::Row> rows;
  rows.reserve(lights.size());
  for (const vtkIndirectSenderClusters::Light& light : lights)
  {
    rows.push_back({ { light.Position.x, light.Position.y, light.Position.z }, light.Area,
      { light.Normal.x, light.Normal.y, light.Normal.z },
      { light.DensityArea.x, light.DensityArea.y, light.DensityArea.z }, light.ChildDistance,
      light.ContactSoftening,
      { light.LobeDirection.x, light.LobeDirection.y, light.LobeDirection.z }, light.LobeExponent,
      { light.LobeDensityArea.x, light.LobeDensityArea.y, light.LobeDensityArea.z } });
  }
  return rows;
}
