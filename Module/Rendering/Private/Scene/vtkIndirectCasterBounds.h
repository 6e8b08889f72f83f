// SPDX-License-Identifier: BSD-3-Clause
// The bounds within which props may move. Scene units and the fits of all maps follow from them.
// Otherwise a prop that moves at the border of the scene would change them in every frame, and with
// them all kept results. Bounds are wide in interactive frames alone: the picture of a still frame
// follows from its scene, whatever came before.
#pragma once

#include <array>         // for boxes
#include <unordered_map> // for boxes by prop
#include <vector>        // for casters

class vtkProp;
struct vtkIndirectCaster;

class vtkIndirectCasterBounds
{
public:
  /**
   * Gives casters wide bounds, at first their own. A caster that has left them gets an eighth of
   * the scene's size on each side, clipped to the scene where the caster lies within it, and keeps
   * these bounds until it leaves them. All casters get their own bounds again in a frame that is
   * not interactive, and when the scene fills less than half of the wide bounds.
   */
  void Give(std::vector<vtkIndirectCaster>& casters, bool interactive);

  /** Forgets all bounds. */
  void Forget() { this->Boxes.clear(); }

private:
  using Box = std::array<double, 6>;

  std::unordered_map<vtkProp*, Box> Boxes;
};
