// SPDX-License-Identifier: BSD-3-Clause
// Irradiance that comes directly from area lights in moving frames: in closed form, and images by
// their descent, at every eighth pixel of every eighth row, and wherever surfaces or light are not
// even between these. What hides the light, 16 points of each lamp tell, which four pixels of a
// block of 4 x 4 ask between them.
//
// What it ignores: edges of shadows finer than four pixels; steps between the 16 points.
#ifndef vtkIndirectAreaSamples_h
#define vtkIndirectAreaSamples_h

#include "Gather/vtkIndirectAreaBlock.h"         // for a member
#include "Gather/vtkIndirectAreaLamps.h"         // for lamps
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectTarget.h"            // for members

#include <string> // for definitions

class vtkIndirectAreaMaps;
class vtkIndirectGeometryBuffer;
class vtkShaderProgram;

class vtkIndirectAreaSamples
{
public:
  vtkIndirectAreaSamples();

  /** Points of a lamp that are asked. */
  static constexpr int NumberOfPoints = 16;
  ///@{
  /** Distances in moving frames, and in those that stand still. */
  static constexpr int DistancesOfMoving = 14;
  static constexpr int DistancesOfStill = 28;
  ///@}

  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectGeometryBuffer& Geometry;
    const vtkIndirectAreaLamps& Lamps;
    const vtkIndirectAreaMaps* Maps; // null where nothing hides lamps
    double Tolerance;                // of the mean of an image
    int Distances;                   // from which on light is interpolated, over those of samples
  };

  /**
   * Adds to a target of the frame's size that is clear, with blending functions of one and one, in
   * a vtkIndirectFullScreenState. Returns false, after an error.
   */
  bool Sum(const Input& input, vtkIndirectTarget& irradiance);

  size_t GetBytes() const;
  void Release(vtkWindow* window);

private:
  // Lamps of a draw.
  struct Batch
  {
    size_t First;
    size_t Count;
    int Images;
  };

  bool Resize(const Input& input);
  std::string GetDefinitions(const Input& input, const Batch& batch) const;
  vtkShaderProgram* Use(
    const Input& input, const Batch& batch, vtkIndirectFullScreenProgram& kernel);
  void Deactivate(const Input& input, const Batch& batch);
  bool FindOpen(const Input& input, const Batch& batch);
  bool FindSamples(const Input& input, const Batch& batch);
  bool Interpolate(const Input& input, const Batch& batch, vtkIndirectTarget& irradiance);

  vtkIndirectAreaBlock Block;
  vtkIndirectTarget Open;
  vtkIndirectTarget Samples;
  vtkIndirectFullScreenProgram OpenKernel{ "vtkIndirectAreaOpenFS.glsl" };
  vtkIndirectFullScreenProgram SampleKernel{ "vtkIndirectAreaSamplesFS.glsl" };
  vtkIndirectFullScreenProgram SumKernel{ "vtkIndirectAreaSumFS.glsl" };
};

#endif
