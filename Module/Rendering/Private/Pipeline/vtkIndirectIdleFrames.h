// SPDX-License-Identifier: BSD-3-Clause
// Frames of a window that nobody touches: while its picture lacks depth maps or a refinement, a
// timer of the interactor draws the next frame. Each frame is an event of its own, so that input
// comes in between.
#pragma once

#include "vtkCallbackCommand.h"        // for a member
#include "vtkNew.h"                    // for a member
#include "vtkRenderWindowInteractor.h" // for a member
#include "vtkWeakPointer.h"            // for a member

#include <vector> // for a list

class vtkRenderWindow;

class vtkIndirectIdleFrames
{
public:
  vtkIndirectIdleFrames();
  ~vtkIndirectIdleFrames();
  vtkIndirectIdleFrames(const vtkIndirectIdleFrames&) = delete;
  void operator=(const vtkIndirectIdleFrames&) = delete;

  /** Returns true if the window has an interactor that handles events. */
  static bool CanFollow(vtkRenderWindow* window);
  /**
   * Ends a frame of a window. left: the work that further frames have. There is a next frame if a
   * timer can be had, and, after a frame of the timer, if that frame has done something.
   */
  void EndFrame(vtkRenderWindow* window, long long left);
  /** Returns true if the timer draws the frame. */
  bool IsOwnFrame() const { return this->IsOwn; }
  /** Lets timers that are still to fire draw nothing. */
  void Stop();

private:
  static void OnTimer(vtkObject* caller, unsigned long event, void* self, void* data);

  vtkNew<vtkCallbackCommand> Command;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor; // that has the timer
  int Timer = 0;                                        // of the next frame; 0: none
  std::vector<int> Timers;                              // that the interactor has
  unsigned long Tag = 0;
  bool IsOwn = false; // the timer draws the frame
  long long Left = 0; // after the last frame
};
