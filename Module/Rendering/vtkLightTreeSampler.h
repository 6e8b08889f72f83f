// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLightTreeSampler
 * @brief Virtual lights from a tree over the texels of the lights' maps
 *
 * The texels whose light lies farthest from its mean, by place and normal, are divided until there
 * are as many clusters as lights: a cut through a tree (Walter, Fernandez, Arbree, Bala, Donikian,
 * Greenberg 2005, "Lightcuts: a scalable approach to illumination"). All receivers sum these
 * lights. Receivers near a light sum the eight nodes below it instead, and near one of these nodes
 * the eight below that. Levels are blended at the distance at which the error of the coarser one is
 * `ErrorTolerance` of the scene's usual irradiance. So no light is lost, none is spent on texels
 * that no light reaches, and contacts have thousands of lights.
 *
 * The mean squared relative error is half to a thirtieth of that of as many lights of
 * vtkUniformLightSampler, at about the same time. Approximations: a node is a patch, correct up to
 * the second order in its width over the distance. Where a receiver's horizon cuts it the result is
 * too dark, by up to 5 %, and behind thin bent sheets, within a node's width, too bright. Maps are
 * read back when they have changed. A node's depth map serves its branches.
 */

#ifndef vtkLightTreeSampler_h
#define vtkLightTreeSampler_h

#include "vtkIndirectSettings.h"        // For properties
#include "vtkRenderingIndirectModule.h" // For export macro
#include "vtkVirtualLightSampler.h"

class VTKRENDERINGINDIRECT_EXPORT vtkLightTreeSampler final : public vtkVirtualLightSampler
{
public:
  static vtkLightTreeSampler* New();
  vtkTypeMacro(vtkLightTreeSampler, vtkVirtualLightSampler);

  /**
   * Largest number of virtual lights that all receivers sum, over all lights of the scene together.
   * There may be as few as half of these, once they lie within 4 % of the scene's diagonal of the
   * texels that they represent, root mean square. Setting it turns
   * AutomaticNumberOfLights off. Default 256, range 1 to 1048576.
   */
  void SetNumberOfLights(int number) override;

  ///@{
  /**
   * Make as many lights as the scene needs by the same measure, 128 to 1024 instead of
   * NumberOfLights. In changing scenes, while the window's rate is a frame a second or more
   * (vtkRenderWindow::SetDesiredUpdateRate), at most NumberOfLights. Default on.
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
