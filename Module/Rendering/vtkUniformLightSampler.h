// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkUniformLightSampler
 * @brief Virtual lights spread evenly over the texels of the lights' maps that send light
 *
 * The lights of the scene share NumberOfLights equally. A pattern in the unit square, which depends
 * only on these parameters, is warped to the texels that send light, so that no light is lost on
 * other texels (Documentation/methods/importance-sampling.md); if all texels send light, the warp
 * changes nothing. Lights of maps of several faces are spread uniformly over directions. In maps of
 * more than 256 texels along an edge one texel represents several.
 */

#ifndef vtkUniformLightSampler_h
#define vtkUniformLightSampler_h

#include "vtkIndirectSettings.h"        // For properties
#include "vtkRenderingIndirectModule.h" // For export macro
#include "vtkVirtualLightSampler.h"

class VTKRENDERINGINDIRECT_EXPORT vtkUniformLightSampler final : public vtkVirtualLightSampler
{
public:
  static vtkUniformLightSampler* New();
  vtkTypeMacro(vtkUniformLightSampler, vtkVirtualLightSampler);

  enum PatternType
  {
    GRID = 0,           // regular grid, the largest square number of lights that fits
    JITTERED = 1,       // one random place in each cell of that grid, from a fixed seed
    LOW_DISCREPANCY = 2 // Fibonacci lattice, any number of lights
  };

  ///@{
  /** The pattern by which the lights are spread. Default LOW_DISCREPANCY. */
  vtkIndirectClampMacro(Pattern, int, GRID, LOW_DISCREPANCY);
  void SetPatternToGrid() { this->SetPattern(GRID); }
  void SetPatternToJittered() { this->SetPattern(JITTERED); }
  void SetPatternToLowDiscrepancy() { this->SetPattern(LOW_DISCREPANCY); }
  ///@}

  ///@{
  /**
   * Draw lights only from texels that send light. If it is off, lights are spread over whole maps,
   * as in the paper, and those on other texels have no light. Default on.
   */
  vtkIndirectFlagMacro(LitTexels);
  ///@}

  ///@{
  /**
   * Multiply each light by the share of the hemisphere above it that other surfaces in its map fill
   * within a tenth of the scene's diagonal, so that lights with few surfaces near them are small
   * (Dachsbacher and Stamminger 2006, section 3.6). Not physical: too dark, by all light of open
   * surfaces, and not part of any comparison with a reference. Default off.
   */
  vtkIndirectFlagMacro(AmbientOcclusion);
  ///@}

protected:
  vtkUniformLightSampler();
  ~vtkUniformLightSampler() override = default;

  struct SettingsType
  {
    int Pattern = LOW_DISCREPANCY;
    bool LitTexels = true;
    bool AmbientOcclusion = false;
  };
  SettingsType Settings;

private:
  vtkUniformLightSampler(const vtkUniformLightSampler&) = delete;
  void operator=(const vtkUniformLightSampler&) = delete;
};

#endif
