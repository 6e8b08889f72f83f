// SPDX-License-Identifier: BSD-3-Clause
// Uniforms from GLM types, and the OpenGL state of a full-screen program.
#pragma once

#include "OpenGL/vtkIndirectGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

inline void vtkIndirectSetUniform(vtkShaderProgram* program, const char* name, const glm::vec2& v)
{
  program->SetUniform2f(name, glm::value_ptr(v));
}

inline void vtkIndirectSetUniform(vtkShaderProgram* program, const char* name, const glm::vec3& v)
{
  program->SetUniform3f(name, glm::value_ptr(v));
}

inline void vtkIndirectSetUniform(vtkShaderProgram* program, const char* name, const glm::vec4& v)
{
  program->SetUniform4f(name, glm::value_ptr(v));
}

inline void vtkIndirectSetUniform(vtkShaderProgram* program, const char* name, glm::mat3 m)
{
  program->SetUniformMatrix3x3(name, glm::value_ptr(m));
}

inline void vtkIndirectSetUniform(vtkShaderProgram* program, const char* name, glm::mat4 m)
{
  program->SetUniformMatrix4x4(name, glm::value_ptr(m));
}

/**
 * Disables depth test, blending and scissor during its lifetime, and afterwards restores them and
 * the rest of the state that full-screen programs change.
 */
class vtkIndirectFullScreenState
{
public:
  explicit vtkIndirectFullScreenState(vtkOpenGLRenderWindow* window)
    : Depth(window->GetState(), GL_DEPTH_TEST)
    , Blend(window->GetState(), GL_BLEND)
    , Scissor(window->GetState(), GL_SCISSOR_TEST)
    , BlendFunc(window->GetState())
    , ClearColor(window->GetState())
    , DepthFunc(window->GetState())
    , DepthMask(window->GetState())
    , ScissorBox(window->GetState())
    , Viewport(window->GetState())
  {
    window->GetState()->vtkglDisable(GL_DEPTH_TEST);
    window->GetState()->vtkglDisable(GL_BLEND);
    window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
  }

private:
  vtkOpenGLState::ScopedglEnableDisable Depth;
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglEnableDisable Scissor;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunc;
  vtkOpenGLState::ScopedglClearColor ClearColor;
  vtkOpenGLState::ScopedglDepthFunc DepthFunc;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglScissor ScissorBox;
  vtkOpenGLState::ScopedglViewport Viewport;
};

/** Adds drawn values to the target during its lifetime, or replaces the target's values. */
class vtkIndirectAddition
{
public:
  explicit vtkIndirectAddition(vtkOpenGLRenderWindow* window, bool adds = true)
    : Blend(window->GetState(), GL_BLEND)
    , BlendFunc(window->GetState())
  {
    if (adds)
    {
      window->GetState()->vtkglEnable(GL_BLEND);
      window->GetState()->vtkglBlendFunc(GL_ONE, GL_ONE);
    }
  }

private:
  vtkOpenGLState::ScopedglEnableDisable Blend;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunc;
};
