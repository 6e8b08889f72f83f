// SPDX-License-Identifier: BSD-3-Clause
// Virtual lights where the light of lamps leaves bodies of glass: lobes about the refracted
// directions (Dachsbacher and Stamminger 2006, section 3.3, with both faces of a body).
//
// Light goes uniformly towards each body: through the squares of a grid that is as wide as the
// sphere around the body's bounds looks from the light. Light that passes the body becomes a
// virtual light on the far face, with the lobe's flux alone.
#pragma once

#include "OpenGL/vtkIndirectKey.h"         // for keys
#include "Senders/vtkIndirectRefraction.h" // for paths
#include "Senders/vtkIndirectSampler.h"

#include <vector> // for rows

class vtkActor;
struct vtkIndirectLight;

class vtkIndirectRefractionSampler : public vtkIndirectSampler
{
public:
  /** Makes each light send twice this many squares of light towards a body. */
  void SetNumberOfLights(int number);

  bool Update(const Input& input) override;
  void AddToReport(vtkIndirectReport& report) const override;

protected:
  void ReleaseOwn(vtkWindow* window) override
  {
    this->vtkIndirectSampler::ReleaseOwn(window);
    this->Key.Clear();
    this->Bodies.clear();
  }

private:
  void Add(const vtkIndirectFrame& frame, const vtkIndirectLight& light, vtkActor* actor,
    const vtkIndirectRefraction& body, std::vector<Row>& rows) const;

  int NumberOfLights = 256;
  std::vector<vtkIndirectRefraction> Bodies; // of the frame's refractors
  vtkIndirectKey Key;                        // the inputs of the lights
};
