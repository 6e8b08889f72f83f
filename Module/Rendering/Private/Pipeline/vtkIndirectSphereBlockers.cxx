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
  std::vector<vtkIndirectBlockingSpheres::Look> looks;
  for (const vtkIndirectProxySphere& sphere : this->Scene.TakeSpheres())
  {
    spheres.emplace_back(sphere.Center, sphere.Radius);
    looks.push_back({ sphere.Albedo, sphere.PhysicallyBased });
  }
  // A colour may have changed, or a prop that draws no spheres.
  if (spheres != this->Result.Spheres)
  {
    this->Result.Spheres = std::move(spheres);
    ++this->Result.NumberOfUpdates;
  }
  if (looks != this->Result.Looks)
  {
    this->Result.Looks = std::move(looks);
    ++this->Result.NumberOfLooks;
  }
  this->Result.What = this->Scene.GetWhat();
  this->Result.Props = this->Scene.GetProps();
  this->Result.Mappers = this->Scene.GetMappers();
  this->Result.LeftOut = this->Scene.GetLeftOut();
  return &this->Result;
}

//------------------------------------------------------------------------------
void vtkIndirectSphereBlockers::Forget()
{
  this->Scene.Forget();
  const size_t updates = this->Result.NumberOfUpdates;
  const size_t looks = this->Result.NumberOfLooks;
  this->Result = vtkIndirectBlockingSpheres();
  this->Result.NumberOfUpdates = updates;
  this->Result.NumberOfLooks = looks;
}
