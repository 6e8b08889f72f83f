// SPDX-License-Identifier: BSD-3-Clause
// Virtual lights where the light of lamps leaves bodies of glass: lobes about the refracted
// directions (Dachsbacher and Stamminger 2006, section 3.3, with both faces of a body).
//
// Light goes towards each body evenly: through squares of the plane that the light sees its bounds'
// sphere on. Light that comes through is a virtual light on the far face, of the lobe's flux alone.
#ifndef vtkIndirectRefractionSampler_h
#define vtkIndirectRefractionSampler_h

#include "Visibility/vtkIndirectRefraction.h" // for paths
#include "vtkVirtualLightSampler.h"

#include <vector> // for rows

class vtkActor;
struct vtkIndirectLight;

class vtkIndirectRefractionSampler : public vtkVirtualLightSampler
{
public:
  static vtkIndirectRefractionSampler* New();
  vtkTypeMacro(vtkIndirectRefractionSampler, vtkVirtualLightSampler);

  /** Squares towards a body from each light: twice as many as a sampler has lights. */
  void SetNumberOfLightsOf(vtkVirtualLightSampler* sampler);

  bool Update(const Input& input) override;
  void AddToReport(vtkIndirectReport& report) const override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkIndirectRefractionSampler() = default;
  ~vtkIndirectRefractionSampler() override = default;

private:
  vtkIndirectRefractionSampler(const vtkIndirectRefractionSampler&) = delete;
  void operator=(const vtkIndirectRefractionSampler&) = delete;

  void Add(const vtkIndirectFrame& frame, const vtkIndirectLight& light, vtkActor* actor,
    const vtkIndirectRefraction& body, std::vector<Row>& rows) const;

  int NumberOfLights = 256;
  std::vector<vtkIndirectRefraction> Bodies; // of the frame's refractors
  std::vector<double> Key;                   // what the lights were made from
};

#endif
