// SPDX-License-Identifier: BSD-3-Clause
// The actors that spheres are looked for in, and whether VTK draws molecules.
#ifndef vtkIndirectProxyActors_h
#define vtkIndirectProxyActors_h

// Atoms: headers alone, so that no library of chemistry is needed where there are none.
#if __has_include("vtkOpenGLMoleculeMapper.h")
#include "vtkOpenGLMoleculeMapper.h" // for its users
#define VTKI_MOLECULES
#endif

#include <functional> // for calls

class vtkActor;
class vtkMatrix4x4;
class vtkProp;

namespace vtkIndirectProxyActors
{
/** Calls for each visible actor with a mapper in a prop, with its matrix in world coordinates. */
void ForEach(vtkProp* prop, const std::function<void(vtkActor*, vtkMatrix4x4*)>& call);
}
#endif
