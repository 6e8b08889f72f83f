// SPDX-License-Identifier: BSD-3-Clause
// Rows of spheres in place of sticks: bonds of molecules, and the sticks of vtkOpenGLStickMapper.
//
// Touching spheres of a stick's radius have a total surface equal to the stick's mantle
// (Archimedes), so that the sums of their cross sections, averaged over directions, are equal
// (Cauchy: a fourth of the surface). For sticks so thin that there would be more than
// MostSpheresOfAStick, spheres are apart and larger, with the same sum. Ends have no lids.
//
// Segments are either occluded or not, so no sphere may extend beyond its stick, whose surface
// would lie in its own shadow: rows of INSIDE have the stick's radius, and a distance of one
// radius. A stick is then up to 13 %, on average 4 %, thinner from the side.
#pragma once

#include "vtkType.h" // for numbers

#include <functional> // for calls

class vtkDataSet;
class vtkMapper;

namespace vtkIndirectProxySticks
{
constexpr int MostSpheresOfAStick = 8;
/** This is the limit of INSIDE; longer sticks let light through between their spheres. */
constexpr int MostSpheresInsideAStick = 4096;

enum RowType
{
  AVERAGED, // match the stick's cross sections, averaged over directions
  INSIDE    // inside the stick
};

/**
 * Returns the number of spheres for a stick, and their radius; none for a stick without length or
 * radius.
 */
int FindRow(double length, double radius, double& radiusOfSpheres);
/** Returns the number of spheres of INSIDE, whose radius is the stick's. */
int FindRowInside(double length, double radius);
/** Calls with the position and the radius of each sphere of each stick in data of
 * vtkOpenGLStickMapper, and the number of the stick. */
void ForEach(vtkMapper* sticks, vtkDataSet* data, RowType type,
  const std::function<void(vtkIdType, const double[3], double)>& call);
}
