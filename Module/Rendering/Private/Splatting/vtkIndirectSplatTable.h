// SPDX-License-Identifier: BSD-3-Clause
// The ellipsoids outside of which virtual lights and their lobes do not count, beside the table of
// the lights.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectResource.h"          // for the base class
#include "OpenGL/vtkIndirectTarget.h"            // for members
#include "Plan/vtkIndirectEstimate.h"            // for the input
#include "vtkType.h"                             // for the time

#include <string> // for definitions

class vtkIndirectSplatTable : public vtkIndirectResource
{
public:
  explicit vtkIndirectSplatTable(vtkIndirectResource* owner);

  /**
   * Updates the ellipsoids. threshold: IntensityThreshold; fades: there is a far field. Returns
   * false, after an error, if OpenGL refuses.
   */
  bool Update(const vtkIndirectEstimateInput& input, double threshold, bool fades);

  /** Binds the textures of vtkIndirectSplatLight.glsl and vtkIndirectSplatBounds.glsl. */
  void Activate(const vtkIndirectProgram& program) const;

  /** Binds these and the inputs of a sum at receivers: eye, surfaces, lights and their lobes,
   * visibility. */
  void Activate(const vtkIndirectEstimateInput& input, const vtkIndirectProgram& program) const;

  /** Definitions for shaders that read the table: lights have lobes, splats fade. */
  std::string GetDefinitions(bool lobes) const;

  /** Returns the centre and half length, axis and half width; also of lobes if lights have them. */
  const vtkIndirectTarget& GetBounds() const { return this->Bounds; }

protected:
  void ReleaseOwn(vtkWindow*) override { this->NumberOfLights = -1; }

private:
  bool Draw(const vtkIndirectEstimateInput& input);

  vtkIndirectTarget Columns;
  vtkIndirectTarget Mean;
  vtkIndirectTarget Bounds;
  vtkIndirectFullScreenProgram SumColumns{ this, "vtkIndirectSplatMeanFS.glsl" };
  vtkIndirectFullScreenProgram SumAll{ this, "vtkIndirectSplatMeanFS.glsl" };
  vtkIndirectFullScreenProgram MakeBounds{ this, "vtkIndirectSplatTableFS.glsl" };
  // Inputs of the current table.
  vtkMTimeType ContentTime = 0;
  int NumberOfLights = -1;
  double Threshold = 0.0;
  bool Fades = false;
  bool Lobes = false;
};
