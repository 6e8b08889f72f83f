// SPDX-License-Identifier: BSD-3-Clause
// The room in which props may move. Scene units and the fits of all maps follow from it. Otherwise
// a prop that moves at the border of the scene would change them in every frame, and with them all
// kept results. The room of a scene that has not moved is its bounds.
#ifndef vtkIndirectRoom_h
#define vtkIndirectRoom_h

#include <array>         // for boxes
#include <unordered_map> // for rooms by prop
#include <vector>        // for casters

class vtkProp;
struct vtkIndirectCaster;

class vtkIndirectRoom
{
public:
  /**
   * Gives casters room, at first their bounds. A caster that has left its room gets an eighth of
   * the scene's size on each side, clipped to the scene where the caster lies within it, and keeps
   * this room until it leaves it. All casters get their bounds again when the scene fills less than
   * half of all room. They also do when nothing has moved since the last frame and the room may
   * rest: then a still scene looks as if it had never moved.
   */
  void Give(std::vector<vtkIndirectCaster>& casters, bool mayRest);

  /** Forgets all rooms and the last frame. */
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

#endif
