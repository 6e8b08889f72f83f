// SPDX-License-Identifier: BSD-3-Clause
// Reports when the OpenGL context that something was made in is about to end.
#ifndef vtkIndirectContextGuard_h
#define vtkIndirectContextGuard_h

#include "vtkObjectFactory.h"      // for the macro
#include "vtkOpenGLRenderWindow.h" // for comparisons
#include "vtkTextureObject.h"

#include <functional> // for the callback

// VTK's windows ask their textures, and no one else, to let go of a context: this is a texture
// that never allocates anything. SetContext with another window lets go of the earlier one, too.
class vtkIndirectContextGuard : public vtkTextureObject
{
public:
  static vtkIndirectContextGuard* New() { VTK_STANDARD_NEW_BODY(vtkIndirectContextGuard); }
  vtkTypeMacro(vtkIndirectContextGuard, vtkTextureObject);

  /** Called with the window whose context is let go of; it is current. */
  std::function<void(vtkWindow*)> Release;

  /** Whether nothing can have been made in a context of another window. */
  bool CanBeOf(vtkWindow* window) { return !this->GetContext() || this->GetContext() == window; }

  /** Lets go of the window's context, whichever is current. */
  void LetGo(vtkWindow* window)
  {
    // It makes the context current and comes back to the method below.
    this->Superclass::ReleaseGraphicsResources(window);
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Superclass::ReleaseGraphicsResources(window);
    if (this->Release)
    {
      this->Release(window);
    }
  }

protected:
  vtkIndirectContextGuard() = default;
  ~vtkIndirectContextGuard() override = default;

private:
  vtkIndirectContextGuard(const vtkIndirectContextGuard&) = delete;
  void operator=(const vtkIndirectContextGuard&) = delete;
};

#endif
