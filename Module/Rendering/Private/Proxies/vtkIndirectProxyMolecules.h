// SPDX-License-Identifier: BSD-3-Clause
// Defines VTKI_MOLECULES if this VTK draws molecules.
#pragma once

// Uses only headers of atoms, so that without molecules no library of chemistry is needed.
#if __has_include("vtkOpenGLMoleculeMapper.h")
#include "vtkOpenGLMoleculeMapper.h" // for its users
#define VTKI_MOLECULES
#endif
