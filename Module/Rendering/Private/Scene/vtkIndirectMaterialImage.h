// SPDX-License-Identifier: BSD-3-Clause
// The image of a texture as OpenGL has it, for the processor: linear where VTK declares it sRGB.
#pragma once

#include "vtkType.h" // for numbers

#include <glm/glm.hpp> // for colours
#include <vector>      // for pixels

class vtkTexture;

class vtkIndirectMaterialImage
{
public:
  /** Reads a texture. Returns false, and is empty, if the texture has no image in a plane. */
  bool Read(vtkTexture* texture);
  bool IsEmpty() const { return this->Pixels.empty(); }
  /** Returns true if its pixels differ. */
  bool Varies() const { return this->Different; }
  /** Returns the colour at texture coordinates; white if these are not finite. */
  glm::dvec3 Find(const glm::dvec2& at) const;
  /** Returns the mean of all pixels. */
  const glm::dvec3& GetMean() const { return this->Mean; }
  const vtkIdType* GetCounts() const { return this->Counts; }
  size_t GetBytes() const { return this->Pixels.size(); }

private:
  glm::dvec3 GetPixel(vtkIdType x, vtkIdType y) const;

  std::vector<unsigned char> Pixels; // rgb
  vtkIdType Counts[2] = { 0, 0 };
  int Wrap = 0;
  bool Smooth = false;
  bool Encoded = false;
  bool Different = false;
  glm::dvec3 Mean{ 1.0 };
};
