// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectActors.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkDataSetMapper.h"
#include "vtkMapper.h"
#include "vtkPolyData.h"

//------------------------------------------------------------------------------
void vtkIndirectActors::ForEach(
  vtkProp* prop, const std::function<void(vtkActor*, vtkMatrix4x4*)>& call)
{
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkAssemblyNode* last = path->GetLastNode();
    auto* actor = vtkActor::SafeDownCast(last->GetViewProp());
    if (actor && actor->GetMapper() && actor->GetVisibility())
    {
      call(actor, last->GetMatrix() ? last->GetMatrix() : actor->GetMatrix());
    }
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectActors::RunsPipeline(vtkAlgorithm* mapper)
{
  auto* known = vtkMapper::SafeDownCast(mapper);
  return !known || !known->GetStatic() ||
    (vtkDataSetMapper::SafeDownCast(known) &&
      vtkPolyData::SafeDownCast(known->GetInputDataObject(0, 0)));
}
