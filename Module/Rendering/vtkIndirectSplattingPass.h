// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkIndirectSplattingPass
 * @brief Light of virtual lights, each of which is summed only where it matters
 *
 * Dachsbacher and Stamminger 2006, "Splatting indirect illumination": a splat is drawn for each
 * virtual light and added. It covers the pixels that the light may give more than I_low, an
 * intensity over a squared distance. The bound is an ellipsoid about the iso-surface where the
 * light reaches I_low (section 3.4 and appendix of the paper); see IntensityThreshold.
 *
 * Differences from the paper:
 * - The light's irradiance is that of vtkRSMGatherPass, the disk kernel, which needs no clamp.
 *   Inside its iso-surface the light counts, outside it does not, even within the ellipsoid.
 * - If lights have branches (vtkLightTreeSampler), receivers near a light sum its branches, as the
 *   gather does, and the bound holds all of them.
 * - The light that the bounds cut off is not lost: it varies slowly, and is summed at every
 *   FarFieldStep-th pixel and interpolated (FarField). The report has its share of the irradiance,
 *   by luminance, at these pixels, or without FarField at every 16th one.
 * - Sums do not depend on an order of drawing: splats are blended in 32-bit floats in the order of
 *   the lights, or, with OpenGL 4.3, summed in that order in tiles of 16 x 16 pixels, each of which
 *   lists the ellipsoids that its surfaces meet.
 *
 * Approximations: those of vtkRSMGatherPass over the same lights, to which the result converges as
 * IntensityThreshold goes to 0, and the far field's interpolation, of either sign. Without FarField
 * the light that is cut off is lost (bias <= 0).
 *
 * Buffers (vtkIndirectIlluminationPass::DebugView, CopyBuffer): `splat.overdraw`, the number of
 * splats at each pixel over 256 (figure 8 of the paper).
 *
 * Receivers with Phong's model and a specular coefficient also reflect the lights in their lobes:
 * all of them, summed at each of their pixels; see SpecularTransport.
 *
 * Lobes of specular senders have splats of their own beside the light's (section 3.3): an ellipsoid
 * about the surface where the lobe, normalised and widened near its light, reaches I_low. The light
 * that these splats cut off is measured and restored with the rest.
 *
 * The preset PAPER (SetPreset) is the method as published: I_low of 0.05, light beyond the bounds
 * is lost, and 768 lights by hierarchical warping (vtkImportanceLightSampler).
 *
 * Memory: 16 bytes a pixel, 32 for each sample of the far field, and 32 a light, 64 if lights have
 * lobes.
 */

#ifndef vtkIndirectSplattingPass_h
#define vtkIndirectSplattingPass_h

#include "vtkIndirectEstimatorPass.h"
#include "vtkIndirectSettings.h"        // For properties
#include "vtkRenderingIndirectModule.h" // For export macro

class VTKRENDERINGINDIRECT_EXPORT vtkIndirectSplattingPass final : public vtkIndirectEstimatorPass
{
public:
  static vtkIndirectSplattingPass* New();
  vtkTypeMacro(vtkIndirectSplattingPass, vtkIndirectEstimatorPass);

  const char* GetMethodName() const override { return "splatting"; }

  ///@{
  /**
   * The lowest intensity over a squared distance at which a virtual light counts is I_low =
   * IntensityThreshold * I0 / l^2. I0 is the mean intensity of the frame's virtual lights along
   * their normals, with the light of lobes taken as diffuse; l is a twentieth of the diagonal of
   * the scene's bounds. The mean light reaches l / sqrt(IntensityThreshold): half a diagonal for
   * 0.01, 0.22 for 0.05, 0.16 for 0.1, whatever the number of lights. A light of four times that
   * intensity reaches twice as far, and a lobe of exponent P and the same flux sqrt((P + 1) / 2)
   * times as far. 0: all lights count everywhere. Default 0.02, range 0 to 1.
   */
  vtkIndirectClampMacro(IntensityThreshold, double, 0.0, 1.0);
  ///@}

  ///@{
  /**
   * Restore the light that the bounds cut off, as a term that is interpolated between every
   * FarFieldStep-th pixels. Splats then end smoothly, from 2 I_low to I_low. Without it each splat
   * ends with a step of up to I_low times the receiver's cosine, as in the paper, and the picture
   * is darker. Default on.
   */
  vtkIndirectFlagMacro(FarField);
  ///@}

  ///@{
  /** Pixels from one sample of the far field to the next. Default 8, range 2 to 64. */
  vtkIndirectClampMacro(FarFieldStep, int, 2, 64);
  ///@}

protected:
  vtkIndirectSplattingPass();
  ~vtkIndirectSplattingPass() override = default;

  void ApplyPreset() override;
  vtkSmartPointer<vtkVirtualLightSampler> MakeSamplerOfPaper() const override;

private:
  vtkIndirectSplattingPass(const vtkIndirectSplattingPass&) = delete;
  void operator=(const vtkIndirectSplattingPass&) = delete;

  struct SettingsType
  {
    double IntensityThreshold = 0.02;
    bool FarField = true;
    int FarFieldStep = 8;
  };
  SettingsType Settings;
};

#endif
