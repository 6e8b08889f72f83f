// SPDX-License-Identifier: BSD-3-Clause
// Complete shader texts from the embedded files.
#ifndef vtkIndirectShaderLibrary_h
#define vtkIndirectShaderLibrary_h

#include <string> // for texts

namespace vtkIndirectShaderLibrary
{
/**
 * Text of a file with its includes expanded, each once, depth first. The name `gather` stands for
 * VTKI_GATHER, the one include that a stage leaves open. Returns an empty string, after one error,
 * for a file that is not embedded.
 */
std::string GetText(const std::string& fileName, const std::string& gather = std::string());

/** What all shaders enable: a part of OpenGL since 3.3 that VTK's GLSL 1.50 lacks, bits of floats.
 */
extern const char* const Extensions;

/**
 * Text of a shader: GetText with the extensions and then `definitions` behind its first line, in
 * place of which VTK puts version 1.50; definitions that begin with a #version line bring their own.
 */
std::string GetShader(const std::string& fileName, const std::string& definitions,
  const std::string& gather = std::string());

/** MD5 of all shader text, so that a figure can be traced to the shaders that made it. */
std::string GetHash();
}

#endif
