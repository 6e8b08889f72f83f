// SPDX-License-Identifier: BSD-3-Clause
// The part of an area light's view in which a caster can hide the light. A depth map of this part
// alone has finer texels: for a lamp far above a machine they are ten times finer than those of a
// map of all that the lamp shines at.
#pragma once

#include "Capture/vtkIndirectDepthTile.h" // for views

#include <glm/glm.hpp> // for corners

#include <array>  // for boxes
#include <limits> // for empty parts
#include <vector> // for boxes

class vtkProp;
struct vtkIndirectFrame;

class vtkIndirectCasterWindow
{
public:
  /**
   * Finds the casters that can hide a polygon from a receiver. All casters can, except convex ones
   * that a face of their bounds separates from the polygon and all other casters, such as a ground,
   * a table or a wall. Corners are in scene units. Returns true if these casters have changed.
   */
  bool Update(const vtkIndirectFrame& frame, const std::vector<glm::dvec3>& corners);

  /**
   * Narrows the views of perspective tiles of one axis to the casters that can hide their places.
   * Each tile gets its own view ahead; strips and depths are shared by all tiles. Depths begin at
   * these casters and end behind all casters.
   */
  void Fit(const std::vector<vtkIndirectDepthTile*>& tiles) const;

  /**
   * Returns true if a prop is a polygonal mesh of few points that is flat, or closed and convex:
   * such a prop hides nothing of its own front.
   */
  static bool IsConvex(vtkProp* prop);

private:
  using Box = std::array<glm::dvec3, 8>;

  // This is the part of a view that boxes cover.
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
