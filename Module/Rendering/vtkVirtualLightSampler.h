// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkVirtualLightSampler
 * @brief Abstract: where virtual lights come from
 *
 * A virtual light is a place that sends light: position, normal, the area A of the surface that it
 * stands for, and that surface's reflected radiance times the area, B A (Keller 1997, "Instant
 * radiosity"; Dachsbacher and Stamminger 2005). Or it is a direction that light comes from, with
 * the solid angle that it stands for and the radiance times that.
 *
 * Where a light falls on something specular, a virtual light has a lobe, too: about the direction
 * in which it is reflected (Dachsbacher and Stamminger 2006, "Splatting indirect illumination", eq.
 * 3).
 *
 * A sampler holds what the user sets of it. The part that makes the lights is private to this
 * library, so classes outside of it cannot derive from this one.
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
   * Virtual lights of a frame, over all lights of the scene together; classes say what they make of
   * it. As many are made of the sky and of area lights, and of what leaves each body of glass. The
   * cost of an estimator grows with it, and its sampling error falls about as one over it. Default
   * 256, of vtkRandomWalkLightSampler 1000; range 1 to 1048576.
   */
  virtual void SetNumberOfLights(int number);
  int GetNumberOfLights() const { return this->NumberOfLights; }
  ///@}

  /** Number of virtual lights in the last frame. */
  int GetActualNumberOfLights() const;

  /** Gives back what it holds in the window's context; without a window nothing happens. */
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
