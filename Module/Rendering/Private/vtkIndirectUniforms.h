// SPDX-License-Identifier: BSD-3-Clause
// Uniforms from GLM types, those that every stage with an eye needs, and the OpenGL state of a
// full-screen kernel.
#ifndef vtkIndirectUniforms_h
#define vtkIndirectUniforms_h

#include "vtkIndirectGL.h"

#include "vtkIndirectFrame.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <glm/gtc/type_ptr.hpp>

inline void vtkIndirectSetUniform(vtkShaderProgram* program, const char* name, const glm::vec2& v)
{
  program->SetUniform2f(name, glm::value_ptr(v));
}

inline void vtkIndirectSetUniform(vtkShaderProgram* program, const char* name, const glm::vec3& v)
{
  program->SetUniform3f(name, glm::value_ptr(v));
}

inline void vtkIndirectSetUniform(vtkShaderProgram* program, const char* name, glm::mat3 m)
{
  program->SetUniformMatrix3x3(name, glm::value_ptr(m));
}

inline void vtkIndirectSetUniform(vtkShaderProgram* program, const char* name, glm::mat4 m)
{
  program->SetUniformMatrix4x4(name, glm::value_ptr(m));
}

/** Rays of the eye and the way to scene units. */
inline void vtkIndirectSetEyeUniforms(vtkShaderProgram* program, const vtkIndirectFrame& frame)
{
  vtkIndirectSetUniform(program, "vtkiRayOrigin", glm::mat3(frame.RayOrigin));
  vtkIndirectSetUniform(program, "vtkiRayDirection", glm::mat3(frame.RayDirection));
  vtkIndirectSetUniform(program, "vtkiViewToScene", glm::mat4(frame.ViewToScene));
}

/** No depth test, no blending, no scissor while it lives. */
class vtkIndirectKernelState
{
public:
  explicit vtkIndirectKernelState(vtkOpenGLRenderWindow* window)
    : Depth(window->GetState(), GL_DEPTH_TEST)
    , Blend(window->GetState(), GL_BLEND)
    , Scissor(window->GetState(), GL_SCISSOR_TEST)
  {
    window->GetState()->vtkglDisable(GL_DEPTH_TEST);
    window->GetState()->vtkglDisable(GL_BLEND);
    window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
  }

private:
  vtkOpenGLState::ScopedglEnableDisable Depth;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable Scissor;
};

#endif
