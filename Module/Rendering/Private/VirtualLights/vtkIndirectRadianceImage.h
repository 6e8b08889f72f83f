// SPDX-License-Identifier: BSD-3-Clause
// The pixels of an image as radiances.
#ifndef vtkIndirectRadianceImage_h
#define vtkIndirectRadianceImage_h

#include "vtkType.h" // for counts

#include <glm/glm.hpp> // for colours

class vtkDataArray;
class vtkImageData;

class vtkIndirectRadianceImage
{
public:
  /** Sums of squares of greater radiances, and of images of such, are no longer floats. */
  static constexpr double MostRadiance = 1e18;

  /** Whether it is one slice with a scalar, of one component or more, for each of its points. */
  static bool CanRead(vtkImageData* image);

  /** Of an image that it can read. encoded: values are decoded by sRGB's transfer function. */
  vtkIndirectRadianceImage(vtkImageData* image, bool encoded);

  int GetWidth() const { return this->Size[0]; }
  int GetHeight() const { return this->Size[1]; }
  /** Bytes are parts of 255; what is negative or not finite counts as zero. */
  glm::dvec3 Get(int column, int row);
  /** How many values of those that Get has read were negative or not finite. */
  vtkIdType GetNumberOfInvalid() const { return this->NumberOfInvalid; }

private:
  int Size[2];
  vtkDataArray* Values;
  int Components;
  double Unit;
  bool Encoded;
  vtkIdType NumberOfInvalid = 0;
};

#endif
