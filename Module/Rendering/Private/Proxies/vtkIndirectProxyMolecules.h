// SPDX-License-Identifier: BSD-3-Clause
// Defines VTKI_MOLECULES where this VTK draws molecules.
#ifndef vtkIndirectProxyMolecules_h
#define vtkIndirectProxyMolecules_h

// Atoms: headers alone, so that no library of chemistry is needed where there are none.
#if __has_include("vtkOpenGLMoleculeMapper.h")
#include "vtkOpenGLMoleculeMapper.h" // for its users
#define VTKI_MOLECULES
#endif
#endif
