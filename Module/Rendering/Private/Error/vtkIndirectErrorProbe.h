// SPDX-License-Identifier: BSD-3-Clause
// The error of a picture's irradiance, estimated by path tracing at a few hundred of its pixels.
//
// Each pixel has two independent estimates A and B of its irradiance. With the picture's irradiance
// S, (S - A)(S - B) is an unbiased estimate of the squared error of S, however noisy A and B are.
// Pixels are added until the spread of these products tells their mean well enough. Pixels, paths
// and their number depend on the scene and the picture alone, never on time.
#pragma once

#include "Error/vtkIndirectPathTracer.h" // for places

#include <cstdint>     // for numbers
#include <glm/glm.hpp> // for vectors
#include <vector>      // for lists

class vtkImageData;

class vtkIndirectErrorProbe
{
public:
  /** These are images of a frame, of floats, in world units (vtkIndirectComposite). */
  struct Images
  {
    vtkImageData* Irradiance;
    vtkImageData* Normal;
    vtkImageData* Depth;

    glm::dvec3 GetIrradiance(vtkIdType index) const;
    glm::dvec3 GetNormal(vtkIdType index) const;
    double GetDepth(vtkIdType index) const;
  };

  /**
   * Returns the RMS error of the irradiance over its mean, as path tracing tells it; negative if no
   * pixel can be judged. Pixels at silhouettes and creases, which path tracers draw elsewhere, and
   * pixels whose surface rays do not meet are left out. An error too small to be told from zero is
   * the least that would be told. The places and the light that rays find are kept until Clear:
   * surfaces, lights and the eye must be the same.
   */
  double Estimate(
    const vtkIndirectFrame& frame, const vtkIndirectPathTracer& tracer, const Images& images);
  /** Returns a pixel's middle in the image, from -1 to 1. */
  static glm::dvec2 FindMiddle(const vtkIndirectFrame& frame, vtkIdType index);
  /**
   * Finds the surface that a pixel shows, with the normal that it shows. Returns false if rays do
   * not meet it; the irradiance is not read.
   */
  static bool FindPlace(const vtkIndirectFrame& frame, const vtkIndirectSurfaces& surfaces,
    const Images& images, vtkIdType index, vtkIndirectPathTracer::Place& place);
  /** Returns the number of pixels of the last estimate. */
  size_t GetNumberOfPixels() const { return this->Pixels.size(); }
  /** Forgets what rays have found, for another picture. */
  void Clear();

private:
  struct Pixel
  {
    vtkIndirectPathTracer::Place Place;
    std::uint32_t Candidate = 0; // its number among all candidates
    vtkIdType Index = 0;         // in the images
    glm::dvec3 Traced[2];
  };

  bool FindPixel(const vtkIndirectFrame& frame, const vtkIndirectSurfaces& surfaces,
    const Images& images, Pixel& pixel) const;
  bool AddPixels(
    const vtkIndirectFrame& frame, const vtkIndirectPathTracer& tracer, const Images& images);

  std::vector<Pixel> Pixels;
  std::uint32_t Candidates = 0;
};
