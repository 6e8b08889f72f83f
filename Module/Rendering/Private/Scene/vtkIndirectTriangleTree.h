// SPDX-License-Identifier: BSD-3-Clause
// A tree of boxes over triangles and spheres (vtkIndirectBoxTree). It says whether a segment is
// blocked, which triangle or sphere a ray meets first, and which triangles are near to a point.
//
// Corners are kept in double precision, as they were given. The test of a triangle is watertight
// (Woop, Benthin, Wald 2013, "Watertight ray/triangle intersection"): edges that two triangles
// share get the same numbers with the other sign, so a segment through an edge or a corner meets at
// least one of them. Boxes are wider than their triangles by more than all rounding, so the tree
// finds what a loop over all triangles would.
#pragma once

#include <cmath>       // for infinity
#include <cstdint>     // for indices
#include <functional>  // for visitors
#include <glm/glm.hpp> // for vectors
#include <vector>      // for triangles

class vtkIndirectTriangleTree
{
public:
  /** This is the place at which a ray first meets a triangle or a sphere. */
  struct Hit
  {
    uint32_t Triangle = None; // how many triangles and spheres had been given before this one
    double Distance = 0.0;    // in the tree's unit
    double Weights[3]; // of the triangle's corners, in the order in which they were given; the
                       // unit normal of a sphere
  };
  static constexpr uint32_t None = 0xffffffffu;

  void Clear();
  /**
   * Corners in any unit. A triangle without area, or with a corner that is no number, blocks
   * nothing and is left out: false. It counts in the numbers of the triangles that follow.
   */
  bool Add(const glm::dvec3 corners[3]);
  /**
   * Adds a sphere, which counts as one more triangle in the numbers. A sphere without radius, or
   * whose numbers are not finite, is left out: false.
   */
  bool AddSphere(const glm::dvec3& center, double radius);
  /** Makes the tree after the last triangle and the last sphere. */
  void Finish();

  /**
   * Returns true if a triangle or a sphere crosses the segment between its ends. A triangle that an
   * end lies on, and a sphere that an end lies on or in, does not count: a surface hides none of
   * its own light. Both sides of a triangle block.
   */
  bool IsBlocked(const glm::dvec3& start, const glm::dvec3& end) const;

  /**
   * Finds the first triangle, seen from either side, or sphere, from outside, that a ray of this
   * unit direction meets, except the one of number `except`. Returns false if the ray meets none.
   */
  bool FindNearest(
    const glm::dvec3& start, const glm::dvec3& direction, uint32_t except, Hit& hit) const;

  /** Calls for each triangle whose box is within this distance of a point; spheres are left out. */
  void ForEachNear(const glm::dvec3& point, double distance,
    const std::function<void(const glm::dvec3 corners[3])>& call) const;

  size_t GetNumberOfTriangles() const { return this->Triangles.size() - this->NumberOfSpheres; }
  size_t GetNumberOfSpheres() const { return this->NumberOfSpheres; }
  size_t GetBytes() const
  {
    return this->Triangles.size() * sizeof(Triangle) + this->Nodes.size() * sizeof(Node) +
      this->Numbers.size() * sizeof(uint32_t);
  }

private:
  struct Triangle
  {
    glm::dvec3 Corners[3]; // a sphere has its center, its radius and infinity here

    bool IsSphere() const { return std::isinf(this->Corners[2].x); }
    bool MeetsSphere(const glm::dvec3& start, const glm::dvec3& direction, double& distance,
      double normal[3]) const;
    bool SphereCrosses(const glm::dvec3& start, const glm::dvec3& way) const;
  };
  // Boxes about the tree's origin, side by side in vectors' lanes; a node fills two cache lines.
  static constexpr int Width = 4;
  struct alignas(64) Node
  {
    float Bounds[2][3][Width]; // lower and upper; a missing child has them swapped
    uint32_t First[Width];     // child, or the first triangle of a leaf
    uint32_t Count[Width];     // number of a leaf's triangles; 0: not a leaf
  };
  struct Line;
  struct Ray;

  bool Clip(const glm::dvec3& start, const glm::dvec3& way, double& enter, double& leave) const;
  template <typename Call>
  void Walk(const Line& line, float& limit, Call call) const;

  std::vector<Triangle> Triangles; // by leaf after Finish
  std::vector<uint32_t> Numbers;   // numbers of these triangles, in the order in which they were
                                   // given
  uint32_t NumberOfGiven = 0;
  size_t NumberOfSpheres = 0;
  std::vector<Node> Nodes;
  glm::dvec3 Lower{ 0.0 }; // of all boxes
  glm::dvec3 Upper{ 0.0 };
  glm::dvec3 Origin{ 0.0 }; // where most triangles are
};
