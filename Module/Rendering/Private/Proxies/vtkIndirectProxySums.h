// SPDX-License-Identifier: BSD-3-Clause
// Sums a tree of spheres for what the eye sees: irradiance of the sky that they leave, and of what
// they send. In compute shaders by tiles of 16 x 16 receivers, or by rectangles that are drawn and
// blended; both give the same within rounding.
#ifndef vtkIndirectProxySums_h
#define vtkIndirectProxySums_h

#include "OpenGL/vtkIndirectCommandBuffer.h"     // for a member
#include "OpenGL/vtkIndirectComputeProgram.h"    // for members
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectTarget.h"            // for members
#include "Proxies/vtkIndirectProxyLight.h"       // for a member
#include "Proxies/vtkIndirectProxyTreeTables.h"  // for a member
#include "Splatting/vtkIndirectSplatMesh.h"      // for a member

#include <string> // for texts

class vtkIndirectGeometryBuffer;
struct vtkIndirectFrame;

class vtkIndirectProxySums
{
public:
  vtkIndirectProxySums();

  /** Whether this OpenGL sums in tiles now; see vtkIndirectPaths. */
  static bool UsesTiles();

  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectGeometryBuffer& Geometry;
    int Step = 1;            // every so many pixels is a receiver
    bool Hides = true;       // else nothing hides the sky
    bool Middle = false;     // radiance of spheres at their middles
    bool Exact = false;      // radiance of spheres at each place of theirs
    bool Shadowed = true;    // spheres hide the light from each other that they send
    double LightReach = 0.0; // radii within which a sphere sends; 0: everywhere
  };

  /** Uploads entries. Returns false, after an error, when OpenGL refuses. */
  bool Update(vtkOpenGLRenderWindow* window, const vtkIndirectProxyTree& tree,
    const std::vector<vtkIndirectProxyPolygon>& polygons);
  /** The light that all is summed under; null: none. After Update. */
  void SetEnvironment(vtkOpenGLRenderWindow* window, vtkEnvironmentLight* environment);

  /**
   * Fills an image of the frame's size, of RGBA32F: irradiance of the sky and, in a second channel
   * if it has that, of what proxies send. Within a vtkIndirectFullScreenState. Returns false when a
   * program does not compile.
   */
  bool Sum(const Input& input, vtkIndirectTarget& image);

  size_t GetBytes() const;
  void Release(vtkWindow* window);

private:
  void Activate(const Input& input, vtkShaderProgram* program) const;
  void Deactivate(const Input& input) const;
  bool LightSenders(const Input& input);
  bool SumInTiles(
    const Input& input, const std::string& definitions, vtkIndirectTarget& image, int mode);
  static void BindImages(vtkIndirectTarget& target, int unit, bool binds);
  bool SumRest(const Input& input, const std::string& definitions, vtkIndirectTarget& image);
  bool ChooseRest(const Input& input, vtkIndirectTarget& image);
  bool ShareRest(const Input& input, const std::string& definitions, vtkIndirectTarget& image);
  bool SumBlended(const Input& input, const std::string& definitions, vtkIndirectTarget& image);
  bool Splat(const Input& input, const std::string& definitions);
  bool Upsample(const Input& input, const std::string& definitions, vtkIndirectTarget& image);

  vtkIndirectProxyTreeTables Tables;
  vtkIndirectProxyLight Light;
  bool Changed = true; // since the light was set
  bool SendersAreLit = false;
  int CoarseSize[2] = { 0, 0 };
  vtkIndirectTarget SenderLight; // what falls on senders
  vtkIndirectTarget AllLight;    // the same, and means of it, in pairs
  vtkIndirectTarget Coarse;
  vtkIndirectTarget Shared;  // receivers of tiles
  vtkIndirectTarget Counts;  // of them
  vtkIndirectTarget Blended; // sums
  vtkIndirectSplatMesh Mesh;
  vtkIndirectCommandBuffer Rest{ 2 }; // tiles' receivers, pixels that they serve
  vtkIndirectComputeProgram Choosing{ "vtkIndirectProxyChooseCS.glsl" };
  vtkIndirectComputeProgram Sharing{ "vtkIndirectProxyShareCS.glsl" };
  // Of coarse receivers, of all pixels, of tiles' receivers, of senders.
  vtkIndirectComputeProgram Tiles[4]{ vtkIndirectComputeProgram("vtkIndirectProxyTilesCS.glsl"),
    vtkIndirectComputeProgram("vtkIndirectProxyTilesCS.glsl"),
    vtkIndirectComputeProgram("vtkIndirectProxyTilesCS.glsl"),
    vtkIndirectComputeProgram("vtkIndirectProxyTilesCS.glsl") };
  vtkIndirectFullScreenProgram Sending{ "vtkIndirectProxySendersFS.glsl" };
  vtkIndirectFullScreenProgram Averaging{ "vtkIndirectProxySendersFS.glsl" };
  vtkIndirectFullScreenProgram Upsampling{ "vtkIndirectProxyUpsampleFS.glsl" };
  vtkIndirectFullScreenProgram Background{ "vtkIndirectClearFS.glsl" };
  vtkIndirectFullScreenProgram Resolving{ "vtkIndirectProxyResolveFS.glsl" };
};
#endif
