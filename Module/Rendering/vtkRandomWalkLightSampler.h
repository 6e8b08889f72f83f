// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRandomWalkLightSampler
 * @brief Virtual lights without light maps: where paths from the lights meet surfaces
 *
 * Rays leave the lights by a low-discrepancy sequence and go on, by diffuse reflection, through the
 * scene's triangles. Each place that a path meets is a virtual light of one bounce more than the
 * one before it (Keller 1997, "Instant radiosity"; Dachsbacher and Stamminger 2006, "Splatting
 * indirect illumination", section 3.7). So there are lights of all bounces up to
 * vtkIndirectIlluminationPass::NumberOfBounces, for every estimator that sums virtual lights, and
 * the only maps are those for shadows of direct light.
 *
 * Rays meet the polygons that VTK's mappers draw, glyphs and spheres of impostors, lit as VTK
 * lights them: properties, scalars' and blocks' colours, textures, interpolated normals, culling.
 * Props with neither polygons that the processor can read nor spheres do not stop rays and send no
 * light of them; the report names such props. The tree of triangles is made again only when
 * geometry changes, paths only when lights or surfaces do; the report counts both (walks,
 * walk_trees). A light that moves a little moves the virtual lights a little.
 *
 * There are about NumberOfLights virtual lights, over all lights of the scene and all bounces
 * together: the number of paths is chosen for this expected number of vertices.
 */

#ifndef vtkRandomWalkLightSampler_h
#define vtkRandomWalkLightSampler_h

#include "vtkIndirectSettings.h"        // For properties
#include "vtkRenderingIndirectModule.h" // For export macro
#include "vtkVirtualLightSampler.h"

class VTKRENDERINGINDIRECT_EXPORT vtkRandomWalkLightSampler final : public vtkVirtualLightSampler
{
public:
  static vtkRandomWalkLightSampler* New();
  vtkTypeMacro(vtkRandomWalkLightSampler, vtkVirtualLightSampler);

  ///@{
  /**
   * First bounce whose lights are made: 2 adds the bounces that a sampler of the first bounce
   * leaves out, for vtkIndirectIlluminationPass::AddSampler. Default 1, range 1 to 16.
   */
  vtkIndirectClampMacro(FirstBounce, int, 1, 16);
  ///@}

  ///@{
  /**
   * Approximate number of vertices of paths that the lights are made of, as vtkLightTreeSampler
   * makes lights of maps' texels: at most NumberOfLights clusters, with branches that near
   * receivers sum. In changing scenes, while the window's rate is a frame a second or more
   * (vtkRenderWindow::SetDesiredUpdateRate), an eighth as many. Default 0: each light is a vertex.
   * Range 0 to 1048576.
   */
  vtkIndirectClampMacro(NumberOfVertices, int, 0, 1048576);
  ///@}

  ///@{
  /**
   * Number of frames over which the walk extends while no light and no surface changes, and the
   * window's rate is below a frame a second (vtkRenderWindow::SetDesiredUpdateRate): the second
   * frame has twice as many paths as the first, and so on; 1048576 vertices at most. Any change
   * begins a new walk. Default 1, range 1 to 1024.
   */
  vtkIndirectClampMacro(NumberOfFrames, int, 1, 1024);
  ///@}

protected:
  vtkRandomWalkLightSampler();
  ~vtkRandomWalkLightSampler() override = default;

  struct SettingsType
  {
    int FirstBounce = 1;
    int NumberOfVertices = 0;
    int NumberOfFrames = 1;
  };
  SettingsType Settings;

private:
  vtkRandomWalkLightSampler(const vtkRandomWalkLightSampler&) = delete;
  void operator=(const vtkRandomWalkLightSampler&) = delete;
};

#endif
