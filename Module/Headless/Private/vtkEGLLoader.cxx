// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEGLLoader.h"

#ifdef VTK_INDIRECT_USE_GLEW
#include "vtk_glew.h"
#endif

#include "vtkEGLUtilities.h"

namespace
{
// OpenGL names that are needed before VTK has loaded OpenGL.
constexpr unsigned int GLRendererName = 0x1F01;
constexpr unsigned int GLVersionName = 0x1F02;
constexpr unsigned int GLMajorVersion = 0x821B;
constexpr unsigned int GLMinorVersion = 0x821C;
constexpr unsigned int GLMaxTextureSize = 0x0D33;
constexpr unsigned int GLSmoothLineWidthRange = 0x0B22;
constexpr unsigned int GLAliasedLineWidthRange = 0x846E;

using GetStringFunction = const unsigned char* (*)(unsigned int);
using GetIntegerFunction = void (*)(unsigned int, int*);
using GetFloatFunction = void (*)(unsigned int, float*);

//------------------------------------------------------------------------------
std::string GetString(unsigned int name)
{
  auto function = vtkEGLUtilities::GetFunction<GetStringFunction>("glGetString");
  const unsigned char* text = function ? function(name) : nullptr;
  return text ? reinterpret_cast<const char*>(text) : "";
}

//------------------------------------------------------------------------------
int GetInteger(unsigned int name)
{
  auto function = vtkEGLUtilities::GetFunction<GetIntegerFunction>("glGetIntegerv");
  int value = 0;
  if (function)
  {
    function(name, &value);
  }
  return value;
}
}

//------------------------------------------------------------------------------
std::string vtkEGLLoader::GetVersion()
{
  return GetString(GLVersionName);
}

//------------------------------------------------------------------------------
std::string vtkEGLLoader::GetRenderer()
{
  return GetString(GLRendererName);
}

//------------------------------------------------------------------------------
int vtkEGLLoader::GetVersionNumber()
{
  return 10 * GetInteger(GLMajorVersion) + GetInteger(GLMinorVersion);
}

//------------------------------------------------------------------------------
int vtkEGLLoader::GetMaximumTextureSize()
{
  return GetInteger(GLMaxTextureSize);
}

//------------------------------------------------------------------------------
float vtkEGLLoader::GetMaximumLineWidth(bool smooth)
{
  auto function = vtkEGLUtilities::GetFunction<GetFloatFunction>("glGetFloatv");
  float range[2] = { 1.0f, 1.0f };
  if (function)
  {
    function(smooth ? GLSmoothLineWidthRange : GLAliasedLineWidthRange, range);
  }
  return range[1];
}

#ifdef VTK_INDIRECT_USE_GLEW
//------------------------------------------------------------------------------
std::string vtkEGLLoader::LoadGLEW()
{
  GLenum result = glewInit();
#ifdef GLEW_ERROR_NO_GLX_DISPLAY
  // A GLEW built for GLX loads all of OpenGL, and then reports that it finds no GLX display.
  if (result == GLEW_ERROR_NO_GLX_DISPLAY)
  {
    result = GLEW_OK;
  }
#endif
  return result == GLEW_OK ? std::string()
                           : std::string("GLEW cannot be initialized: ") +
      reinterpret_cast<const char*>(glewGetErrorString(result));
}
#endif
