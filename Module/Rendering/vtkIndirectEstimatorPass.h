// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkIndirectEstimatorPass
 * @brief Abstract: geometry buffer, maps and virtual lights in, irradiance out
 *
 * The irradiance is in VTK's units, where a constant radiance L over the hemisphere gives E = L and
 * a diffuse surface sends out albedo times E. Its texture has the size of the viewport.
 */

#ifndef vtkIndirectEstimatorPass_h
#define vtkIndirectEstimatorPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRenderingIndirectModule.h" // For export macro

#include <memory> // for the target
#include <string> // for names
#include <vector> // for names

class vtkGeometryBufferPass;
class vtkIndirectStageTimer;
struct vtkIndirectReport;
class vtkIndirectTarget;
class vtkReflectiveShadowMapPass;
class vtkVirtualLightSampler;
struct vtkIndirectFrame;
struct vtkIndirectReport;

class VTKRENDERINGINDIRECT_EXPORT vtkIndirectEstimatorPass : public vtkOpenGLRenderPass
{
public:
  vtkTypeMacro(vtkIndirectEstimatorPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** An estimator has no picture of its own: this is an error. See Estimate. */
  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /** Short name for reports, e.g. "gather". */
  virtual const char* GetMethodName() const = 0;
  /** Most bounces that this estimator computes. */
  virtual int GetMaximumNumberOfBounces() const { return 1; }

#ifndef __VTK_WRAP__
  /** What a frame's estimate reads; eye stands in for the maps where a headlight needs none. */
  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkGeometryBufferPass& Geometry;
    vtkReflectiveShadowMapPass& Maps;
    vtkVirtualLightSampler* Sampler; // null when the estimator asked for none
    bool EyeIsMap;
    int NumberOfBounces = 1;     // as asked for
    bool Caching = true;         // off: nothing may be kept from earlier frames
    double ErrorTolerance = 0.0; // relative; 0: the estimator's own parameters
  };

  /**
   * The sampler whose lights this estimator reads: the user's, one of its own, or null when it
   * reads the maps themselves.
   */
  virtual vtkVirtualLightSampler* ChooseSampler(vtkVirtualLightSampler* users)
  {
    return users;
  }
  /** The same for a frame whose only light is a headlight, which has no map. */
  virtual vtkVirtualLightSampler* ChooseHeadlightSampler(vtkVirtualLightSampler* users)
  {
    return this->ChooseSampler(users);
  }

  /** Fills the irradiance texture. Returns false, after an error, when it cannot. */
  virtual bool Estimate(const Input& input, vtkIndirectStageTimer& timer) = 0;

  vtkIndirectTarget& GetIrradiance()
  {
    return *this->Irradiance;
  }
  /** Irradiance that a stored value of one stands for. */
  double GetIrradianceUnit() const
  {
    return this->IrradianceUnit;
  }
  virtual size_t GetBytes() const;

  /** Says what the last frame modelled and left out. Default: one bounce without visibility. */
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
  virtual int DrawChannel(const std::string&, const vtkIndirectFrame&, const vtkGeometryBufferPass&)
  {
    return 0;
  }
#endif

protected:
  vtkIndirectEstimatorPass();
  ~vtkIndirectEstimatorPass() override;

#ifndef __VTK_WRAP__
  /**
   * Whether the irradiance is stored in 16-bit floats, of which one stands for `unit`, and whether
   * a 16-bit depth buffer comes with it. The default is 32-bit floats, one, and none.
   */
  void SetIrradianceStorage(vtkWindow* window, bool half, double unit, bool depth);
#endif

  std::unique_ptr<vtkIndirectTarget> Irradiance;

private:
  double IrradianceUnit = 1.0;
  bool IrradianceIsHalf = false;
  bool IrradianceHasDepth = false;
  vtkIndirectEstimatorPass(const vtkIndirectEstimatorPass&) = delete;
  void operator=(const vtkIndirectEstimatorPass&) = delete;
};

#endif
