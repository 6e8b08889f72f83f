// SPDX-License-Identifier: BSD-3-Clause
// The room that props have to move in. Scene units and the fits of all maps follow from them:
// where something moves at the border of the scene they would change in every frame, and with them
// all that is kept. Where nothing has moved it is their bounds.
#ifndef vtkIndirectRoom_h
#define vtkIndirectRoom_h

#include <array>         // for boxes
#include <unordered_map> // for what was before
#include <vector>        // for casters

class vtkProp;
struct vtkIndirectCaster;

class vtkIndirectRoom
{
public:
  /**
   * Gives casters room. It is their bounds at first. One that has left its room gets an eighth of
   * the scene's size on each side, which makes the scene no larger where it is within, and keeps
   * that until it leaves it. Where the scene has come to fill less than half of all room, all get
   * their bounds again; also where nothing has moved since the last frame, if it may rest: what
   * stands looks as if it had never moved.
   */
  void Give(std::vector<vtkIndirectCaster>& casters, bool mayRest);

  /** Forgets what was before. */
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
