// SPDX-License-Identifier: BSD-3-Clause
// Smooths the visible share of the sky over neighbours on the surface, and makes it irradiance; see
// vtkIndirectSkySmoothFS.glsl.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for a member
#include "OpenGL/vtkIndirectTarget.h"            // for a member

#include <functional> // for uniforms

struct vtkIndirectFrame;
class vtkIndirectGeometryBuffer;
class vtkIndirectSkyReprojection;

class vtkIndirectSkySmoothing : public vtkIndirectResource
{
public:
  using SetUniforms = std::function<void(const vtkIndirectProgram&)>;

  explicit vtkIndirectSkySmoothing(vtkIndirectResource* owner);

  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectGeometryBuffer& Geometry;
    double PartAngle; // between the middle and the rim of a direction's part of the sky
    bool Visibility;  // false: nothing hides the sky, and nothing is smoothed
    bool Moving;      // fewer neighbours are asked
    vtkIndirectSkyReprojection* Kept; // has the shares, and gets their means; may be null
    bool LeavesMeans;                 // the target of the shares is to hold their means afterwards
  };

  /** Angle of the smoothing over that of a direction's part of the sky. */
  static constexpr double Parts = 1.5;

  /** depth: the target whose depth tells where shares are drawn. */
  bool Resize(const vtkIndirectFrame& frame, const vtkIndirectTarget& depth);
  /** Target of the shares, which the caller fills before Run; unless they are kept. */
  vtkIndirectTarget& GetShares() { return this->Shares[0]; }
  const vtkIndirectTarget& GetShares() const { return this->Shares[0]; }
  /** Writes irradiance; setLast sets the uniforms that turn a share into it. */
  bool Run(const Input& input, vtkIndirectTarget& irradiance, const SetUniforms& setLast);

private:
  struct Pass
  {
    int Neighbors;            // to either side
    float Scale;              // radius over that of the shares
    SetUniforms SetLast = {}; // set for the pass that makes shares irradiance
  };
  struct Kernels
  {
    vtkIndirectFullScreenProgram Rows;
    vtkIndirectFullScreenProgram Columns;
  };
  bool Draw(const Input& input, const Pass& pass, vtkIndirectFullScreenProgram& kernel,
    const vtkIndirectTarget& from, vtkIndirectTarget& to);

  vtkIndirectTarget Shares[2]; // visible shares of the sky, and their means
  Kernels OwnKernels{ { this, "vtkIndirectSkySmoothFS.glsl" },
    { this, "vtkIndirectSkySmoothFS.glsl" } };
  Kernels KeptKernels{ { this, "vtkIndirectSkySmoothFS.glsl" },
    { this, "vtkIndirectSkySmoothFS.glsl" } };
  vtkIndirectFullScreenProgram Last{ this, "vtkIndirectSkySmoothFS.glsl" }; // to irradiance
};
