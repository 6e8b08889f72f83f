// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkUniformLightSampler
 * @brief Virtual lights spread evenly over the texels of the lights' maps that send light
 *
 * The lights of the scene share NumberOfLights equally. A pattern in the unit square, which depends
 * on nothing but the numbers given here, is warped to the texels that send light, so that none of
 * it is lost on the others (Documentation/methods/importance-sampling.md); where all texels do, the
 * warp changes nothing. Maps of several faces have lights spread evenly over directions. Of maps of
 * more than 256 texels along an edge one texel stands for several.
 */

#ifndef vtkUniformLightSampler_h
#define vtkUniformLightSampler_h

#include "vtkMapLightSampler.h"
#include "vtkRenderingIndirectModule.h" // For export macro

class VTKRENDERINGINDIRECT_EXPORT vtkUniformLightSampler : public vtkMapLightSampler
{
public:
  static vtkUniformLightSampler* New();
  vtkTypeMacro(vtkUniformLightSampler, vtkMapLightSampler);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PatternType
  {
    GRID = 0,           // regular grid, the largest square number of lights that fits
    JITTERED = 1,       // one random place in each cell of that grid, from a fixed seed
    LOW_DISCREPANCY = 2 // Fibonacci lattice, any number of lights
  };

  ///@{
  /** How the lights are spread. Default LOW_DISCREPANCY. */
  vtkSetClampMacro(Pattern, int, GRID, LOW_DISCREPANCY);
  vtkGetMacro(Pattern, int);
  void SetPatternToGrid() { this->SetPattern(GRID); }
  void SetPatternToJittered() { this->SetPattern(JITTERED); }
  void SetPatternToLowDiscrepancy() { this->SetPattern(LOW_DISCREPANCY); }
  ///@}

  ///@{
  /**
   * Virtual lights of a frame. Default 256, range 1 to 1048576. The cost of an estimator grows with
   * it, and its sampling error falls about as one over it.
   */
  vtkSetClampMacro(NumberOfLights, int, 1, 1048576);
  int GetNumberOfLights() override { return this->NumberOfLights; }
  ///@}

  ///@{
  /**
   * Whether lights are drawn from texels that send light only. Off, they are spread over whole
   * maps, as in the paper, and those on the other texels have no light. Default on.
   */
  vtkSetMacro(LitTexels, bool);
  vtkGetMacro(LitTexels, bool);
  vtkBooleanMacro(LitTexels, bool);
  ///@}

  ///@{
  /**
   * Whether a light is multiplied by the share of the hemisphere above it that other surfaces in
   * its map fill within a tenth of the scene's diagonal, so that lights that few surfaces are near
   * to are small (Dachsbacher and Stamminger 2006, section 3.6). Not physical: too dark, by all
   * light of open surfaces, and no part of any comparison with a reference. Default off.
   */
  vtkSetMacro(AmbientOcclusion, bool);
  vtkGetMacro(AmbientOcclusion, bool);
  vtkBooleanMacro(AmbientOcclusion, bool);
  ///@}

#ifndef __VTK_WRAP__
  void MakePattern(const std::vector<Source>& sources, std::vector<Sample>& pattern) override;
  Drawing GetDrawing() const override;
#endif

protected:
  vtkUniformLightSampler() = default;
  ~vtkUniformLightSampler() override = default;

  int Pattern = LOW_DISCREPANCY;
  int NumberOfLights = 256;
  bool LitTexels = true;
  bool AmbientOcclusion = false;

private:
  vtkUniformLightSampler(const vtkUniformLightSampler&) = delete;
  void operator=(const vtkUniformLightSampler&) = delete;
};

#endif
