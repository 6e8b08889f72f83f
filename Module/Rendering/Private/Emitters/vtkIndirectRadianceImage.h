// SPDX-License-Identifier: BSD-3-Clause
// The pixels of an image as radiances.
#pragma once

#include "vtkType.h" // for counts

#include <glm/glm.hpp> // for colours

class vtkDataArray;
class vtkImageData;

class vtkIndirectRadianceImage
{
public:
  /**
   * This is the greatest radiance: sums of squares of greater ones, and of images of them, overflow
   * floats.
   */
  static constexpr double MostRadiance = 1e18;

  /**
   * Returns true if the image is one slice with a scalar, of one component or more, for each of its
   * points.
   */
  static bool CanRead(vtkImageData* image);

  /**
   * Reads an image for which CanRead is true. encoded: values are decoded by sRGB's transfer
   * function.
   */
  vtkIndirectRadianceImage(vtkImageData* image, bool encoded);

  int GetWidth() const { return this->Size[0]; }
  int GetHeight() const { return this->Size[1]; }
  /**
   * Returns a pixel's radiance. Bytes are parts of 255; negative and non-finite values count as
   * zero.
   */
  glm::dvec3 Get(int column, int row);
  /** Returns how many of the values that Get has read were negative or not finite. */
  vtkIdType GetNumberOfInvalid() const { return this->NumberOfInvalid; }

private:
  int Size[2];
  vtkDataArray* Values;
  int Components;
  double Unit;
  bool Encoded;
  vtkIdType NumberOfInvalid = 0;
};
