// SPDX-License-Identifier: BSD-3-Clause
// Who uses which EGL display. Displays are shared: asking twice for one gives the same handle, and
// terminating it ends it for everybody. So users are counted, over all windows and threads, and a
// display that somebody else had initialized is never terminated.
#ifndef vtkEGLDisplayUsers_h
#define vtkEGLDisplayUsers_h

#include <EGL/egl.h>

#include <map>   // for entries
#include <mutex> // for the lock

class vtkEGLDisplayUsers
{
public:
  /** The one of the process. Never deleted: windows may be destroyed as late as static objects. */
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
