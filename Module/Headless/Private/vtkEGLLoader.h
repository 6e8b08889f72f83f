// SPDX-License-Identifier: BSD-3-Clause
// OpenGL's functions through EGL: the queries made before VTK has loaded OpenGL, and the loading
// itself for a VTK that uses GLEW. The context must be current.
#pragma once

#include <string> // for names

// Before VTK 9.4 OpenGL's functions come from GLEW.
#if !__has_include("vtk_glad.h")
#define VTK_INDIRECT_USE_GLEW
#endif

namespace vtkEGLLoader
{
std::string GetVersion();
std::string GetRenderer();

/** 45 for OpenGL 4.5. */
int GetVersionNumber();
int GetMaximumTextureSize();
float GetMaximumLineWidth(bool smooth);

#ifdef VTK_INDIRECT_USE_GLEW
/** Returns an empty string, or the reason why OpenGL cannot be loaded. */
std::string LoadGLEW();
#endif
}
