// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkIndirectEstimatorPass
 * @brief Abstract: geometry buffer, maps and virtual lights in, irradiance out
 *
 * The irradiance is in VTK's units, where a constant radiance L over the hemisphere gives E = L and
 * a diffuse surface sends out albedo times E. Its texture has the size of the viewport.
 *
 * Estimators that know how also compute what receivers reflect specularly, by the lobes of VTK's
 * Phong model; see SpecularTransport. It comes without the material's specular colour, by which the
 * composite multiplies it. Some also sum what senders reflect specularly, such as caustics; see
 * SumsLobes.
 */

#ifndef vtkIndirectEstimatorPass_h
#define vtkIndirectEstimatorPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRenderingIndirectModule.h" // For export macro
#include "vtkSmartPointer.h"            // For the guard
#include "vtkTimeStamp.h"               // For estimates

#include <memory> // for the targets
#include <string> // for names
#include <vector> // for names

class vtkIndirectGeometryBuffer;
class vtkIndirectContextGuard;
class vtkIndirectIlluminationPass;
class vtkIndirectTarget;
class vtkOpenGLRenderWindow;
class vtkIndirectSampler;
struct vtkIndirectAbilities;
struct vtkIndirectEstimate;
struct vtkIndirectEstimateInput;
struct vtkIndirectFrame;
struct vtkIndirectPlan;
struct vtkIndirectReport;
struct vtkIndirectVisibilityNeeds;

class VTKRENDERINGINDIRECT_EXPORT vtkIndirectEstimatorPass : public vtkOpenGLRenderPass
{
public:
  vtkTypeMacro(vtkIndirectEstimatorPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Draws the whole frame with this estimator, as a vtkIndirectIlluminationPass does that it is set
   * on: renderer->SetPass(estimator). What belongs to a frame is set on GetIlluminationPass.
   */
  void Render(const vtkRenderState* s) override;
  /** The pass by which this one draws frames when it is set on a renderer by itself. */
  vtkIndirectIlluminationPass* GetIlluminationPass();
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /** Short name for reports, e.g. "gather". */
  virtual const char* GetMethodName() const = 0;
  /** Most bounces that this estimator computes. */
  virtual int GetMaximumNumberOfBounces() const { return 1; }

  ///@{
  /**
   * Whether receivers with Phong's model and a specular coefficient reflect indirect light
   * specularly, and senders with such or with VTK's PBR reflect the lights specularly, where the
   * estimator can compute it. Costs nothing where there are none. Default on.
   */
  vtkSetMacro(SpecularTransport, bool);
  vtkGetMacro(SpecularTransport, bool);
  vtkBooleanMacro(SpecularTransport, bool);
  ///@}
  /** Whether this estimator can compute specular reflection of receivers. */
  virtual bool ComputesGlossy() const { return false; }
  /** Whether it can sum what senders reflect specularly, the lobes of virtual lights. */
  virtual bool SumsLobes() const { return false; }

  ///@{
  /**
   * Whether what stands between senders and receivers is looked up in voxels of the scene and among
   * its spheres, where vtkIndirectIlluminationPass::Visibility is automatic. Default off, of
   * radiance hints on.
   */
  vtkSetMacro(Occupancy, bool);
  vtkGetMacro(Occupancy, bool);
  vtkBooleanMacro(Occupancy, bool);
  ///@}

  ///@{
  /** Voxels along the longest edge of the scene. Default 128, range 16 to 128. */
  vtkSetClampMacro(OccupancyResolution, int, 16, 128);
  vtkGetMacro(OccupancyResolution, int);
  ///@}

#ifndef __VTK_WRAP__
  using Input = vtkIndirectEstimateInput;

  /**
   * Lets go of all graphics resources when the window's context ends, also while the pass uses
   * another estimator and does not know this one; and at once of what it has of another window or
   * for another user, a number that each pass has of its own. To be called in every frame, before
   * anything of the frame is asked of it.
   */
  void HoldContext(vtkOpenGLRenderWindow* window, vtkMTimeType user);
  /**
   * Grows with each estimate, and where resources are released: an estimate is there, with its
   * images, as long as this is what it was when it had been made.
   */
  vtkMTimeType GetEstimateTime() const
  {
    return this->EstimateTime.GetMTime();
  }
  /** Makes the frame's irradiance, see Estimate. */
  vtkIndirectEstimate MakeEstimate(const Input& input);

  /** What the plan has to know of it, where the pass asks for an error tolerance. */
  vtkIndirectAbilities GetAbilities(double tolerance) const;
  /** Whether it can ask whether a light of the table is seen, by its number. Default: no. */
  virtual bool TakesLightMaps() const
  {
    return false;
  }
  /** Whether nothing hides senders unless the user asks for it, as in a paper. Default: no. */
  virtual bool IgnoresVisibility() const
  {
    return false;
  }
  /** Whether it sums texels of the lights' maps where there are such, and nothing else. Default:
   * no.
   */
  virtual bool ReadsMaps() const
  {
    return false;
  }
  /** Whether it sums the sky and what surfaces send of its light itself, and no lights: its
   * estimate has a Sky. Default: no. */
  virtual bool SumsSky() const
  {
    return false;
  }
  /** Whether it sums lights of the frame's sampler, not of its own. Default: yes. */
  virtual bool TakesSampler() const
  {
    return true;
  }
  /** What it needs of the visibility stage. Default: what the plan has chosen. */
  virtual vtkIndirectVisibilityNeeds GetVisibilityNeeds(const vtkIndirectPlan& plan) const;
  /**
   * The sampler whose lights this estimator reads: the user's, one of its own, or null when it
   * reads the maps themselves.
   */
  virtual std::shared_ptr<vtkIndirectSampler> ChooseSampler(
    const std::shared_ptr<vtkIndirectSampler>& users, const vtkIndirectPlan& plan);

  /** VTK irradiance that a stored value of one stands for. */
  double GetIrradianceUnit() const
  {
    return this->IrradianceUnit;
  }

  /** Of textures and buffers. */
  virtual size_t GetBytes() const;
  /** Of tables in main memory. */
  virtual size_t GetMainMemoryBytes() const
  {
    return 0;
  }

  /**
   * The error that the estimator's parameters are chosen by when the pass asks for so much, 0 for
   * nothing; 0 when none of them are. Default: none.
   */
  virtual double FindErrorTolerance(double) const
  {
    return 0.0;
  }

  /** Says what the last frame modelled and left out. Default: one diffuse bounce. */
  virtual void AddToReport(vtkIndirectReport& report) const;

  /** Names of buffers of the estimator's own that can be looked at. */
  virtual std::vector<std::string> GetChannelNames() const
  {
    return {};
  }
  /**
   * Draws one of them, of the last frame, into the bound target of the frame's size, which is
   * clear. Returns the number of its components, 1 or 3, or 0 when it cannot.
   */
  virtual int DrawChannel(
    const std::string&, const vtkIndirectFrame&, const vtkIndirectGeometryBuffer&)
  {
    return 0;
  }
#endif

protected:
  vtkIndirectEstimatorPass();
  ~vtkIndirectEstimatorPass() override;

#ifndef __VTK_WRAP__
  /** Makes the frame's irradiance; FAILED after an error. */
  virtual vtkIndirectEstimate Estimate(const Input& input) = 0;

  /** Whether ReleaseGraphicsResources has anything to release in the window's context. */
  bool CanBeOf(vtkWindow* window);

  /**
   * Whether the irradiance is stored in 16-bit floats, of which one stands for `unit`, and whether
   * a 16-bit depth buffer comes with it. The default is 32-bit floats, one, and none.
   */
  void SetIrradianceStorage(vtkWindow* window, bool half, double unit, bool depth);

  /**
   * Creates or resizes the texture of what is reflected specularly, stored like the irradiance, for
   * a frame that has it, and releases it for others; HasGlossy says which. After
   * SetIrradianceStorage. Returns false, after an error, when OpenGL refuses.
   */
  bool ResizeGlossy(const Input& input);
  /** The last frame's result, with the images as they are now. */
  vtkIndirectEstimate MakeResult() const;
#endif

  bool SpecularTransport = true;
  bool HasGlossy = false;
  vtkSmartPointer<vtkIndirectContextGuard> Guard;
  std::unique_ptr<vtkIndirectTarget> Irradiance;
  std::unique_ptr<vtkIndirectTarget> Glossy;
  bool Occupancy = false;
  int OccupancyResolution = 128;

private:
  double IrradianceUnit = 1.0;
  bool IrradianceIsHalf = false;
  bool IrradianceHasDepth = false;
  // Draws frames where this is a renderer's pass; it does not hold this one.
  vtkSmartPointer<vtkIndirectIlluminationPass> Whole;
  bool IsReleasing = false;
  vtkTimeStamp EstimateTime;
  vtkMTimeType User = 0;

  vtkIndirectEstimatorPass(const vtkIndirectEstimatorPass&) = delete;
  void operator=(const vtkIndirectEstimatorPass&) = delete;
};

#endif
