// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectMaterialImage.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace
{
// Returns the pixel of a texture coordinate, given in pixels.
vtkIdType FindPixel(vtkIdType i, vtkIdType count, int wrap)
{
  if (wrap == vtkTexture::Repeat)
  {
    return (i % count + count) % count;
  }
  if (wrap == vtkTexture::MirroredRepeat)
  {
    const vtkIdType at = (i % (2 * count) + 2 * count) % (2 * count);
    return at < count ? at : 2 * count - 1 - at;
  }
  return std::min(std::max<vtkIdType>(i, 0), count - 1);
}

// Decodes sRGB by its transfer function, as OpenGL does for such textures.
double Decode(double value)
{
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}
}

//------------------------------------------------------------------------------
bool vtkIndirectMaterialImage::Read(vtkTexture* texture)
{
  *this = vtkIndirectMaterialImage();
  vtkImageData* image = texture && !texture->GetCubeMap() ? texture->GetInput() : nullptr;
  vtkDataArray* values = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!values || values->GetNumberOfTuples() == 0)
  {
    return false;
  }
  int size[3];
  image->GetDimensions(size);
  // A texture's image lies in a plane of any two axes.
  vtkIdType counts[2] = { 1, 1 };
  for (int axis = 0, next = 0; axis < 3 && next < 2; ++axis)
  {
    if (size[axis] > 1)
    {
      counts[next++] = size[axis];
    }
  }
  const size_t count = static_cast<size_t>(counts[0]) * static_cast<size_t>(counts[1]);
  auto* plain = vtkUnsignedCharArray::SafeDownCast(values);
  const bool mapped = texture->GetColorMode() == VTK_COLOR_MODE_MAP_SCALARS || !plain;
  const unsigned char* bytes = mapped ? texture->MapScalarsToColors(values) : plain->GetPointer(0);
  const int components = mapped ? 4 : values->GetNumberOfComponents();
  if (!bytes || count > static_cast<size_t>(values->GetNumberOfTuples()))
  {
    return false;
  }
  std::copy(counts, counts + 2, this->Counts);
  this->Wrap = texture->GetWrap();
  this->Smooth = texture->GetInterpolate() != 0;
  // OpenGL has no sRGB format of one or two components.
  this->Encoded = texture->GetUseSRGBColorSpace() && components >= 3;
  this->Pixels.resize(3 * count);
  glm::dvec3 sum(0.0);
  for (size_t i = 0; i < count; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const size_t to = 3 * i + static_cast<size_t>(c);
      this->Pixels[to] =
        bytes[static_cast<size_t>(components) * i + static_cast<size_t>(components < 3 ? 0 : c)];
      this->Different = this->Different || this->Pixels[to] != this->Pixels[static_cast<size_t>(c)];
    }
    const vtkIdType at = static_cast<vtkIdType>(i);
    sum += this->GetPixel(at % counts[0], at / counts[0]);
  }
  this->Mean = sum / static_cast<double>(count);
  return true;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectMaterialImage::GetPixel(vtkIdType x, vtkIdType y) const
{
  const size_t i = static_cast<size_t>(FindPixel(x, this->Counts[0], this->Wrap) +
    this->Counts[0] * FindPixel(y, this->Counts[1], this->Wrap));
  glm::dvec3 color;
  for (int c = 0; c < 3; ++c)
  {
    color[c] = this->Pixels[3 * i + static_cast<size_t>(c)] / 255.0;
    color[c] = this->Encoded ? Decode(color[c]) : color[c];
  }
  return color;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectMaterialImage::Find(const glm::dvec2& at) const
{
  glm::dvec2 p = at * glm::dvec2(this->Counts[0], this->Counts[1]);
  if (this->IsEmpty() || !std::isfinite(p.x + p.y) || glm::length(p) > 1e15)
  {
    return glm::dvec3(1.0);
  }
  if (!this->Smooth)
  {
    return this->GetPixel(
      static_cast<vtkIdType>(std::floor(p.x)), static_cast<vtkIdType>(std::floor(p.y)));
  }
  p -= 0.5;
  const glm::dvec2 first = glm::floor(p);
  const glm::dvec2 f = p - first;
  const vtkIdType x = static_cast<vtkIdType>(first.x);
  const vtkIdType y = static_cast<vtkIdType>(first.y);
  return glm::mix(glm::mix(this->GetPixel(x, y), this->GetPixel(x + 1, y), f.x),
    glm::mix(this->GetPixel(x, y + 1), this->GetPixel(x + 1, y + 1), f.x), f.y);
}
