// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkVirtualLightSampler
 * @brief Abstract: the source of virtual lights
 *
 * A virtual light is a place that sends light: position, normal, the area A of the surface that it
 * represents, and that surface's reflected radiance times the area, B A (Keller 1997, "Instant
 * radiosity"; Dachsbacher and Stamminger 2005). Or it is a direction that light comes from, with
 * the solid angle that it represents and the radiance times that angle.
 *
 * A virtual light on a specular surface also has a lobe, about the direction of the mirrored light
 * (Dachsbacher and Stamminger 2006, "Splatting indirect illumination", eq. 3).
 *
 * A sampler holds the user's settings. The part that makes the lights is private to this library,
 * so classes outside of it cannot derive from this one.
 */

#ifndef vtkVirtualLightSampler_h
#define vtkVirtualLightSampler_h

#include "vtkObject.h"
#include "vtkRenderingIndirectModule.h" // For export macro

#include <memory> // for the private part

class vtkIndirectSampler;
class vtkWindow;

class VTKRENDERINGINDIRECT_EXPORT vtkVirtualLightSampler : public vtkObject
{
public:
  vtkTypeMacro(vtkVirtualLightSampler, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of virtual lights of a frame, over all lights of the scene together; subclasses define
   * its exact meaning. The sky and area lights get as many, and so does the light that leaves each
   * body of glass. The cost of an estimator grows with it, and its sampling error falls about as
   * one over it. Default 256, of vtkRandomWalkLightSampler 1000; range 1 to 1048576.
   */
  virtual void SetNumberOfLights(int number);
  int GetNumberOfLights() const { return this->NumberOfLights; }
  ///@}

  /** Releases all resources in the window's context; does nothing without a window. */
  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  explicit vtkVirtualLightSampler(std::unique_ptr<vtkIndirectSampler> lights);
  ~vtkVirtualLightSampler() override;

  int NumberOfLights = 256;

private:
  vtkVirtualLightSampler(const vtkVirtualLightSampler&) = delete;
  void operator=(const vtkVirtualLightSampler&) = delete;

  friend class vtkIndirectSampler;
  const std::unique_ptr<vtkIndirectSampler> Lights;
};

#endif
