// SPDX-License-Identifier: BSD-3-Clause
// What lights senders besides the renderer's lights: the sky in a few directions, and rectangles in
// a few pieces. Each is a light with a map, as the renderer's are.
#ifndef vtkIndirectEmitters_h
#define vtkIndirectEmitters_h

#include "Frame/vtkIndirectFrame.h" // for lights
#include "vtkSmartPointer.h"        // for lights

#include <vector> // for lists

class vtkAreaLight;
class vtkEnvironmentLight;
class vtkIndirectSkyProjection;

struct vtkIndirectEmitter
{
  /** The same of what has the same place in any frame, whatever it sends. */
  int Number = 0;
  /** Of colour one: what maps hold does not depend on how much light there is. */
  vtkIndirectLight Light;
  glm::dvec3 Strength{ 0.0 }; // VTK's colour times intensity
  size_t Pieces = 1;          // that it stands for
};

namespace vtkIndirectEmitters
{
using List = std::vector<vtkIndirectEmitter>;

/** Directions of the sky's groups (vtkIndirectSkyGroups), those that send light. */
void AddSky(List& emitters, vtkIndirectSkyProjection& projection, vtkEnvironmentLight* environment);

/** Pieces of area lights: each has a map of five faces. */
constexpr size_t MostPieces = 64;

/**
 * Pieces of area lights, 2 x 2 of each, or one where there are more than four: spots that send by
 * the cosine, of which a surface gets what it gets from a disk of the piece's area. They stay where
 * they are, also while an image changes. Where there would be more than MostPieces, those that are
 * near each other and face alike are one.
 */
void AddAreaLights(List& emitters, const std::vector<vtkSmartPointer<vtkAreaLight>>& lights);

/** VTK irradiance, of the brightest colour, of a surface there that would face all area lights. */
double FindIrradiance(
  const std::vector<vtkSmartPointer<vtkAreaLight>>& lights, const double place[3]);
}

#endif
