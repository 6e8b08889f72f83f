// SPDX-License-Identifier: BSD-3-Clause
// Rows of spheres in place of sticks: bonds of molecules, and what vtkOpenGLStickMapper draws.
//
// Spheres of a stick's radius that touch each other have the stick's mantle for their surface
// (Archimedes), so that their cross sections, meaned over directions, are together the stick's
// (Cauchy: a fourth of the surface). Of sticks so thin that this would be more than
// MostSpheresOfAStick, spheres are apart and larger, with the same sum. Ends have no lids.
//
// For segments, which are hidden or not, no sphere may stick out of its stick, whose surface would
// else be in its own shadow: rows of INSIDE have the stick's radius, and a radius from one to the
// next. A stick is then up to 13 %, in the mean 4 %, thinner from the side.
#ifndef vtkIndirectProxySticks_h
#define vtkIndirectProxySticks_h

#include "vtkType.h" // for numbers

#include <functional> // for calls

class vtkDataSet;
class vtkMapper;

namespace vtkIndirectProxySticks
{
constexpr int MostSpheresOfAStick = 8;
/** Of INSIDE; longer ones are let through between their spheres. */
constexpr int MostSpheresInsideAStick = 4096;

enum RowType
{
  AVERAGED, // the stick's cross sections, meaned over directions
  INSIDE    // of the stick
};

/** The mapper of a molecule's bonds; null for any other mapper. */
vtkMapper* FindBonds(vtkMapper* molecule);
/** Spheres of a stick: how many, and their radius; none of a stick without length or radius. */
int FindRow(double length, double radius, double& radiusOfSpheres);
/** The same of INSIDE, whose radius is the stick's. */
int FindRowInside(double length, double radius);
/** Calls with the place and the radius of each sphere of each stick of data that
 * vtkOpenGLStickMapper draws, and the number of the stick. */
void ForEach(vtkMapper* sticks, vtkDataSet* data, RowType type,
  const std::function<void(vtkIdType, const double[3], double)>& call);
}
#endif
