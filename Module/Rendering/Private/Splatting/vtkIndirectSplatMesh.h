// SPDX-License-Identifier: BSD-3-Clause
// Geometry of a splat: a polyhedron about the unit ball, or a rectangle.
#pragma once

#include "OpenGL/vtkIndirectResource.h" // for the base class
#include "vtkOpenGLRenderWindow.h"      // for the weak pointer
#include "vtkWeakPointer.h"             // for the context

#include <array>       // for triangles
#include <glm/glm.hpp> // for corners
#include <vector>      // for lists

class vtkIndirectSplatMesh : public vtkIndirectResource
{
public:
  struct Polyhedron
  {
    std::vector<glm::dvec3> Corners;
    std::vector<std::array<unsigned short, 3>> Triangles; // counterclockwise from outside
  };

  /**
   * Returns an icosahedron whose faces are split into four each, enlarged until it encloses the
   * unit ball: 42 corners, 80 triangles. An affine map preserves that, so it encloses any ellipsoid
   * that the ball is mapped to.
   */
  static Polyhedron MakePolyhedron();

  using vtkIndirectResource::vtkIndirectResource;
  ~vtkIndirectSplatMesh() override;

  /** Draws this many instances of the polyhedron or of the square from -1 to 1; the corners go to
   * the attribute. */
  void Draw(vtkOpenGLRenderWindow* window, int attribute, bool rectangles, int instances);

protected:
  size_t GetOwnBytes() const override { return this->Bytes; }
  void ReleaseOwn(vtkWindow* window) override;

private:
  void Create(vtkOpenGLRenderWindow* window);

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  unsigned int VertexArray = 0;
  unsigned int Buffers[2] = { 0, 0 }; // corners, triangles
  int NumberOfIndices = 0;
  int FirstOfRectangle = 0; // first corner of the rectangle
  size_t Bytes = 0;
};
