// SPDX-License-Identifier: BSD-3-Clause
// Emitters that light senders besides the renderer's lights: the sky in a few directions, and
// rectangles in a few pieces. Each of them is a light with a map, as the renderer's lights are. Its
// colour is VTK's colour times intensity.
#pragma once

#include "Scene/vtkIndirectFrame.h" // for lights
#include "vtkSmartPointer.h"        // for lights

#include <vector> // for lists

class vtkAreaLight;
class vtkEnvironmentLight;
class vtkIndirectSkyProjection;

namespace vtkIndirectEmitters
{
using List = std::vector<vtkIndirectLight>;

/** This is the number of groups of directions of the sky, without those of one direction. */
constexpr int NumberOfSkyGroups = 32;

/**
 * Adds the groups of directions of the sky that send light. Their directions are fixed in the
 * world, and they hold all of the sky's light. A direction with more light than a group's mean
 * share, such as a sun's, is a group of its own. Reflected light is a mean over many senders, so it
 * needs fewer directions than received light. environment: null if there is no sky.
 *   turning: directional lights that turn with the camera, if there are such. Each adds its own
 * direction, which serves one view.
 */
void AddDirections(List& emitters, vtkIndirectSkyProjection& projection,
  vtkEnvironmentLight* environment, const List& turning = {});

/**
 * Adds the same groups for all views. The three directions around a turning light get its light, so
 * that surfaces that see all three receive what the light gives them. Groups without light are
 * added, too, as they may get light in another view.
 */
void AddSteadyDirections(List& emitters, vtkIndirectSkyProjection& projection,
  vtkEnvironmentLight* environment, const List& turning);

/** Largest number of pieces of area lights: each has a map of five faces. */
constexpr size_t MostPieces = 64;

/**
 * Adds pieces of the lights that are on, which all shine into the scene: 4 x 4 of a single light, 2
 * x 2 of each if up to four lights are on or, for a single light, in haste, and else one. A piece
 * is a spot that sends by the cosine, from a place within the piece, and gives a surface the
 * irradiance of a disk of the piece's area. Pieces stay in place while an image changes. If there
 * would be more than MostPieces, pieces that are near each other and face alike are joined.
 */
void AddAreaLights(
  List& emitters, const std::vector<vtkSmartPointer<vtkAreaLight>>& lights, bool inHaste);

/**
 * Returns the VTK irradiance, of the brightest colour, of a surface at this place that would face
 * all area lights.
 */
double FindIrradiance(
  const std::vector<vtkSmartPointer<vtkAreaLight>>& lights, const double place[3]);
}
