// SPDX-License-Identifier: BSD-3-Clause
// Visibility of virtual lights from receivers, for estimators. It comes from nothing, from voxels
// of the scene and spheres that they do not hold, from the scene's surfaces themselves, or from
// depth maps of the lights.
#pragma once

#include "Maps/vtkIndirectDepthMaps.h"        // for depth maps
#include "OpenGL/vtkIndirectDataTexture.h"    // for a member
#include "OpenGL/vtkIndirectResource.h"       // for the base class
#include "Plan/vtkIndirectEstimate.h"         // for the needs
#include "Scene/vtkIndirectBlockingSpheres.h" // for the input
#include "Visibility/vtkIndirectSphereGrid.h" // for a member

#include <cstddef> // for size_t
#include <memory>  // for the volume
#include <string>  // for reasons
#include <vector>  // for maps

class vtkIndirectCreases;
class vtkIndirectOccupancyVolume;
class vtkIndirectSurfaces;
class vtkIndirectVirtualLights;
class vtkOpenGLRenderWindow;
struct vtkIndirectFrame;
struct vtkIndirectReport;

class vtkIndirectVisibility : public vtkIndirectResource
{
public:
  using Needs = vtkIndirectVisibilityNeeds;

  /**
   * This is the number of senders that a shader may test from one place in one draw. Mesa's
   * llvmpipe ends all loops of an invocation after 65535 rounds together, and a round is a sender
   * or four steps on the way to it. This number leaves 124 steps a sender, four times what rooms
   * need; there are fewer senders where spheres need more steps. An estimator with more senders
   * sums in several draws. The number is a multiple of vtkIndirectSampler::RowLength.
   */
  static constexpr int MaximumNumberOfSegments = 2048;
  int GetMaximumNumberOfSegments() const;
  /** This is the same where no segments are walked: a round a sender, and room for other loops. */
  static constexpr int MaximumNumberOfSenders = 16384;
  int GetMaximumNumberOfSenders() const
  {
    return this->WalksSegments() ? this->GetMaximumNumberOfSegments() : MaximumNumberOfSenders;
  }

  /** client: of the depth maps of lights. */
  vtkIndirectVisibility(vtkIndirectResource* owner, vtkIndirectDepthMaps& maps,
    vtkIndirectDepthMaps::ClientType client);
  ~vtkIndirectVisibility() override;

  /** This is the data that visibility is made from. */
  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectVirtualLights* Lights; // null where the frame has none
    bool Caching;
    /** These are the scene's surfaces, up to date where they are needed. */
    const vtkIndirectSurfaces& Surfaces;
    /** These are the spheres that mappers draw, which voxels do not hold; may be null. */
    const vtkIndirectBlockingSpheres* Spheres = nullptr;
  };

  /**
   * Brings visibility up to date, and asks for depth maps; without caching visibility is made anew.
   * Releases data that are not needed.
   */
  void Update(const Input& input, const Needs& needs);
  /** Lets lights without a map share maps, after maps have been drawn. */
  void UpdateSharing(const vtkIndirectFrame& frame);

  /** Returns true if senders can be hidden: visibility is wanted, and something can hide them. */
  bool HidesSenders() const { return this->WalksSegments() || this->LooksUpMaps(); }
  /** Returns true if shaders walk segments, which limits the number of senders in a draw. */
  bool WalksSegments() const { return this->WalksVoxels() || this->WalksSpheres(); }
  bool LooksUpMaps() const { return this->Current.Senders && this->Current.Maps; }
  /** Returns the depth maps of virtual lights. */
  const vtkIndirectDepthAtlas& GetMaps() const { return this->Atlas; }
  /** Returns true if shaders walk through voxels, or through lists of spheres. */
  bool WalksVoxels() const;
  bool WalksSpheres() const;
  /**
   * Returns true if the surfaces themselves hide senders: exact visibility is wanted, and there are
   * surfaces.
   */
  bool IsExact() const;
  /**
   * Returns definitions for shaders that include vtkIndirectVisibility.glsl; empty where nothing
   * hides.
   */
  std::string GetDefinitions() const;
  /** Binds the textures that the definitions' shaders read, or nothing if nothing hides senders. */
  void Activate(vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program,
    const vtkIndirectCreases& creases) const;

  /** Returns the voxels, empty where no stage needs them. */
  const vtkIndirectOccupancyVolume& GetVolume() const { return *this->Volume; }
  /** Returns the scene's surfaces of the last Update; valid only where they are needed. */
  const vtkIndirectSurfaces& GetSurfaces() const { return *this->Surfaces; }
  /** Returns the lists of spheres, empty where no stage needs them or there are no spheres. */
  const vtkIndirectSphereGrid& GetSpheres() const { return this->Spheres; }
  /** Returns how often lists of spheres have been made. */
  size_t GetNumberOfSphereUpdates() const { return this->NumberOfSphereUpdates; }
  /** Grows when the voxels or the surfaces change: results derived from them are stale. */
  size_t GetNumberOfUpdates() const { return this->NumberOfUpdates; }

  void AddToReport(vtkIndirectReport& report) const;
  size_t GetMainMemoryBytes() const;

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  void UpdateSpheres(const Input& input);
  double FindRounds() const;
  bool TakesLongSteps() const;
  void AddSegmentsToReport(vtkIndirectReport& report, const char* name) const;
  void ReadLights(const vtkIndirectVirtualLights& lights);
  void RequestMaps(const Input& input);
  void ShareTiles(const vtkIndirectFrame& frame);

  Needs Current;
  std::unique_ptr<vtkIndirectOccupancyVolume> Volume;
  const vtkIndirectSurfaces* Surfaces = nullptr; // of this frame
  vtkMTimeType SurfacesTime = 0;
  size_t NumberOfUpdates = 0;
  vtkIndirectSphereGrid Spheres{ this };
  const vtkIndirectBlockingSpheres* Blocking = nullptr; // of this frame
  size_t SpheresTime = 0;                               // when the lists were made
  size_t NumberOfSphereUpdates = 0;
  double StepsOfSpheres = 0.0; // of a segment, in the mean
  bool SpheresAreTooMany = false;
  vtkIndirectDepthMaps& DepthMaps;
  vtkIndirectDepthMaps::ClientType Client;
  const vtkIndirectDepthAtlas& Atlas;            // maps as they were drawn
  std::vector<vtkIndirectDepthMaps::Map> Lights; // maps of all lights
  std::vector<vtkIndirectDepthMaps::Map> Maps;   // maps that have a place in the atlas
  size_t Stride = 1;                             // step from one of their lights to the next
  vtkMTimeType LightsTime = 0;                   // time at which the lights were read
  bool LightsAreNew = false;                     // the lights were read since UpdateSharing
  bool WithDirections = false;                   // some lights are directions
  // With fewer tiles than lights: the owner of the tile that each light looks up.
  bool Shares = false;
  vtkIndirectDataTexture Owners{ this };
};
