// SPDX-License-Identifier: BSD-3-Clause
// Buffers of a frame, read back; their errors against a reference; pictures of them.
#ifndef CardImages_h
#define CardImages_h

#include "CardScene.h" // for Image

#include <array>  // for places
#include <string> // for names
#include <vector> // for places

class vtkIndirectIlluminationPass;

namespace card
{
/** A buffer of the last frame. Throws std::runtime_error where there is none of that name. */
Image CopyBuffer(vtkIndirectIlluminationPass* pass, const std::string& name);

/** Red, green, blue of the window, 0 to 1. */
Image CopyWindow(Scene& scene);

/**
 * Places spread over an image, the same for the same size everywhere: one in each cell of a grid of
 * at most 64 x 36, at a pixel of it that a hash chooses.
 */
std::vector<std::array<int, 2>> MakePlaces(int width, int height);

/** Errors of irradiance against one reference, as `vtk-indirect compare` defines them. */
struct Errors
{
  double RootMeanSquare = 0.0; // over the reference's mean
  double Relative = 0.0;       // relMSE
  double Bias = 0.0;           // over the reference's mean
  long Receivers = 0;
};

/**
 * The image at the points of the reference's pixels, interpolated between the four pixels about
 * each where no pixel coincides. Both see along the same axis with the same vertical angle; what
 * the image does not show does not count.
 */
Errors Compare(const Image& image, const Image& reference, const Image& mask);

/**
 * A PNG file, 32 to 960 pixels wide: the image, values from 0 to `white` as 0 to 255 (gamma 2.2),
 * with red crosses at the places. Returns false when it cannot be written.
 */
bool WritePicture(const std::string& path, const Image& image, double white,
  const std::vector<std::array<int, 2>>& crosses);
}

#endif
