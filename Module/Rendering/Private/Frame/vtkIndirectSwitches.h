// SPDX-License-Identifier: BSD-3-Clause
// The renderer's own switches that a renderer with a pass does not see to: which of them the pass
// sees to, and what is to be said of the others.
//
// Seen to elsewhere: background, gradient, texture, Erase and the layers' PreserveColorBuffer and
// PreserveDepthBuffer, translucent props with UseDepthPeeling and UseDepthPeelingForVolumes,
// UseFXAA (vtkIndirectView); UseImageBasedLighting (vtkIndirectImageLight). VTK's mappers light
// both sides of a surface, whatever TwoSidedLighting says.
#ifndef vtkIndirectSwitches_h
#define vtkIndirectSwitches_h

#include <set>     // for what has been said
#include <string>  // for reasons
#include <utility> // for pairs
#include <vector>  // for lists

class vtkRenderState;

class vtkIndirectSwitches
{
public:
  using Entries = std::vector<std::pair<std::string, std::string>>; // what, why

  /** Whether the renderer removes hidden lines, and there are lines to remove. */
  static bool RemovesHiddenLines(const vtkRenderState* s);
  /**
   * Whether something in the scene is drawn where the depth buffer says that it is seen, as labels
   * of a vtkSelectVisiblePoints are.
   */
  static bool LooksDepthUp(const vtkRenderState* s);
  /**
   * Why surfaces cannot be had under the passes that the renderer's chain of passes begins with;
   * empty where they can.
   */
  static std::string FindRefusal(const vtkRenderState* s);

  /** What is on and not done. ownDelegate: the user's own draws the opaque props. */
  void Update(const vtkRenderState* s, bool ownDelegate);
  const Entries& GetLeftOut() const { return this->LeftOut; }
  /** Whether to say this now: true once, until it has not been for a frame. */
  bool IsNew(const std::string& what) { return this->Said.insert(what).second; }

private:
  Entries LeftOut;
  std::set<std::string> Said;
};

#endif
