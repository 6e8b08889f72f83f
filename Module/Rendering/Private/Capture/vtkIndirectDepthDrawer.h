// SPDX-License-Identifier: BSD-3-Clause
// Draws the depth of plain polygons from their mappers' buffers, reading only positions. The state
// of a prop is set up once for any number of cameras, and software rasterizers interpolate no
// attributes: two thirds of the time of mappers. Not for props that differ from their polygons:
// impostors, glyphs, textures, clipping planes, users' shaders.
#pragma once

#include "Capture/vtkIndirectCoarseLevels.h" // for levels
#include "OpenGL/vtkIndirectResource.h"      // for the base class
#include "vtkSmartPointer.h"                 // for a member

#include <glm/glm.hpp> // for matrices

class vtkOpenGLPolyDataMapper;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkProp;
class vtkShaderProgram;

class vtkIndirectDepthDrawer : public vtkIndirectResource
{
public:
  explicit vtkIndirectDepthDrawer(vtkIndirectResource* owner);
  ~vtkIndirectDepthDrawer() override;

  /**
   * True if this draws the same depth as the prop's mapper, and the mapper's buffers are current:
   * it has drawn since its data last changed.
   */
  static bool CanDraw(vtkProp* prop);

  /** Sets up a prop for which CanDraw is true, or a coarse level in its place. Returns false, after
   * an error, if the program fails. */
  bool Begin(
    vtkOpenGLRenderWindow* window, vtkProp* prop, vtkIndirectCoarseLevels::Level* level = nullptr);
  /** Draws it into the current viewport; both transforms in double precision. Returns triangles. */
  size_t Draw(const glm::dmat4& worldToClip);
  /** Triangles of the prop itself, also if a coarse level is drawn in its place. */
  size_t CountTriangles() const;
  void End();

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  vtkShaderProgram* Program = nullptr;
  vtkSmartPointer<vtkOpenGLVertexArrayObject> Vertices;
  vtkOpenGLPolyDataMapper* Mapper = nullptr;       // between Begin and End
  vtkIndirectCoarseLevels::Level* Level = nullptr; // between Begin and End
  glm::dmat4 ToWorld{ 1.0 };                       // transform from the buffer's coordinates
};
