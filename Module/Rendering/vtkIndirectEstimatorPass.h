// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkIndirectEstimatorPass
 * @brief Abstract: geometry buffer, maps and virtual lights in, irradiance out
 *
 * The irradiance is in VTK's units, where a constant radiance L over the hemisphere gives E = L and
 * a diffuse surface sends out albedo times E. Its texture has the size of the viewport.
 *
 * Some estimators also compute what receivers reflect specularly, by the lobes of VTK's Phong
 * model; see SpecularTransport. The result excludes the material's specular colour, by which the
 * composite multiplies it. Some estimators also sum what senders reflect specularly, such as
 * caustics.
 *
 * An estimator holds the user's settings. The part that sums the light is private to this library,
 * so classes outside of it cannot derive from this one.
 */

#ifndef vtkIndirectEstimatorPass_h
#define vtkIndirectEstimatorPass_h

#include "vtkIndirectSettings.h" // For properties
#include "vtkOpenGLRenderPass.h"
#include "vtkRenderingIndirectModule.h" // For export macro
#include "vtkSmartPointer.h"            // For a member

#include <memory> // for the private part

class vtkIndirectIlluminationPass;
class vtkIndirectSum;

class VTKRENDERINGINDIRECT_EXPORT vtkIndirectEstimatorPass : public vtkOpenGLRenderPass
{
public:
  vtkTypeMacro(vtkIndirectEstimatorPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Draws the whole frame with this estimator, like a vtkIndirectIlluminationPass with this
   * estimator: renderer->SetPass(estimator). Settings of the frame are set on GetIlluminationPass.
   */
  void Render(const vtkRenderState* s) override;
  /** Returns the pass by which this one draws frames when it is set on a renderer by itself. */
  vtkIndirectIlluminationPass* GetIlluminationPass();
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /** Returns a short name for reports, e.g. "gather". */
  virtual const char* GetMethodName() const = 0;

  ///@{
  /**
   * Let receivers with Phong's model and a specular coefficient reflect indirect light specularly,
   * and senders with such a model or with VTK's PBR reflect the lights specularly, if the
   * estimator can compute that. Costs nothing in scenes without such surfaces. Default on.
   */
  vtkIndirectFlagMacro(SpecularTransport);
  ///@}

  ///@{
  /**
   * Alias for scripts: if vtkIndirectIlluminationPass::Visibility is AUTO, AUTO means VOXELS with
   * this estimator. Default off, on for radiance hints. The report says whether voxels were used.
   */
  vtkIndirectFlagMacro(Occupancy);
  ///@}

  ///@{
  /** Voxels along the longest edge of the scene. Default 128, range 16 to 128. */
  vtkIndirectClampMacro(OccupancyResolution, int, 16, 128);
  ///@}

protected:
  explicit vtkIndirectEstimatorPass(std::unique_ptr<vtkIndirectSum> sum);
  ~vtkIndirectEstimatorPass() override;

private:
  vtkIndirectEstimatorPass(const vtkIndirectEstimatorPass&) = delete;
  void operator=(const vtkIndirectEstimatorPass&) = delete;

  struct SettingsType
  {
    bool SpecularTransport = true;
    bool Occupancy = false;
    int OccupancyResolution = 128;
  };
  SettingsType Settings;

  friend class vtkIndirectSum;
  const std::unique_ptr<vtkIndirectSum> Sum;
  // The pass draws frames if this one is a renderer's pass; it does not hold this one.
  vtkSmartPointer<vtkIndirectIlluminationPass> Whole;
  bool IsReleasing = false;
};

#endif
