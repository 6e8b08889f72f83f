// SPDX-License-Identifier: BSD-3-Clause
// Irradiance that comes directly from an environment: summed at every pixel over directions that
// are fixed in the world, each with a depth map of the scene. Turning or changing the environment
// changes weights alone; maps are kept while the camera moves.
//
// A direction that much of the light comes from, such as that of a sun, has a finer map and
// filtered edges of its shadows.
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

  size_t GetNumberOfTilesDrawn() const;
  size_t GetBytes() const;
  void AddToReport(vtkIndirectReport& report) const;
  void Release(vtkWindow* window);

private:
  // Directions that are summed alike, their maps and the program.
  struct Group
  {
    std::vector<size_t> Members; // numbers of directions
    std::vector<vtkIndirectDepthAtlas::Emitter> Emitters;
    int Texels = 0;
    vtkIndirectDepthAtlas Atlas;
    vtkIndirectFullScreenProgram Kernel{ "vtkIndirectSkyFS.glsl" };
  };

  void UpdateDirections(const Input& input);
  void FitTiles(const vtkIndirectFrame& frame);
  std::vector<glm::vec4> MakeBlock(const Group& group, size_t first, size_t count) const;
  bool SumGroup(const Input& input, Group& group, bool adds);

  vtkIndirectTarget Irradiance;
  enum GroupType
  {
    Strong,
    Others,
    NumberOfGroups
  };
  Group Groups[NumberOfGroups];
  vtkIndirectUniformBlock Block{ "vtkiSkyBlock" };

  std::vector<glm::dvec3> Directions;       // the lattice
  std::vector<glm::dvec3> Light;            // radiance times solid angle, a value for each
  vtkEnvironmentLight* Projected = nullptr; // whose light that is, and its time
  vtkMTimeType ProjectedTime = 0;
  std::vector<double> FitKey; // what the tiles are fitted to
  bool Visible = false;
  size_t ContentTime = 0;
};

#endif
