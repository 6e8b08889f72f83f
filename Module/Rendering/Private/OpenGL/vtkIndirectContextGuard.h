// SPDX-License-Identifier: BSD-3-Clause
// Reports the end of the OpenGL context in which its owner has made objects.
#pragma once

#include "vtkObjectFactory.h"      // for the macro
#include "vtkOpenGLRenderWindow.h" // for comparisons
#include "vtkTextureObject.h"

#include <functional> // for the callback

// VTK's windows notify only their textures of the end of a context: this is a texture that never
// allocates anything. SetContext with another window releases the earlier one, too.
class vtkIndirectContextGuard : public vtkTextureObject
{
public:
  static vtkIndirectContextGuard* New() { VTK_STANDARD_NEW_BODY(vtkIndirectContextGuard); }
  vtkTypeMacro(vtkIndirectContextGuard, vtkTextureObject);

  /** Called with the window whose context ends; the context is current. */
  std::function<void(vtkWindow*)> Release;

  /** Returns false only if all objects were made in the context of another window. */
  bool CanBeOf(vtkWindow* window) { return !this->GetContext() || this->GetContext() == window; }

  /** Releases the window's context, whichever is current. */
  void LetGo(vtkWindow* window)
  {
    // The superclass makes the context current and calls the method below.
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
