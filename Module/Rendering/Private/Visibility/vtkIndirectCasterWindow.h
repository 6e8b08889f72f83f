// SPDX-License-Identifier: BSD-3-Clause
// The part of what an area light sees in which something can hide it. A depth map of no more than
// that has finer texels: of a lamp far above a machine they are ten times finer than those of all
// that the lamp shines at.
#ifndef vtkIndirectCasterWindow_h
#define vtkIndirectCasterWindow_h

#include "Visibility/vtkIndirectDepthTile.h" // for views

#include <glm/glm.hpp> // for corners

#include <array>  // for boxes
#include <limits> // for what is empty
#include <vector> // for boxes

class vtkProp;
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
   * Narrows the views of perspective tiles of one axis to what can hide their places: that ahead
   * for each, strips and depths for all together. They begin there and end behind all casters.
   */
  void Fit(std::vector<vtkIndirectDepthTile*> tiles) const;

  /**
   * Whether a prop is a polygonal mesh of few points that is flat, or closed and convex: it hides
   * nothing of its own front.
   */
  static bool IsConvex(vtkProp* prop);

private:
  using Box = std::array<glm::dvec3, 8>;

  // What a view shows of boxes.
  struct Part
  {
    glm::dvec2 Lower{ std::numeric_limits<double>::infinity() }; // tangents
    glm::dvec2 Upper{ -std::numeric_limits<double>::infinity() };
    double Nearest = std::numeric_limits<double>::infinity(); // scene units

    bool IsEmpty() const { return !(this->Lower.x <= this->Upper.x); }
    void Add(const Part& other)
    {
      this->Lower = glm::min(this->Lower, other.Lower);
      this->Upper = glm::max(this->Upper, other.Upper);
      this->Nearest = glm::min(this->Nearest, other.Nearest);
    }
  };

  Part FindPart(
    const vtkIndirectDepthTile& view, const glm::dvec2& least, const glm::dvec2& most) const;
  static vtkIndirectDepthTile::Strip ToWindow(
    const Part& part, const glm::dvec2& least, const glm::dvec2& most);

  std::vector<Box> Boxes; // scene units
  Box All;                // around all casters
};

#endif
