// SPDX-License-Identifier: BSD-3-Clause
// The share of area lights that is seen, in frames that stand still: a ratio of two sums over
// points of the lights, each with a depth map of its own. The first round's points are those of
// moving frames; further frames of the same view add further rounds, whose maps are not kept.
#ifndef vtkIndirectAreaRounds_h
#define vtkIndirectAreaRounds_h

#include "Gather/vtkIndirectAreaBlock.h"         // for a member
#include "Gather/vtkIndirectAreaMaps.h"          // for a member
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectTarget.h"            // for members

class vtkIndirectGeometryBuffer;
class vtkSurfaceCapturePass;
class vtkWindow;
struct vtkIndirectFrame;

class vtkIndirectAreaRounds
{
public:
  vtkIndirectAreaRounds();

  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectGeometryBuffer& Geometry;
    vtkSurfaceCapturePass* Capture;
    const vtkIndirectAreaLamps& Lamps;
    const vtkIndirectAreaMaps& First; // of the first round
    bool Caching;
  };

  /** Creates what Sum and Multiply need. Returns false, after an error, when OpenGL refuses. */
  bool Resize(const vtkIndirectFrame& frame);
  /** What lights give if nothing hid them is drawn here. */
  vtkIndirectTarget& GetOpen() { return this->Open; }

  /** Sums the first round. Returns false, after an error. */
  bool Begin(const Input& input);
  /** Draws maps of the next round, at most so many, and sums it when all are there. */
  bool Continue(const Input& input, int most);
  /** Multiplies what lights give by the share that is seen, in a vtkIndirectFullScreenState. */
  bool Multiply(const vtkIndirectFrame& frame, vtkIndirectTarget& irradiance);

  /** How many rounds are there. */
  int GetNumberOfRounds() const { return this->Rounds; }
  bool IsFinished() const { return this->Rounds >= vtkIndirectAreaLamps::NumberOfRounds; }

  size_t GetNumberOfTilesDrawn() const { return this->Maps.GetAtlas().GetNumberOfTilesDrawn(); }
  size_t GetBytes() const;
  void Release(vtkWindow* window);

private:
  bool Add(const Input& input, const vtkIndirectAreaMaps& maps);

  int Rounds = 0;
  vtkIndirectAreaMaps Maps; // of the next round
  vtkIndirectAreaBlock Block;
  vtkIndirectTarget Open;
  vtkIndirectTarget Sums;
  vtkIndirectFullScreenProgram ShareKernel{ "vtkIndirectAreaShareFS.glsl" };
  vtkIndirectFullScreenProgram ProductKernel{ "vtkIndirectAreaProductFS.glsl" };
};

#endif
