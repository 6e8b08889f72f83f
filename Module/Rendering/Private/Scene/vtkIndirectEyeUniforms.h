// SPDX-License-Identifier: BSD-3-Clause
// Uniforms that every stage with an eye needs.
#pragma once

#include "OpenGL/vtkIndirectUniforms.h"

#include "Scene/vtkIndirectFrame.h"

/** Sets the rays of the eye, the transform to scene units and the size of the frame in pixels. */
inline void vtkIndirectSetEyeUniforms(vtkShaderProgram* program, const vtkIndirectFrame& frame)
{
  vtkIndirectSetUniform(program, "vtkiRayOrigin", glm::mat3(frame.RayOrigin));
  vtkIndirectSetUniform(program, "vtkiRayDirection", glm::mat3(frame.RayDirection));
  vtkIndirectSetUniform(program, "vtkiViewToScene", glm::mat4(frame.ViewToScene));
  program->SetUniform2i("vtkiSize", frame.Size);
}
