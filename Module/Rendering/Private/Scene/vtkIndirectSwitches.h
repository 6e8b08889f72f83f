// SPDX-License-Identifier: BSD-3-Clause
// Switches of the renderer that VTK ignores for a renderer with a pass. The pass handles some of
// them; for the others the report gets an entry.
//
// Handled elsewhere: background, gradient, texture, Erase and the layers' PreserveColorBuffer and
// PreserveDepthBuffer, translucent props with UseDepthPeeling and UseDepthPeelingForVolumes,
// UseFXAA (vtkIndirectRendererWork); UseImageBasedLighting (vtkIndirectImageLight). VTK's mappers
// light both sides of a surface, whatever TwoSidedLighting is.
#pragma once

#include <set>     // for warnings that were given
#include <string>  // for reasons
#include <utility> // for pairs
#include <vector>  // for lists

class vtkRenderState;

class vtkIndirectSwitches
{
public:
  using Entries = std::vector<std::pair<std::string, std::string>>; // subject, reason

  /** Returns true if the renderer removes hidden lines, and there are lines to remove. */
  static bool RemovesHiddenLines(const vtkRenderState* s);
  /**
   * Returns true if a prop is drawn where the depth buffer shows that its place is visible, such as
   * labels of a vtkSelectVisiblePoints.
   */
  static bool LooksDepthUp(const vtkRenderState* s);
  /**
   * Returns the reason why the renderer's first passes in its chain give no surfaces; empty if they
   * do.
   */
  static std::string FindRefusal(const vtkRenderState* s);

  /**
   * Finds the switches that are on without effect. ownDelegate: the user's own delegate draws the
   * opaque props.
   */
  void Update(const vtkRenderState* s, bool ownDelegate);
  const Entries& GetLeftOut() const { return this->LeftOut; }
  /** Returns true if this must be reported now: once, until it is absent from a frame. */
  bool IsNew(const std::string& what) { return this->Said.insert(what).second; }

private:
  Entries LeftOut;
  std::set<std::string> Said;
};
