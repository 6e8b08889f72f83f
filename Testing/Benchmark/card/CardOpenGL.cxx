// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "CardOpenGL.h"

#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkNew.h"
#include "vtkVersion.h"

#include <gnu/libc-version.h>

#include <fstream>
#include <stdexcept>
#include <thread>

using Json = nlohmann::json;

namespace
{
struct Limit
{
  const char* Name;
  GLenum Value;
};

const Limit Limits[] = {
  { "GL_MAX_TEXTURE_SIZE", GL_MAX_TEXTURE_SIZE },
  { "GL_MAX_ARRAY_TEXTURE_LAYERS", GL_MAX_ARRAY_TEXTURE_LAYERS },
  { "GL_MAX_UNIFORM_BLOCK_SIZE", GL_MAX_UNIFORM_BLOCK_SIZE },
  { "GL_MAX_FRAGMENT_UNIFORM_COMPONENTS", GL_MAX_FRAGMENT_UNIFORM_COMPONENTS },
  { "GL_MAX_VARYING_COMPONENTS", GL_MAX_VARYING_COMPONENTS },
  { "GL_MAX_DRAW_BUFFERS", GL_MAX_DRAW_BUFFERS },
  { "GL_MAX_TEXTURE_IMAGE_UNITS", GL_MAX_TEXTURE_IMAGE_UNITS },
#ifdef GL_MAX_SHADER_STORAGE_BLOCK_SIZE
  { "GL_MAX_SHADER_STORAGE_BLOCK_SIZE", GL_MAX_SHADER_STORAGE_BLOCK_SIZE },
  { "GL_MAX_COMPUTE_SHARED_MEMORY_SIZE", GL_MAX_COMPUTE_SHARED_MEMORY_SIZE },
  { "GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS", GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS },
#endif
};

//------------------------------------------------------------------------------
std::string GetProcessor()
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
  {
    if (line.compare(0, 10, "model name") == 0 && line.find(": ") != std::string::npos)
    {
      return line.substr(line.find(": ") + 2);
    }
  }
  return "unknown";
}

std::string GetString(GLenum name)
{
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "";
}

//------------------------------------------------------------------------------
// Facts of the pack, as bake.py has written them.
std::string GetPack(const card::Options& options)
{
  std::ifstream file(options.Pack + "/scenes/pack.txt");
  std::string line;
  std::getline(file, line);
  return line;
}

//------------------------------------------------------------------------------
Json Describe(const card::Options& options)
{
  vtkNew<vtkEGLHeadlessRenderWindow> window;
  window->SetSize(16, 16);
  window->Initialize();
  if (!window->GetGenericContext())
  {
    throw std::runtime_error(window->GetLastErrorMessage());
  }
  Json unit = { { "status", "passed" }, { "vendor", GetString(GL_VENDOR) },
    { "renderer", window->GetGLRenderer() }, { "version", window->GetGLVersion() },
    { "glsl", GetString(GL_SHADING_LANGUAGE_VERSION) }, { "platform", window->GetPlatformName() },
    { "vtk", vtkVersion::GetVTKVersion() }, { "processor", GetProcessor() },
    { "threads", std::thread::hardware_concurrency() }, { "glibc", gnu_get_libc_version() },
    { "pack", GetPack(options) }, { "warning", window->GetLastWarningMessage() } };
  for (const Limit& limit : Limits)
  {
    GLint value = 0;
    glGetIntegerv(limit.Value, &value);
    // A name that an older OpenGL does not know is an error, and no limit.
    unit["limits"][limit.Name] = glGetError() == GL_NO_ERROR ? Json(value) : Json();
  }
  for (int i = 0; i < window->GetNumberOfDevices(); ++i)
  {
    unit["devices"].push_back(vtkEGLHeadlessRenderWindow::GetDeviceDescription(i));
  }
  return unit;
}
}

//------------------------------------------------------------------------------
card::Part card::MakeOpenGLPart(const Options& options)
{
  return { "opengl", { "context" }, [&options](const std::string&) { return Describe(options); } };
}
