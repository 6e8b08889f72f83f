// SPDX-License-Identifier: BSD-3-Clause
// An estimator as the pipeline sees it: geometry buffer, maps and virtual lights in, irradiance
// out. A vtkIndirectEstimatorPass holds the user's settings and one of these, which sums the light.
#ifndef vtkIndirectSum_h
#define vtkIndirectSum_h

#include "Frame/vtkIndirectEstimate.h"        // for results
#include "Frame/vtkIndirectPlan.h"            // for abilities
#include "OpenGL/vtkIndirectTarget.h"         // for members
#include "VirtualLights/vtkIndirectSampler.h" // for samplers
#include "vtkSmartPointer.h"                  // for the guard
#include "vtkTimeStamp.h"                     // for a member

#include <memory> // for the targets
#include <string> // for names
#include <vector> // for names

class vtkIndirectContextGuard;
class vtkIndirectEstimatorPass;
struct vtkIndirectReport;

class vtkIndirectSum
{
public:
  using Input = vtkIndirectEstimateInput;

  /** pass: the public object that holds it. */
  explicit vtkIndirectSum(vtkIndirectEstimatorPass& pass);
  virtual ~vtkIndirectSum();
  vtkIndirectSum(const vtkIndirectSum&) = delete;
  void operator=(const vtkIndirectSum&) = delete;

  static vtkIndirectSum& Get(const vtkIndirectEstimatorPass* pass);

  /**
   * Lets go of all graphics resources when the window's context ends, also while the illumination
   * pass uses another estimator and does not know this one; and at once of those of another window
   * or for another user, a number that each illumination pass has of its own. To be called in every
   * frame, before anything else of the frame.
   */
  void HoldContext(vtkOpenGLRenderWindow* window, vtkMTimeType user);
  /**
   * Gives back what it holds in the window's context; without a window nothing happens. Returns
   * whether the pass that draws frames by this estimator alone has to do the same.
   */
  bool Release(vtkWindow* window);
  /**
   * Grows with each estimate, and where resources are released: an estimate exists, with its
   * images, as long as this is what it was when it had been made.
   */
  vtkMTimeType GetEstimateTime() const { return this->EstimateTime.GetMTime(); }
  /** Makes the frame's irradiance, see Estimate. */
  vtkIndirectEstimate MakeEstimate(const Input& input);

  /** The facts that the plan needs of it, where the user asks for this error tolerance. */
  virtual vtkIndirectAbilities GetAbilities(double tolerance) const;
  /** Its needs of the visibility stage. Default: what the plan has chosen. */
  virtual vtkIndirectVisibilityNeeds GetVisibilityNeeds(const vtkIndirectPlan& plan) const;
  /**
   * The sampler whose lights this estimator reads: the user's, one of its own, or null when it
   * reads the maps themselves.
   */
  virtual vtkIndirectSampler::Pointer ChooseSampler(
    const vtkIndirectSampler::Pointer& users, const vtkIndirectPlan&)
  {
    return users;
  }

  /** Bytes of textures and buffers. */
  virtual size_t GetBytes() const;
  /** Bytes of tables in main memory. */
  virtual size_t GetMainMemoryBytes() const { return 0; }
  /** Says what the last frame modelled and left out. Default: one diffuse bounce. */
  virtual void AddToReport(vtkIndirectReport& report) const;

  /** Names of buffers of the estimator's own that can be looked at. */
  virtual std::vector<std::string> GetChannelNames() const { return {}; }
  /**
   * Draws one of these buffers, of the last frame, into the bound target of the frame's size, which
   * is clear. Returns the number of its components, 1 or 3, or 0 when it cannot.
   */
  virtual int DrawChannel(
    const std::string&, const vtkIndirectFrame&, const vtkIndirectGeometryBuffer&)
  {
    return 0;
  }

  /** VTK irradiance that a stored value of one stands for. */
  double GetIrradianceUnit() const { return this->IrradianceUnit; }
  const vtkIndirectTarget& GetIrradiance() const { return *this->Irradiance; }

protected:
  /** Makes the frame's irradiance; FAILED after an error. */
  virtual vtkIndirectEstimate Estimate(const Input& input) = 0;
  /** Gives back the resources of a subclass, in the context of this window. */
  virtual void ReleaseOwn(vtkWindow* window) = 0;

  /**
   * Chooses whether the irradiance is stored in 16-bit floats, of which one stands for `unit`, and
   * whether a 16-bit depth buffer comes with it. The default is 32-bit floats, one, and none.
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

  vtkIndirectEstimatorPass& Pass;
  bool HasGlossy = false;
  std::unique_ptr<vtkIndirectTarget> Irradiance;
  std::unique_ptr<vtkIndirectTarget> Glossy;

private:
  vtkSmartPointer<vtkIndirectContextGuard> Guard;
  double IrradianceUnit = 1.0;
  bool IrradianceIsHalf = false;
  bool IrradianceHasDepth = false;
  bool IsHolding = false; // within HoldContext
  vtkTimeStamp EstimateTime;
  vtkMTimeType User = 0;
};

#endif
