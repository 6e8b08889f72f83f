// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkIndirectSphereBlockers.h"

//------------------------------------------------------------------------------
const vtkIndirectBlockingSpheres* vtkIndirectSphereBlockers::Update(
  const vtkIndirectFrame& frame, vtkObject* caller)
{
  if (!this->Scene.Update(frame, {}, caller))
  {
    return &this->Result;
  }
  ++this->Result.NumberOfUpdates;
  this->Result.Spheres.clear();
  for (const vtkIndirectProxySphere& sphere : this->Scene.TakeSpheres())
  {
    this->Result.Spheres.emplace_back(sphere.Center, sphere.Radius);
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
