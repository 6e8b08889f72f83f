// SPDX-License-Identifier: BSD-3-Clause
// The answer to whether two points on surfaces see each other, by the surfaces themselves: the
// oracle of all approximate visibility. Lengths are scene units (diagonal = 1).
//
// Points come from buffers and lie beside their triangles, by up to 1e-4 where depth is taken from
// a depth buffer. Each is therefore brought back to its triangle, in double precision, and then
// lifted off it along the triangle's own normal. A segment between two ends that lie in front of
// both planes crosses neither, so no surface hides its own light. An end in front of whose plane
// the other is not does not see it, also where a smooth normal would.
//
// One thing is lost: nothing nearer to a surface than Lift hides light from it.
#ifndef vtkIndirectSightLines_h
#define vtkIndirectSightLines_h

#include <glm/glm.hpp> // for vectors

class vtkIndirectTriangleTree;

class vtkIndirectSightLines
{
public:
  /** How far from its triangle a point may lie: twice what the buffers are off by. */
  static constexpr double Reach = 2e-4;
  /** Ends are lifted off their planes by this: a hundredth of a pixel of an image of a scene. */
  static constexpr double Lift = 1e-5;

  struct End
  {
    glm::dvec3 Position{ 0.0 }; // lifted
    glm::dvec3 Normal{ 0.0 };   // the triangle's; the shading normal where there is none
    bool OnSurface = false;     // there is a triangle
  };

  /** Uses the tree and makes no copy. */
  explicit vtkIndirectSightLines(const vtkIndirectTriangleTree& tree)
    : Tree(tree)
  {
  }

  /**
   * The end of segments from and to a point of this unit shading normal. Where no triangle is
   * within reach, as on surfaces that a mapper makes in its shaders, or in mid-air, the point
   * itself.
   */
  End FindEnd(const glm::dvec3& position, const glm::dvec3& normal) const;
  bool IsVisible(const End& a, const End& b) const;

private:
  const vtkIndirectTriangleTree& Tree;
};

#endif
