// SPDX-License-Identifier: BSD-3-Clause
// Sums a tree of spheres at the visible surfaces: irradiance of the sky that they leave visible,
// and of their own light. Compute shaders sum in tiles of 16 x 16 receivers, or rectangles are
// drawn and blended; both give the same result within rounding.
#pragma once

#include "OpenGL/vtkIndirectCommandBuffer.h"     // for a member
#include "OpenGL/vtkIndirectComputeProgram.h"    // for members
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectPointProgram.h"      // for a member
#include "OpenGL/vtkIndirectResource.h"          // for the base class
#include "OpenGL/vtkIndirectTarget.h"            // for members
#include "Proxies/vtkIndirectProxyLight.h"       // for a member
#include "Proxies/vtkIndirectProxyTreeTables.h"  // for a member
#include "Splatting/vtkIndirectSplatMesh.h"      // for a member
#include "Sums/vtkIndirectReceiverGrid.h"        // for a member

#include <string> // for texts

class vtkIndirectGeometryBuffer;
struct vtkIndirectFrame;

class vtkIndirectProxySums : public vtkIndirectResource
{
public:
  explicit vtkIndirectProxySums(vtkIndirectResource* owner);

  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectGeometryBuffer& Geometry;
    int Step = 1;             // pixels from one receiver to the next
    int Upsampling = 0;       // vtkProxyAccumulationPass::UpsamplingType
    bool Hides = true;        // false: the sky is unoccluded
    bool EyeIsInside = false; // a sphere contains the eye
    bool Middle = false;      // radiance of spheres at their middles
    bool Exact = false;       // radiance of spheres at each of their points
    bool Shadowed = true;     // spheres occlude each other's light
    double LightReach = 0.0;  // radii within which a sphere sends; 0: everywhere
  };

  /** Uploads entries. Returns false, after an error, if OpenGL refuses. */
  bool Update(vtkOpenGLRenderWindow* window, const vtkIndirectProxyTree& tree,
    const std::vector<vtkIndirectProxyPolygon>& polygons);
  /** Sets the environment of the sums; null: none. After Update. */
  void SetEnvironment(vtkOpenGLRenderWindow* window, vtkEnvironmentLight* environment);

  /**
   * Fills an image of the frame's size, of RGBA32F: irradiance of the sky and, in a second channel
   * if present, of the proxies' light. Within a vtkIndirectFullScreenState. Returns false if a
   * program does not compile.
   */
  bool Sum(const Input& input, vtkIndirectTarget& image);

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  void Activate(const Input& input, const vtkIndirectProgram& program) const;
  bool LightSenders(const Input& input);
  bool SumInTiles(
    const Input& input, const std::string& definitions, vtkIndirectTarget& image, int mode);
  bool SumRest(const Input& input, const std::string& definitions, vtkIndirectTarget& image);
  bool ChooseRest(const Input& input, vtkIndirectTarget& image);
  bool ShareRest(const Input& input, const std::string& definitions, vtkIndirectTarget& image);
  bool SumBlended(const Input& input, const std::string& definitions, vtkIndirectTarget& image);
  bool Splat(const Input& input, const std::string& definitions);
  bool Upsample(const Input& input, const std::string& definitions, vtkIndirectTarget& image);

  vtkIndirectProxyTreeTables Tables{ this };
  vtkIndirectProxyLight Light{ this };
  bool Changed = true; // since the light was set
  bool SendersAreLit = false;
  int CoarseSize[2] = { 0, 0 };
  vtkIndirectTarget SenderLight; // light that falls on senders
  vtkIndirectTarget AllLight;    // that light and its means, in pairs
  vtkIndirectReceiverGrid Coarse;
  vtkIndirectTarget Shared;  // receivers of tiles
  vtkIndirectTarget Counts;  // number of receivers
  vtkIndirectTarget Blended; // sums
  vtkIndirectSplatMesh Mesh{ this };
  vtkIndirectCommandBuffer Rest{ this, 2 }; // tiles' receivers, and the pixels that they represent
  vtkIndirectComputeProgram Choosing{ this, "vtkIndirectProxyChooseCS.glsl" };
  vtkIndirectComputeProgram Sharing{ this, "vtkIndirectProxyShareCS.glsl" };
  // They sum at coarse receivers, at all pixels, at tiles' receivers and at senders.
  vtkIndirectComputeProgram Tiles[4]{ { this, "vtkIndirectProxyTilesCS.glsl" },
    { this, "vtkIndirectProxyTilesCS.glsl" }, { this, "vtkIndirectProxyTilesCS.glsl" },
    { this, "vtkIndirectProxyTilesCS.glsl" } };
  vtkIndirectFullScreenProgram Sending{ this, "vtkIndirectProxySendersFS.glsl" };
  vtkIndirectFullScreenProgram Averaging{ this, "vtkIndirectProxySendersFS.glsl" };
  vtkIndirectPointProgram Splatting{ this, "vtkIndirectProxySplatVS.glsl",
    "vtkIndirectProxySplatFS.glsl" };
  vtkIndirectFullScreenProgram Upsampling{ this, "vtkIndirectProxyUpsampleFS.glsl" };
  vtkIndirectFullScreenProgram Resolving{ this, "vtkIndirectProxyResolveFS.glsl" };
};
