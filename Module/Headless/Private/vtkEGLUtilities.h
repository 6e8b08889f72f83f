// SPDX-License-Identifier: BSD-3-Clause
// Small questions to EGL: what an error is called, what is offered, where a function is.
#ifndef vtkEGLUtilities_h
#define vtkEGLUtilities_h

#include <EGL/egl.h>

#include <string> // for names

namespace vtkEGLUtilities
{
std::string GetErrorName(EGLint error);

/** Whether a list of extensions, which may be nullptr, has that one. */
bool HasExtension(const char* extensions, const std::string& name);

/** Whether that OpenGL renderer, by the name that it gives itself, is a rasterizer on the
 * processor. One that reaches such a rasterizer by way of Vulkan or of a virtual machine names it
 * too. */
bool IsSoftwareRenderer(const std::string& renderer);

/** A function by its name, nullptr where EGL does not know it. */
template <typename Function>
Function GetFunction(const char* name)
{
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}
}

#endif
