// SPDX-License-Identifier: BSD-3-Clause
// What the specular lobes of virtual lights give receivers, added to what an estimator has made of
// their diffuse light: at every pixel, or interpolated from every few where that changes little. A
// narrow lobe is summed at every pixel that it may reach, however coarse the diffuse light is.
#ifndef vtkIndirectLobeGather_h
#define vtkIndirectLobeGather_h

#include "Frame/vtkIndirectEstimate.h"           // for the input
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectTarget.h"            // for a member

#include <string> // for definitions

class vtkIndirectLobeGather
{
public:
  vtkIndirectLobeGather();

  /** Where sums go: images of the frame's size, in which one stands for `Unit`. */
  struct Output
  {
    vtkIndirectTarget& Irradiance;
    vtkIndirectTarget* Glossy; // null where no receiver is specular
    double Unit;
  };

  /**
   * Adds the lobes of the frame's lights, where these have any. step: pixels between samples, 1:
   * none is interpolated; tolerance: of interpolation, over the light there. Within a
   * vtkIndirectFullScreenState, and a scope of the blending's function. Returns false, after an
   * error, when OpenGL refuses.
   */
  bool Add(const vtkIndirectEstimateInput& input, const Output& output, int step, double tolerance);

  /**
   * Adds them to what specular receivers reflect alone, whose unit is one: for estimators that sum
   * the irradiance of lobes themselves. Otherwise as Add.
   */
  bool AddToGlossy(const vtkIndirectEstimateInput& input, vtkIndirectTarget& glossy);

  size_t GetBytes() const { return this->Coarse.GetBytes(); }
  void Release(vtkWindow* window);

private:
  static int FindRowsPerDraw(const vtkIndirectEstimateInput& input);
  bool Draw(const vtkIndirectEstimateInput& input, vtkIndirectFullScreenProgram& kernel,
    const std::string& definitions, vtkIndirectTarget& target, double unit, int step,
    double tolerance, int rowsPerDraw);

  vtkIndirectTarget Coarse;
  vtkIndirectFullScreenProgram AtSamples{ "vtkIndirectLobeFS.glsl" };
  vtkIndirectFullScreenProgram AtPixels{ "vtkIndirectLobeFS.glsl" };
  vtkIndirectFullScreenProgram InGlossy{ "vtkIndirectLobeFS.glsl" };
};

#endif
