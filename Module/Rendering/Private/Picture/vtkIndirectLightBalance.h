// SPDX-License-Identifier: BSD-3-Clause
// The balance of two lights in a picture: a preset's own light in place of a share of the
// renderer's lamps, which nothing hides.
//
// The more is replaced, the more shape the picture shows. The balance is measured in the frame, so
// that the picture is as bright as plain VTK's, and no channel clips that plain VTK does not clip.
// Sums over the whole picture change smoothly with the camera.
#pragma once

#include <vector> // for blocks of pixels

struct vtkIndirectLightBalance
{
  double Replaced = 0.0; // share of the lamps' diffuse light
  double Strength = 1.0; // factor of the own light

  /**
   * This is a block of pixels: sums of the mean of red, green and blue over its pixels that VTK
   * does not draw black. Without such pixels it does not count.
   */
  struct Block
  {
    double Plain = 0.0; // all of VTK's shading, at most 1 a channel
    double Lamps = 0.0; // its part that lamps light diffusely
    double Own = 0.0;   // the own light of strength 1, as surfaces reflect it
    // The greatest strengths with which no channel of a pixel exceeds 1, or plain VTK's value if
    // that is more, where none and where all of the lamps' light is replaced.
    double Room[2] = { Unbounded, Unbounded };
  };
  static constexpr double Unbounded = 1e3;

  /** Finds the balance that replaces most, at most the share `most`. */
  static vtkIndirectLightBalance Find(const std::vector<Block>& blocks, double most);
};
