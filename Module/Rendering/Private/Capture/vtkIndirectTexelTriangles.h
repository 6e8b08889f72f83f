// SPDX-License-Identifier: BSD-3-Clause
// The triangles of dense meshes that cover the centre of a texel in a parallel map: only these draw
// something. Where a map has far fewer texels than a mesh has triangles, the mapper draws from a
// short list of indices, in the order of its own list, so that the map stays the same. For OpenGL
// on the processor, which takes longer to transform a triangle than this takes to leave one out.
#pragma once

#include "Capture/vtkIndirectDepthDrawer.h"    // for buffers of indices
#include "Capture/vtkIndirectSmallTriangles.h" // for a member
#include "vtkNew.h"                            // for members

#include <cstddef> // for size_t
#include <glm/glm.hpp>
#include <map>    // for members
#include <vector> // for lists

class vtkOpenGLIndexBufferObject;
class vtkProp;
struct vtkIndirectDepthTile;
struct vtkIndirectFrame;

class vtkIndirectTexelTriangles
{
public:
  /** For the life of this object, a prop's mapper draws only what a view with so many texels along
   * an edge shows; all triangles where that is not worth it, or where they have numbers. */
  class Scope
  {
  public:
    Scope(vtkIndirectTexelTriangles& triangles, const vtkIndirectFrame& frame,
      const vtkIndirectDepthTile& view, int texels, vtkProp* prop);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    vtkProp* Prop = nullptr; // null: its mapper draws all
    vtkIndirectDepthDrawer::IndexBuffers Own{};
    vtkNew<vtkOpenGLIndexBufferObject> Short[2];
  };

  /** Forgets the meshes, which may change before the next map. */
  void Clear() { this->Meshes.clear(); }

private:
  struct Mesh
  {
    std::vector<vtkIndirectMeshParts::Triangle> Triangles;
    std::vector<glm::vec3> Points; // from the first one
    glm::dvec3 First{ 0.0 };
  };
  std::map<vtkProp*, Mesh> Meshes;
  vtkIndirectSmallTriangles Small;

  static bool CanChoose(vtkProp* prop);
  const Mesh& Read(vtkProp* prop);
};
