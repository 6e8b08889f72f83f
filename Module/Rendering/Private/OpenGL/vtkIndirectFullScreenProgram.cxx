// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "OpenGL/vtkIndirectFullScreenProgram.h"

#include "OpenGL/vtkIndirectBackEndChoices.h"
#include "OpenGL/vtkIndirectComputeProgram.h"
#include "OpenGL/vtkIndirectFlatUniforms.h"
#include "OpenGL/vtkIndirectShaderLibrary.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>

vtkIndirectFullScreenProgram::vtkIndirectFullScreenProgram(const char* stage, const char* gather)
  : Stage(stage)
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

// Layout qualifier of an image; all formats of targets have one.
const char* GetImageFormat(unsigned int internalFormat)
{
  switch (internalFormat)
  {
    case GL_RGBA16F:
      return "rgba16f";
    case GL_RG32F:
      return "rg32f";
    case GL_R32F:
      return "r32f";
    case GL_RG16F:
      return "rg16f";
    default:
      return "rgba32f";
  }
}

// Invocations of a group: a tile, or a piece of a row if there are few rows.
std::array<int, 2> FindGroup(const vtkIndirectTarget& target)
{
  return target.GetHeight() < 8 ? std::array<int, 2>{ 64, 1 } : std::array<int, 2>{ 8, 8 };
}

void Replace(std::string& text, const std::string& from, const std::string& to)
{
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
  {
    text.replace(at, from.size(), to);
  }
}
}

//------------------------------------------------------------------------------
void vtkIndirectFullScreenProgram::SetGather(const std::string& gather)
{
  if (gather != this->Gather)
  {
    this->Gather = gather;
    this->Release();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectFullScreenProgram::SetDefinitions(const std::string& definitions)
{
  if (definitions != this->Definitions)
  {
    this->Definitions = definitions;
    this->Release();
  }
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkIndirectFullScreenProgram::Use(vtkOpenGLRenderWindow* window)
{
  this->Target = nullptr;
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
  return program && program->GetCompiled() ? program : nullptr;
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkIndirectFullScreenProgram::Use(
  vtkOpenGLRenderWindow* window, const std::string& definitions)
{
  this->SetDefinitions(definitions);
  return this->Use(window);
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkIndirectFullScreenProgram::Use(
  vtkOpenGLRenderWindow* window, const vtkIndirectTarget& target, bool adds)
{
  if (vtkIndirectBackEndChoices::Get(vtkIndirectBackEndChoices::Kernels) ==
    vtkIndirectBackEndChoices::KernelsFragment)
  {
    return this->Use(window);
  }
  std::string key = (adds ? "+" : "=") + std::to_string(FindGroup(target)[1]);
  for (int i = 0; i < target.GetNumberOfChannels(); ++i)
  {
    key += GetImageFormat(target.GetInternalFormat(i));
  }
  if (!this->Compute || key != this->ComputeKey)
  {
    this->Compute = std::make_unique<vtkIndirectComputeProgram>("");
    this->Compute->SetText(this->GetComputeText(target, adds));
    this->ComputeKey = key;
  }
  this->Current = this->Compute->Use(window);
  this->Target = &target;
  return this->Current;
}

//------------------------------------------------------------------------------
// The stage's text with its position and its outputs as variables, and an entry point that sets the
// position and stores the outputs.
std::string vtkIndirectFullScreenProgram::GetComputeText(
  const vtkIndirectTarget& target, bool adds) const
{
  std::string stage =
    vtkIndirectShaderLibrary::GetShader(this->Stage, this->Definitions, this->Gather);
  Replace(stage, "gl_FragCoord", "vtkiPlace");
  Replace(stage, "gl_FragData", "vtkiOutput");
  Replace(stage, "void main()", "void vtkiStage()");
  const std::array<int, 2> group = FindGroup(target);
  std::string declarations = "layout(local_size_x = " + std::to_string(group[0]) +
    ", local_size_y = " + std::to_string(group[1]) +
    ") in;\nuniform ivec2 vtkiTargetSize;\nvec4 vtkiPlace = vec4(0.0f);\nvec4 vtkiOutput[8];\n";
  std::string stores;
  for (int i = 0; i < target.GetNumberOfChannels(); ++i)
  {
    const std::string number = std::to_string(i);
    const std::string image = "vtkiTarget" + number;
    declarations += "layout(" + std::string(GetImageFormat(target.GetInternalFormat(i))) +
      ", binding = " + number + ") uniform " + (adds ? "" : "writeonly ") + "image2D " + image +
      ";\n";
    stores += "  imageStore(" + image + ", place, vtkiOutput[" + number + "]" +
      (adds ? " + imageLoad(" + image + ", place)" : "") + ");\n";
  }
  // Extensions come first. The position has an initial value, because compilers warn about
  // functions that use a variable before main sets it.
  const size_t at = stage.rfind("#extension");
  stage.insert(stage.find('\n', at) + 1, declarations);
  return stage +
    "void main()\n{\n"
    "  ivec2 place = ivec2(gl_GlobalInvocationID.xy);\n"
    "  if (place.x >= vtkiTargetSize.x || place.y >= vtkiTargetSize.y)\n  {\n    return;\n  }\n"
    "  vtkiPlace = vec4(vec2(place) + 0.5f, 0.0f, 1.0f);\n"
    "  vtkiStage();\n" +
    stores + "}\n";
}

//------------------------------------------------------------------------------
void vtkIndirectFullScreenProgram::Dispatch()
{
#ifdef GL_COMPUTE_SHADER
  const vtkIndirectTarget& target = *this->Target;
  const int size[2] = { target.GetWidth(), target.GetHeight() };
  const int channels = target.GetNumberOfChannels();
  this->Current->SetUniform2i("vtkiTargetSize", size);
  auto bind = [&](bool on)
  {
    for (int i = 0; i < channels; ++i)
    {
      glBindImageTexture(static_cast<GLuint>(i), on ? target.GetTexture(i)->GetHandle() : 0, 0,
        GL_FALSE, 0, GL_READ_WRITE, target.GetInternalFormat(i));
    }
  };
  bind(true);
  const std::array<int, 2> group = FindGroup(target);
  // Waits for draws into the images and the kernel's inputs, which llvmpipe does not do by itself.
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
  glDispatchCompute(static_cast<GLuint>((size[0] + group[0] - 1) / group[0]),
    static_cast<GLuint>((size[1] + group[1] - 1) / group[1]), 1);
  // The next user may sample the image, draw over it, add to it, read it back or replace it.
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT |
    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
  bind(false);
#endif
}

//------------------------------------------------------------------------------
void vtkIndirectFullScreenProgram::Draw()
{
  this->Target ? this->Dispatch() : this->Quad->Render();
}

//------------------------------------------------------------------------------
void vtkIndirectFullScreenProgram::Release()
{
  this->Quad.reset();
  this->Compute.reset();
  this->Target = nullptr;
}
