// SPDX-License-Identifier: BSD-3-Clause
// Adds two-dimensional arrays to VTK 9.1's texture object, which does binding, parameters and
// release.
#pragma once

#include "vtkTextureObject.h"

class vtkIndirectArrayTexture : public vtkTextureObject
{
public:
  static vtkIndirectArrayTexture* New();
  vtkTypeMacro(vtkIndirectArrayTexture, vtkTextureObject);

  /** Square layers of a colour or a depth format, unfiltered. */
  void Allocate(vtkOpenGLRenderWindow* window, unsigned int internalFormat, int texels, int layers);

  /** Attaches one layer to the framebuffer that is bound for drawing. */
  void AttachLayer(unsigned int attachment, int layer);

protected:
  vtkIndirectArrayTexture() = default;
  ~vtkIndirectArrayTexture() override = default;

private:
  vtkIndirectArrayTexture(const vtkIndirectArrayTexture&) = delete;
  void operator=(const vtkIndirectArrayTexture&) = delete;
};
