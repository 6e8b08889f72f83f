// SPDX-License-Identifier: BSD-3-Clause
// The OpenGL loader of this VTK; include in sources only, before any other GL header.
#pragma once

#if __has_include("vtk_glad.h")
#include "vtk_glad.h" // VTK 9.4 and newer
#else
#include "vtk_glew.h"
#endif
