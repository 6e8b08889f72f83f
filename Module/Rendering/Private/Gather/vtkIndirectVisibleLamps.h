// SPDX-License-Identifier: BSD-3-Clause
// Area lights that are seen themselves, drawn into the geometry buffer as what is not lit: only the
// eye sees them, so that no depth map holds them and nothing is in their shadow.
//
// They are no props, and nobody fits the camera's clipping range to them: beyond its planes they
// are drawn all the same, in front of or behind everything else.
#ifndef vtkIndirectVisibleLamps_h
#define vtkIndirectVisibleLamps_h

#include "OpenGL/vtkIndirectPointProgram.h" // for members
#include "vtkSmartPointer.h"                // for lights
#include "vtkType.h"                        // for times

#include <map>    // for images
#include <vector> // for lists

class vtkAreaLight;
class vtkIndirectGeometryBuffer;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;
struct vtkIndirectFrame;

class vtkIndirectVisibleLamps
{
public:
  using Lights = std::vector<vtkSmartPointer<vtkAreaLight>>;

  /** How many can be seen from somewhere. */
  static int Count(const Lights& lights);

  /** Returns false, after an error, when OpenGL refuses. */
  bool Draw(
    const vtkIndirectFrame& frame, const Lights& lights, vtkIndirectGeometryBuffer& geometry);

  size_t GetBytes() const;
  void Release(vtkWindow* window);

private:
  // A light's image, with its means over halves, quarters and so on.
  struct Picture
  {
    vtkSmartPointer<vtkTextureObject> Texture;
    vtkMTimeType Time = 0; // of the light
  };

  vtkTextureObject* FindPicture(vtkOpenGLRenderWindow* window, vtkAreaLight* light);
  bool DrawLamp(
    const vtkIndirectFrame& frame, vtkAreaLight* light, const vtkIndirectGeometryBuffer& geometry);

  vtkIndirectPointProgram Kernels[2] = { { "vtkIndirectLampVS.glsl", "vtkIndirectLampFS.glsl" },
    { "vtkIndirectLampVS.glsl", "vtkIndirectLampFS.glsl" } }; // of one radiance, of images
  std::map<vtkSmartPointer<vtkAreaLight>, Picture> Pictures;
};

#endif
