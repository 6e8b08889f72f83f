// SPDX-License-Identifier: BSD-3-Clause
// The far field: the light that splats cut off, summed at every n-th pixel, measured, and
// interpolated.
#ifndef vtkIndirectFarField_h
#define vtkIndirectFarField_h

#include "Capture/vtkIndirectReceiverGrid.h"     // for a member
#include "Frame/vtkIndirectEstimate.h"           // for the input
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectTarget.h"            // for targets

class vtkIndirectSplatTable;

class vtkIndirectFarField
{
public:
  vtkIndirectFarField();

  /**
   * Sums the far field at every step-th pixel. Within a vtkIndirectFullScreenState. Returns false,
   * after an error, if OpenGL refuses.
   */
  bool Sum(const vtkIndirectEstimateInput& input, const vtkIndirectSplatTable& table, int step);
  /** Adds the sum to `irradiance`, of the frame's size; after Sum with the same arguments. */
  bool AddTo(const vtkIndirectEstimateInput& input, const vtkIndirectSplatTable& table, int step,
    vtkIndirectTarget& irradiance);

  /**
   * Share of the last frame's irradiance that splats cut off, by luminance, over the pixels of the
   * sum; 0 without a sum. Reads the sum back, once a frame.
   */
  double FindShare() const;

  /** Releases the sum's images if no light is cut off. */
  void ReleaseSum(vtkWindow* window);
  size_t GetBytes() const { return this->Coarse.GetBytes(); }
  void Release(vtkWindow* window);

private:
  vtkIndirectReceiverGrid Coarse;
  vtkIndirectFullScreenProgram SumCoarse{ "vtkIndirectFarFieldFS.glsl" };
  vtkIndirectFullScreenProgram Interpolate{ "vtkIndirectFarFieldAddFS.glsl" };
  mutable double Share = 0.0;
  mutable bool ShareIsKnown = true;
};

#endif
