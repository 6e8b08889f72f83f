// SPDX-License-Identifier: BSD-3-Clause
// Which context is current in a thread, to come back to.
#ifndef vtkEGLBinding_h
#define vtkEGLBinding_h

#include <EGL/egl.h>

struct vtkEGLBinding
{
  EGLDisplay Display = EGL_NO_DISPLAY;
  EGLSurface Draw = EGL_NO_SURFACE;
  EGLSurface Read = EGL_NO_SURFACE;
  EGLContext Context = EGL_NO_CONTEXT;

  bool HasContext() const { return this->Context != EGL_NO_CONTEXT; }

  static vtkEGLBinding GetCurrent();
  bool IsCurrent() const;
  bool MakeCurrent() const;

  /** Nothing is current in the thread afterwards, if this was. */
  void ReleaseCurrent() const;
};

#endif
