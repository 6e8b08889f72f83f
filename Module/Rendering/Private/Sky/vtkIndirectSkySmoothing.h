// SPDX-License-Identifier: BSD-3-Clause
// Smooths the visible share of the sky over neighbours on the surface, and makes it irradiance; see
// vtkIndirectSkySmoothFS.glsl.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for a member
#include "OpenGL/vtkIndirectTarget.h"            // for a member

#include <functional> // for uniforms

struct vtkIndirectFrame;
class vtkIndirectGeometryBuffer;

class vtkIndirectSkySmoothing : public vtkIndirectResource
{
public:
  explicit vtkIndirectSkySmoothing(vtkIndirectResource* owner);

  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectGeometryBuffer& Geometry;
    double PartAngle; // between the middle and the rim of a direction's part of the sky
    bool Visibility;  // false: nothing hides the sky, and nothing is smoothed
    bool Moving;      // fewer neighbours are asked
  };

  /** Angle of the smoothing over that of a direction's part of the sky. */
  static constexpr double Parts = 1.5;

  bool Resize(const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry);
  /** Target of the shares, which the caller fills before Run. */
  vtkIndirectTarget& GetShares() { return this->Shares[0]; }
  /** Writes irradiance; setLast sets the uniforms that turn a share into it. */
  bool Run(const Input& input, vtkIndirectTarget& irradiance,
    const std::function<void(const vtkIndirectProgram&)>& setLast);

private:
  vtkIndirectTarget Shares[2]; // visible shares of the sky, and their means
  // along rows, along columns, and along columns to irradiance
  vtkIndirectFullScreenProgram Rows{ this, "vtkIndirectSkySmoothFS.glsl" };
  vtkIndirectFullScreenProgram Columns{ this, "vtkIndirectSkySmoothFS.glsl" };
  vtkIndirectFullScreenProgram Last{ this, "vtkIndirectSkySmoothFS.glsl" };
};
