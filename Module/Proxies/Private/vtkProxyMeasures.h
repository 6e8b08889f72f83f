// SPDX-License-Identifier: BSD-3-Clause
// How well spheres stand for a surface and what it encloses.
#ifndef vtkProxyMeasures_h
#define vtkProxyMeasures_h

#include "vtkProxySolid.h" // for what is inside

/** In lengths of vtkProxySurface. Surface inside the solid is left out: nothing sees it. */
struct vtkProxyMeasures
{
  double CoveredArea = 1.0;         // share no farther than the error outside of the spheres
  double MaximumGap = 0.0;          // how far the surface is outside of the spheres, at most
  double RootMeanSquareError = 0.0; // distance of the surface to that of the spheres' union
  double MaximumProtrusion = 0.0;   // how far spheres stick out of the solid, at most
  double SolidVolume = 0.0;         // of what the surface encloses
  double CoveredVolume = 1.0;       // share of it inside of spheres
  double ProtrudingVolume = 0.0;    // of the union, outside of the solid

  void Measure(const vtkProxySurface& surface, const vtkProxySolid& solid,
    const std::vector<vtkProxySphere>& spheres, double error);
};

#endif
