// SPDX-License-Identifier: BSD-3-Clause
// An OpenGL core-profile context with all that it needs, on one platform.
#ifndef vtkEGLContext_h
#define vtkEGLContext_h

#include "vtkEGLBinding.h" // for the superclass

#include <string> // for names

struct vtkEGLPlatform;

struct vtkEGLContext : vtkEGLBinding
{
  /** What the context says of itself. */
  std::string PlatformName;
  std::string Version;
  std::string Renderer;
  int MaximumSize = 0;

  /** Why the context renders in software on a machine with a card, in one line; else empty. */
  std::string Warning;

  /** Makes a context on the first platform that works, or on one device. Returns an empty string,
   * or the reasons why none works; nothing is left behind then. What is current stays so. */
  std::string Create(int deviceIndex);

  void Destroy();

private:
  std::string CreateOn(const vtkEGLPlatform& platform);
  std::string MakeContextAndSurface();
  std::string Examine(const vtkEGLPlatform& platform);
};

#endif
