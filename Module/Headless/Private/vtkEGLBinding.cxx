// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEGLBinding.h"

//------------------------------------------------------------------------------
// EGL keeps one current context for OpenGL and one for OpenGL ES; another library may have switched
// the API.
vtkEGLBinding vtkEGLBinding::GetCurrent()
{
  eglBindAPI(EGL_OPENGL_API);
  vtkEGLBinding binding;
  binding.Context = eglGetCurrentContext();
  if (binding.HasContext())
  {
    binding.Display = eglGetCurrentDisplay();
    binding.Draw = eglGetCurrentSurface(EGL_DRAW);
    binding.Read = eglGetCurrentSurface(EGL_READ);
  }
  return binding;
}

//------------------------------------------------------------------------------
bool vtkEGLBinding::MakeCurrent() const
{
  eglBindAPI(EGL_OPENGL_API);
  return eglMakeCurrent(this->Display, this->Draw, this->Read, this->Context) == EGL_TRUE;
}

//------------------------------------------------------------------------------
void vtkEGLBinding::ReleaseCurrent() const
{
  if (this->IsCurrent())
  {
    eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
}
