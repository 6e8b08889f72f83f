// SPDX-License-Identifier: BSD-3-Clause
// Uniforms of surfaces whose positions are counted from within the scene, see CountFromWithin in
// vtkIndirectCaptureText.cxx: far from the origin floats would round positions too coarsely.
#pragma once

#include <glm/glm.hpp> // for places

class vtkProp;
class vtkRenderer;
class vtkShaderProgram;

namespace vtkIndirectWithin
{
/**
 * Sets the uniforms, if the program has them: positions relative to the scene's centre, in the
 * prop's own coordinates and rounding, and the matrices from these positions.
 */
void SetUniforms(
  vtkShaderProgram* program, vtkProp* prop, vtkRenderer* renderer, const glm::dvec3& sceneCenter);
}
