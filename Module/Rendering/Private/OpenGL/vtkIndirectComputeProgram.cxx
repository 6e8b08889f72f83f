// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "OpenGL/vtkIndirectComputeProgram.h"

#include "OpenGL/vtkIndirectBackEndChoices.h"
#include "OpenGL/vtkIndirectCommandBuffer.h"
#include "OpenGL/vtkIndirectShaderLibrary.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkWeakPointer.h"

#include <vector>

//------------------------------------------------------------------------------
class vtkIndirectComputeProgram::Program : public vtkShaderProgram
{
public:
  static Program* New() { VTK_STANDARD_NEW_BODY(Program); }
  vtkTypeMacro(Program, vtkShaderProgram);

  bool Build(vtkOpenGLRenderWindow* window, const std::string& text)
  {
    this->Window = window;
    const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
    const char* source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    const auto program = glCreateProgram();
    glAttachShader(program, shader);
    glLinkProgram(program);
    glDetachShader(program, shader);
    GLint compiled = GL_FALSE;
    GLint linked = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (compiled == GL_FALSE || linked == GL_FALSE)
    {
      std::vector<char> log(4096, '\0');
      if (compiled == GL_FALSE)
      {
        glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
      }
      else
      {
        glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
      }
      vtkErrorMacro("A compute shader was refused: " << log.data());
      glDeleteShader(shader);
      glDeleteProgram(program);
      return false;
    }
    glDeleteShader(shader);
    this->Handle = static_cast<int>(program);
    this->Linked = true;
    return true;
  }

  void Destroy()
  {
    if (this->Handle)
    {
      glDeleteProgram(static_cast<GLuint>(this->Handle));
      this->Handle = 0;
    }
    this->Linked = false;
    this->Window = nullptr;
  }

protected:
  Program() = default;
  ~Program() override
  {
    if (this->Window)
    {
      this->Window->MakeCurrent();
      this->Destroy();
    }
  }

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // window of the program's context
};

//------------------------------------------------------------------------------
vtkIndirectComputeProgram::vtkIndirectComputeProgram(vtkIndirectResource* owner, const char* stage)
  : vtkIndirectResource(owner)
  , Stage(stage)
{
}

vtkIndirectComputeProgram::~vtkIndirectComputeProgram() = default;

//------------------------------------------------------------------------------
bool vtkIndirectComputeProgram::IsSupported()
{
  return vtkIndirectBackEndChoices::Get(vtkIndirectBackEndChoices::Compute) ==
    vtkIndirectBackEndChoices::ComputeOn;
}

//------------------------------------------------------------------------------
void vtkIndirectComputeProgram::SetDefinitions(const std::string& definitions)
{
  if (definitions != this->Definitions)
  {
    this->Definitions = definitions;
    this->ReleaseOwn(nullptr);
  }
}

//------------------------------------------------------------------------------
vtkIndirectProgram vtkIndirectComputeProgram::Use(vtkOpenGLRenderWindow* window)
{
  if (!this->Built)
  {
    std::string text = vtkIndirectShaderLibrary::GetText(this->Stage);
    // VTK puts the version of other stages into the first line.
    text.replace(0, text.find('\n') + 1, "#version 430\n" + this->Definitions);
    auto built = vtkSmartPointer<Program>::New();
    if (!built->Build(window, text))
    {
      return nullptr;
    }
    this->Built = built;
  }
  // Otherwise the cache would take the program that it bound last for the current one.
  window->GetShaderCache()->ReleaseCurrentShader();
  glUseProgram(static_cast<GLuint>(this->Built->GetHandle()));
  return vtkIndirectProgram(this->Built);
}

//------------------------------------------------------------------------------
void vtkIndirectComputeProgram::AddImages(const vtkIndirectTarget& target, int unit)
{
  for (int i = 0; i < target.GetNumberOfChannels(); ++i)
  {
    this->Units.push_back(static_cast<GLuint>(unit + i));
    glBindImageTexture(this->Units.back(), target.GetTexture(i)->GetHandle(), 0, GL_FALSE, 0,
      GL_READ_WRITE, target.GetInternalFormat(i));
  }
}

//------------------------------------------------------------------------------
// llvmpipe does not wait for draws into a kernel's inputs by itself.
void vtkIndirectComputeProgram::Begin()
{
  glMemoryBarrier(
    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

//------------------------------------------------------------------------------
// The next user of an image may sample the image, draw over it, add to it, read it back or replace
// it; the next user of a list may append, read or dispatch.
void vtkIndirectComputeProgram::End()
{
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT |
    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
    GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  for (const unsigned int unit : this->Units)
  {
    glBindImageTexture(unit, 0, 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  }
  this->Units.clear();
}

//------------------------------------------------------------------------------
void vtkIndirectComputeProgram::Run(int width, int height, int groupSize)
{
  Begin();
  glDispatchCompute(static_cast<GLuint>((width + groupSize - 1) / groupSize),
    static_cast<GLuint>((height + groupSize - 1) / groupSize), 1);
  this->End();
}

//------------------------------------------------------------------------------
void vtkIndirectComputeProgram::Run(const vtkIndirectCommandBuffer& lists, size_t list)
{
  Begin();
  lists.Dispatch(list);
  this->End();
}

//------------------------------------------------------------------------------
void vtkIndirectComputeProgram::ReleaseOwn(vtkWindow*)
{
  if (this->Built)
  {
    this->Built->Destroy();
    this->Built = nullptr;
  }
}
