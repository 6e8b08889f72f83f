// SPDX-License-Identifier: BSD-3-Clause
// Files mark missing values by numbers such as 1e20 and 9.97e36. Points at these are not the size
// of a scene: scene units, maps and grids would shrink the rest to nothing. VTK itself leaves
// infinite points out of bounds.
#pragma once

class vtkProp;

namespace vtkIndirectFillValues
{
enum class Points
{
  NONE, // no point lies beyond: bounds are VTK's
  SOME,
  ALL // all points lie beyond: there are no bounds
};

/** Returns true if no float within these bounds overflows when it is squared. */
bool IsWithin(const double bounds[6]);

/**
 * Tells which points of a prop's parts, levels of detail and blocks lie beyond that. If some do, it
 * gives the world bounds of the others, with the size of glyphs and atoms.
 */
Points FindBounds(vtkProp* prop, double bounds[6]);
}
