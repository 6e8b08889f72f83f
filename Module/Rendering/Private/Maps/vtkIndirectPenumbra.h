// SPDX-License-Identifier: BSD-3-Clause
// Depth maps of lights that have a size, one from each of a few points of the light: mappers'
// shaders take the mean of what these maps see of a receiver (vtkIndirectPenumbra.glsl). The mean
// converges to the truth with the number of points. A single map from the centre, blurred by the
// distance of the blocker that it finds, would not converge, because the light's border sees behind
// the blocker. Maps are kept while the camera moves.
//
// Limits: blockers thinner than a texel (bias of either sign), and the sharpness of a shadow within
// two texels of a contact. The steps of single points show as bands where a penumbra is many texels
// wide.
#pragma once

#include "Capture/vtkIndirectShadowMaps.h"       // for the maps that the capture reads
#include "Maps/vtkIndirectDepthMaps.h"           // for depth maps
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for a member
#include "OpenGL/vtkIndirectResource.h"          // for the base class
#include "OpenGL/vtkIndirectTarget.h"            // for a member

#include <cstddef> // for size_t
#include <vector>  // for lists

class vtkIndirectLightMap;
class vtkIndirectLightMaps;
class vtkSurfaceCapturePass;
struct vtkIndirectFrame;
struct vtkIndirectReport;

class vtkIndirectPenumbra : public vtkIndirectResource
{
public:
  vtkIndirectPenumbra(vtkIndirectResource* owner, vtkIndirectDepthMaps& maps);
  ~vtkIndirectPenumbra() override;

  /**
   * Brings the maps of lights up to date that have a size and a map from their centre; the centre's
   * map gives the light's place and reach. The capture stays attached. Returns false, after an
   * error, when OpenGL refuses.
   */
  bool Update(const vtkIndirectFrame& frame, const vtkIndirectLightMaps& maps,
    vtkSurfaceCapturePass* capture);

  ///@{
  /** Add its maps to the shadows and bind them; pair. */
  void Activate(vtkIndirectShadowMaps& shadows);
  void Deactivate() const;
  ///@}

  void AddToReport(vtkIndirectReport& report) const;

  /**
   * A light's maps: numbers for shaders, a tile for each point and face, and the wanted number of
   * texels along a tile's edge.
   */
  struct Light
  {
    vtkIndirectPenumbraMap Map;
    std::vector<vtkIndirectDepthTile> Tiles;
    double Texels = 0.0;
  };
  /** Fits the maps of a light to the casters. */
  static Light Fit(const vtkIndirectFrame& frame, const vtkIndirectLightMap& centre);

protected:
  /** Releases the maps: shaders look up no penumbra. */
  void ReleaseOwn(vtkWindow* window) override;

private:
  bool JoinTexels(const vtkIndirectFrame& frame);

  vtkIndirectDepthMaps& DepthMaps;
  const vtkIndirectDepthAtlas& Atlas;
  std::vector<Light> Lights;
  int Texels = 0;          // along an edge of a tile
  vtkIndirectTarget Tiles; // maps that shaders read
  vtkIndirectFullScreenProgram Kernel{ this, "vtkIndirectPenumbraTilesFS.glsl" };
  size_t Joined = 0; // number of tiles that had been drawn by the last JoinTexels
};
