// SPDX-License-Identifier: BSD-3-Clause
// Irradiance that comes directly from an environment: summed at every pixel over directions that
// are fixed in the world, each with a depth map of the scene. Turning or changing the environment
// changes weights alone; maps are kept while the camera moves.
//
// What it ignores: directions between those of the lattice (bias of either sign, less than 0.2 % of
// an open plane for 64), surfaces finer than a tile's texel (too dark in relief, too bright at
// contacts).
#ifndef vtkIndirectSkyGather_h
#define vtkIndirectSkyGather_h

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for a member
#include "OpenGL/vtkIndirectTarget.h"            // for a member
#include "OpenGL/vtkIndirectUniformBlock.h"      // for a member
#include "Visibility/vtkIndirectDepthAtlas.h"    // for a member

#include <glm/glm.hpp> // for directions
#include <vector>      // for lists

class vtkEnvironmentLight;
class vtkIndirectGeometryBuffer;
class vtkSurfaceCapturePass;
struct vtkIndirectFrame;
struct vtkIndirectPlan;
struct vtkIndirectReport;

class vtkIndirectSkyGather
{
public:
  vtkIndirectSkyGather();

  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectPlan& Plan;
    const vtkIndirectGeometryBuffer& Geometry;
    vtkSurfaceCapturePass* Capture;
    vtkEnvironmentLight* Environment;
  };

  /** Brings the depth maps up to date. Returns false, after an error, when OpenGL refuses. */
  bool UpdateMaps(const Input& input);
  /** Grows when maps or weights have changed. */
  size_t GetContentTime() const { return this->ContentTime; }
  /** Sums. Returns false, after an error. */
  bool Sum(const Input& input);

  /** Irradiance in VTK's units, a value for every pixel. */
  const vtkIndirectTarget& GetIrradiance() const { return this->Irradiance; }

  size_t GetNumberOfTilesDrawn() const { return this->Atlas.GetNumberOfTilesDrawn(); }
  size_t GetBytes() const;
  void AddToReport(vtkIndirectReport& report) const;
  void Release(vtkWindow* window);

private:
  void UpdateDirections(const Input& input);
  void FitTiles(const vtkIndirectFrame& frame);
  std::vector<glm::vec4> MakeBlock(const vtkIndirectFrame& frame, size_t first, size_t count) const;

  vtkIndirectTarget Irradiance;
  vtkIndirectDepthAtlas Atlas;
  vtkIndirectUniformBlock Block{ "vtkiSkyBlock" };
  vtkIndirectFullScreenProgram Kernel{ "vtkIndirectSkyFS.glsl" };

  std::vector<glm::dvec3> Directions; // the lattice
  std::vector<glm::dvec3> Light;      // radiance times solid angle, a value for each
  std::vector<vtkIndirectDepthAtlas::Emitter> Emitters;
  std::vector<size_t> Lit;                  // numbers of those that send anything
  vtkEnvironmentLight* Projected = nullptr; // whose light that is, and its time
  vtkMTimeType ProjectedTime = 0;
  std::vector<double> FitKey; // what the tiles are fitted to
  bool Visible = false;
  size_t ContentTime = 0;
};

#endif
