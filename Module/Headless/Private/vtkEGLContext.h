// SPDX-License-Identifier: BSD-3-Clause
// An OpenGL core-profile context with its surface and display, on one platform.
#pragma once

#include "vtkEGLBinding.h" // for the superclass

#include <string> // for names

struct vtkEGLPlatform;

struct vtkEGLContext : vtkEGLBinding
{
  /** OpenGL's own description of the context. */
  std::string PlatformName;
  std::string Version;
  std::string Renderer;
  int MaximumSize = 0;

  /** Reason why the context renders in software on a machine with a card, in one line; else
   * empty. */
  std::string Warning;

  /** Makes a context on the first platform that works, or on one device. Returns an empty string,
   * or the reasons why none works, and then keeps no objects. The current context stays current. */
  std::string Create(int deviceIndex);

  void Destroy();

private:
  std::string CreateOn(const vtkEGLPlatform& platform);
  std::string MakeContextAndSurface();
  std::string Examine(const vtkEGLPlatform& platform);
};
