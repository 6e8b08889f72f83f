// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRSMReferencePass
 * @brief The sum over senders at every pixel, in double precision on the CPU
 *
 * The reference for estimators that must converge to one diffuse bounce, with or without
 * visibility: it reads the geometry buffer and the virtual lights back and evaluates, in double
 * precision and with code of its own,
 *
 *     E(x) = sum over senders p of B_p A_p cosS cosR / (pi r^2 + A_p)
 *
 * at every pixel, with no interpolation, and at specular pixels the reflection in their lobes,
 *
 *     S(x) = sum over senders p of B_p A_p cosS max(R.V, 0)^power / (pi r^2 + A_p).
 *
 * Both sums include the specular reflection of senders: their lobes, of flux F_p, add F_p I(w) cosR
 * / (r^2 + A_p / (pi max(P', 1))) to E and the same without cosR, times the receiver's lobe, to S
 * (vtkIndirectLibSenderLobe.glsl has the lobe I and its normalisation).
 *
 * In mode ALL_TEXELS the senders are all texels of all maps:
 * with maps of 256 texels squared that is the reference called R1. In mode VIRTUAL_LIGHTS they are
 * the sampler's lights, which isolates the arithmetic of a shader from its sampling.
 *
 * Visibility chooses the senders that a pixel sees: all, those that voxels and spheres of the scene
 * do not hide, or those that none of its triangles and spheres hides
 * (Documentation/methods/occupancy.md).
 *
 * Cost: pixels times senders, about 10^9 terms a second on two cores. It uses VTK's threads.
 *
 * @sa vtkRSMGatherPass
 */

#ifndef vtkRSMReferencePass_h
#define vtkRSMReferencePass_h

#include "vtkIndirectEstimatorPass.h"
#include "vtkIndirectOracleModule.h" // For export macro
#include "vtkIndirectSettings.h"     // For properties

class VTKINDIRECTORACLE_EXPORT vtkRSMReferencePass : public vtkIndirectEstimatorPass
{
public:
  static vtkRSMReferencePass* New();
  vtkTypeMacro(vtkRSMReferencePass, vtkIndirectEstimatorPass);

  const char* GetMethodName() const override { return "reference"; }

  enum ModeType
  {
    ALL_TEXELS = 0,
    VIRTUAL_LIGHTS = 1
  };

  ///@{
  /** The senders that are summed. Default ALL_TEXELS. */
  vtkIndirectClampMacro(Mode, int, ALL_TEXELS, VIRTUAL_LIGHTS);
  void SetModeToAllTexels() { this->SetMode(ALL_TEXELS); }
  void SetModeToVirtualLights() { this->SetMode(VIRTUAL_LIGHTS); }
  ///@}

  enum VisibilityType
  {
    NONE = 0,
    VOXELS = 1,
    EXACT = 2
  };

  ///@{
  /**
   * The obstacles that hide senders from receivers. NONE: those of
   * vtkIndirectIlluminationPass::Visibility, where AUTO means no obstacle. VOXELS: occupied voxels
   * and spheres. EXACT: the triangles of all props that cast shadows, and the spheres of mappers
   * that draw such, by a segment from each pixel to each sender that faces it; both sides of a
   * triangle block. Mappers without polygons that the processor can read draw other shapes, which
   * block nothing; the report names such props. Surfaces hide no light from places nearer to them
   * than 1e-5 of the scene's diagonal. Default NONE.
   */
  vtkIndirectClampMacro(Visibility, int, NONE, EXACT);
  void SetVisibilityToNone() { this->SetVisibility(NONE); }
  void SetVisibilityToVoxels() { this->SetVisibility(VOXELS); }
  void SetVisibilityToExact() { this->SetVisibility(EXACT); }
  ///@}

protected:
  vtkRSMReferencePass();
  ~vtkRSMReferencePass() override = default;

private:
  vtkRSMReferencePass(const vtkRSMReferencePass&) = delete;
  void operator=(const vtkRSMReferencePass&) = delete;

  struct SettingsType
  {
    int Mode = ALL_TEXELS;
    int Visibility = NONE;
  };
  SettingsType Settings;
};

#endif
