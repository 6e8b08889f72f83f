// SPDX-License-Identifier: BSD-3-Clause
// An estimator as the pipeline sees it: geometry buffer, maps and virtual lights in, irradiance
// out. A vtkIndirectEstimatorPass holds the user's settings and an object of this class, which sums
// the light.
#pragma once

#include "OpenGL/vtkIndirectTarget.h"   // for members
#include "Plan/vtkIndirectPlan.h"       // for abilities
#include "Senders/vtkIndirectSampler.h" // for samplers
#include "Sums/vtkIndirectFrameLight.h" // for the base class
#include "vtkSmartPointer.h"            // for the guard
#include "vtkTimeStamp.h"               // for a member

#include <memory> // for the targets
#include <string> // for names
#include <vector> // for names

class vtkIndirectContextGuard;
class vtkIndirectEstimatorPass;
class vtkIndirectSettingList;

class vtkIndirectSum : public vtkIndirectFrameLight
{
public:
  /** pass: the public object that holds this one. */
  explicit vtkIndirectSum(vtkIndirectEstimatorPass& pass);
  ~vtkIndirectSum() override;

  static vtkIndirectSum& Get(const vtkIndirectEstimatorPass* pass);

  /**
   * Makes the estimator release all graphics resources when the window's context ends, also while
   * the illumination pass uses another estimator and does not know this one. Releases them at once
   * if they belong to another window or another user; each illumination pass is a user with a
   * number of its own. Must be called in every frame, before all other functions.
   */
  void HoldContext(vtkOpenGLRenderWindow* window, vtkMTimeType user);
  /**
   * Releases all resources in the window's context; does nothing without a window. Returns true if
   * the pass that draws frames by this estimator alone has to release its resources, too.
   */
  bool EndContext(vtkWindow* window);
  vtkMTimeType GetEstimateTime() const override { return this->EstimateTime.GetMTime(); }
  void AppendTo(vtkIndirectKey& key, const Input& input) const override;
  vtkIndirectEstimate MakeEstimate(const Input& input) override;

  /**
   * Adds the estimator's settings: those in force in the last frame, of this plan, or, for null,
   * those that are set.
   */
  virtual void AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const;
  /** Returns the facts that the plan needs of it, for an error tolerance of the user. */
  virtual vtkIndirectAbilities GetAbilities(double tolerance) const;
  /** Returns its needs of the visibility stage. Default: as planned. */
  virtual vtkIndirectVisibilityNeeds GetVisibilityNeeds(const vtkIndirectPlan& plan) const;
  /**
   * Returns the sampler whose lights this estimator reads: the user's, one of its own, or null if
   * it reads the maps themselves.
   */
  virtual vtkIndirectSampler::Pointer ChooseSampler(
    const vtkIndirectSampler::Pointer& users, const vtkIndirectPlan&)
  {
    return users;
  }

  /** Default: one diffuse bounce. */
  void AddToReport(vtkIndirectReport& report) const override;

  /** Returns the names of the estimator's own buffers that can be displayed. */
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

  /** Returns the VTK irradiance of a stored value of one. */
  double GetIrradianceUnit() const { return this->IrradianceUnit; }
  const vtkIndirectTarget& GetIrradiance() const { return *this->Irradiance; }

protected:
  /** Returns the distance of the nearest receivers that look up maps, in pixels. */
  virtual int FindReceiverStep(const vtkIndirectPlan&) const { return 1; }
  /** Makes the frame's irradiance; FAILED after an error. */
  virtual vtkIndirectEstimate Estimate(const Input& input) = 0;

  /**
   * Chooses whether the irradiance is stored in 16-bit floats, where a value of one means `unit`,
   * and whether a 16-bit depth buffer comes with it. Default: 32-bit floats, a unit of one, and no
   * depth buffer. Returns true if the image is a new one.
   */
  bool SetIrradianceStorage(bool half, double unit, bool depth);
  /**
   * Creates or resizes the texture of specular reflections, stored like the irradiance, if the
   * frame has them, and releases it otherwise; HasGlossy tells which. To be called after
   * SetIrradianceStorage. Returns false, after an error, when OpenGL refuses.
   */
  bool ResizeGlossy(const Input& input);
  /** Makes an image of irradiance in the storage that is chosen. */
  std::unique_ptr<vtkIndirectTarget> MakeIrradiance();
  /** Returns the last frame's result, with its current images. */
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
