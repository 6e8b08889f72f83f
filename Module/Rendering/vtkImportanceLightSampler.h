// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkImportanceLightSampler
 * @brief Virtual lights drawn from the lights' maps where most light comes from
 *
 * After Dachsbacher and Stamminger 2006, "Splatting indirect illumination", section 3.5: sums of
 * the texels' reflected flux over squares of them, on the card, and a low-discrepancy pattern that
 * is warped by these from the coarsest level on (equations 4 to 6). All lights of the scene share
 * NumberOfLights by this importance. Each virtual light is divided by the probability
 * that it was drawn with, exactly, so that sums have no bias; nothing is drawn where nothing is
 * lit.
 *
 * Where a headlight is the only light, as many even ones are made of what the eye sees. Where
 * texels reflect alike, lights are those of vtkUniformLightSampler. Approximations: none in the
 * sums; of maps of more than 256 texels along an edge one texel stands for several.
 * Documentation/methods/importance-sampling.md says where it pays.
 */

#ifndef vtkImportanceLightSampler_h
#define vtkImportanceLightSampler_h

#include "vtkIndirectSettings.h"        // For properties
#include "vtkRenderingIndirectModule.h" // For export macro
#include "vtkVirtualLightSampler.h"

class VTKRENDERINGINDIRECT_EXPORT vtkImportanceLightSampler : public vtkVirtualLightSampler
{
public:
  static vtkImportanceLightSampler* New();
  vtkTypeMacro(vtkImportanceLightSampler, vtkVirtualLightSampler);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum WarpingType
  {
    APART = 0,   // a square's halves are warped by their own sums: the paper's method A
    TOGETHER = 1 // both halves by their common sums: method B, with lights of unlike weights
  };

  ///@{
  /** The way in which squares are warped. Default APART. */
  vtkIndirectClampMacro(Warping, int, APART, TOGETHER);
  void SetWarpingToApart() { this->SetWarping(APART); }
  void SetWarpingToTogether() { this->SetWarping(TOGETHER); }
  ///@}

  ///@{
  /**
   * Levels of the warp, from the coarsest on; below these, lights are spread evenly over what sends
   * light. Default 0: all of them; range 0 to 10. The paper has 1 to 4.
   */
  vtkIndirectClampMacro(Levels, int, 0, 10);
  ///@}

  ///@{
  /**
   * Share of lights that is spread evenly over the texels that send light, within each light of the
   * scene. It bounds the area that a virtual light stands for, where surfaces reflect little.
   * Default 0.25, range 0 to 1.
   */
  vtkIndirectClampMacro(Evenness, double, 0.0, 1.0);
  ///@}

  ///@{
  /**
   * Weight of texels that have other surfaces near them, which their light has an effect on: the
   * flux is multiplied by 1/64 + 1 - Occlusion * O, O the share of the hemisphere
   * above a texel that no surface in the light's map fills within a tenth of the scene's diagonal.
   * At 1 it is the paper's (1 - O), but that every texel that sends light may be drawn. Surfaces
   * that the light does not see are left out: O is too large there, the sums are right all the
   * same. Default 0.9, range 0 to 1.
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
