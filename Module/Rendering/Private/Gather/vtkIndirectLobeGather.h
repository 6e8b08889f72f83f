// SPDX-License-Identifier: BSD-3-Clause
// Adds the light of virtual lights' specular lobes to an estimator's result for their diffuse
// light: at every pixel, or interpolated between samples where interpolation changes little. A
// narrow lobe is summed at every pixel that it may reach, however coarse the diffuse light is.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectResource.h"          // for the base class
#include "OpenGL/vtkIndirectTarget.h"            // for targets
#include "Plan/vtkIndirectEstimate.h"            // for the input
#include "Sums/vtkIndirectReceiverGrid.h"        // for a member

#include <string> // for definitions

class vtkIndirectLobeGather : public vtkIndirectResource
{
public:
  explicit vtkIndirectLobeGather(vtkIndirectResource* owner);

  /** The targets of sums: images of the frame's size, where a value of one means `Unit`. */
  struct Output
  {
    vtkIndirectTarget& Irradiance;
    vtkIndirectTarget* Glossy; // null where no receiver is specular
    double Unit;
    bool HasOwn = false; // pixels of depth 0 in Irradiance have the light of lobes already
  };

  /**
   * Adds the lobes of the frame's lights, if these have any. step: pixels between samples, 1: no
   * pixel is interpolated; tolerance: error of interpolation, over the light of the pixel. Must be
   * called within a vtkIndirectFullScreenState. Returns false, after an error, when OpenGL refuses.
   */
  bool Add(const vtkIndirectEstimateInput& input, const Output& output, int step, double tolerance);

  /**
   * Adds the lobes only to the reflections of specular receivers, whose unit is one: for estimators
   * that sum the irradiance of lobes themselves. Otherwise as Add.
   */
  bool AddToGlossy(const vtkIndirectEstimateInput& input, vtkIndirectTarget& glossy);

private:
  static int FindRowsPerDraw(const vtkIndirectEstimateInput& input);
  bool Draw(const vtkIndirectEstimateInput& input, vtkIndirectFullScreenProgram& kernel,
    const std::string& definitions, vtkIndirectTarget& target, double unit, int step,
    double tolerance, int rowsPerDraw);

  vtkIndirectReceiverGrid Coarse;
  vtkIndirectFullScreenProgram AtSamples{ this, "vtkIndirectLobeFS.glsl" };
  vtkIndirectFullScreenProgram AtPixels{ this, "vtkIndirectLobeFS.glsl" };
  vtkIndirectFullScreenProgram InGlossy{ this, "vtkIndirectLobeFS.glsl" };
};
