// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEGLUtilities.h"

#include <algorithm>
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

//------------------------------------------------------------------------------
bool vtkEGLUtilities::IsSoftwareRenderer(const std::string& renderer)
{
  std::string lower(renderer);
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  // "LLVM" alone is no sign: drivers of GPUs compile their shaders with it.
  for (const char* name : { "llvmpipe", "lavapipe", "softpipe", "swrast", "software rasterizer",
         "swiftshader", "microsoft basic render" })
  {
    if (lower.find(name) != std::string::npos)
    {
      return true;
    }
  }
  // Mesa's OpenSWR, "SWR (LLVM 9.0, 256 bits)". The three letters may be part of another word.
  return lower.compare(0, 5, "swr (") == 0 || lower.find("(swr (") != std::string::npos;
}
