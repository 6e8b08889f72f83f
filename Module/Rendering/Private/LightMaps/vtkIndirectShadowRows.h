// SPDX-License-Identifier: BSD-3-Clause
// Depths of light maps in the form of shadow look-ups: a texel holds three neighbours of a row, and
// the slope of the middle one's surface. Nine depths take three fetches; a fetch of four channels
// costs little more than a fetch of one.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for a member
#include "OpenGL/vtkIndirectResource.h"          // for the base class
#include "vtkSmartPointer.h"                     // for members

#include <cstddef> // for size_t
#include <vector>  // for the layers

class vtkIndirectArrayTexture;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;

class vtkIndirectShadowRows : public vtkIndirectResource
{
public:
  explicit vtkIndirectShadowRows(vtkIndirectResource* owner);
  ~vtkIndirectShadowRows() override;

  /** Marks a layer of the depths as drawn again. */
  void Forget(int layer);

  /**
   * Brings the first layers up to date. unit, slopes: texture units of the depths and their slopes.
   * Returns false, after an error, when OpenGL refuses.
   */
  bool Update(vtkOpenGLRenderWindow* window, int unit, int slopes, int texels, int layers);

  /** Binds the rows and returns the texture unit; pair with Deactivate. */
  int Activate();
  void Deactivate();

protected:
  size_t GetOwnBytes() const override;
  void ReleaseOwn(vtkWindow* window) override;

private:
  int Texels = 0;
  std::vector<bool> Valid; // by layer
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  vtkSmartPointer<vtkIndirectArrayTexture> Texture;
  vtkIndirectFullScreenProgram Kernel;
};
