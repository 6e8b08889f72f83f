// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkEnvironmentLight
 * @brief Light from all around the scene: the same radiance everywhere, or an image of the sky
 *
 * The light comes from infinitely far away. Without an image it is Radiance from every direction; a
 * surface that sees all of its hemisphere then has the irradiance E = Radiance. An image is
 * equirectangular and shows the surroundings as vtkSkybox does (of VTK up to 9.4, with its default
 * plane): its middle lies ahead (-z), its right half to the right (+x), its upper edge above (+y);
 * Up and Right turn all of it. Its rows go from the nadir to the zenith, bottom row first, as VTK's
 * readers return them.
 *
 * @code
 * vtkNew<vtkEnvironmentLight> sky;
 * sky->SetRadiance(1.0, 1.0, 1.0);
 * pass->SetEnvironment(sky);
 * @endcode
 */

#ifndef vtkEnvironmentLight_h
#define vtkEnvironmentLight_h

#include "vtkIndirectEmitterBase.h"
#include "vtkRenderingIndirectModule.h" // For export macro

#include <vector> // for the cells

class vtkInformationObjectBaseKey;

class VTKRENDERINGINDIRECT_EXPORT vtkEnvironmentLight final : public vtkIndirectEmitterBase
{
public:
  static vtkEnvironmentLight* New();
  vtkTypeMacro(vtkEnvironmentLight, vtkIndirectEmitterBase);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The direction to the upper edge of the image, in world coordinates, of any length. Default (0,
   * 1, 0).
   */
  vtkSetVector3Macro(Up, double);
  vtkGetVector3Macro(Up, double);
  ///@}

  ///@{
  /**
   * The direction to the right of the image's middle, of any length; only its part across Up
   * counts. Default (1, 0, 0).
   */
  vtkSetVector3Macro(Right, double);
  vtkGetVector3Macro(Right, double);
  ///@}

  /**
   * Returns the radiance from a direction in world coordinates, of any length: that of the image's
   * nearest pixel.
   */
  void GetRadianceFrom(const double direction[3], double radiance[3]);

  /**
   * The key of vtkRenderer::GetInformation under which a renderer keeps its environment until a
   * pass is switched on. Python's vtkindirect.enable gives it to the pass.
   */
  static vtkInformationObjectBaseKey* ENVIRONMENT();

protected:
  vtkEnvironmentLight();
  ~vtkEnvironmentLight() override;

  double Up[3] = { 0.0, 1.0, 0.0 };
  double Right[3] = { 1.0, 0.0, 0.0 };

private:
  vtkEnvironmentLight(const vtkEnvironmentLight&) = delete;
  void operator=(const vtkEnvironmentLight&) = delete;

  friend struct vtkIndirectEmitterAccess; // its comments describe the next members

  struct Cell
  {
    double Direction[3]; // world, unit, to the middle of its light
    double Light[3];     // radiance integrated over its solid angle
  };
  const std::vector<Cell>& GetCells();
  void GetGreatestRadiance(double radiance[3]);
  void MakeCells();

  std::vector<Cell> Cells;
  double Greatest[3] = {};
  vtkMTimeType CellsTime = 0; // time of the data that they were made from
};

#endif
