// SPDX-License-Identifier: BSD-3-Clause
// The visible share of area lights in still frames: a ratio of two sums over points of the lights,
// each with a depth map of its own. The points of the first round are those of moving frames.
// Further frames of the same view add further rounds, whose maps are not kept.
#pragma once

#include "Area/vtkIndirectAreaBlock.h"           // for a member
#include "Area/vtkIndirectAreaMaps.h"            // for a member
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectResource.h"          // for the base class
#include "OpenGL/vtkIndirectTarget.h"            // for members

class vtkIndirectGeometryBuffer;
struct vtkIndirectFrame;

class vtkIndirectAreaRounds : public vtkIndirectResource
{
public:
  vtkIndirectAreaRounds(vtkIndirectResource* owner, vtkIndirectDepthMaps& maps);

  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectGeometryBuffer& Geometry;
    const vtkIndirectAreaLamps& Lamps;
    const vtkIndirectAreaMaps& First; // maps of the first round
  };

  /**
   * Creates the targets of Sum and Multiply. Returns false, after an error, when OpenGL refuses.
   */
  bool Resize(const vtkIndirectFrame& frame);
  /** Returns the target for the lights' unoccluded irradiance. */
  vtkIndirectTarget& GetOpen() { return this->Open; }
  const vtkIndirectTarget& GetOpen() const { return this->Open; }

  /** Sums the first round. Returns false, after an error. */
  bool Begin(const Input& input);
  /** Asks for the maps of the next round. */
  void RequestNext(const vtkIndirectFrame& frame, const vtkIndirectAreaLamps& lamps)
  {
    this->Maps.Update(frame, lamps, this->Rounds);
  }
  /** Sums that round when all its maps are present. */
  bool Continue(const Input& input);
  /** Multiplies the unoccluded irradiance by the visible share, in a vtkIndirectFullScreenState. */
  bool Multiply(const vtkIndirectFrame& frame, vtkIndirectTarget& irradiance);

  /** Returns the number of rounds that are summed. */
  int GetNumberOfRounds() const { return this->Rounds; }
  bool IsFinished() const { return this->Rounds >= vtkIndirectAreaLamps::NumberOfRounds; }

protected:
  void ReleaseOwn(vtkWindow*) override { this->Rounds = 0; }

private:
  bool Add(const Input& input, const vtkIndirectAreaMaps& maps);

  int Rounds = 0;
  vtkIndirectAreaMaps Maps; // maps of the next round
  vtkIndirectAreaBlock Block;
  vtkIndirectTarget Open;
  vtkIndirectTarget Sums;
  vtkIndirectFullScreenProgram ShareKernel{ this, "vtkIndirectAreaShareFS.glsl" };
  vtkIndirectFullScreenProgram ProductKernel{ this, "vtkIndirectAreaProductFS.glsl" };
};
