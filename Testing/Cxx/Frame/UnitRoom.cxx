// SPDX-License-Identifier: BSD-3-Clause
// Bounds for moving casters, and empty scenes.
#include "vtkIndirectTestUtilities.h"

#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectRoom.h"
#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkNew.h"

#include <algorithm>
#include <vector>

using namespace vtkIndirectTest;

// For an empty box VTK returns infinity, or ends the program, depending on its version.
VTK_INDIRECT_TEST(RoomOfNothing)
{
  CheckEqual("the diagonal of an empty box", vtkIndirectFrame::FindDiagonal(vtkBoundingBox()), 0.0);
  CheckEqual("of a point", vtkIndirectFrame::FindDiagonal({ 1.0, 1.0, 2.0, 2.0, 3.0, 3.0 }), 0.0);
  CheckEqual("of a box", vtkIndirectFrame::FindDiagonal({ 0.0, 1.0, 0.0, 2.0, 0.0, 2.0 }), 3.0);

  vtkIndirectRoom room;
  std::vector<vtkIndirectCaster> nothing;
  room.Give(nothing, true);
  Check("a scene that is empty", nothing.empty());

  vtkNew<vtkActor> actor;
  const double bounds[6] = { 0.0, 1.0, 0.0, 2.0, 0.0, 2.0 };
  std::vector<vtkIndirectCaster> one(1);
  one[0].Prop = actor;
  std::copy(bounds, bounds + 6, one[0].Bounds);
  room.Give(one, true);
  Check("what comes has its bounds", one[0].HasRoom && std::equal(bounds, bounds + 6, one[0].Room));
  room.Give(nothing, true);
  one[0].HasRoom = false;
  std::fill(one[0].Room, one[0].Room + 6, 7.0);
  room.Give(one, true);
  Check("and when it was away", one[0].HasRoom && std::equal(bounds, bounds + 6, one[0].Room));
}
