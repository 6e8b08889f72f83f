// SPDX-License-Identifier: BSD-3-Clause
// Depth of plain polygons, drawn from the buffers that their mappers keep: positions in, nothing
// else. The state of a prop is set up once for any number of cameras, and software rasterizers
// carry no attribute along: two thirds of the time that mappers take. What looks different from
// its polygons (impostors, glyphs, textures, clipping planes, shaders of users) is not for it.
#ifndef vtkIndirectDepthDrawer_h
#define vtkIndirectDepthDrawer_h

#include "Capture/vtkIndirectCoarseLevels.h" // for levels
#include "vtkSmartPointer.h"                 // for a member

#include <glm/glm.hpp> // for matrices

class vtkOpenGLPolyDataMapper;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkProp;
class vtkShaderProgram;
class vtkWindow;

class vtkIndirectDepthDrawer
{
public:
  vtkIndirectDepthDrawer();
  ~vtkIndirectDepthDrawer();

  /**
   * Whether this draws what the prop's mapper would, and the mapper's buffers are up to date: it
   * has drawn since its data last changed.
   */
  static bool CanDraw(vtkProp* prop);

  /** Sets up a prop that it can draw, or a coarse level in its place. Returns false, after an
   * error, where the program fails. */
  bool Begin(
    vtkOpenGLRenderWindow* window, vtkProp* prop, vtkIndirectCoarseLevels::Level* level = nullptr);
  /** Draws it into the current viewport; both transforms in double precision. Returns triangles. */
  size_t Draw(const glm::dmat4& worldToClip);
  /** Triangles of the prop itself, whatever is drawn in its place. */
  size_t CountTriangles() const;
  void End();

  void Release(vtkWindow* window);

private:
  vtkShaderProgram* Program = nullptr;
  vtkSmartPointer<vtkOpenGLVertexArrayObject> Vertices;
  vtkOpenGLPolyDataMapper* Mapper = nullptr;       // between Begin and End
  vtkIndirectCoarseLevels::Level* Level = nullptr; // the same
  glm::dmat4 ToWorld{ 1.0 };                       // from what the buffer holds
};

#endif
