// SPDX-License-Identifier: BSD-3-Clause
// A texture of data that the processor has made.
#pragma once

#include "OpenGL/vtkIndirectProgram.h"  // for programs
#include "OpenGL/vtkIndirectResource.h" // for the base class
#include "vtkSmartPointer.h"            // for the texture

#include <glm/glm.hpp> // for sizes

class vtkOpenGLRenderWindow;
class vtkTextureObject;

class vtkIndirectDataTexture : public vtkIndirectResource
{
public:
  vtkIndirectDataTexture(vtkIndirectResource* owner);
  ~vtkIndirectDataTexture() override;

  enum ContentType
  {
    FLOATS,
    BYTES,         // shaders read 0 to 1
    INTEGER_BYTES, // shaders read unsigned integers
    INTEGERS
  };

  /**
   * Replaces the content by texels of this many components; size.z = 0: in two dimensions. Shaders
   * get the nearest texel, or with `linear` interpolated ones, clamped to the edge. Returns false,
   * after an error, if OpenGL refuses.
   */
  bool Set(vtkOpenGLRenderWindow* window, ContentType content, int components,
    const glm::ivec3& size, const void* data, bool linear = false);

  bool IsEmpty() const { return this->Texture == nullptr; }

  /** Binds the texture to a sampler; not for an empty texture. */
  void Activate(const vtkIndirectProgram& program, const char* uniform) const;

  /** Drops the content, which is out of date; the context need not be current. */
  void Clear();

protected:
  size_t GetOwnBytes() const override { return this->Bytes; }
  void ReleaseOwn(vtkWindow* window) override;

private:
  vtkSmartPointer<vtkTextureObject> Texture;
  size_t Bytes = 0;
};
