// SPDX-License-Identifier: BSD-3-Clause
// Random scenes under random cameras, from fixed seeds, and comparisons of multiresolution
// splatting with the gather of the same lights.
#ifndef vtkIndirectRandomFrame_h
#define vtkIndirectRandomFrame_h

#include "vtkIndirectTestUtilities.h"
#include "vtkMultiresolutionSplattingPass.h" // for members

#include <string> // for names
#include <vector> // for sizes

namespace vtkIndirectTest
{
/** Width and height: odd, prime, one pixel, a line, and common ones. */
struct FrameSize
{
  int Width;
  int Height;
};
const std::vector<FrameSize>& GetFrameSizes();

/** The light of a frame. HEADLIGHT: of the camera, which has no map. */
enum class FrameLight
{
  SPOT,
  POINT,
  DIRECTIONAL,
  SEVERAL,
  HEADLIGHT
};
constexpr int NumberOfFrameLights = 5;

/** A scene with the splatting, and a gather over the same lights for comparison. */
struct MultiresolutionScene : Scene
{
  MultiresolutionScene(int width, int height);

  vtkNew<vtkMultiresolutionSplattingPass> Splatting;

  /** Irradiance by the splatting, or by the gather at every pixel. */
  Image Splat();
  Image GatherAll();
  /** Both thresholds of the geometry and that of the lighting, times a factor of the defaults. */
  void ScaleThresholds(double factor);
};

/** Floor, perhaps walls, boxes, spheres and quads; one to three lights; an eye that sees them. */
struct RandomFrame : MultiresolutionScene
{
  RandomFrame(int number, const FrameSize& size, FrameLight light);

  std::string Name;
};

/** Differences of an image to an expected one. */
struct ImageError
{
  /** Largest difference of a pixel's colour, relative to the expected one, or to the bound by
   * `least`. */
  double Worst = 0.0;
  int NumberOff = 0;           // pixels that differ by more than 1e-5
  double RootMeanSquare = 0.0; // over the expected mean
  double Mean = 0.0;           // of the expected image
  double Power = 0.0;          // root mean square of the expected image
};
/** least: differences are relative to at least this share of the largest expected value, and to
 * at least `floor`. */
ImageError Compare(const Image& image, const Image& expected, double least, double floor = 0.0);
}

#endif
