// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkIndirectSphereBlockers.h"

#include <utility>

//------------------------------------------------------------------------------
const vtkIndirectBlockingSpheres* vtkIndirectSphereBlockers::Update(
  const vtkIndirectFrame& frame, vtkObject* caller)
{
  if (!this->Scene.Update(frame, {}, caller))
  {
    return &this->Result;
  }
  std::vector<glm::dvec4> spheres;
  for (const vtkIndirectProxySphere& sphere : this->Scene.TakeSpheres())
  {
    spheres.emplace_back(sphere.Center, sphere.Radius);
  }
  // A colour may have changed, or what is no sphere.
  if (spheres != this->Result.Spheres)
  {
    this->Result.Spheres = std::move(spheres);
    ++this->Result.NumberOfUpdates;
  }
  this->Result.What = this->Scene.GetWhat();
  this->Result.Props = this->Scene.GetProps();
  this->Result.LeftOut = this->Scene.GetLeftOut();
  return &this->Result;
}

//------------------------------------------------------------------------------
void vtkIndirectSphereBlockers::Forget()
{
  this->Scene.Forget();
  const size_t updates = this->Result.NumberOfUpdates;
  this->Result = vtkIndirectBlockingSpheres();
  this->Result.NumberOfUpdates = updates;
}
