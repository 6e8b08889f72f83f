// SPDX-License-Identifier: BSD-3-Clause
#include "Maps/vtkIndirectDepthMaps.h"

#include "Plan/vtkIndirectReport.h"
#include "Scene/vtkIndirectFrame.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace
{
// Memory of all maps, in texels: 384 MB. The most virtual lights (80 MB), strong directions
// (128 MB) and directions of a sky (64 MB) fit in beside 112 MB of other maps.
constexpr double Memory = 96.0 * 1024.0 * 1024.0;
}

//------------------------------------------------------------------------------
void vtkIndirectDepthMaps::Begin(const vtkIndirectFrame& frame, bool caching)
{
  const bool otherUnits =
    frame.SceneScale != this->SceneScale || frame.SceneCenter != this->SceneCenter;
  const std::vector<vtkIndirectDepthAtlas::Bounds> changed = this->FindChanges(frame);
  for (Client& client : this->Clients)
  {
    client.Asks = false;
    if (!caching)
    {
      client.Atlas.Forget();
    }
    if (otherUnits)
    {
      client.Atlas.Convert(this->SceneScale, this->SceneCenter, frame);
    }
    client.Atlas.MarkStale(frame, changed);
  }
  this->SceneScale = frame.SceneScale;
  this->SceneCenter = frame.SceneCenter;
}

//------------------------------------------------------------------------------
// Returns the bounds of casters that have come, gone or changed since the last frame, before and
// after the change.
std::vector<vtkIndirectDepthAtlas::Bounds> vtkIndirectDepthMaps::FindChanges(
  const vtkIndirectFrame& frame)
{
  Casters now;
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    auto& [revision, bounds] = now[caster.Prop];
    revision = caster.Revision;
    std::copy(caster.Bounds, caster.Bounds + 6, bounds.begin());
  }
  std::vector<vtkIndirectDepthAtlas::Bounds> changed;
  auto addMissing = [&changed](const Casters& from, const Casters& to)
  {
    for (const auto& [prop, state] : from)
    {
      const auto found = to.find(prop);
      if (found == to.end() || found->second != state)
      {
        changed.push_back(state.second);
      }
    }
  };
  addMissing(now, this->LastCasters);
  addMissing(this->LastCasters, now);
  this->LastCasters = std::move(now);
  return changed;
}

//------------------------------------------------------------------------------
void vtkIndirectDepthMaps::Request(
  ClientType client, const vtkIndirectFrame& frame, const std::vector<Map>& maps, int texels)
{
  double memory = Memory;
  for (int i = 0; i < client; ++i)
  {
    memory -= this->Clients[i].Atlas.CountTexels();
  }
  this->Clients[client].Atlas.Request(frame, maps, texels, memory);
  this->Clients[client].Asks = true;
}

//------------------------------------------------------------------------------
bool vtkIndirectDepthMaps::HasRequests() const
{
  return std::any_of(std::begin(this->Clients), std::end(this->Clients),
    [](const Client& client) { return client.Asks; });
}

//------------------------------------------------------------------------------
bool vtkIndirectDepthMaps::Draw(
  const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture, int tiles)
{
  int clients = 0; // that need tiles
  int needed = 0;
  for (const Client& client : this->Clients)
  {
    const int left = client.Asks ? client.Atlas.GetNumberOfTilesLeft() : 0;
    clients += left > 0 ? 1 : 0;
    needed += left;
  }
  bool drawn = true;
  for (Client& client : this->Clients)
  {
    if (!client.Asks)
    {
      continue;
    }
    client.Asks = false;
    const int left = client.Atlas.GetNumberOfTilesLeft();
    needed -= left;
    const int share = std::max((tiles + clients - 1) / std::max(clients, 1), tiles - needed);
    clients -= left > 0 ? 1 : 0;
    drawn = client.Atlas.Draw(frame, capture, std::max(share, 0)) && drawn;
    const int spent = left - client.Atlas.GetNumberOfTilesLeft();
    tiles = std::max(tiles - spent, 0);
    this->NumberOfTilesDrawn += static_cast<size_t>(spent);
  }
  return drawn;
}

//------------------------------------------------------------------------------
void vtkIndirectDepthMaps::AddToReport(vtkIndirectReport& report) const
{
  for (const Client& client : this->Clients)
  {
    const vtkIndirectDepthAtlas& atlas = client.Atlas;
    report.Bytes += atlas.GetBytes();
    if (!client.Name)
    {
      continue;
    }
    auto add = [&](int count, const char* before, const char* after, const char* why)
    {
      if (count > 0)
      {
        report.LeftOut.emplace_back(before + std::to_string(count) + after + client.Name, why);
      }
    };
    const int missing = atlas.GetNumberOfMissingTiles();
    add(atlas.GetNumberOfTilesTooMany(), "depth maps of ", " ",
      "there is no memory for so many; other maps stand for them, and nothing hides a light that "
      "has none");
    add(missing, "depth maps of ", " ",
      "further frames draw them; until then other maps stand for them");
    add(atlas.GetNumberOfTilesLeft() - missing, "what has just moved, in ", " depth maps of ",
      "further frames draw them again");
  }
}

//------------------------------------------------------------------------------
void vtkIndirectDepthMaps::Release(ClientType client, vtkWindow* window)
{
  this->Clients[client].Atlas.Release(window);
  this->Clients[client].Asks = false;
}

//------------------------------------------------------------------------------
void vtkIndirectDepthMaps::Release(vtkWindow* window)
{
  for (int i = 0; i < NUMBER_OF_CLIENTS; ++i)
  {
    this->Release(static_cast<ClientType>(i), window);
  }
}
