// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMultiresolutionSplattingPass
 * @brief One bounce of light, evaluated once for each group of pixels that looks alike
 *
 * Nichols and Wyman 2009, "Multiresolution splatting for indirect illumination": the image is cut
 * into subsplats, squares of 1 to 2^n pixels, coarse where one surface fills them and fine at edges
 * and creases; all virtual lights are summed once a subsplat; from the coarsest level down each is
 * interpolated with neighbours on the same surface.
 *
 * Where this differs from the paper:
 * - A subsplat is split where its surface leaves a plane, not where its depths differ, so a plane
 *   seen at a grazing angle stays whole (PlaneThreshold). DEPTH_RANGE is the paper's test.
 * - Subsplats that touch differ by one level at most (Balance).
 * - Beside the irradiance E each holds the luminance of the vector irradiance, whose projection on
 *   the pixel's own normal corrects E to first order (NormalCorrection). On curved surfaces this
 *   halves the number of subsplats for the same error.
 * - Neighbours count in the interpolation only when they lie on the same plane, so nothing crosses
 *   an edge that runs between two subsplats.
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
 * of the paper); see GlossyThreshold.
 *
 * With vtkIndirectIlluminationPass::ErrorTolerance the thresholds are chosen by the pass: in
 * proportion, the defaults for 0.02. One that differs from its default is the user's, and stays;
 * the report then says which.
 *
 * Memory: with the default storage, at most 24 bytes a pixel.
 */

#ifndef vtkMultiresolutionSplattingPass_h
#define vtkMultiresolutionSplattingPass_h

#include "vtkIndirectEstimatorPass.h"
#include "vtkRenderingIndirectModule.h" // For export macro

struct vtkIndirectSubsplatSettings;

class VTKRENDERINGINDIRECT_EXPORT vtkMultiresolutionSplattingPass : public vtkIndirectEstimatorPass
{
public:
  static vtkMultiresolutionSplattingPass* New();
  vtkTypeMacro(vtkMultiresolutionSplattingPass, vtkIndirectEstimatorPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  const char* GetMethodName() const override { return "multiresolution"; }
  bool ComputesGlossy() const override { return true; }
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * Most texels along an edge of the coarsest level. Default 64, range 4 to 64; the paper's is 16.
   */
  vtkSetClampMacro(CoarsestResolution, int, 4, 64);
  vtkGetMacro(CoarsestResolution, int);
  ///@}

  enum FinestLevelType
  {
    FULL_RESOLUTION = 0,
    HALF_RESOLUTION = 1
  };

  ///@{
  /**
   * The finest subsplats: pixels, or squares of two by two. With HALF_RESOLUTION pixels that lie on
   * the surface of no sample around them are evaluated on their own. Default FULL_RESOLUTION.
   */
  vtkSetClampMacro(FinestLevel, int, FULL_RESOLUTION, HALF_RESOLUTION);
  vtkGetMacro(FinestLevel, int);
  void SetFinestLevelToFullResolution() { this->SetFinestLevel(FULL_RESOLUTION); }
  void SetFinestLevelToHalfResolution() { this->SetFinestLevel(HALF_RESOLUTION); }
  ///@}

  enum RefinementType
  {
    DEPTH_RANGE = 0,
    PLANE_DEVIATION = 1
  };

  ///@{
  /**
   * What splits a subsplat, and what its neighbours must agree in. DEPTH_RANGE is the paper's test
   * by min-max pyramids (DepthThreshold, and the range of each component of the normal against
   * NormalThreshold), with its interpolation, which takes every neighbour that has illumination.
   * Default PLANE_DEVIATION.
   */
  vtkSetClampMacro(Refinement, int, DEPTH_RANGE, PLANE_DEVIATION);
  vtkGetMacro(Refinement, int);
  void SetRefinementToDepthRange() { this->SetRefinement(DEPTH_RANGE); }
  void SetRefinementToPlaneDeviation() { this->SetRefinement(PLANE_DEVIATION); }
  ///@}

  ///@{
  /**
   * DEPTH_RANGE: largest difference between depths in a subsplat, as a fraction of the diagonal of
   * the scene's bounds. Default 0.02, range 0 to 1. 0 splits everything.
   */
  vtkSetClampMacro(DepthThreshold, double, 0.0, 1.0);
  vtkGetMacro(DepthThreshold, double);
  ///@}

  ///@{
  /**
   * Farthest that a subsplat's surface may lie from its mean tangent plane, as a fraction of the
   * subsplat's width. Default 0.25, range 0 to 100. 0 splits everything.
   */
  vtkSetClampMacro(PlaneThreshold, double, 0.0, 100.0);
  vtkGetMacro(PlaneThreshold, double);
  ///@}

  ///@{
  /**
   * Largest difference between a subsplat's unit normals and their mean. Default 0.2, range 0 to 2.
   * 0 splits everything.
   */
  vtkSetClampMacro(NormalThreshold, double, 0.0, 2.0);
  vtkGetMacro(NormalThreshold, double);
  ///@}

  ///@{
  /**
   * Largest error of interpolating the irradiance between subsplats, relative to it, as estimated
   * from how it varies over the coarsest level, and from how much the virtual light bends it that
   * does so most nearby. Default 0.0015, range 0 to 1; 0 does not look.
   */
  vtkSetClampMacro(LightingThreshold, double, 0.0, 1.0);
  vtkGetMacro(LightingThreshold, double);
  ///@}

  ///@{
  /** Whether subsplats that touch differ by one level at most. Default on. */
  vtkSetMacro(Balance, bool);
  vtkGetMacro(Balance, bool);
  vtkBooleanMacro(Balance, bool);
  ///@}

  ///@{
  /** Whether the irradiance follows the pixel's own normal to first order. Default on. */
  vtkSetMacro(NormalCorrection, bool);
  vtkGetMacro(NormalCorrection, bool);
  vtkBooleanMacro(NormalCorrection, bool);
  ///@}

  ///@{
  /**
   * What virtual lights that are left out of a specular lobe, or interpolated in it, may change of
   * it, by an estimate for each and all of them together: a fraction of the irradiance. The list of
   * each subsplat's lights is refined by it. Default 0.02, range 0 to 1; 0 sums all lights at every
   * specular pixel, and so does an OpenGL older than 4.3. The report says which it was.
   */
  vtkSetClampMacro(GlossyThreshold, double, 0.0, 1.0);
  vtkGetMacro(GlossyThreshold, double);
  ///@}

  ///@{
  /**
   * Equation (2) of the paper: the share alpha of the irradiance that goes with the cosine between
   * normal and eye. Not physical: it darkens. Default 0 (off), range 0 to 1; the paper's is 0.5.
   */
  vtkSetClampMacro(SurfaceDetail, double, 0.0, 1.0);
  vtkGetMacro(SurfaceDetail, double);
  ///@}

  enum StorageType
  {
    HALF_FLOAT = 0,
    FLOAT = 1
  };

  enum RendererType
  {
    AUTOMATIC = 0,
    POINT_SPLATS = 1,
    LEAF_FRAGMENTS = 2,
    LEAF_COMPUTE = 3
  };

  ///@{
  /**
   * How the lights are summed. POINT_SPLATS is the paper's: a point for each subsplat and light,
   * added by blending (with 16-bit storage its sums round at every light). LEAF_FRAGMENTS sums in
   * full-screen passes, one a level. LEAF_COMPUTE works through lists of split subsplats, four
   * leaves at a time, and needs OpenGL 4.3. All have the same leaves and, but for rounding, the
   * same result. Default AUTOMATIC: LEAF_COMPUTE where there is OpenGL 4.3, the fastest wherever
   * measured, else LEAF_FRAGMENTS.
   */
  vtkSetClampMacro(Renderer, int, AUTOMATIC, LEAF_COMPUTE);
  vtkGetMacro(Renderer, int);
  void SetRendererToAutomatic() { this->SetRenderer(AUTOMATIC); }
  void SetRendererToPointSplats() { this->SetRenderer(POINT_SPLATS); }
  void SetRendererToLeafFragments() { this->SetRenderer(LEAF_FRAGMENTS); }
  void SetRendererToLeafCompute() { this->SetRenderer(LEAF_COMPUTE); }
  ///@}

  ///@{
  /** Precision of the stored illumination: 16 or 32 bits. Default HALF_FLOAT. */
  vtkSetClampMacro(Storage, int, HALF_FLOAT, FLOAT);
  vtkGetMacro(Storage, int);
  void SetStorageToHalfFloat() { this->SetStorage(HALF_FLOAT); }
  void SetStorageToFloat() { this->SetStorage(FLOAT); }
  ///@}

#ifndef __VTK_WRAP__
  vtkIndirectEstimate Estimate(const Input& input) override;
  size_t GetBytes() const override;
  double FindErrorTolerance(double asked) const override;
  void AddToReport(vtkIndirectReport& report) const override;
  std::vector<std::string> GetChannelNames() const override;
  int DrawChannel(const std::string& name, const vtkIndirectFrame& frame,
    const vtkIndirectGeometryBuffer& geometry) override;
#endif

protected:
  vtkMultiresolutionSplattingPass();
  ~vtkMultiresolutionSplattingPass() override;

  int CoarsestResolution = 64;
  int FinestLevel = FULL_RESOLUTION;
  int Refinement = PLANE_DEVIATION;
#ifndef __VTK_WRAP__
  // The defaults, which ErrorTolerance scales.
  static constexpr double StandardPlaneThreshold = 0.25;
  static constexpr double StandardDepthThreshold = 0.02;
  static constexpr double StandardNormalThreshold = 0.2;
  static constexpr double StandardLightingThreshold = 0.0015;
  static constexpr double StandardGlossyThreshold = 0.02;
#endif
  double PlaneThreshold = StandardPlaneThreshold;
  double DepthThreshold = StandardDepthThreshold;
  double NormalThreshold = StandardNormalThreshold;
  double LightingThreshold = StandardLightingThreshold;
  bool Balance = true;
  bool NormalCorrection = true;
  double GlossyThreshold = StandardGlossyThreshold;
  double SurfaceDetail = 0.0;
  int Renderer = AUTOMATIC;
  int Storage = HALF_FLOAT;

private:
  vtkMultiresolutionSplattingPass(const vtkMultiresolutionSplattingPass&) = delete;
  void operator=(const vtkMultiresolutionSplattingPass&) = delete;

#ifndef __VTK_WRAP__
  bool MakeSettings(const Input& input, vtkIndirectSubsplatSettings& settings, int& renderer);
  bool Fill(const Input& input, const vtkIndirectSubsplatSettings& settings, int renderer,
    vtkIndirectTarget& pixels);
  bool FillInBatches(const Input& input, const vtkIndirectSubsplatSettings& settings, int renderer);
  bool FillGlossy(const Input& input, const vtkIndirectSubsplatSettings& settings);
  /** Names of the thresholds that the irradiance's subsplats obey and that the user has set. */
  std::vector<std::string> FindOwnThresholds() const;
  static constexpr int NumberOfThresholds = 3; // that they obey
#endif

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
