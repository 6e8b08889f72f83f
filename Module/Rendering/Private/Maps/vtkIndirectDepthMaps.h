// SPDX-License-Identifier: BSD-3-Clause
// The depth maps of all kinds of emitters. A client asks for its maps and looks them up. This class
// holds the maps' textures, marks maps as stale that see a change of the scene, bounds the memory,
// shares the work of a frame among the clients, and reports the maps that are left to be drawn.
#pragma once

#include "Maps/vtkIndirectDepthAtlas.h" // for members
#include "vtkType.h"                    // for revisions

#include <cstddef>       // for size_t
#include <unordered_map> // for casters
#include <utility>       // for pairs
#include <vector>        // for lists

class vtkProp;
class vtkSurfaceCapturePass;
class vtkWindow;
struct vtkIndirectFrame;
struct vtkIndirectReport;

class vtkIndirectDepthMaps
{
public:
  /** These are the clients, in the order in which a frame draws their maps. */
  enum ClientType
  {
    EYE,       // what the eye sees; see vtkIndirectViewSamples
    PENUMBRAE, // points of lights that have a size
    VIRTUAL_LIGHTS,
    STRONG_SKY, // directions with much of the sky's light
    SKY,
    AREA_LIGHTS,
    AREA_ROUNDS,    // further points of area lights, whose maps are not kept
    FURTHER_LIGHTS, // virtual lights of a finer picture of the same scene
    FURTHER_SKY,    // directions of the sky of a finer picture
    NUMBER_OF_CLIENTS
  };
  using Map = vtkIndirectDepthAtlas::Map;

  /**
   * Begins a frame: marks maps as stale that see a change of the scene. Without caching all maps
   * are dropped.
   */
  void Begin(const vtkIndirectFrame& frame, bool caching);
  /**
   * Asks for a client's maps, in place of its former ones, with this many texels along an edge, or
   * fewer if the client and those before it would need more than the memory of all maps.
   */
  void Request(
    ClientType client, const vtkIndirectFrame& frame, const std::vector<Map>& maps, int texels);
  /** Returns true if any client has asked since the last Draw. */
  bool HasRequests() const;
  /**
   * Draws maps of these clients, `tiles` at most. Clients share the tiles equally; a client that
   * needs fewer leaves them to the others. Returns false, after an error, when OpenGL refuses.
   */
  bool Draw(const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture, int tiles = 1 << 30);

  /** Returns a client's maps. */
  const vtkIndirectDepthAtlas& Get(ClientType client) const { return this->Clients[client].Atlas; }
  /** Returns the number of tiles drawn since construction. */
  size_t GetNumberOfTilesDrawn() const { return this->NumberOfTilesDrawn; }
  /** Adds the memory, and the maps that are missing or stale. */
  void AddToReport(vtkIndirectReport& report) const;
  void Release(ClientType client, vtkWindow* window);
  /** Releases the maps of all clients. */
  void Release(vtkWindow* window);

private:
  struct Client
  {
    const char* Name; // of the emitters, for reports; null: nothing to report
    vtkIndirectDepthAtlas Atlas;
    bool Asks = false; // since the last Draw
    explicit Client(const char* name, bool strips = false)
      : Name(name)
      , Atlas(strips)
    {
    }
  };
  // The revisions and bounds of casters.
  using Casters =
    std::unordered_map<vtkProp*, std::pair<vtkTypeUInt64, vtkIndirectDepthAtlas::Bounds>>;

  std::vector<vtkIndirectDepthAtlas::Bounds> FindChanges(const vtkIndirectFrame& frame);

  Client Clients[NUMBER_OF_CLIENTS]{ Client(nullptr), Client("lights that have a size"),
    Client("virtual lights", true), Client("strong directions of the sky"),
    Client("directions of the sky"), Client("points of area lights", true), Client(nullptr, true),
    Client("virtual lights of a finer picture", true),
    Client("directions of the sky of a finer picture") };
  size_t NumberOfTilesDrawn = 0;
  Casters LastCasters; // at the last Begin
  double SceneScale = 0.0;
  glm::dvec3 SceneCenter{ 0.0 };
};
