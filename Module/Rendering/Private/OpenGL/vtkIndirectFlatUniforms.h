// SPDX-License-Identifier: BSD-3-Clause
// Uniforms of a fragment shader as flat varyings, where that is cheaper. OpenGL on the processor
// (Mesa's llvmpipe) reads every component of a uniform for each of eight pixels by itself, bounds
// checked, wherever it is used: 4 ns for eight pixels, half a texel. A flat varying is one load; it
// costs at the vertices, and 10 ns for each triangle and four components.
#ifndef vtkIndirectFlatUniforms_h
#define vtkIndirectFlatUniforms_h

#include <string>

namespace vtkIndirectFlatUniforms
{
/**
 * Lets a vertex shader hand on what a fragment shader declares, a line each, as `uniform T name;`
 * with T int, float, or vectors or matrices of float or int; both go on calling it by that name.
 * Arrays, samplers and what would be more than `maximum` components stay as they are. Nothing may
 * stand between the two shaders.
 */
void Move(std::string& vertexShader, std::string& fragmentShader, int maximum);
}

#endif
