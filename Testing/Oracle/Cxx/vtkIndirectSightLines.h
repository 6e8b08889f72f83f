// SPDX-License-Identifier: BSD-3-Clause
// Exact visibility between two points on surfaces, by the surfaces themselves: the reference for
// all approximate visibility. Lengths are scene units (diagonal = 1).
//
// Points come from buffers and lie beside their triangles, by up to 1e-4 where a depth buffer gives
// the depth. Each point is therefore moved onto its triangle, in double precision, and then lifted
// off along the triangle's own normal. A segment between two ends that lie in front of both planes
// crosses neither plane, so no surface hides its own light. An end does not see another end that
// lies behind its plane, even where a smooth normal would.
//
// Limit: a blocker nearer to a surface than Lift hides no light from it.
#ifndef vtkIndirectSightLines_h
#define vtkIndirectSightLines_h

#include <glm/glm.hpp> // for vectors

class vtkIndirectTriangleTree;

class vtkIndirectSightLines
{
public:
  /** Largest distance of a point from its triangle: twice the error of the buffers. */
  static constexpr double Reach = 2e-4;
  /**
   * Distance by which ends are lifted off their planes: a hundredth of a pixel of an image of a
   * scene.
   */
  static constexpr double Lift = 1e-5;

  /** The plane of a triangle that a point lies on. */
  struct Facet
  {
    glm::dvec3 Normal{ 0.0 };  // unit, on the side of the given normal
    double Height = 0.0;       // height of the point over the plane, to that side
    double Distance = 0.0;     // from the point to the triangle
    glm::dvec3 Nearest{ 0.0 }; // point of the triangle
    glm::dvec3 Centre{ 0.0 };  // centre of the triangle
  };

  struct End
  {
    glm::dvec3 Position{ 0.0 }; // lifted
    glm::dvec3 Normal{ 0.0 };   // the triangle's normal; the shading normal where there is no
                                // triangle
    bool OnSurface = false;     // true if a triangle is within reach
  };

  /**
   * Finds the triangle that a point of this shading normal lies on: the nearest one within reach,
   * where a right angle between its plane's normal and the given one counts as much as the reach.
   * Returns false if no triangle is within reach.
   */
  static bool FindFacet(const vtkIndirectTriangleTree& tree, const glm::dvec3& point,
    const glm::dvec3& normal, double reach, Facet& facet);

  /** Uses the tree and makes no copy. */
  explicit vtkIndirectSightLines(const vtkIndirectTriangleTree& tree)
    : Tree(tree)
  {
  }

  /**
   * Makes the end of segments from and to a point of this unit shading normal. Where no triangle
   * is within reach, as in mid-air or on surfaces that a mapper makes in its shaders, the end is
   * the point itself.
   */
  End FindEnd(const glm::dvec3& position, const glm::dvec3& normal) const;
  bool IsVisible(const End& a, const End& b) const;

private:
  const vtkIndirectTriangleTree& Tree;
};

#endif
