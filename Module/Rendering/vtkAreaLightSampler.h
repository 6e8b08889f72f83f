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
  /** Lights that it cuts. One that is there already is not added again. */
  void AddLight(vtkAreaLight* light);
  void RemoveLight(vtkAreaLight* light);
  void RemoveAllLights();
  int GetNumberOfAreaLights() const { return static_cast<int>(this->Lights.size()); }
  /** Null where there are not so many. */
  vtkAreaLight* GetAreaLight(int index) const;
  ///@}

  ///@{
  /**
   * Virtual lights of all of them, at most, but one for each side that sends light. Default 256,
   * range 1 to 1048576. They are shared by how much the light of each is spread.
   */
  vtkSetClampMacro(NumberOfLights, int, 1, 1048576);
  int GetNumberOfLights() override { return this->NumberOfLights; }
  ///@}

  void ReleaseGraphicsResources(vtkWindow* window) override;

  /** The times of the lights count, and those of their images. */
  vtkMTimeType GetMTime() override;

#ifndef __VTK_WRAP__
  bool Update(const Input& input) override;
#endif

protected:
  vtkAreaLightSampler();
  ~vtkAreaLightSampler() override;

  int NumberOfLights = 256;

private:
  vtkAreaLightSampler(const vtkAreaLightSampler&) = delete;
  void operator=(const vtkAreaLightSampler&) = delete;

  std::vector<vtkSmartPointer<vtkAreaLight>> Lights;
  std::vector<double> MadeKey; // what the virtual lights were made from
};

#endif
