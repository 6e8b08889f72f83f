// SPDX-License-Identifier: BSD-3-Clause
// The ellipsoids outside of which virtual lights and their lobes do not count, beside the table of
// the lights.
#ifndef vtkIndirectSplatTable_h
#define vtkIndirectSplatTable_h

#include "Frame/vtkIndirectEstimate.h"           // for the input
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectTarget.h"            // for members
#include "vtkType.h"                             // for the time

#include <string> // for definitions

class vtkIndirectSplatTable
{
public:
  vtkIndirectSplatTable();

  /**
   * Brings it up to date; threshold: IntensityThreshold; fades: there is a
   * far field. Returns false, after an error, when OpenGL
   * refuses.
   */
  bool Update(const vtkIndirectEstimateInput& input, double threshold, bool fades);

  ///@{
  /** Bind what vtkIndirectSplatLight.glsl and vtkIndirectSplatBounds.glsl read; pair. */
  void Activate(vtkShaderProgram* program) const;
  void Deactivate() const;
  ///@}

  ///@{
  /** Bind these and what a sum over them at receivers reads besides: eye, surfaces, lights and
   * their lobes, visibility; pair. */
  void Activate(const vtkIndirectEstimateInput& input, vtkShaderProgram* program) const;
  void Deactivate(const vtkIndirectEstimateInput& input) const;
  ///@}

  /** Lines that what reads it begins with: whether lights have lobes, and splats fade. */
  std::string GetDefinitions(bool lobes) const;

  /** Centre and half length, axis and half width, as shaders read them; where lights have lobes
   * theirs, too. */
  const vtkIndirectTarget& GetBounds() const { return this->Bounds; }

  size_t GetBytes() const;
  void Release(vtkWindow* window);

private:
  bool Draw(const vtkIndirectEstimateInput& input);

  vtkIndirectTarget Columns;
  vtkIndirectTarget Mean;
  vtkIndirectTarget Bounds;
  vtkIndirectFullScreenProgram SumColumns{ "vtkIndirectSplatMeanFS.glsl" };
  vtkIndirectFullScreenProgram SumAll{ "vtkIndirectSplatMeanFS.glsl" };
  vtkIndirectFullScreenProgram MakeBounds{ "vtkIndirectSplatTableFS.glsl" };
  // What it was made of.
  vtkMTimeType ContentTime = 0;
  int NumberOfLights = -1;
  double Threshold = 0.0;
  bool Fades = false;
  bool Lobes = false;
};

#endif
