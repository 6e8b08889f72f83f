// SPDX-License-Identifier: BSD-3-Clause
// Spheres and sticks that VTK's shaders draw at points. Bounds of VTK's mappers hold the points
// alone, so what is drawn reaches beyond them.
#pragma once

class vtkDataArray;
class vtkDataSet;
class vtkMapper;
class vtkProp;

namespace vtkIndirectImpostors
{
/** Returns the array of radii of a vtkOpenGLSphereMapper; null if all have its Radius. */
vtkDataArray* FindRadii(vtkMapper* mapper, vtkDataSet* data);

/**
 * Returns the array of a vtkOpenGLStickMapper with length and radius, and that with directions;
 * null for other mappers and arrays.
 */
vtkDataArray* FindStickScales(vtkMapper* mapper, vtkDataSet* data);
vtkDataArray* FindStickDirections(vtkMapper* mapper, vtkDataSet* data);

/** Returns how far spheres and sticks of a prop reach from their points, in world units. */
double FindReach(vtkProp* prop);
}
