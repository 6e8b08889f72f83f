// SPDX-License-Identifier: BSD-3-Clause
// Settings made by the presets of vtkMultiresolutionSplattingPass: details of the method that users
// rarely have a reason to change. Documentation/methods/multiresolution-splatting.md tells the
// effect of each.
#pragma once

#include "vtkMultiresolutionSplattingPass.h" // for Of

/** The defaults are those of the preset ROBUST. */
struct vtkIndirectSubsplatDetails
{
  int CoarsestResolution = 64; // most texels along an edge of the coarsest level
  // This is the criterion that splits a subsplat and selects neighbours for interpolation: true is
  // the paper's test by min-max pyramids (DepthThreshold, and the range of each component of the
  // normal against NormalThreshold), with its interpolation from every illuminated neighbour; false
  // tests PlaneThreshold, and the normals' distance from their mean.
  bool DepthRange = false;
  // Largest relative error of interpolating the irradiance between subsplats, estimated from its
  // variation over the coarsest level and from its curvature by the virtual light that bends it
  // most nearby. 0 skips the test.
  double LightingThreshold = 0.0015;
  bool Balance = true;          // neighbouring subsplats differ by one level at most
  bool NormalCorrection = true; // the irradiance follows the pixel's own normal to first order
  bool HalfFloats = true;       // the stored illumination has 16 bits, else 32
  // Error from virtual lights that are left out of a specular lobe, or interpolated in it, by an
  // estimate for each and for their sum: a fraction of the irradiance. Refines the list of each
  // subsplat's lights. 0, or OpenGL older than 4.3, sums all lights at every specular pixel.
  double GlossyThreshold = 0.02;

  /** Returns the details of a pass; tests change them one by one. */
  static vtkIndirectSubsplatDetails& Of(const vtkMultiresolutionSplattingPass* pass)
  {
    return *pass->Details;
  }
  /** Returns the choices of the preset PAPER: the same sums, by the fastest renderer. */
  static vtkIndirectSubsplatDetails OfPaper()
  {
    vtkIndirectSubsplatDetails details;
    details.CoarsestResolution = 16;
    details.DepthRange = true;
    details.LightingThreshold = 0.0;
    details.Balance = false;
    details.NormalCorrection = false;
    return details;
  }
};
