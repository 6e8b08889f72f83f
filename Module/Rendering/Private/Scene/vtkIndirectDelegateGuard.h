// SPDX-License-Identifier: BSD-3-Clause
// Remembers a refused delegate, one whose picture gives no surfaces, until it changes. Also
// remembers whether a delegate is drawing.
#pragma once

#include "OpenGL/vtkIndirectKey.h" // for a member
#include "vtkRenderPass.h"         // for delegates

class vtkIndirectDelegateGuard
{
public:
  /** The reason why frames of a refused delegate are its picture alone. */
  static constexpr const char* Why = "the surfaces of what its delegate draws are not to be had";

  void Begin() { this->Drawing = true; }
  void End() { this->Drawing = false; }
  bool IsDrawing() const { return this->Drawing; }

  /** Refuses a delegate. Returns true if it was not refused before. */
  bool Refuse(vtkRenderPass* delegate)
  {
    return this->Refused.Take({ "delegate", delegate }) && delegate;
  }
  /**
   * Returns true if the delegate is refused. A null delegate, the default one, is never refused.
   */
  bool IsRefused(vtkRenderPass* delegate) const
  {
    return delegate && this->Refused == vtkIndirectKey("delegate", delegate);
  }

private:
  vtkIndirectKey Refused;
  bool Drawing = false;
};
