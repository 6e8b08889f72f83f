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

class vtkGeometryBufferPass;
class vtkIndirectStageTimer;
struct vtkIndirectReport;
class vtkIndirectTarget;
class vtkReflectiveShadowMapPass;
class vtkVirtualLightSampler;
struct vtkIndirectFrame;

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
    int NumberOfBounces = 1; // as asked for
    bool Caching = true;     // off: nothing may be kept from earlier frames
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
  virtual size_t GetBytes() const;

  /** Says what the last frame modelled and left out. Default: one bounce without visibility. */
  virtual void AddToReport(vtkIndirectReport& report) const;
#endif

protected:
  vtkIndirectEstimatorPass();
  ~vtkIndirectEstimatorPass() override;

  std::unique_ptr<vtkIndirectTarget> Irradiance;

private:
  vtkIndirectEstimatorPass(const vtkIndirectEstimatorPass&) = delete;
  void operator=(const vtkIndirectEstimatorPass&) = delete;
};

#endif
