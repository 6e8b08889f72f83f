// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkAreaLightSampler
 * @brief Virtual lights of area lights
 *
 * Rectangles that send light (vtkAreaLight), cut into pieces of which each is a virtual light: all
 * of the light in few of them, more where it is concentrated. Any estimator that sums virtual
 * lights takes them, and a depth map of each tells what it is hidden from. The pass itself does not
 * need it: vtkIndirectIlluminationPass::AddAreaLight computes direct light in closed form. This is
 * the way of the paper, for vtkIndirectIlluminationPass::AddSampler.
 *
 * There are NumberOfLights virtual lights of all area lights at most, but one for each side that
 * sends light; they are shared by how much the light of each is spread.
 *
 * Direct illumination from dynamic area lights: Nichols and Wyman 2009. Approximation: a piece is a
 * disk of its area at its light's mean place, so nearer to the rectangle than a piece is large the
 * light is wrong, in the middle of a piece too bright and between pieces too dark; with 256 lights
 * an evenly bright square has pieces of a sixteenth of its edge.
 */

#ifndef vtkAreaLightSampler_h
#define vtkAreaLightSampler_h

#include "vtkRenderingIndirectModule.h" // For export macro
#include "vtkSmartPointer.h"            // for lights
#include "vtkVirtualLightSampler.h"

#include <vector> // for lists

class vtkAreaLight;

class VTKRENDERINGINDIRECT_EXPORT vtkAreaLightSampler : public vtkVirtualLightSampler
{
public:
  static vtkAreaLightSampler* New();
  vtkTypeMacro(vtkAreaLightSampler, vtkVirtualLightSampler);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Area lights that are cut. A light that is there already is not added again. */
  void AddLight(vtkAreaLight* light);
  void RemoveLight(vtkAreaLight* light);
  void RemoveAllLights();
  int GetNumberOfAreaLights() const { return static_cast<int>(this->Lights.size()); }
  /** Null where there are not so many. */
  vtkAreaLight* GetAreaLight(int index) const;
  ///@}

  /** The times of the lights count, and those of their images. */
  vtkMTimeType GetMTime() override;

protected:
  vtkAreaLightSampler();
  ~vtkAreaLightSampler() override;

private:
  vtkAreaLightSampler(const vtkAreaLightSampler&) = delete;
  void operator=(const vtkAreaLightSampler&) = delete;

  std::vector<vtkSmartPointer<vtkAreaLight>> Lights;
};

#endif
