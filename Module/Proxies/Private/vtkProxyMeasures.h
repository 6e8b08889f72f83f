// SPDX-License-Identifier: BSD-3-Clause
// Measures how well spheres approximate a surface and its interior.
#pragma once

#include "vtkProxySolid.h" // for the interior

/** In lengths of vtkProxySurface. Surface inside the solid is left out, because it is invisible. */
struct vtkProxyMeasures
{
  double CoveredArea = 1.0;         // share within the error outside of the spheres
  double MaximumGap = 0.0;          // largest distance of the surface outside of the spheres
  double RootMeanSquareError = 0.0; // between the surface and that of the spheres' union
  double MaximumProtrusion = 0.0;   // largest extent of spheres beyond the solid
  double SolidVolume = 0.0;         // volume of the surface's interior
  double CoveredVolume = 1.0;       // share of that volume inside of spheres
  double ProtrudingVolume = 0.0;    // volume of the union outside of the solid

  void Measure(const vtkProxySurface& surface, const vtkProxySolid& solid,
    const std::vector<vtkProxySphere>& spheres, double error);
};
