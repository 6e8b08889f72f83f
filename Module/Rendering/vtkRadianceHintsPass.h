// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRadianceHintsPass
 * @brief Many bounces of diffuse light, held in a grid of the space
 *
 * After Papaioannou 2011, "Real-time diffuse global illumination using radiance hints". Hints are
 * points of a grid that hold the incoming radiance as spherical harmonics. Senders of the lights'
 * maps are summed at each hint, further bounces go from hints to surfaces and back, and pixels look
 * up their irradiance at the hints around them. A frame in which neither lights nor surfaces change
 * costs that look-up alone, because hints are fixed in the world.
 *
 * The preset ROBUST goes beyond the paper: all of a map is read, in blocks, instead of some of its
 * texels; a sender is at least as large as a share of a hint's cell; irradiance is never negative,
 * nor too dark where light comes from one side; voxels of the scene's surfaces hide senders from
 * hints and hints from pixels; later bounces come from the surfaces that rays meet, with their
 * albedo, instead of from other hints; hints far from all surfaces are not computed if all surfaces
 * are polygons; pixels look up once.
 *
 * The preset PAPER (SetPreset) is the method as published: NumberOfSamples texels of the maps,
 * bounces from 32 other hints, four look-ups, no voxels.
 *
 * Approximations: order 2 or 3 of spherical harmonics blurs light over directions, the grid over
 * places; surfaces thinner than a voxel of the occupancy volume are a voxel thick.
 */

#ifndef vtkRadianceHintsPass_h
#define vtkRadianceHintsPass_h

#include "vtkIndirectEstimatorPass.h"
#include "vtkIndirectSettings.h"        // For properties
#include "vtkRenderingIndirectModule.h" // For export macro

struct vtkIndirectHintDetails;

class VTKRENDERINGINDIRECT_EXPORT vtkRadianceHintsPass final : public vtkIndirectEstimatorPass
{
public:
  static vtkRadianceHintsPass* New();
  vtkTypeMacro(vtkRadianceHintsPass, vtkIndirectEstimatorPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  const char* GetMethodName() const override { return "hints"; }

  ///@{
  /** Order of the spherical harmonics. Default 2, range 2 to 3. */
  vtkIndirectClampMacro(Order, int, 2, 3);
  ///@}

  enum ExtentType
  {
    SCENE = 0,
    VIEW = 1
  };

  ///@{
  /**
   * The space of the grid: the scene's bounds, or the part of them that the view can see, which
   * makes smaller cells but moves the hints with the camera. Default SCENE.
   */
  vtkIndirectClampMacro(Extent, int, SCENE, VIEW);
  void SetExtentToScene() { this->SetExtent(SCENE); }
  void SetExtentToView() { this->SetExtent(VIEW); }
  ///@}

  ///@{
  /**
   * Hints along x, y and z, clamped to 0 to 64. Default 0 0 0: chosen by the pass's ErrorTolerance,
   * within 0.002 to 1, and by 0.05 if that is 0. Light from a distance of a quarter of the scene is
   * interpolated over a cell c of an extent D with an error of about 12 (c/D)^2: 16 hints along the
   * longest axis for 0.05. The rays of all hints may be 2^28, a table of 1 GiB: a frame with more
   * rays has an error and no indirect light.
   */
  virtual void SetGridResolution(int x, int y, int z);
  void SetGridResolution(const int resolution[3])
  {
    this->SetGridResolution(resolution[0], resolution[1], resolution[2]);
  }
  int* GetGridResolution() VTK_SIZEHINT(3) { return this->Settings.GridResolution; }
  void GetGridResolution(int resolution[3]) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      resolution[axis] = this->Settings.GridResolution[axis];
    }
  }
  ///@}

  ///@{
  /**
   * Number of grids: 1, or 2 for a second, finer one around the camera's focal point that fades
   * into the first over its outermost two cells, except where both grids end. Default 1.
   */
  vtkIndirectClampMacro(NumberOfGrids, int, 1, 2);
  ///@}

  ///@{
  /** Edge of the finer grid as a fraction of the scene's. Default 0.4, range 0.05 to 1. */
  vtkIndirectClampMacro(FineGridExtent, double, 0.05, 1.0);
  ///@}

  ///@{
  /**
   * PAPER: samples a hint, divided among the faces of all maps. Default 40, range 1 to 4096. ROBUST
   * reads all senders, as do both presets with a single headlight, which has no map.
   */
  vtkIndirectClampMacro(NumberOfSamples, int, 1, 4096);
  ///@}

  ///@{
  /**
   * PAPER: c_RSM of the paper, the share of each map's area, around the hint's own place in the
   * map, that the samples are drawn from. Light from the rest is lost (bias <= 0). Default 1, range
   * 0.001 to 1; the paper has 0.05 to 0.15 under a sun and up to 0.9 indoors.
   */
  vtkIndirectClampMacro(MapCoverage, double, 0.001, 1.0);
  ///@}

  ///@{
  /**
   * PAPER: N_b of the paper, other hints that send a hint light of later bounces. Default 32, range
   * 1 to 1024; the paper has 16 to 32.
   */
  vtkIndirectClampMacro(NumberOfBounceSamples, int, 1, 1024);
  ///@}

  ///@{
  /**
   * PAPER: r_max of the paper over the scene's diagonal, the largest distance between hints that
   * send each other light of later bounces. Light from beyond is lost (bias <= 0). Default 1, range
   * 0.01 to 1.
   */
  vtkIndirectClampMacro(BounceRange, double, 0.01, 1.0);
  ///@}

  ///@{
  /**
   * Turn the four look-ups of PAPER about the normal from pixel to pixel (section 9.3 of the
   * paper), which trades banding for noise. No effect with ROBUST, which looks up once. Default
   * off.
   */
  vtkIndirectFlagMacro(LookupRotation);
  ///@}

  ///@{
  /**
   * Section 8 of the paper: let the eye's depth hide senders from hints. Not physical; makes hints
   * depend on the camera. Default off.
   */
  vtkIndirectFlagMacro(DepthOcclusion);
  ///@}

  ///@{
  /**
   * DepthOcclusion: points tested on each segment from a sender to a hint, and the factor by which
   * each hidden point multiplies the light. Default 5 and 0.6, ranges 1 to 64 and 0 to 1; the paper
   * has 3 to 8 points and names no factor.
   */
  vtkIndirectClampMacro(NumberOfDepthSamples, int, 1, 64);
  vtkIndirectClampMacro(DepthAttenuation, double, 0.0, 1.0);
  ///@}

  ///@{
  /**
   * Pixels from one look-up to the next; pixels between are interpolated. Default 4, range 1 to 16.
   */
  vtkIndirectClampMacro(InterpolationStep, int, 1, 16);
  ///@}

  ///@{
  /**
   * Share of the last frame's irradiance that a pixel keeps, against flicker of moving lights; 0.5
   * in the paper. Default 0, right for still images; range 0 to 0.95. In an unchanged scene the
   * irradiance approaches its value without smoothing, and reaches it, bit for bit, when all but
   * 2^-12 of a difference would be gone: after 12 equal frames for 0.5, 38 for 0.8, 163 for 0.95.
   */
  vtkIndirectClampMacro(TemporalSmoothing, double, 0.0, 0.95);
  ///@}

  /** Return the number of hints in the last frame, and of those that were computed. */
  int GetNumberOfHints() const;
  int GetNumberOfActiveHints() const;

protected:
  vtkRadianceHintsPass();
  ~vtkRadianceHintsPass() override;

  void ApplyPreset() override;

private:
  vtkRadianceHintsPass(const vtkRadianceHintsPass&) = delete;
  void operator=(const vtkRadianceHintsPass&) = delete;

  friend class vtkIndirectHintSum;
  friend struct vtkIndirectHintDetails;
  struct SettingsType
  {
    int Order = 2;
    int Extent = SCENE;
    int GridResolution[3] = { 0, 0, 0 };
    int NumberOfGrids = 1;
    double FineGridExtent = 0.4;
    int NumberOfSamples = 40;
    double MapCoverage = 1.0;
    int NumberOfBounceSamples = 32;
    double BounceRange = 1.0;
    bool LookupRotation = false;
    bool DepthOcclusion = false;
    int NumberOfDepthSamples = 5;
    double DepthAttenuation = 0.6;
    int InterpolationStep = 4;
    double TemporalSmoothing = 0.0;
  };
  SettingsType Settings;
  const std::unique_ptr<vtkIndirectHintDetails> Details; // choices of the preset
};

#endif
