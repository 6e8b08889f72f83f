// SPDX-License-Identifier: BSD-3-Clause
// Counts the users of EGL displays. Displays are shared: two requests for a display give the same
// handle, and terminating it ends it for everybody. So users are counted over all windows and
// threads, and a display initialized by other code is never terminated.
#ifndef vtkEGLDisplayUsers_h
#define vtkEGLDisplayUsers_h

#include <EGL/egl.h>

#include <map>   // for entries
#include <mutex> // for the lock

class vtkEGLDisplayUsers
{
public:
  /** The instance of the process. Never deleted: windows may be destroyed as late as static
   * objects. */
  static vtkEGLDisplayUsers& GetInstance();

  /** Initializes the display for its first user. Returns false, with EGL's error, if that fails. */
  bool Acquire(EGLDisplay display);

  /** Pair with a successful Acquire. Terminates the display after its last user. */
  void Release(EGLDisplay display);

private:
  struct Entry
  {
    int Count = 0;
    bool IsForeign = false;
  };
  std::mutex Mutex;
  std::map<EGLDisplay, Entry> Entries;
};

#endif
