// SPDX-License-Identifier: BSD-3-Clause
// The part of what an area light sees in which something can hide it. A depth map of no more than
// that has finer texels: of a lamp far above a machine they are ten times finer than those of all
// that the lamp shines at.
#ifndef vtkIndirectCasterWindow_h
#define vtkIndirectCasterWindow_h

#include <glm/glm.hpp> // for corners

#include <array>  // for boxes
#include <vector> // for boxes

class vtkProp;
struct vtkIndirectDepthTile;
struct vtkIndirectFrame;

class vtkIndirectCasterWindow
{
public:
  /**
   * Finds what can hide a polygon from anything: all casters but those that are convex and lie,
   * with a face of their bounds between, on the other side from the polygon and all other casters,
   * such as a ground, a table or a wall. Corners in scene units. Returns whether that has changed.
   */
  bool Update(const vtkIndirectFrame& frame, const std::vector<glm::dvec3>& corners);

  /**
   * Narrows the view of a perspective tile to what can hide its place. It begins there and ends
   * behind all casters.
   */
  void Fit(vtkIndirectDepthTile& tile) const;

  /**
   * Whether a prop is a polygonal mesh of few points that is flat, or closed and convex: it hides
   * nothing of its own front.
   */
  static bool IsConvex(vtkProp* prop);

private:
  using Box = std::array<glm::dvec3, 8>;

  std::vector<Box> Boxes; // scene units
  Box All;                // around all casters
};

#endif
