// SPDX-License-Identifier: BSD-3-Clause
// Bounds for moving casters, and empty scenes.
#include "vtkIndirectTestUtilities.h"

#include "Scene/vtkIndirectCasterBounds.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkNew.h"

#include <algorithm>
#include <vector>

using namespace vtkIndirectTest;

// For an empty box VTK returns infinity, or ends the program, depending on its version.
VTK_INDIRECT_TEST(CasterBoundsOfNothing)
{
  CheckEqual("the diagonal of an empty box", vtkIndirectFrame::FindDiagonal(vtkBoundingBox()), 0.0);
  CheckEqual("of a point", vtkIndirectFrame::FindDiagonal({ 1.0, 1.0, 2.0, 2.0, 3.0, 3.0 }), 0.0);
  CheckEqual("of a box", vtkIndirectFrame::FindDiagonal({ 0.0, 1.0, 0.0, 2.0, 0.0, 2.0 }), 3.0);

  vtkIndirectCasterBounds casterBounds;
  std::vector<vtkIndirectCaster> nothing;
  casterBounds.Give(nothing, true);
  Check("a scene that is empty", nothing.empty());

  vtkNew<vtkActor> actor;
  const double bounds[6] = { 0.0, 1.0, 0.0, 2.0, 0.0, 2.0 };
  std::vector<vtkIndirectCaster> one(1);
  one[0].Prop = actor;
  std::copy(bounds, bounds + 6, one[0].Bounds);
  casterBounds.Give(one, true);
  Check("what comes has its bounds",
    one[0].HasWideBounds && std::equal(bounds, bounds + 6, one[0].WideBounds));
  casterBounds.Give(nothing, true);
  one[0].HasWideBounds = false;
  std::fill(one[0].WideBounds, one[0].WideBounds + 6, 7.0);
  casterBounds.Give(one, true);
  Check("and when it was away",
    one[0].HasWideBounds && std::equal(bounds, bounds + 6, one[0].WideBounds));

  const double moved[6] = { 0.5, 1.5, 0.0, 2.0, 0.0, 2.0 };
  std::copy(moved, moved + 6, one[0].Bounds);
  casterBounds.Give(one, true);
  CheckAtLeast("wide bounds of a prop that moves", one[0].WideBounds[1], 1.6, "an eighth of 2.9");
  casterBounds.Give(one, false);
  Check("a still frame has exact ones", std::equal(moved, moved + 6, one[0].WideBounds));
}
