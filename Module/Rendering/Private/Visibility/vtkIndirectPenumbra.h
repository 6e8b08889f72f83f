// SPDX-License-Identifier: BSD-3-Clause
// Depth maps of lights that have a size, one from each of a few points of it: mappers' shaders take
// the mean of what these see of a receiver (vtkIndirectPenumbra.glsl). That converges to the truth
// with the number of points; a single map from the centre, blurred by the distance of what it
// finds, would not, because the light's border sees behind what hides its centre. They are kept
// while the camera moves.
//
// What it ignores: blockers thinner than a texel (bias of either sign), and within two texels of a
// contact how sharp a shadow is. Steps of single points show as bands where a penumbra is many
// texels wide.
#ifndef vtkIndirectPenumbra_h
#define vtkIndirectPenumbra_h

#include "Capture/vtkIndirectShadowMaps.h"       // for what the capture reads
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for a member
#include "OpenGL/vtkIndirectTarget.h"            // for a member
#include "Visibility/vtkIndirectDepthAtlas.h"    // for a member

#include <cstddef> // for size_t
#include <vector>  // for lists

class vtkIndirectLightMap;
class vtkIndirectLightMaps;
class vtkSurfaceCapturePass;
struct vtkIndirectFrame;
struct vtkIndirectReport;

class vtkIndirectPenumbra
{
public:
  vtkIndirectPenumbra();
  ~vtkIndirectPenumbra();

  /**
   * Brings the maps of those lights up to date that have a size and a map of their centre; these
   * say where the light is and how far it reaches. The capture stays attached. Returns false, after
   * an error, when OpenGL refuses.
   */
  bool Update(const vtkIndirectFrame& frame, const vtkIndirectLightMaps& maps,
    vtkSurfaceCapturePass* capture, bool caching);
  /** Gives back what it holds: no shadows are looked up. */
  void Clear(const vtkIndirectFrame& frame);

  /** Adds its maps to the shadows and binds them; pair with Deactivate. */
  void Activate(vtkIndirectShadowMaps& shadows);
  void Deactivate() const;

  size_t GetNumberOfTilesDrawn() const { return this->Atlas.GetNumberOfTilesDrawn(); }
  size_t GetBytes() const { return this->Atlas.GetBytes() + this->Tiles.GetBytes(); }
  void AddToReport(vtkIndirectReport& report) const;
  void Release(vtkWindow* window);

  /**
   * A light's maps: numbers for shaders, a tile for each point and face, and how many texels a
   * tile is to have along an edge.
   */
  struct Light
  {
    vtkIndirectPenumbraMap Map;
    std::vector<vtkIndirectDepthAtlas::Emitter> Emitters;
    double Texels = 0.0;
  };
  /** Fits them to what casts shadows. */
  static Light Fit(const vtkIndirectFrame& frame, const vtkIndirectLightMap& centre);

private:
  bool JoinTexels(const vtkIndirectFrame& frame);

  std::vector<Light> Lights;
  std::vector<vtkIndirectDepthAtlas::Emitter> Emitters;
  int Texels = 0; // along an edge of a tile
  vtkIndirectDepthAtlas Atlas;
  vtkIndirectTarget Tiles; // as shaders read them
  vtkIndirectFullScreenProgram Kernel{ "vtkIndirectPenumbraTilesFS.glsl" };
  size_t Joined = 0; // how many tiles the atlas had drawn by then
};

#endif
