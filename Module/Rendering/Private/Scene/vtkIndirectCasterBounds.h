// SPDX-License-Identifier: BSD-3-Clause
// The bounds within which props may move. Scene units and the fits of all maps follow from them.
// Otherwise a prop that moves at the border of the scene would change them in every frame, and with
// them all kept results. The wide bounds of a scene that has not moved are its bounds.
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
   * these bounds until it leaves them. All casters get their bounds again when the scene fills less
   * than half of the wide bounds. They also do when nothing has moved since the last frame and
   * bounds may rest: then a still scene looks as if it had never moved.
   */
  void Give(std::vector<vtkIndirectCaster>& casters, bool mayRest);

  /** Forgets all bounds and the last frame. */
  void Forget()
  {
    this->Boxes.clear();
    this->Before.clear();
  }

private:
  using Box = std::array<double, 6>;

  std::unordered_map<vtkProp*, Box> Boxes;
  std::vector<Box> Before; // bounds in the last frame
};
