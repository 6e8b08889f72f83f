// SPDX-License-Identifier: BSD-3-Clause
// Remembers a thread's current context, to restore it.
#pragma once

#include <EGL/egl.h>

struct vtkEGLBinding
{
  EGLDisplay Display = EGL_NO_DISPLAY;
  EGLSurface Draw = EGL_NO_SURFACE;
  EGLSurface Read = EGL_NO_SURFACE;
  EGLContext Context = EGL_NO_CONTEXT;

  bool HasContext() const { return this->Context != EGL_NO_CONTEXT; }

  static vtkEGLBinding GetCurrent();
  bool IsCurrent() const { return this->HasContext() && GetCurrent().Context == this->Context; }
  bool MakeCurrent() const;

  /** Leaves the thread without a current context if this one was current. */
  void ReleaseCurrent() const;
};
