// SPDX-License-Identifier: BSD-3-Clause
// Settings made by the presets of vtkRadianceHintsPass: details of the method that users rarely
// have a reason to change. Documentation/methods/radiance-hints.md tells the effect of each.
#pragma once

#include "vtkRadianceHintsPass.h" // for Of

/** The defaults are those of the preset ROBUST. */
struct vtkIndirectHintDetails
{
  // Order 3 stores 11 numbers, all of the luma and the mean of the two chroma differences; else
  // RGB, 27 numbers. Order 2 is RGB, 12 numbers.
  bool LumaChroma = true;
  // Reads every map completely, in blocks of texels; else NumberOfSamples texels, others for each
  // hint.
  bool Dense = true;
  int BlocksPerEdge = 24; // dense: along an edge of a map's face
  // Makes a sender at least as large as a share of the hint's cell, whose inside one hint does not
  // resolve, by moving the hint back from the sender's plane.
  bool Softening = true;
  // Removes the ringing of spherical harmonics from the irradiance: never negative, and for order 2
  // without loss in front of concentrated light.
  bool Deringing = true;
  // Without visibility: reduces the weight of hints behind senders.
  bool FacingWeights = true;
  // Leaves out hints far from every surface in frames that draw only polygons: glyphs, impostors,
  // lines, points and users' shaders have no known bounds.
  bool SkipEmptyCells = true;
  // Later bounces use the albedo of the surfaces around each hint; else the scene's mean.
  bool AlbedoVolume = true;
  // Later bounces come from other hints, at random (Eq. 8 to 11); else from surfaces that the
  // hint's rays meet.
  bool FromHints = false;
  int NumberOfRays = 400; // at least; an even square number
  // 1: half a cell above the surface; or 4, the paper's: one above and three at 80 degrees on a
  // hemisphere as wide as a cell's diagonal.
  int NumberOfLookups = 1;

  /** Returns the details of a pass; tests change them one by one. */
  static vtkIndirectHintDetails& Of(const vtkRadianceHintsPass* pass) { return *pass->Details; }
  /** Returns the choices of the preset PAPER. */
  static vtkIndirectHintDetails OfPaper()
  {
    vtkIndirectHintDetails details;
    details.LumaChroma = false;
    details.Dense = false;
    details.Softening = false;
    details.Deringing = false;
    details.FacingWeights = false;
    details.SkipEmptyCells = false;
    details.AlbedoVolume = false;
    details.FromHints = true;
    details.NumberOfLookups = 4;
    return details;
  }
};
