// SPDX-License-Identifier: BSD-3-Clause
// The actors that a prop draws: the prop itself, or the parts of an assembly.
#ifndef vtkIndirectActors_h
#define vtkIndirectActors_h

#include <functional> // for calls

class vtkActor;
class vtkMatrix4x4;
class vtkProp;

namespace vtkIndirectActors
{
/**
 * Calls the function for each visible actor with a mapper in a prop, with the actor's matrix in
 * world coordinates.
 */
void ForEach(vtkProp* prop, const std::function<void(vtkActor*, vtkMatrix4x4*)>& call);
}
#endif
