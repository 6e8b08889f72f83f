// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRadianceHintsPass
 * @brief Many bounces of diffuse light, held in a grid of the space
 *
 * After Papaioannou 2011, "Real-time diffuse global illumination using radiance hints". Hints are
 * points of a grid that hold the incoming radiance as spherical harmonics. Senders of the lights'
 * maps are summed at each hint, further bounces go from hints to surfaces and back, and pixels look
 * their irradiance up at the hints around them. The cost of a frame in which neither lights nor
 * surfaces change is that look-up alone; hints are fixed in the world.
 *
 * Beyond the paper, each with a switch:
 * - Sampling DENSE: all of a map, in blocks, instead of some of its texels
 * - Softening: a sender is at least as large as a share of a hint's cell
 * - Deringing: irradiance is never negative, nor too dark where light comes from one side
 * - ColorLayout LUMA_CHROMA: colour costs one number each beyond the luma
 * - Occupancy: voxels of the scene's surfaces hide senders from hints and hints from pixels
 * - BounceSampling SURFACES: bounces from the surfaces that rays meet, not from other hints
 * - SkipEmptyCells: hints far from all surfaces are not computed, where polygons are all there is
 *
 * Approximations: order 2 or 3 of spherical harmonics blurs light over directions, the grid over
 * places; surfaces thinner than a voxel of the occupancy volume are a voxel thick.
 *
 * SetToPaper() switches to the paper's own choices.
 */

#ifndef vtkRadianceHintsPass_h
#define vtkRadianceHintsPass_h

#include "vtkIndirectEstimatorPass.h"
#include "vtkRenderingIndirectModule.h" // For export macro

#include <vector> // for read-back

class VTKRENDERINGINDIRECT_EXPORT vtkRadianceHintsPass : public vtkIndirectEstimatorPass
{
public:
  static vtkRadianceHintsPass* New();
  vtkTypeMacro(vtkRadianceHintsPass, vtkIndirectEstimatorPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  const char* GetMethodName() const override { return "hints"; }
  int GetMaximumNumberOfBounces() const override { return 16; }
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /** The paper's method: every switch listed above off, four look-ups, 40 samples. */
  void SetToPaper();

  ///@{
  /** Order of the spherical harmonics. Default 2, range 2 to 3. */
  vtkSetClampMacro(Order, int, 2, 3);
  vtkGetMacro(Order, int);
  ///@}

  enum ColorLayoutType
  {
    RGB = 0,
    LUMA_CHROMA = 1
  };

  ///@{
  /**
   * How order 3 holds colours: RGB, 27 numbers, or LUMA_CHROMA, 11: all of the luma, of the two
   * chroma differences the mean. Default LUMA_CHROMA. Order 2 is always RGB, 12 numbers.
   */
  vtkSetClampMacro(ColorLayout, int, RGB, LUMA_CHROMA);
  vtkGetMacro(ColorLayout, int);
  void SetColorLayoutToRGB() { this->SetColorLayout(RGB); }
  void SetColorLayoutToLumaChroma() { this->SetColorLayout(LUMA_CHROMA); }
  ///@}

  enum ExtentType
  {
    SCENE = 0,
    VIEW = 1
  };

  ///@{
  /**
   * What the grid spans: the scene's bounds, or the part of them that the view can see, which makes
   * smaller cells but moves the hints with the camera. Default SCENE.
   */
  vtkSetClampMacro(Extent, int, SCENE, VIEW);
  vtkGetMacro(Extent, int);
  void SetExtentToScene() { this->SetExtent(SCENE); }
  void SetExtentToView() { this->SetExtent(VIEW); }
  ///@}

  ///@{
  /**
   * Hints along x, y and z, clamped to 0 to 64. Default 0 0 0: from ErrorTolerance. Hints of all
   * grids times NumberOfRays may be 2^28, a table of 1 GiB: a frame with more has an error and no
   * indirect light.
   */
  virtual void SetGridResolution(int x, int y, int z);
  void SetGridResolution(const int resolution[3])
  {
    this->SetGridResolution(resolution[0], resolution[1], resolution[2]);
  }
  vtkGetVector3Macro(GridResolution, int);
  ///@}

  ///@{
  /**
   * Relative error of interpolating between hints that the automatic resolution aims at. Default 0:
   * vtkIndirectIlluminationPass::ErrorTolerance, and 0.05 where that is 0 too. Range, beside 0,
   * 0.002 to 1. Light from a distance of a quarter of the scene is interpolated over a cell c of an
   * extent D with an error of about 12 (c/D)^2: 16 hints along the longest axis for 0.05.
   */
  virtual void SetErrorTolerance(double tolerance);
  vtkGetMacro(ErrorTolerance, double);
  ///@}

  ///@{
  /**
   * Grids: 1, or 2 for a second, finer one around the camera's focal point that fades into the
   * first over its outermost two cells. Default 1.
   */
  vtkSetClampMacro(NumberOfGrids, int, 1, 2);
  vtkGetMacro(NumberOfGrids, int);
  ///@}

  ///@{
  /** Edge of the finer grid as a fraction of the scene's. Default 0.4, range 0.05 to 1. */
  vtkSetClampMacro(FineGridExtent, double, 0.05, 1.0);
  vtkGetMacro(FineGridExtent, double);
  ///@}

  enum SamplingType
  {
    SAMPLED = 0,
    DENSE = 1
  };

  ///@{
  /**
   * How maps are read: SAMPLED, NumberOfSamples texels of all maps together, others for each hint
   * and from jittered places; DENSE, all of every map in blocks of texels. Default DENSE. A single
   * headlight has no map: its virtual lights are read, in both modes.
   */
  vtkSetClampMacro(Sampling, int, SAMPLED, DENSE);
  vtkGetMacro(Sampling, int);
  void SetSamplingToSampled() { this->SetSampling(SAMPLED); }
  void SetSamplingToDense() { this->SetSampling(DENSE); }
  ///@}

  ///@{
  /** SAMPLED: samples a hint, divided among the faces of all maps. Default 40, range 1 to 4096. */
  vtkSetClampMacro(NumberOfSamples, int, 1, 4096);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * SAMPLED: share of a map, about the hint's own place in it, that samples are spread over. What
   * lies outside is lost. Default 1, range 0.01 to 1.
   */
  vtkSetClampMacro(Coverage, double, 0.01, 1.0);
  vtkGetMacro(Coverage, double);
  ///@}

  ///@{
  /** DENSE: blocks along the edge of a face of a map. Default 24, range 1 to 128. */
  vtkSetClampMacro(BlocksPerEdge, int, 1, 128);
  vtkGetMacro(BlocksPerEdge, int);
  ///@}

  ///@{
  /**
   * Whether a sender's size is at least a share of the hint's cell: a hint stands for its cell and
   * cannot tell what is nearer. It steps back from a sender's plane instead. Default on.
   */
  vtkSetMacro(Softening, bool);
  vtkGetMacro(Softening, bool);
  vtkBooleanMacro(Softening, bool);
  ///@}

  ///@{
  /**
   * Whether the irradiance is rid of the ringing of spherical harmonics: never negative, and for
   * order 2 as bright in front of concentrated light as it should be. Default on.
   */
  vtkSetMacro(Deringing, bool);
  vtkGetMacro(Deringing, bool);
  vtkBooleanMacro(Deringing, bool);
  ///@}

  ///@{
  /**
   * Without Occupancy: whether hints behind the surfaces that send light weigh less. Default on.
   */
  vtkSetMacro(FacingWeights, bool);
  vtkGetMacro(FacingWeights, bool);
  vtkBooleanMacro(FacingWeights, bool);
  ///@}

  ///@{
  /**
   * Whether hints far from every surface are left out, in frames that show nothing but polygons:
   * where glyphs, impostors, lines, points or shaders of the user's own draw, only they know.
   * Default on.
   */
  vtkSetMacro(SkipEmptyCells, bool);
  vtkGetMacro(SkipEmptyCells, bool);
  vtkBooleanMacro(SkipEmptyCells, bool);
  ///@}

  ///@{
  /**
   * Whether later bounces take the albedo of the surfaces where they happen; off: the scene's mean.
   * Default on.
   */
  vtkSetMacro(AlbedoVolume, bool);
  vtkGetMacro(AlbedoVolume, bool);
  vtkBooleanMacro(AlbedoVolume, bool);
  ///@}

  enum BounceSamplingType
  {
    HINTS = 0,
    SURFACES = 1
  };

  ///@{
  /**
   * Where later bounces come from: HINTS, random other hints (Eq. 8 to 11), or SURFACES, those that
   * rays from the hint meet. Default SURFACES.
   */
  vtkSetClampMacro(BounceSampling, int, HINTS, SURFACES);
  vtkGetMacro(BounceSampling, int);
  void SetBounceSamplingToHints() { this->SetBounceSampling(HINTS); }
  void SetBounceSamplingToSurfaces() { this->SetBounceSampling(SURFACES); }
  ///@}

  ///@{
  /**
   * Rays from a hint that tell what it sees, for Occupancy and for bounces from SURFACES: at least
   * so many, an even square number. Default 400, range 4 to 4096; see GridResolution.
   */
  vtkSetClampMacro(NumberOfRays, int, 4, 4096);
  vtkGetMacro(NumberOfRays, int);
  ///@}

  ///@{
  /** HINTS: other hints that a bounce to a hint is sampled from. Default 32, range 1 to 1024. */
  vtkSetClampMacro(NumberOfBounceSamples, int, 1, 1024);
  vtkGetMacro(NumberOfBounceSamples, int);
  ///@}

  ///@{
  /**
   * HINTS: farthest that a bounce comes from, as a fraction of the scene's diagonal; stored
   * distances are in its units. Default 1, range 0.01 to 1.
   */
  vtkSetClampMacro(BounceRange, double, 0.01, 1.0);
  vtkGetMacro(BounceRange, double);
  ///@}

  ///@{
  /**
   * Look-ups a pixel: 1, half a cell above the surface, or 4, the paper's (one above and three at
   * 80 degrees on a hemisphere as wide as a cell's diagonal). Default 1.
   */
  void SetNumberOfLookups(int lookups);
  vtkGetMacro(NumberOfLookups, int);
  ///@}

  ///@{
  /** Whether the four look-ups turn from pixel to pixel. Default off: turning is noise. */
  vtkSetMacro(LookupRotation, bool);
  vtkGetMacro(LookupRotation, bool);
  vtkBooleanMacro(LookupRotation, bool);
  ///@}

  ///@{
  /**
   * Section 8: whether the eye's depth hides senders from hints. Not physical; makes hints depend
   * on the camera. Default off.
   */
  vtkSetMacro(DepthOcclusion, bool);
  vtkGetMacro(DepthOcclusion, bool);
  vtkBooleanMacro(DepthOcclusion, bool);
  ///@}

  ///@{
  /** Places on each way that DepthOcclusion tests. Default 5, range 3 to 8. */
  vtkSetClampMacro(NumberOfDepthSamples, int, 3, 8);
  vtkGetMacro(NumberOfDepthSamples, int);
  ///@}

  ///@{
  /** What a hidden place leaves of the light. Default 0.6, range 0 to 1. */
  vtkSetClampMacro(DepthAttenuation, double, 0.0, 1.0);
  vtkGetMacro(DepthAttenuation, double);
  ///@}

  ///@{
  /** Pixels from one look-up to the next; between them it is interpolated. Default 4, range 1
   * to 16.
   */
  vtkSetClampMacro(InterpolationStep, int, 1, 16);
  vtkGetMacro(InterpolationStep, int);
  ///@}

  ///@{
  /** Least cosine between normals that are interpolated. Default 0.9, range 0 to 1. */
  vtkSetClampMacro(InterpolationMinimumCosine, double, 0.0, 1.0);
  vtkGetMacro(InterpolationMinimumCosine, double);
  ///@}

  ///@{
  /**
   * Farthest that a sample may lie from a pixel's tangent plane, as a fraction of the distance
   * between samples on a surface that faces the eye. Default 0.5, range 0 to 100.
   */
  vtkSetClampMacro(InterpolationPlaneTolerance, double, 0.0, 100.0);
  vtkGetMacro(InterpolationPlaneTolerance, double);
  ///@}

  ///@{
  /**
   * Share of the last frame's irradiance that a pixel keeps, against flicker of moving lights; 0.5
   * in the paper. Default 0, right for still images; range 0 to 0.95. While nothing changes the
   * irradiance goes on to its value without smoothing, and has it, bit for bit, when all but
   * 2^-12 of a difference would be gone: after 12 equal frames for 0.5, 38 for 0.8, 163 for 0.95.
   */
  vtkSetClampMacro(TemporalSmoothing, double, 0.0, 0.95);
  vtkGetMacro(TemporalSmoothing, double);
  ///@}

  ///@{
  /** How often light was brought to the hints since construction. */
  vtkGetMacro(NumberOfHintUpdates, vtkIdType);
  ///@}
  /** Hints of the last frame, and those of them that were computed. */
  int GetNumberOfHints() const;
  int GetNumberOfActiveHints() const;

#ifndef __VTK_WRAP__
  vtkIndirectVisibilityNeeds GetVisibilityNeeds(const vtkIndirectPlan& plan) const override;
  vtkVirtualLightSampler* ChooseSampler(
    vtkVirtualLightSampler* users, const vtkIndirectPlan& plan) override;
  vtkIndirectEstimate Estimate(const Input& input) override;
  size_t GetBytes() const override;
  size_t GetMainMemoryBytes() const override;
  double FindErrorTolerance(double asked) const override;
  void AddToReport(vtkIndirectReport& report) const override;

  /** Place of a hint in scene units and its field: `Order` squared numbers each for three colours,
   * first the reds; order 3 needs ColorLayout RGB. For tests. */
  struct Hint
  {
    double Position[3];
    bool Active;
    std::vector<double> Coefficients;
  };
  std::vector<Hint> ReadHints();
#endif

protected:
  vtkRadianceHintsPass();
  ~vtkRadianceHintsPass() override;

  int Order = 2;
  int ColorLayout = LUMA_CHROMA;
  int Extent = SCENE;
  int GridResolution[3] = { 0, 0, 0 };
  double ErrorTolerance = 0.0;
  int NumberOfGrids = 1;
  double FineGridExtent = 0.4;
  int Sampling = DENSE;
  int NumberOfSamples = 40;
  double Coverage = 1.0;
  int BlocksPerEdge = 24;
  bool Softening = true;
  bool Deringing = true;
  bool FacingWeights = true;
  bool SkipEmptyCells = true;
  bool AlbedoVolume = true;
  int BounceSampling = SURFACES;
  int NumberOfRays = 400;
  int NumberOfBounceSamples = 32;
  double BounceRange = 1.0;
  int NumberOfLookups = 1;
  bool LookupRotation = false;
  bool DepthOcclusion = false;
  int NumberOfDepthSamples = 5;
  double DepthAttenuation = 0.6;
  int InterpolationStep = 4;
  double InterpolationMinimumCosine = 0.9;
  double InterpolationPlaneTolerance = 0.5;
  double TemporalSmoothing = 0.0;
  vtkIdType NumberOfHintUpdates = 0;

private:
  vtkRadianceHintsPass(const vtkRadianceHintsPass&) = delete;
  void operator=(const vtkRadianceHintsPass&) = delete;

  int GetLayout() const;
  bool UpdateGeometry(const Input& input);
  bool UpdateLight(const Input& input, bool anew);
  bool LookUp(const Input& input);
  bool FillMixedCells(const Input& input);
  void SetInterpolationUniforms(vtkShaderProgram* program) const;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
