// SPDX-License-Identifier: BSD-3-Clause
// The irradiance that comes directly from area lights. It is the unoccluded irradiance in closed
// form (for images: over texels of a pyramid, as fine as the tolerance requires), times the visible
// share of the light. This share is a ratio of two sums over points of the light, each with a depth
// map of its own: for a fully visible light it is one, without noise. Still frames sum at every
// pixel (vtkIndirectAreaRounds), moving ones at samples (vtkIndirectAreaSamples).
#pragma once

#include "Area/vtkIndirectAreaBlock.h"           // for a member
#include "Area/vtkIndirectAreaLamps.h"           // for a member
#include "Area/vtkIndirectAreaLobes.h"           // for a member
#include "Area/vtkIndirectAreaMaps.h"            // for a member
#include "Area/vtkIndirectAreaRounds.h"          // for a member
#include "Area/vtkIndirectAreaSamples.h"         // for a member
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectTarget.h"            // for members
#include "Sums/vtkIndirectFrameLight.h"          // for the base class

class vtkIndirectAreaGather : public vtkIndirectFrameLight
{
public:
  vtkIndirectAreaGather(vtkIndirectResource* owner, vtkIndirectDepthMaps& maps);

  void AppendTo(vtkIndirectKey& key, const Input& input) const override;
  bool Update(const Input& input) override;
  bool IsComplete() const override { return !this->Visible || this->Maps.IsComplete(); }
  int GetNumberOfTilesLeft() const override;
  /** Sums the light. Further rounds of points of each light refine a still result. */
  vtkIndirectEstimate MakeEstimate(const Input& input) override;
  void AddToReport(vtkIndirectReport& report) const override;

private:
  bool IsFinished() const;
  bool SumAll(const Input& input);
  double GetTolerance(const Input& input) const;
  bool SumIrradiance(const Input& input);
  bool SumLobes(const Input& input);
  bool SumRounds(const Input& input);
  bool SumOpen(const Input& input, vtkIndirectTarget& target);
  bool SumMoving(const Input& input);
  const vtkIndirectTarget* FindOpen() const;

  vtkIndirectAreaLamps Lamps{ this };
  vtkIndirectAreaMaps Maps; // maps of the first round
  bool Visible = false;     // something can hide the lamps
  bool Moving = false;
  vtkIndirectFullScreenProgram Kernel{ this,
    "vtkIndirectAreaFS.glsl" };                // for lamps of one radiance
  vtkIndirectAreaBlock Block{ this, 1, 1 };    // a lamp for the kernel
  vtkIndirectAreaSamples Samples{ this };      // for moving frames
  vtkIndirectAreaSamples StillSamples{ this }; // for images, in still frames
  vtkIndirectAreaRounds Rounds;
  vtkIndirectAreaLobes Lobes{ this };
  bool Specular = false; // some receivers are specular
  vtkIndirectTarget Irradiance;
  vtkIndirectAreaSamples OpenSamples{ this }; // for surfaces that catch light, in moving frames
  vtkIndirectTarget Open;                     // the light if nothing hid it, in these frames
};
