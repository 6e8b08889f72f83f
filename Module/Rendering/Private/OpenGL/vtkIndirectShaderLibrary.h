// SPDX-License-Identifier: BSD-3-Clause
// Complete shader texts from the embedded files.
#pragma once

#include <string> // for texts

namespace vtkIndirectShaderLibrary
{
/**
 * Returns the text of a file with its includes expanded, each once, depth first. `gather` replaces
 * VTKI_GATHER, the one include that a stage leaves open. Returns an empty string, after one error,
 * for a file that is not embedded.
 */
std::string GetText(const std::string& fileName, const std::string& gather = std::string());

/** Extensions that all shaders enable: bits of floats, in OpenGL since 3.3, but not in VTK's GLSL
 * 1.50.
 */
extern const char* const Extensions;

/**
 * Returns the text of a shader: GetText with the extensions and then `definitions` after its first
 * line, which VTK replaces by version 1.50; definitions may begin with their own #version line.
 */
std::string GetShader(const std::string& fileName, const std::string& definitions,
  const std::string& gather = std::string());

/** Returns the MD5 of all shader text, which lets figures be traced to their shaders. */
std::string GetHash();
}
