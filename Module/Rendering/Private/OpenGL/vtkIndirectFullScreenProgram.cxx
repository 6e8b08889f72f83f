// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "OpenGL/vtkIndirectFullScreenProgram.h"

#include "OpenGL/vtkIndirectBackEndChoices.h"
#include "OpenGL/vtkIndirectFlatUniforms.h"
#include "OpenGL/vtkIndirectShaderLibrary.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLShaderCache.h"

#include <algorithm>

vtkIndirectFullScreenProgram::vtkIndirectFullScreenProgram(
  vtkIndirectResource* owner, const char* stage, const char* gather)
  : vtkIndirectResource(owner)
  , Stage(stage)
  , Gather(gather)
{
}

vtkIndirectFullScreenProgram::~vtkIndirectFullScreenProgram() = default;

namespace
{
// VTK's quad helper requires both attributes; stages need only the position.
const char* const VertexShader = R"(//VTK::System::Dec
in vec4 ndCoordIn;
in vec2 texCoordIn;
void main()
{
  gl_Position = vec4(2.0 * texCoordIn - 1.0, 0.0, ndCoordIn.w);
}
)";
}

//------------------------------------------------------------------------------
void vtkIndirectFullScreenProgram::SetDefinitions(const std::string& definitions)
{
  if (definitions != this->Definitions)
  {
    this->Definitions = definitions;
    this->Quad.reset();
  }
}

//------------------------------------------------------------------------------
vtkIndirectProgram vtkIndirectFullScreenProgram::Use(vtkOpenGLRenderWindow* window)
{
  if (!this->Quad)
  {
    std::string fragment =
      vtkIndirectShaderLibrary::GetShader(this->Stage, this->Definitions, this->Gather);
    std::string vertex = VertexShader;
    if (vtkIndirectBackEndChoices::Get(vtkIndirectBackEndChoices::Uniforms) ==
      vtkIndirectBackEndChoices::UniformsFlat)
    {
      // Limit of OpenGL on the processor; the compiler drops varyings that no result depends on.
      GLint maximum = 128;
      glGetIntegerv(GL_MAX_VARYING_COMPONENTS, &maximum);
      vtkIndirectFlatUniforms::Move(vertex, fragment, std::min(maximum, 128));
    }
    // Four arguments up to VTK 9.1; the fifth of later versions has a default.
    this->Quad =
      std::make_unique<vtkOpenGLQuadHelper>(window, vertex.c_str(), fragment.c_str(), "");
  }
  else if (this->Quad->Program)
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  vtkShaderProgram* program = this->Quad->Program;
  return vtkIndirectProgram(program && program->GetCompiled() ? program : nullptr);
}

//------------------------------------------------------------------------------
vtkIndirectProgram vtkIndirectFullScreenProgram::Use(
  vtkOpenGLRenderWindow* window, const std::string& definitions)
{
  this->SetDefinitions(definitions);
  return this->Use(window);
}

//------------------------------------------------------------------------------
void vtkIndirectFullScreenProgram::Draw()
{
  this->Quad->Render();
}

//------------------------------------------------------------------------------
bool vtkIndirectFullScreenProgram::Run(vtkOpenGLRenderWindow* window, vtkIndirectTarget& target,
  const std::function<void(const vtkIndirectProgram&)>& set)
{
  const vtkIndirectProgram program = this->Use(window);
  if (program)
  {
    target.Begin();
    set(program);
    this->Draw();
    target.End();
  }
  return program != nullptr;
}

//------------------------------------------------------------------------------
bool vtkIndirectFullScreenProgram::RunOnSurfaces(vtkOpenGLRenderWindow* window,
  vtkIndirectTarget& target, const std::function<void(const vtkIndirectProgram&)>& set)
{
  const vtkIndirectProgram program = this->Use(window);
  if (program)
  {
    vtkOpenGLState* state = window->GetState();
    target.Begin();
    target.Clear();
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglDepthFunc(GL_GREATER);
    // VTK's state does not track the depth range and assumes the default.
    glDepthRange(1.0, 1.0);
    set(program);
    this->Draw();
    glDepthRange(0.0, 1.0);
    state->vtkglDisable(GL_DEPTH_TEST);
    target.End();
  }
  return program != nullptr;
}

//------------------------------------------------------------------------------
bool vtkIndirectFullScreenProgram::RunRows(vtkOpenGLRenderWindow* window, vtkIndirectTarget& target,
  int rows, int most, const std::function<void(const vtkIndirectProgram&)>& set)
{
  const vtkIndirectProgram program = this->Use(window);
  if (program)
  {
    target.Begin();
    if (rows > most)
    {
      target.Clear();
    }
    const vtkIndirectAddition addition(window, rows > most);
    set(program);
    this->DrawRows(program, rows, most);
    target.End();
  }
  return program != nullptr;
}

//------------------------------------------------------------------------------
void vtkIndirectFullScreenProgram::DrawRows(const vtkIndirectProgram& program, int rows, int most)
{
  for (int row = 0; row < rows; row += most)
  {
    const int block[2] = { row, std::min(row + most, rows) };
    program->SetUniform2i("vtkiLightRows", block);
    this->Draw();
    if (rows > most)
    {
      glFlush();
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectFullScreenProgram::ReleaseOwn(vtkWindow*)
{
  this->Quad.reset();
}
