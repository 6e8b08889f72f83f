// SPDX-License-Identifier: BSD-3-Clause
// Area lights that are visible themselves, drawn into the geometry buffer as unlit surfaces. Only
// the eye sees them, so no depth map holds them and they cast no shadows.
//
// They are not props, and the camera's clipping range is not fitted to them: beyond its planes they
// are drawn nevertheless, in front of or behind everything else.
#pragma once

#include "OpenGL/vtkIndirectKey.h"          // for members
#include "OpenGL/vtkIndirectPointProgram.h" // for members
#include "OpenGL/vtkIndirectResource.h"     // for the base class
#include "vtkSmartPointer.h"                // for lights

#include <map>    // for images
#include <vector> // for lists

class vtkAreaLight;
class vtkIndirectGeometryBuffer;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
struct vtkIndirectFrame;

class vtkIndirectVisibleLamps : public vtkIndirectResource
{
public:
  using vtkIndirectResource::vtkIndirectResource;
  using Lights = std::vector<vtkSmartPointer<vtkAreaLight>>;

  /** Returns the number of lamps that are visible from some place. */
  static int Count(const Lights& lights);

  /** Draws the lamps. Returns false, after an error, when OpenGL refuses. */
  bool Draw(
    const vtkIndirectFrame& frame, const Lights& lights, vtkIndirectGeometryBuffer& geometry);

protected:
  size_t GetOwnBytes() const override;
  void ReleaseOwn(vtkWindow* window) override;

private:
  // A light's image, with its means over halves, quarters and so on.
  struct Picture
  {
    vtkSmartPointer<vtkTextureObject> Texture;
    vtkIndirectKey Light; // the light that it was made of
  };

  vtkTextureObject* FindPicture(vtkOpenGLRenderWindow* window, vtkAreaLight* light);
  bool DrawLamp(
    const vtkIndirectFrame& frame, vtkAreaLight* light, const vtkIndirectGeometryBuffer& geometry);

  vtkIndirectPointProgram Kernels[2] = { { this, "vtkIndirectLampVS.glsl",
                                           "vtkIndirectLampFS.glsl" },
    { this, "vtkIndirectLampVS.glsl", "vtkIndirectLampFS.glsl" } }; // for one radiance, for images
  std::map<vtkSmartPointer<vtkAreaLight>, Picture> Pictures;
};
