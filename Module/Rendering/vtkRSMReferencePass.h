// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRSMReferencePass
 * @brief The sum over senders at every pixel, in double precision on the CPU
 *
 * The oracle for estimators that promise to converge to one unoccluded diffuse bounce: it reads the
 * geometry buffer and the virtual lights back and evaluates, in double precision and with code of
 * its own,
 *
 *     E(x) = sum over senders p of B_p A_p cosS cosR / (pi r^2 + A_p)
 *
 * at every pixel, with no interpolation, and at specular pixels what their lobes reflect,
 *
 *     S(x) = sum over senders p of B_p A_p cosS max(R.V, 0)^power / (pi r^2 + A_p).
 *
 * In mode ALL_TEXELS the senders are all texels of all maps:
 * with maps of 256 texels squared that is the reference called R1. In mode VIRTUAL_LIGHTS they are
 * the sampler's lights, which isolates the arithmetic of a shader from its sampling.
 *
 * Cost: pixels times senders, about 10^9 terms a second on two cores. It uses VTK's threads.
 *
 * @sa vtkRSMGatherPass
 */

#ifndef vtkRSMReferencePass_h
#define vtkRSMReferencePass_h

#include "vtkIndirectEstimatorPass.h"
#include "vtkRenderingIndirectModule.h" // For export macro

class VTKRENDERINGINDIRECT_EXPORT vtkRSMReferencePass : public vtkIndirectEstimatorPass
{
public:
  static vtkRSMReferencePass* New();
  vtkTypeMacro(vtkRSMReferencePass, vtkIndirectEstimatorPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  const char* GetMethodName() const override { return "reference"; }
  bool ComputesGlossy() const override { return true; }
  void ReleaseGraphicsResources(vtkWindow* window) override;

  enum ModeType
  {
    ALL_TEXELS = 0,
    VIRTUAL_LIGHTS = 1
  };

  ///@{
  /** Which senders are summed. Default ALL_TEXELS. */
  vtkSetClampMacro(Mode, int, ALL_TEXELS, VIRTUAL_LIGHTS);
  vtkGetMacro(Mode, int);
  void SetModeToAllTexels() { this->SetMode(ALL_TEXELS); }
  void SetModeToVirtualLights() { this->SetMode(VIRTUAL_LIGHTS); }
  ///@}

#ifndef __VTK_WRAP__
  vtkVirtualLightSampler* ChooseSampler(
    vtkVirtualLightSampler* users, const vtkIndirectPlan& plan) override;
  vtkIndirectEstimate Estimate(const Input& input) override;
  size_t GetBytes() const override;
#endif

protected:
  vtkRSMReferencePass();
  ~vtkRSMReferencePass() override;

  int Mode = ALL_TEXELS;

private:
  vtkRSMReferencePass(const vtkRSMReferencePass&) = delete;
  void operator=(const vtkRSMReferencePass&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
