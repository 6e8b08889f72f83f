// SPDX-License-Identifier: BSD-3-Clause
// What the presets of vtkRadianceHintsPass choose: steps of the method that no user can choose
// well. Documentation/methods/radiance-hints.md has what each is worth.
#ifndef vtkIndirectHintDetails_h
#define vtkIndirectHintDetails_h

/** The defaults are those of the preset ROBUST. */
struct vtkIndirectHintDetails
{
  // How order 3 holds colours: 11 numbers, all of the luma and of the two chroma differences the
  // mean; else RGB, 27 numbers. Order 2 is RGB, 12 numbers.
  bool LumaChroma = true;
  // All of every map is read, in blocks of texels; else NumberOfSamples texels, others for each
  // hint.
  bool Dense = true;
  int BlocksPerEdge = 24; // dense: of a face of a map
  // Sampled: share of a map, about the hint's own place in it, that samples are spread over. What
  // lies outside is lost.
  double Coverage = 1.0;
  // A sender is at least as large as a share of the hint's cell: a hint stands for its cell and
  // does not resolve what is nearer. It steps back from a sender's plane instead.
  bool Softening = true;
  // The irradiance is rid of the ringing of spherical harmonics: never negative, and for order 2 as
  // bright in front of concentrated light as it should be.
  bool Deringing = true;
  // Without visibility: hints behind the surfaces that send light weigh less.
  bool FacingWeights = true;
  // Hints far from every surface are left out, in frames that show nothing but polygons: where
  // glyphs, impostors, lines, points or shaders of the user's own draw, only they know where.
  bool SkipEmptyCells = true;
  // Later bounces take the albedo of the surfaces where they happen; else the scene's mean.
  bool AlbedoVolume = true;
  // Later bounces come from other hints, at random (Eq. 8 to 11); else from what rays of the hint
  // meet.
  bool FromHints = false;
  int NumberOfRays = 400;         // at least; an even square number
  int NumberOfBounceSamples = 32; // FromHints: other hints
  // FromHints: farthest that a bounce comes from, over the scene's diagonal, the unit of stored
  // distances.
  double BounceRange = 1.0;
  // 1, half a cell above the surface, or 4, the paper's: one above and three at 80 degrees on a
  // hemisphere as wide as a cell's diagonal.
  int NumberOfLookups = 1;
  bool LookupRotation = false; // the four turn from pixel to pixel, which is noise
  // Section 8, DepthOcclusion: places on each way that are tested, and what a hidden one leaves.
  int NumberOfDepthSamples = 5;
  double DepthAttenuation = 0.6;

  /** Of the preset PAPER. */
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

#endif
