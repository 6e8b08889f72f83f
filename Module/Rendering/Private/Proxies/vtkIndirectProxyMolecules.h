// SPDX-License-Identifier: BSD-3-Clause
// Whether VTK draws molecules: VTKI_MOLECULES.
#ifndef vtkIndirectProxyMolecules_h
#define vtkIndirectProxyMolecules_h

// Atoms: headers alone, so that no library of chemistry is needed where there are none.
#if __has_include("vtkOpenGLMoleculeMapper.h")
#include "vtkOpenGLMoleculeMapper.h" // for its users
#define VTKI_MOLECULES
#endif
#endif
