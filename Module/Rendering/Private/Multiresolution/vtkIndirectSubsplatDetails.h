// SPDX-License-Identifier: BSD-3-Clause
// What the presets of vtkMultiresolutionSplattingPass choose: steps of the method that no user can
// choose well. Documentation/methods/multiresolution-splatting.md has what each is worth.
#ifndef vtkIndirectSubsplatDetails_h
#define vtkIndirectSubsplatDetails_h

/** The defaults are those of the preset ROBUST. */
struct vtkIndirectSubsplatDetails
{
  enum RendererType
  {
    AUTOMATIC, // COMPUTE where there is OpenGL 4.3, the fastest wherever measured, else FRAGMENTS
    POINTS,    // the paper's: a point for each subsplat and light, added by blending; with 16-bit
               // storage its sums round at every light
    FRAGMENTS, // full-screen passes, one a level
    COMPUTE    // lists of split subsplats, four leaves at a time
  };

  // How lights are summed. All have the same leaves and, but for rounding, the same result.
  RendererType Renderer = AUTOMATIC;
  int CoarsestResolution = 64; // most texels along an edge of the coarsest level
  // What splits a subsplat, and what its neighbours must agree in: the paper's test by min-max
  // pyramids (DepthThreshold, and the range of each component of the normal against
  // NormalThreshold), with its interpolation, which takes every neighbour that has illumination;
  // else PlaneThreshold, and the normals' distance from their mean.
  bool DepthRange = false;
  // Largest error of interpolating the irradiance between subsplats, relative to it, as estimated
  // from how it varies over the coarsest level, and from how much the virtual light bends it that
  // does so most nearby. 0 does not look.
  double LightingThreshold = 0.0015;
  bool Balance = true;          // subsplats that touch differ by one level at most
  bool NormalCorrection = true; // the irradiance follows the pixel's own normal to first order
  bool HalfFloats = true;       // of the stored illumination: 16 bits, else 32
  // What virtual lights that are left out of a specular lobe, or interpolated in it, may change of
  // it, by an estimate for each and all of them together: a fraction of the irradiance. The list of
  // each subsplat's lights is refined by it. 0 sums all lights at every specular pixel, and so does
  // an OpenGL older than 4.3.
  double GlossyThreshold = 0.02;

  /** Of the preset PAPER: the same sums, by the fastest renderer. */
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

#endif
