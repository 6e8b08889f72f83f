// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkImportanceLightSampler
 * @brief Virtual lights drawn from the lights' maps where most light comes from
 *
 * After Dachsbacher and Stamminger 2006, "Splatting indirect illumination", section 3.5: the GPU
 * sums the texels' reflected flux over squares of texels. These sums warp a low-discrepancy pattern
 * from the coarsest level on (equations 4 to 6). All lights of the scene share NumberOfLights by
 * this importance. Each virtual light is divided by the exact probability with which it was drawn,
 * so that sums have no bias; no light is drawn from unlit texels.
 *
 * For a headlight that is the only light, the sampler makes as many uniform lights of the surfaces
 * that the eye sees. Where texels reflect equally, lights are those of vtkUniformLightSampler.
 * Approximations: none in the sums; in maps of more than 256 texels along an edge one texel
 * represents several. Documentation/methods/importance-sampling.md says where the method pays off.
 */

#ifndef vtkImportanceLightSampler_h
#define vtkImportanceLightSampler_h

#include "vtkIndirectSettings.h"        // For properties
#include "vtkRenderingIndirectModule.h" // For export macro
#include "vtkVirtualLightSampler.h"

class VTKRENDERINGINDIRECT_EXPORT vtkImportanceLightSampler final : public vtkVirtualLightSampler
{
public:
  static vtkImportanceLightSampler* New();
  vtkTypeMacro(vtkImportanceLightSampler, vtkVirtualLightSampler);

  enum WarpingType
  {
    APART = 0,   // a square's halves are warped by their own sums: the paper's method A
    TOGETHER = 1 // both halves by their common sums: method B, with lights of unlike weights
  };

  ///@{
  /** The method by which squares are warped. Default APART. */
  vtkIndirectClampMacro(Warping, int, APART, TOGETHER);
  void SetWarpingToApart() { this->SetWarping(APART); }
  void SetWarpingToTogether() { this->SetWarping(TOGETHER); }
  ///@}

  ///@{
  /**
   * Levels of the warp, from the coarsest on; below these, lights are spread uniformly over texels
   * that send light. Default 0: all levels; range 0 to 10. The paper has 1 to 4.
   */
  vtkIndirectClampMacro(Levels, int, 0, 10);
  ///@}

  ///@{
  /**
   * Share of lights that is spread uniformly over the texels that send light, within each light of
   * the scene. It bounds the area that a virtual light represents where surfaces reflect little.
   * Default 0.25, range 0 to 1.
   */
  vtkIndirectClampMacro(Evenness, double, 0.0, 1.0);
  ///@}

  ///@{
  /**
   * Weight of texels near other surfaces, which their light affects: the flux is multiplied by 1/64
   * + 1 - Occlusion * O, where O is the share of the hemisphere above a texel that no surface in
   * the light's map fills within a tenth of the scene's diagonal. At 1 it is the paper's (1 - O),
   * except that every texel that sends light may be drawn. Surfaces that the light does not see are
   * ignored: there O is too large, but the sums remain correct. Default 0.9, range 0 to 1.
   */
  vtkIndirectClampMacro(Occlusion, double, 0.0, 1.0);
  ///@}

protected:
  vtkImportanceLightSampler();
  ~vtkImportanceLightSampler() override = default;

  struct SettingsType
  {
    int Warping = APART;
    int Levels = 0;
    double Evenness = 0.25;
    double Occlusion = 0.9;
  };
  SettingsType Settings;

private:
  vtkImportanceLightSampler(const vtkImportanceLightSampler&) = delete;
  void operator=(const vtkImportanceLightSampler&) = delete;
};

#endif
