// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEGLDisplayUsers.h"

//------------------------------------------------------------------------------
vtkEGLDisplayUsers& vtkEGLDisplayUsers::GetInstance()
{
  static auto* users = new vtkEGLDisplayUsers;
  return *users;
}

//------------------------------------------------------------------------------
bool vtkEGLDisplayUsers::Acquire(EGLDisplay display)
{
  std::lock_guard<std::mutex> lock(this->Mutex);
  Entry& entry = this->Entries[display];
  if (entry.Count == 0)
  {
    entry.IsForeign = eglQueryString(display, EGL_VERSION) != nullptr;
    if (!eglInitialize(display, nullptr, nullptr))
    {
      return false;
    }
  }
  ++entry.Count;
  return true;
}

//------------------------------------------------------------------------------
void vtkEGLDisplayUsers::Release(EGLDisplay display)
{
  std::lock_guard<std::mutex> lock(this->Mutex);
  Entry& entry = this->Entries[display];
  if (--entry.Count == 0 && !entry.IsForeign)
  {
    eglTerminate(display);
  }
}
