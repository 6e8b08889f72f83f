// SPDX-License-Identifier: BSD-3-Clause
// Turns uniforms of a fragment shader into flat varyings if that is cheaper. OpenGL on the
// processor (Mesa's llvmpipe) reads every component of a uniform separately for each of eight
// pixels, with bounds check, at every use: 4 ns for eight pixels, half a texel. A flat varying is
// one load, at the cost of its vertices and 10 ns for each triangle and four components.
#pragma once

#include <string>

namespace vtkIndirectFlatUniforms
{
/**
 * Makes varyings of uniforms that a fragment shader declares, one a line, as `uniform T name;` with
 * T int, float, or vectors or matrices of float or int; the vertex shader passes them on under the
 * same name. Arrays and samplers stay uniforms, and so do uniforms beyond `maximum` components, which
 * count what the vertex shader passes on already. There must be no other stage between the two
 * shaders.
 */
void Move(std::string& vertexShader, std::string& fragmentShader, int maximum);
}
