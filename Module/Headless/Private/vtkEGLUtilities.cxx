// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEGLUtilities.h"

#include <locale>
#include <sstream>

//------------------------------------------------------------------------------
std::string vtkEGLUtilities::GetErrorName(EGLint error)
{
  switch (error)
  {
    case EGL_NOT_INITIALIZED:
      return "EGL_NOT_INITIALIZED";
    case EGL_BAD_ACCESS:
      return "EGL_BAD_ACCESS";
    case EGL_BAD_ALLOC:
      return "EGL_BAD_ALLOC";
    case EGL_BAD_ATTRIBUTE:
      return "EGL_BAD_ATTRIBUTE";
    case EGL_BAD_CONFIG:
      return "EGL_BAD_CONFIG";
    case EGL_BAD_CONTEXT:
      return "EGL_BAD_CONTEXT";
    case EGL_BAD_DISPLAY:
      return "EGL_BAD_DISPLAY";
    case EGL_BAD_MATCH:
      return "EGL_BAD_MATCH";
    case EGL_BAD_PARAMETER:
      return "EGL_BAD_PARAMETER";
    case EGL_CONTEXT_LOST:
      return "EGL_CONTEXT_LOST";
    default:
    {
      std::ostringstream name;
      name.imbue(std::locale::classic());
      name << "EGL error 0x" << std::hex << error;
      return name.str();
    }
  }
}

//------------------------------------------------------------------------------
bool vtkEGLUtilities::HasExtension(const char* extensions, const std::string& name)
{
  std::istringstream words(extensions ? extensions : "");
  std::string word;
  while (words >> word)
  {
    if (word == name)
    {
      return true;
    }
  }
  return false;
}
