// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "OpenGL/vtkIndirectPointProgram.h"

#include "OpenGL/vtkIndirectBackEndChoices.h"
#include "OpenGL/vtkIndirectFlatUniforms.h"
#include "OpenGL/vtkIndirectShaderLibrary.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
vtkIndirectPointProgram::vtkIndirectPointProgram(
  vtkIndirectResource* owner, const char* vertexStage, const char* fragmentStage, int varyings)
  : vtkIndirectResource(owner)
  , VertexStage(vertexStage)
  , FragmentStage(fragmentStage)
  , Varyings(varyings)
{
}

//------------------------------------------------------------------------------
vtkIndirectPointProgram::~vtkIndirectPointProgram()
{
  if (this->Window)
  {
    this->Window->MakeCurrent();
    this->Release(this->Window);
  }
}

//------------------------------------------------------------------------------
vtkIndirectProgram vtkIndirectPointProgram::Use(
  vtkOpenGLRenderWindow* window, const std::string& definitions)
{
  if (this->VertexText.empty() || definitions != this->Definitions)
  {
    this->Definitions = definitions;
    this->VertexText = vtkIndirectShaderLibrary::GetShader(this->VertexStage, definitions);
    this->FragmentText = vtkIndirectShaderLibrary::GetShader(this->FragmentStage, definitions);
    if (this->Varyings > 0 &&
      vtkIndirectBackEndChoices::Get(vtkIndirectBackEndChoices::Uniforms) ==
        vtkIndirectBackEndChoices::UniformsFlat)
    {
      vtkIndirectFlatUniforms::Move(this->VertexText, this->FragmentText, this->Varyings);
    }
  }
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    this->VertexText.c_str(), this->FragmentText.c_str(), "");
  if (!program || !program->GetCompiled())
  {
    return nullptr;
  }
  if (this->VertexArray == 0)
  {
    this->Window = window;
    glGenVertexArrays(1, &this->VertexArray);
  }
  return vtkIndirectProgram(program);
}

//------------------------------------------------------------------------------
void vtkIndirectPointProgram::Draw(int count, int pixels)
{
  this->Window->GetState()->vtkglPointSize(static_cast<float>(pixels));
  glBindVertexArray(this->VertexArray);
  glDrawArrays(GL_POINTS, 0, count);
  glBindVertexArray(0);
  this->Window->GetState()->vtkglPointSize(1.0f);
}

//------------------------------------------------------------------------------
void vtkIndirectPointProgram::DrawRectangle()
{
  glBindVertexArray(this->VertexArray);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindVertexArray(0);
}

//------------------------------------------------------------------------------
void vtkIndirectPointProgram::ReleaseOwn(vtkWindow*)
{
  this->VertexText.clear();
  if (this->VertexArray)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
    this->VertexArray = 0;
  }
  this->Window = nullptr;
}
