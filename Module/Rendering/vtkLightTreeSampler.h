// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLightTreeSampler
 * @brief Virtual lights from a tree over the texels of the lights' maps
 *
 * Texels that send light are divided by place and normal, always those whose light lies farthest
 * from its mean, until there are as many clusters as lights: a cut through a tree (Walter,
 * Fernandez, Arbree, Bala, Donikian, Greenberg 2005, "Lightcuts: a scalable approach to
 * illumination"). All receivers sum these. Those that are near to one of them sum, in its place,
 * the eight nodes below it, and near to one of these the eight below that, blended where the
 * distance is such that the error of the coarser one is `ErrorTolerance` of what is usual in the
 * scene. So no light is lost, none is spent on texels that no light reaches, and contacts have
 * thousands of lights.
 *
 * The mean squared relative error is half to a thirtieth of what as many lights of
 * vtkUniformLightSampler leave, at about the same time. Approximations: a node is a patch,
 * right up to the second order in its width over the distance; where a receiver's horizon cuts it
 * the result is too dark, by up to 5 %, and behind thin bent sheets, within a node's width, too
 * bright. Maps are read back when they have changed: 10 to 40 ms. A node's depth map
 * serves its branches.
 */

#ifndef vtkLightTreeSampler_h
#define vtkLightTreeSampler_h

#include "vtkIndirectSettings.h"        // For properties
#include "vtkRenderingIndirectModule.h" // For export macro
#include "vtkVirtualLightSampler.h"

class VTKRENDERINGINDIRECT_EXPORT vtkLightTreeSampler : public vtkVirtualLightSampler
{
public:
  static vtkLightTreeSampler* New();
  vtkTypeMacro(vtkLightTreeSampler, vtkVirtualLightSampler);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Virtual lights that all receivers sum at most, over all lights of the scene together, and as
   * few as half of these, once they lie within 4 % of the scene's diagonal of what they stand for,
   * root mean square. Where a headlight is the only light, as many as this of even ones of what the
   * eye sees. Setting it turns AutomaticNumberOfLights off. Default 256, range 1 to 1048576.
   */
  void SetNumberOfLights(int number) override;

  ///@{
  /**
   * Make as many lights as the scene needs by the same measure, 128 to 1024 in place of
   * NumberOfLights; of what changes while the window gives a frame a second or less
   * (vtkRenderWindow::SetDesiredUpdateRate), NumberOfLights at most. Default on.
   */
  vtkIndirectFlagMacro(AutomaticNumberOfLights);
  ///@}

protected:
  vtkLightTreeSampler();
  ~vtkLightTreeSampler() override = default;

  struct SettingsType
  {
    bool AutomaticNumberOfLights = true;
  };
  SettingsType Settings;

private:
  vtkLightTreeSampler(const vtkLightTreeSampler&) = delete;
  void operator=(const vtkLightTreeSampler&) = delete;
};

#endif
