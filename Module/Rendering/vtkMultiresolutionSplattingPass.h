// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMultiresolutionSplattingPass
 * @brief Light of virtual lights, summed once for each group of similar pixels
 *
 * Nichols and Wyman 2009, "Multiresolution splatting for indirect illumination": the image is cut
 * into subsplats, squares of 1 to 2^n pixels, coarse where one surface fills them and fine at edges
 * and creases. All virtual lights are summed once for each subsplat; from the coarsest level down
 * each is interpolated with neighbours on the same surface.
 *
 * Differences from the paper:
 * - A subsplat is split where its surface leaves a plane, not where its depths differ, so a plane
 *   seen at a grazing angle stays whole (PlaneThreshold). The preset PAPER has the paper's test.
 * - Adjacent subsplats differ by one level at most.
 * - In addition to the irradiance E each subsplat holds the luminance of the vector irradiance,
 *   whose projection on the pixel's own normal corrects E to first order. On curved surfaces this
 *   halves the number of subsplats for the same error.
 * - Neighbours count in the interpolation only if they lie on the same plane, so no light crosses
 *   an edge between two subsplats.
 *
 * The preset PAPER (SetPreset) splits as Nichols and Wyman do, by min-max pyramids of depth and
 * normal from 16 texels on, and interpolates linearly; 256 lights are a regular grid in the lights'
 * maps.
 *
 * Approximations: those of vtkRSMGatherPass over the same lights, to which the result converges as
 * the thresholds go to 0, and the interpolation's error, of either sign.
 *
 * Debug views and buffers (vtkIndirectIlluminationPass::DebugView, CopyBuffer): `subsplat.level`,
 * the level of each pixel's subsplat; `subsplat.outline`, the subsplats over the irradiance;
 * `subsplat.evaluated<n>`, the illumination of level n's own subsplats; `subsplat.upsampled<n>`,
 * level n with all coarser ones interpolated into it. Level 0 is pixels.
 *
 * Receivers with Phong's model and a specular coefficient also reflect the lights in their lobes,
 * from lists of subsplats for each light that are refined by its computed illumination (section 4.1
 * of the paper). The report says whether all lights are summed at every pixel instead, and why.
 *
 * With vtkIndirectIlluminationPass::ErrorTolerance the pass chooses the thresholds in proportion to
 * it, with the defaults for 0.02. A threshold that the user has set stays, whatever its value; the
 * report then names it.
 *
 * Memory: at most 32 bytes a pixel, of which 8 are for the first moving frame; moving frames in which
 * only the camera has changed take 28 more.
 */

#ifndef vtkMultiresolutionSplattingPass_h
#define vtkMultiresolutionSplattingPass_h

#include "vtkIndirectEstimatorPass.h"
#include "vtkIndirectSettings.h"        // For properties
#include "vtkRenderingIndirectModule.h" // For export macro

struct vtkIndirectSubsplatDetails;

class VTKRENDERINGINDIRECT_EXPORT vtkMultiresolutionSplattingPass : public vtkIndirectEstimatorPass
{
public:
  static vtkMultiresolutionSplattingPass* New();
  vtkTypeMacro(vtkMultiresolutionSplattingPass, vtkIndirectEstimatorPass);

  const char* GetMethodName() const override { return "multiresolution"; }

  enum FinestLevelType
  {
    FULL_RESOLUTION = 0,
    HALF_RESOLUTION = 1,
    QUARTER_RESOLUTION = 2,
    EIGHTH_RESOLUTION = 3
  };

  ///@{
  /**
   * The finest subsplats: pixels, or squares of two, four or eight pixels along an edge, which is
   * the paper's maximal refinement level of 1024, 512, 256 or 128 squared for a picture of 1024
   * squared (section 3.3.1). Pixels that lie on no surface of the samples around them are evaluated
   * on their own. Default FULL_RESOLUTION.
   */
  vtkIndirectClampMacro(FinestLevel, int, FULL_RESOLUTION, EIGHTH_RESOLUTION);
  void SetFinestLevelToFullResolution() { this->SetFinestLevel(FULL_RESOLUTION); }
  void SetFinestLevelToHalfResolution() { this->SetFinestLevel(HALF_RESOLUTION); }
  void SetFinestLevelToQuarterResolution() { this->SetFinestLevel(QUARTER_RESOLUTION); }
  void SetFinestLevelToEighthResolution() { this->SetFinestLevel(EIGHTH_RESOLUTION); }
  ///@}

  enum FormFactorType
  {
    PATCH = 0,
    POINT = 1
  };

  ///@{
  /**
   * The form factor of a virtual light at a diffuse receiver. PATCH: that of the surface that the
   * light represents, bounded at contact. POINT: cosS cosR / (pi r^2), equation (1) of the paper,
   * which is too bright nearer than a patch's width; within 1.8 % of that width it stays what it is
   * there, so that images are finite. Default PATCH.
   */
  vtkIndirectClampMacro(FormFactor, int, PATCH, POINT);
  void SetFormFactorToPatch() { this->SetFormFactor(PATCH); }
  void SetFormFactorToPoint() { this->SetFormFactor(POINT); }
  ///@}

  ///@{
  /**
   * PAPER: largest difference between depths in a subsplat, as a fraction of the diagonal of
   * the scene's bounds. Default 0.02, range 0 to 1. 0 splits everything.
   */
  virtual void SetDepthThreshold(double threshold);
  double GetDepthThreshold() const { return this->Settings.DepthThreshold.Value; }
  ///@}

  ///@{
  /**
   * ROBUST: greatest distance of a subsplat's surface from its mean tangent plane, as a fraction of
   * the subsplat's width. Default 0.25, range 0 to 100. 0 splits everything.
   */
  virtual void SetPlaneThreshold(double threshold);
  double GetPlaneThreshold() const { return this->Settings.PlaneThreshold.Value; }
  ///@}

  ///@{
  /**
   * Largest difference between a subsplat's unit normals and their mean; PAPER: range of each of
   * their components. Default 0.2, range 0 to 2. 0 splits everything.
   */
  virtual void SetNormalThreshold(double threshold);
  double GetNormalThreshold() const { return this->Settings.NormalThreshold.Value; }
  ///@}

  ///@{
  /**
   * Equation (2) of the paper: the share alpha of the irradiance that is multiplied by the cosine
   * between normal and eye. Not physical: it darkens. Default 0 (off), range 0 to 1; the paper's is
   * 0.5.
   */
  vtkIndirectClampMacro(SurfaceDetail, double, 0.0, 1.0);
  ///@}

protected:
  vtkMultiresolutionSplattingPass();
  explicit vtkMultiresolutionSplattingPass(std::unique_ptr<vtkIndirectSum> sum);
  ~vtkMultiresolutionSplattingPass() override;

  void ApplyPreset() override;
  vtkSmartPointer<vtkVirtualLightSampler> MakeSamplerOfPaper() const override;

private:
  vtkMultiresolutionSplattingPass(const vtkMultiresolutionSplattingPass&) = delete;
  void operator=(const vtkMultiresolutionSplattingPass&) = delete;

  friend class vtkIndirectSubsplatSum;
  friend struct vtkIndirectSubsplatDetails;
  /**
   * A threshold. One that the user has set stays unchanged; others follow the pass's
   * ErrorTolerance.
   */
  struct Threshold
  {
    double Value;
    double Most;
    bool IsSet = false;
    double Scale(double tolerance) const;
  };
  struct SettingsType
  {
    int FinestLevel = FULL_RESOLUTION;
    int FormFactor = PATCH;
    Threshold DepthThreshold = { 0.02, 1.0 };
    Threshold PlaneThreshold = { 0.25, 100.0 };
    Threshold NormalThreshold = { 0.2, 2.0 };
    double SurfaceDetail = 0.0;
  };
  SettingsType Settings;
  const std::unique_ptr<vtkIndirectSubsplatDetails> Details; // choices of the preset
  void SetThreshold(Threshold& threshold, double value);
};

#endif
