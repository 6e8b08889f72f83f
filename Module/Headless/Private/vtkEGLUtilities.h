// SPDX-License-Identifier: BSD-3-Clause
// Small queries to EGL: names of errors, extensions, addresses of functions.
#pragma once

#include <EGL/egl.h>

#include <string> // for names

namespace vtkEGLUtilities
{
std::string GetErrorName(EGLint error);

/** True if a list of extensions, which may be nullptr, has that one. */
bool HasExtension(const char* extensions, const std::string& name);

/** True if an OpenGL renderer, by its own name, is a rasterizer on the processor. One that uses
 * such a rasterizer through Vulkan or a virtual machine has its name, too. */
bool IsSoftwareRenderer(const std::string& renderer);

/** A function by its name, nullptr if EGL does not have it. */
template <typename Function>
Function GetFunction(const char* name)
{
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}
}
