// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkAreaLightSampler
 * @brief Virtual lights of area lights
 *
 * Cuts rectangles that send light (vtkAreaLight) into pieces, each of which is a virtual light: few
 * pieces hold all of the light, and more where it is concentrated. Any estimator that sums virtual
 * lights takes them, and a depth map of each virtual light tells what hides it. An area light with
 * vtkAreaLight::Method VIRTUAL_LIGHTS is given to a sampler of the pass's own; this class is also
 * for vtkIndirectIlluminationPass::AddSampler.
 *
 * All area lights together have at most NumberOfLights virtual lights, but at least one for each
 * side that sends light. Each area light's share depends on how much its light is spread.
 *
 * Direct illumination from dynamic area lights: Nichols and Wyman 2009. Clustering MIN_MAX is
 * theirs. With VARIANCE receivers near a piece sum eight pieces in its place, and near one of these
 * eight more, so that the error of each stays below a share of
 * vtkIndirectIlluminationPass::ErrorTolerance: the set of lights for each fragment that the paper
 * names as future work. Approximation: a piece is a disk of its area at its light's mean place.
 * Nearer to the rectangle than the width of the smallest pieces the light is wrong: too bright in
 * the middle of a piece and too dark between pieces. With 256 lights a uniformly bright square has
 * pieces of a sixteenth of its edge, and smallest pieces of a 64th.
 */

#ifndef vtkAreaLightSampler_h
#define vtkAreaLightSampler_h

#include "vtkIndirectSettings.h"        // For properties
#include "vtkRenderingIndirectModule.h" // For export macro
#include "vtkSmartPointer.h"            // for lights
#include "vtkVirtualLightSampler.h"

#include <vector> // for lists

class vtkAreaLight;

class VTKRENDERINGINDIRECT_EXPORT vtkAreaLightSampler final : public vtkVirtualLightSampler
{
public:
  static vtkAreaLightSampler* New();
  vtkTypeMacro(vtkAreaLightSampler, vtkVirtualLightSampler);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ClusteringType
  {
    VARIANCE = 0,
    MIN_MAX = 1
  };

  ///@{
  /**
   * The way that rectangles are cut. VARIANCE: halves the piece whose light lies farthest from its
   * mean. MIN_MAX: joins squares of the finest of 64 x 64 whose least and greatest luminance (the
   * sum over the colours) differ by as little as NumberOfLights allows, as the paper does. Default
   * VARIANCE.
   */
  vtkIndirectClampMacro(Clustering, int, VARIANCE, MIN_MAX);
  void SetClusteringToVariance() { this->SetClustering(VARIANCE); }
  void SetClusteringToMinMax() { this->SetClustering(MIN_MAX); }
  ///@}

  ///@{
  /** Area lights that are cut. Adding a light twice has no effect. */
  void AddLight(vtkAreaLight* light);
  void RemoveLight(vtkAreaLight* light);
  void RemoveAllLights();
  int GetNumberOfAreaLights() const { return static_cast<int>(this->Lights.size()); }
  /** Returns an area light; null if the index is out of range. */
  vtkAreaLight* GetAreaLight(int index) const;
  ///@}

  /** Includes the times of the lights and of their images. */
  vtkMTimeType GetMTime() override;

protected:
  vtkAreaLightSampler();
  ~vtkAreaLightSampler() override;

private:
  vtkAreaLightSampler(const vtkAreaLightSampler&) = delete;
  void operator=(const vtkAreaLightSampler&) = delete;

  friend struct vtkIndirectAreaSamplerAccess; // its comments describe the next function

  void SetLights(const std::vector<vtkSmartPointer<vtkAreaLight>>& lights);

  struct SettingsType
  {
    int Clustering = VARIANCE;
  };
  SettingsType Settings;
  std::vector<vtkSmartPointer<vtkAreaLight>> Lights;
};

#endif
