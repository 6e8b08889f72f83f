// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRSMGatherPass
 * @brief Light summed at each pixel over senders: virtual lights of all bounces, or texels of the
 * lights' maps
 *
 * Equation: E(x) = sum over senders p of B_p A_p cosS cosR / (pi r^2 + A_p), the disk kernel in
 * place of equation (1) of Dachsbacher and Stamminger 2005, "Reflective shadow maps". B_p A_p comes
 * from the maps (vtkReflectiveShadowMapPass).
 *
 * Modes:
 * - ALL_TEXELS: every texel of every map is a sender; the reference for the other two. Its time
 * grows with pixels times texels.
 * - VIRTUAL_LIGHTS: the lights of the sampler, the same for all pixels.
 * - NEIGHBORHOOD: the paper's own method: per pixel, texels in a disk around the pixel's place in
 *   each map. Its expectation is the sum restricted to that disk; light from outside is lost (bias
 *   <= 0), and the report says so.
 *
 * Receivers with a specular coefficient also reflect the same senders in their lobes, summed at
 * each of their pixels with and without interpolation; see SpecularTransport.
 *
 * Approximations: depth maps or voxels hide virtual lights (Visibility of the pass), with the error
 * of their resolution. Only voxels hide texels, otherwise nothing does (bias >= 0), and texels
 * give one bounce (<= 0). Senders of later bounces are diffuse (<= 0). The kernel is low where
 * r^2 < A, by about -0.6 / sqrt(N) for walls that meet, except for lights of a tree.
 *
 * Interpolation (section 5.2 of the paper): the sum is taken at every InterpolationStep-th pixel
 * and interpolated where three of the four around lie on the same surface; other pixels sum for
 * themselves.
 *
 * The preset PAPER (SetPreset) is the paper's method as published: NEIGHBORHOOD with 308 samples in
 * a disk of radius 0.3, and 64 sums along the longer edge of the picture.
 */

#ifndef vtkRSMGatherPass_h
#define vtkRSMGatherPass_h

#include "vtkIndirectEstimatorPass.h"
#include "vtkIndirectSettings.h"        // For properties
#include "vtkRenderingIndirectModule.h" // For export macro

class VTKRENDERINGINDIRECT_EXPORT vtkRSMGatherPass final : public vtkIndirectEstimatorPass
{
public:
  static vtkRSMGatherPass* New();
  vtkTypeMacro(vtkRSMGatherPass, vtkIndirectEstimatorPass);

  const char* GetMethodName() const override { return "gather"; }

  enum ModeType
  {
    ALL_TEXELS = 0,
    VIRTUAL_LIGHTS = 1,
    NEIGHBORHOOD = 2
  };

  ///@{
  /** The senders that are summed. Default VIRTUAL_LIGHTS. */
  vtkIndirectClampMacro(Mode, int, ALL_TEXELS, NEIGHBORHOOD);
  void SetModeToAllTexels() { this->SetMode(ALL_TEXELS); }
  void SetModeToVirtualLights() { this->SetMode(VIRTUAL_LIGHTS); }
  void SetModeToNeighborhood() { this->SetMode(NEIGHBORHOOD); }
  ///@}

  ///@{
  /** NEIGHBORHOOD: samples per map and pixel. Default 256, range 1 to 65536. */
  vtkIndirectClampMacro(NumberOfSamples, int, 1, 65536);
  ///@}

  ///@{
  /**
   * NEIGHBORHOOD: radius of the disk as a fraction of the map's width. Default 0.3, range 0.001 to
   * 1.5; with 1.5 the disk covers a map of one face from everywhere in it. On the cube of a point
   * or wide spot light it lies about the receiver's direction, across faces, up to an angle of
   * atan(2 radius): 31 degrees for 0.3, 72 for 1.5.
   */
  vtkIndirectClampMacro(NeighborhoodRadius, double, 0.001, 1.5);
  ///@}

  ///@{
  /** Interpolate pixels from coarser samples. Default on; no effect with ALL_TEXELS. */
  vtkIndirectFlagMacro(Interpolation);
  ///@}

  ///@{
  /**
   * Pixels from one coarse sample to the next. 0: as many as leave 64 samples along the longer edge
   * of the picture, as in the paper, at most 32; 1: every pixel is summed. Default 4, range 0
   * to 32.
   */
  vtkIndirectClampMacro(InterpolationStep, int, 0, 32);
  ///@}

protected:
  vtkRSMGatherPass();
  ~vtkRSMGatherPass() override = default;

  void ApplyPreset() override;

private:
  vtkRSMGatherPass(const vtkRSMGatherPass&) = delete;
  void operator=(const vtkRSMGatherPass&) = delete;

  struct SettingsType
  {
    int Mode = VIRTUAL_LIGHTS;
    int NumberOfSamples = 256;
    double NeighborhoodRadius = 0.3;
    bool Interpolation = true;
    int InterpolationStep = 4;
  };
  SettingsType Settings;
};

#endif
