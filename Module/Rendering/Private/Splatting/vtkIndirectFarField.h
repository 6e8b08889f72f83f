// SPDX-License-Identifier: BSD-3-Clause
// The far field: the light that splats cut off, summed at every n-th pixel, measured, and
// interpolated.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectResource.h"          // for the base class
#include "OpenGL/vtkIndirectTarget.h"            // for targets
#include "Plan/vtkIndirectEstimate.h"            // for the input
#include "Sums/vtkIndirectReceiverGrid.h"        // for a member

class vtkIndirectSplatTable;

class vtkIndirectFarField : public vtkIndirectResource
{
public:
  explicit vtkIndirectFarField(vtkIndirectResource* owner);

  /**
   * Sums the far field at every step-th pixel. Within a vtkIndirectFullScreenState. Returns false,
   * after an error, if OpenGL refuses.
   */
  bool Sum(const vtkIndirectEstimateInput& input, const vtkIndirectSplatTable& table, int step);
  /** Adds the sum to `irradiance`, of the frame's size; after Sum with the same arguments. */
  bool AddTo(const vtkIndirectEstimateInput& input, const vtkIndirectSplatTable& table, int step,
    vtkIndirectTarget& irradiance);

  /**
   * Returns the share of the last frame's irradiance that splats cut off, by luminance, over the
   * pixels of the sum; 0 without a sum. Reads the sum back, once a frame.
   */
  double FindShare() const;

protected:
  void ReleaseOwn(vtkWindow*) override
  {
    this->Share = 0.0;
    this->ShareIsKnown = true;
  }

private:
  vtkIndirectReceiverGrid Coarse;
  vtkIndirectFullScreenProgram SumCoarse{ this, "vtkIndirectFarFieldFS.glsl" };
  vtkIndirectFullScreenProgram Interpolate{ this, "vtkIndirectFarFieldAddFS.glsl" };
  mutable double Share = 0.0;
  mutable bool ShareIsKnown = true;
};
