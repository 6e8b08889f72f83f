// SPDX-License-Identifier: BSD-3-Clause
// Draws the depth of plain polygons from their mappers' buffers, reading only positions. The state
// of a prop is set up once for any number of cameras, and software rasterizers interpolate no
// attributes: two thirds of the time of mappers. Not for props that differ from their polygons:
// impostors, glyphs, textures, clipping planes, users' shaders.
#pragma once

#include "Capture/vtkIndirectMeshParts.h" // for levels
#include "OpenGL/vtkIndirectResource.h"   // for the base class
#include "vtkSmartPointer.h"              // for a member

#include <array>       // for buffers
#include <glm/glm.hpp> // for matrices
#include <vector>      // for levels

class vtkOpenGLBufferObject;
class vtkOpenGLIndexBufferObject;
class vtkOpenGLPolyDataMapper;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkPolyData;
class vtkProp;
class vtkShaderProgram;

class vtkIndirectDepthDrawer : public vtkIndirectResource
{
public:
  explicit vtkIndirectDepthDrawer(vtkIndirectResource* owner);
  ~vtkIndirectDepthDrawer() override;

  /**
   * Returns true if this draws the same depth as the prop's mapper, and the mapper's buffers are
   * current: it has drawn since its data last changed.
   */
  static bool CanDraw(vtkProp* prop);

  /** Returns the polygons that such a prop draws; null for other props. */
  static vtkPolyData* FindMesh(vtkProp* prop);
  /** Returns the number of triangles of a prop for which CanDraw is true. */
  static size_t CountTriangles(vtkProp* prop);
  /** These triangles, by numbers of the mesh's points, or none if the mapper numbers them
   * otherwise. */
  static std::vector<vtkIndirectMeshParts::Triangle> ReadTriangles(vtkProp* prop);

  /** These are the buffers of indices that such a prop's mapper draws polygons and strips from. */
  using IndexBuffers = std::array<vtkOpenGLIndexBufferObject*, 2>;
  static IndexBuffers GetIndices(vtkProp* prop);
  static void SetIndices(vtkProp* prop, const IndexBuffers& buffers);
  /** Returns true if the shaders of such a prop read what belongs to a triangle's number. */
  static bool NumbersTriangles(vtkProp* prop);

  /** Sets up a prop for which CanDraw is true, or levels of its parts in its place. slopes: true to
   * write vtkiDepthSlope of a parallel map to the first channel. Returns false, after an error, if
   * the program fails. */
  bool Begin(vtkOpenGLRenderWindow* window, vtkProp* prop, vtkIndirectMeshParts* parts = nullptr,
    bool slopes = false);
  /** Sets the depth of the next draw's view in units of the width of a texel. */
  void SetSlopeScale(const glm::dvec2& scale);
  /** Draws it into the current viewport; both transforms in double precision. Returns triangles. */
  size_t Draw(const glm::dmat4& worldToClip);
  /** Draws levels of the parts. emitter: its place and 1, or the direction to it and 0. */
  size_t Draw(const glm::dmat4& worldToClip, const glm::dvec4& emitter,
    const std::vector<vtkIndirectMeshParts::Level>& levels);
  /** Draws triangles of the parts' points. */
  void Draw(const glm::dmat4& worldToClip, const glm::dvec4& emitter,
    const std::vector<unsigned int>& indices);
  void End();

  /** Returns the transform from the points of a prop's parts to the world. */
  static glm::dmat4 GetToWorld(vtkProp* prop, const vtkIndirectMeshParts& parts);

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  void SetView(const glm::dmat4& worldToClip, const glm::dvec4& emitter);

  vtkShaderProgram* Program = nullptr;
  vtkSmartPointer<vtkOpenGLVertexArrayObject> Vertices;
  vtkOpenGLPolyDataMapper* Mapper = nullptr;      // between Begin and End
  vtkIndirectMeshParts* Parts = nullptr;          // between Begin and End
  glm::dmat4 ToWorld{ 1.0 };                      // transform from the buffer's coordinates
  std::vector<int> Counts;                        // of levels
  std::vector<const void*> Offsets;               // of levels
  vtkSmartPointer<vtkOpenGLBufferObject> Indices; // of triangles of the parts
};
