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
class vtkVirtualLightSampler;

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

  enum PresetType
  {
    ROBUST = 0,
    PAPER = 1
  };

  ///@{
  /**
   * ROBUST: the defaults. PAPER: the method as published, for comparisons. Setting PAPER gives this
   * estimator's properties the values of its paper, and setting ROBUST gives them their defaults;
   * both overwrite what was set before, and properties may be changed afterwards. With PAPER, too,
   * an automatic Visibility of the pass hides nothing, an automatic NumberOfBounces is one, and a
   * pass without a sampler takes that of the paper (GetSamplerOfPreset). Each class's page lists
   * where PAPER departs from the paper. Default ROBUST.
   */
  void SetPreset(int preset);
  int GetPreset() const { return this->Preset; }
  void SetPresetToRobust() { this->SetPreset(ROBUST); }
  void SetPresetToPaper() { this->SetPreset(PAPER); }
  ///@}

  /**
   * Returns the sampler that a vtkIndirectIlluminationPass without a sampler takes for this
   * estimator: with PAPER that of the paper. Null: the pass's default, a vtkLightTreeSampler.
   */
  vtkVirtualLightSampler* GetSamplerOfPreset() const;

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
   * Voxels along the longest edge of the scene, for vtkIndirectIlluminationPass::Visibility.
   * Default 128, range 16 to 128.
   */
  vtkIndirectClampMacro(OccupancyResolution, int, 16, 128);
  ///@}

protected:
  explicit vtkIndirectEstimatorPass(std::unique_ptr<vtkIndirectSum> sum);
  ~vtkIndirectEstimatorPass() override;

  /** Gives the estimator's own properties the values of the preset. */
  virtual void ApplyPreset() {}
  /** Makes the paper's sampler; null: the paper has none, or the estimator takes none. */
  virtual vtkSmartPointer<vtkVirtualLightSampler> MakeSamplerOfPaper() const;

private:
  vtkIndirectEstimatorPass(const vtkIndirectEstimatorPass&) = delete;
  void operator=(const vtkIndirectEstimatorPass&) = delete;

  struct SettingsType
  {
    bool SpecularTransport = true;
    int OccupancyResolution = 128;
  };
  SettingsType Settings;
  int Preset = ROBUST;
  vtkSmartPointer<vtkVirtualLightSampler> SamplerOfPreset;

  friend class vtkIndirectSum;
  const std::unique_ptr<vtkIndirectSum> Sum;
  // The pass draws frames if this one is a renderer's pass; it does not hold this one.
  vtkSmartPointer<vtkIndirectIlluminationPass> Whole;
  bool IsReleasing = false;
};

#endif
